#!/usr/bin/env python3
"""Writes scipy.txt: numbers of SciPy and of direct quadrature that the signal tests compare with.

Made with SciPy 1.10.1 and NumPy 1.24.2 (Debian 12: python3-scipy). Run in this folder: python3 make_reference.py
Each line: name, number of values, values with 17 digits.
"""
import numpy as np
from scipy import signal

rate = 25000.0
out = []


def put(name, values):
    values = np.atleast_1d(np.asarray(values, dtype=float)).ravel()
    out.append(name + " " + str(len(values)) + " " + " ".join(f"{v:.17g}" for v in values))


random = np.random.default_rng(20140101)
n = 401
t = np.arange(n) / rate
x = (3.0 + 40 * np.sin(2 * np.pi * 311 * t + 0.3) + 25 * np.sin(2 * np.pi * 1034 * t) * np.exp(-t / 0.004)
     + 5 * random.standard_normal(n))
put("input", x)

# Filters
put("lowpass4", signal.sosfiltfilt(signal.butter(4, 2000, "lowpass", fs=rate, output="sos"), x))
put("lowpass5", signal.sosfiltfilt(signal.butter(5, 3100, "lowpass", fs=rate, output="sos"), x))
put("bandpass4", signal.sosfiltfilt(signal.butter(4, [600, 2000], "bandpass", fs=rate, output="sos"), x))
put("bandpass3", signal.sosfiltfilt(signal.butter(3, [130, 320], "bandpass", fs=rate, output="sos"), x))
put("bandpass1wide", signal.sosfiltfilt(signal.butter(1, [20, 12000], "bandpass", fs=rate, output="sos"), x))

# Spectra: name_window_segment_overlap_padding_detrend
for window in ("boxcar", "hann", "hamming", "blackman"):
    put("welch_" + window, signal.welch(x, rate, window, 128, 64, None, "constant")[1])
put("periodogram", signal.periodogram(x, rate, "boxcar", None, False)[1])
put("periodogram_linear", signal.periodogram(x, rate, "hann", None, "linear")[1])
put("welch_padded", signal.welch(x, rate, "hann", 101, 25, 256, "linear")[1])

# Short-time transforms: no padding, no boundary, scaling "spectrum": a tone of amplitude a gives |S| = a/2
f, tau, s = signal.stft(x, rate, "hann", 64, 48, 128, False, boundary=None, padded=False)
put("stft_time", tau)
put("stft_frequency", f)
put("stft_real", s.real[:, ::6])
put("stft_imag", s.imag[:, ::6])

# Peaks
smooth = signal.sosfiltfilt(signal.butter(4, 2000, "lowpass", fs=rate, output="sos"), x)
plateau = np.array([0, 1, 3, 3, 3, 2, 2.5, 1, 0, 4, 4, 1, 5, 0.5, 0.5, 2, 2], dtype=float)
for name, values in (("smooth", smooth), ("plateau", plateau)):
    index = signal.find_peaks(values)[0]
    width, _, left, right = signal.peak_widths(values, index, 0.5)
    put("peaks_" + name + "_index", index)
    put("peaks_" + name + "_prominence", signal.peak_prominences(values, index)[0])
    put("peaks_" + name + "_left", left)
    put("peaks_" + name + "_right", right)
put("plateau", plateau)

# Continuous wavelet transform: direct quadrature (rectangle rule on the samples) of
# W(s, tau) = 1/sqrt(s) Int x(t) psi*((t - tau)/s) dt, psi = pi^(-1/4) exp(i 6 t) exp(-t^2/2)
w0 = 6.0
samples = np.array([0, 37, 200, 333, 400])
for frequency in (150.0, 311.0, 1034.0, 2500.0, 5000.0):
    for kind, factor in (("energy", (w0 + np.sqrt(2 + w0**2)) / (4 * np.pi)), ("amplitude", w0 / (2 * np.pi))):
        s = factor / frequency
        u = (t[None, :] - t[samples][:, None]) / s
        psi = np.pi**-0.25 * np.exp(1j * w0 * u - u**2 / 2)
        w = (x[None, :] * psi.conj()).sum(axis=1) / rate / np.sqrt(s)
        if kind == "amplitude":
            w *= np.sqrt(2) * np.pi**-0.25 / np.sqrt(s)
        put(f"cwt_{kind}_{frequency:.0f}_real", w.real)
        put(f"cwt_{kind}_{frequency:.0f}_imag", w.imag)

open("scipy.txt", "w").write("\n".join(out) + "\n")
