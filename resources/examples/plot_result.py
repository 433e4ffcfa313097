#!/usr/bin/env python3
"""plot_result.py RESULT.h5 [PICTURE] - axle box acceleration, its power spectral density and its scalogram of one
result, in one picture (default: result.png). Needs python3-h5py and python3-matplotlib."""

import sys

import h5py
import matplotlib

matplotlib.use("Agg")  # needs no display
from matplotlib import pyplot


def unit_of(dataset):
    """Every dataset of a result says its unit."""
    return dataset.attrs["unit"]


with h5py.File(sys.argv[1]) as result:
    figure, (history, density, map_of_power) = pyplot.subplots(3, 1, figsize=(8, 10), layout="constrained")
    figure.suptitle(f"{result.attrs['title']}, {result.attrs['speed']:g} m/s (case {result.attrs['case_hash']})")

    position = 1000 * result["signals/position"][:]  # [mm] of the wheel centre from the deepest point of the defect
    acceleration = result["signals/aba_filtered"]
    history.plot(position, acceleration[:], linewidth=1)
    history.axvline(0, linestyle=":", linewidth=1)
    history.set(xlabel="Position from the defect [mm]", ylabel=f"ABA [{unit_of(acceleration)}]")

    spectrum = result["spectra"]
    density.plot(spectrum["frequency"][:], spectrum["psd"][:], linewidth=1)
    density.set(xlim=(0, 2000), ylim=(0, None), xlabel="Frequency [Hz]", ylabel=f"PSD [{unit_of(spectrum['psd'])}]")
    density.set_title(f"from {1000 * spectrum.attrs['from']:.0f} to {1000 * spectrum.attrs['to']:.0f} mm", fontsize=9)

    scalogram = result["scalogram"]
    along, frequency = 1000 * scalogram["position"][:], scalogram["frequency"][:]
    image = map_of_power.pcolormesh(along, frequency, scalogram["power"][:], shading="nearest", cmap="viridis")
    # Below the cone of influence the ends of the record distort the picture.
    map_of_power.plot(along, scalogram["cone_of_influence"][:], "w--", linewidth=1)
    map_of_power.set(yscale="log", ylim=(frequency.min(), frequency.max()), ylabel="Frequency [Hz]")
    ticks = [tick for tick in (50, 100, 200, 500, 1000, 2000) if frequency.min() <= tick <= frequency.max()]
    map_of_power.set_yticks(ticks, [str(tick) for tick in ticks])
    map_of_power.set_yticks([], minor=True)
    map_of_power.set(xlabel="Position from the defect [mm]", xlim=(along.min(), along.max()))
    history.set_xlim(map_of_power.get_xlim())
    figure.colorbar(image, ax=map_of_power, label=f"Power [{unit_of(scalogram['power'])}]")

    picture = sys.argv[2] if len(sys.argv) > 2 else "result.png"
    figure.savefig(picture, dpi=150)
    print(f"{picture}: peak {abs(acceleration[:]).max():.1f} {unit_of(acceleration)}")
