#!/usr/bin/env python3
"""compare_results.py ONE.h5 OTHER.h5 [PICTURE] - the axle box accelerations and spectra of two results over each other
(default: comparison.png), and a table of their features. Needs python3-h5py and python3-matplotlib."""

import sys

import h5py
import matplotlib

matplotlib.use("Agg")  # needs no display
from matplotlib import pyplot


def features_of(result):
    """Name to (value, unit); none in results up to version 0.2.0, and where the record is too short."""
    group = result.get("features", {})
    return {name: (group[name][()], group[name].attrs["unit"]) for name in group}


with h5py.File(sys.argv[1]) as one, h5py.File(sys.argv[2]) as other:
    figure, (history, density) = pyplot.subplots(2, 1, figsize=(8, 7), layout="constrained")
    for result, line in ((one, "-"), (other, "--")):
        label = f"{result.attrs['stem']} ({result.attrs['case_hash']})"
        history.plot(1000 * result["signals/position"][:], result["signals/aba_filtered"][:], line, label=label)
        density.plot(result["spectra/frequency"][:], result["spectra/psd"][:], line, label=label)
    history.set(xlabel="Position from the defect [mm]", ylabel="ABA [m/s2]")
    density.set(xlim=(0, 2000), ylim=(0, None), xlabel="Frequency [Hz]", ylabel="PSD [(m/s2)2/Hz]")
    history.legend()
    picture = sys.argv[3] if len(sys.argv) > 3 else "comparison.png"
    figure.savefig(picture, dpi=150)

    first, second = features_of(one), features_of(other)
    if not first or not second:
        sys.exit(f"{picture}: drawn, but one of the results holds no features")
    print(f"{'feature':34} {one.attrs['stem']:>14} {other.attrs['stem']:>14}  unit")
    for name in (name for name in first if name in second):
        print(f"{name:34} {first[name][0]:14.5g} {second[name][0]:14.5g}  {first[name][1]}")
