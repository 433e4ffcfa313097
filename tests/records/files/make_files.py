#!/usr/bin/env python3
"""Writes the files of other programs that the tests of long records read.

Made with pandas 1.5.3, PyTables 3.7.0 and SciPy 1.10.1 (Debian 12). Run in this folder: python3 make_files.py
The signal everywhere: aba[i] = 10 sin(2 pi 300 i/25000) + i/100 [g], sampled at 25 kHz; right is twice left; the
position rises by 1 mm a sample from 500 m on.
"""
import numpy as np
import pandas as pd
import scipy.io


def signal(n):
    i = np.arange(n)
    return i, 10 * np.sin(2 * np.pi * 300 * i / 25000) + i / 100


def frame(n):
    i, aba = signal(n)
    return pd.DataFrame({"left [g]": aba, "right [g]": 2 * aba, "position": 500 + i / 1000, "count": i})


rows = frame(400).drop(columns="count")
rows.index = np.arange(400) / 25000
dated = frame(100)
dated.index = pd.to_datetime(1_700_000_000_000_000_000 + np.arange(100) * 40_000)
dated = dated.drop(columns="count")
with pd.HDFStore("pandas.h5", "w") as store:
    store.put("time", rows, format="fixed")
    store.put("sync", frame(10), format="fixed")
    store.put("dated", dated, format="fixed")

# MATLAB files before 7.3: as they were, and as MATLAB 7 deflates them; numbers of several types, and what is no number.
i, aba = signal(400)
scipy.io.savemat("matlab5.mat", {"note": "train 3", "aba": aba, "Fs": 25000.0, "cells": np.array([1, "a"], dtype=object),
                                 "complex": aba + 1j * aba})
scipy.io.savemat("matlab7.mat", {
    "other": np.arange(3.0),
    "run": {"time": i / 25000, "left": aba.astype(np.float32), "counts": (100 * aba).astype(np.int16),
            "speed": np.full(400, 28, dtype=np.uint8)},
    "channels": np.stack([aba, 2 * aba], axis=1)}, do_compression=True)
