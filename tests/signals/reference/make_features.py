#!/usr/bin/env python3
"""Writes features.txt: a signal that this program did not make, and its features by SciPy and direct sums.

The signal: two oscillators (300 and 1034 Hz) struck by a half-sine pulse of 20 mm at 30 m/s, by scipy.signal.lsim.
Made with SciPy 1.10.1 and NumPy 1.24.2 (Debian 12: python3-scipy). Run in this folder: python3 make_features.py
"""
import numpy as np
from scipy import signal

rate, speed, n = 25000.0, 30.0, 2500
out = []


def put(name, values):
    values = np.atleast_1d(np.asarray(values, dtype=float)).ravel()
    out.append(name + " " + str(len(values)) + " " + " ".join(f"{v:.17g}" for v in values))


t = np.arange(n) / rate
start, length = 0.03, 0.02 / speed
pulse = np.where((t >= start) & (t <= start + length), np.sin(np.pi * (t - start) / length), 0.0)
x = np.zeros(n)
for frequency, damping, weight in ((300.0, 0.03, 1.0), (1034.0, 0.012, 0.6)):
    w = 2 * np.pi * frequency
    # acceleration of an oscillator under a force: s^2 / (s^2 + 2 zeta w s + w^2)
    x += weight * signal.lsim(([1, 0, 0], [1, 2 * damping * w, w * w]), pulse, t)[1]
x *= 115 / np.abs(x).max()
put("signal", x)

impact = t[np.abs(x).argmax()]
put("impact", impact)
put("peak", [np.abs(x).max(), x.max(), x.min(), np.sqrt(np.mean(x**2))])

window = int(round(0.25 / speed * rate))
put("moving_rms", max(np.sqrt(np.mean(x[i:i + window]**2)) for i in range(n - window + 1)))

# Spectrum from 0.1 m before to 0.28 m after the impact, Hann, padded to at least rate/3 samples (2^a 3^b 5^c)
eps = 1e-9
part = x[(t >= impact - 0.1 / speed - eps) & (t <= impact + 0.28 / speed + eps)]
padded = 8640  # the smallest 2^a 3^b 5^c not below 25000/3
f, g = signal.welch(part, rate, "hann", len(part), 0, padded, "constant")
fine = np.arange(0, 12500, 0.01)
for low, high in ((130, 320), (200, 400), (1000, 1200)):
    band = np.linspace(low, high, 40001)
    put(f"power_{low}", np.trapz(np.interp(band, f, g), band))
put("integral", g.sum() * (f[1] - f[0]))

# Mean wavelength by crossings of the band-passed record over 0.15 m
wave = signal.sosfiltfilt(signal.butter(4, [600, 2000], "bandpass", fs=rate, output="sos"), x)
keep = (t >= impact - eps) & (t <= impact + 0.15 / speed + eps)
tw, w = t[keep], wave[keep]
i = np.nonzero(np.signbit(w[1:]) != np.signbit(w[:-1]))[0]
crossings = tw[i] + (tw[i + 1] - tw[i]) * w[i] / (w[i] - w[i + 1])
put("wavelength_crossings", speed * 2 * (crossings[-1] - crossings[0]) / (len(crossings) - 1))


# Morlet transform by direct quadrature, amplitude-normalised
def voices(low, high):
    return low * 2.0 ** (np.arange(int(np.floor(np.log2(high / low) * 24 + 1e-9)) + 1) / 24)


def power(frequencies, where):
    rows = []
    for frequency in frequencies:
        s = 6.0 / (2 * np.pi * frequency)
        u = (t[None, :] - t[where][:, None]) / s
        rows.append(np.abs(np.sqrt(2 / np.pi) / rate / s * (x[None, :] * np.exp(-6j * u - u**2 / 2)).sum(axis=1))**2)
    return np.array(rows)


frequencies = voices(600, 2000)
where = np.nonzero(keep)[0]
p = power(frequencies, where)
best = p.argmax(axis=0)
ridge = []
for column, b in enumerate(best):
    offset = 0.0
    if 0 < b < len(frequencies) - 1:
        low, mid, high = p[b - 1:b + 2, column]
        offset = 0.5 * (low - high) / (low - 2 * mid + high)
    ridge.append(frequencies[b] * 2 ** (offset / 24))
weight = p.max(axis=0)
put("wavelength_ridge", speed * weight.sum() / (weight * np.array(ridge)).sum())

after = np.nonzero(t >= impact - eps)[0]
for low, high in ((130, 320), (200, 400), (1000, 1200)):
    envelope = np.sqrt(power(voices(low, high), after).sum(axis=0))
    level = 0.1 * envelope.max()
    put(f"decay_{low}", t[after][np.nonzero(envelope >= level)[0].max()] - impact)

open("features.txt", "w").write("\n".join(out) + "\n")
