#!/usr/bin/env python3
"""Writes the files of other programs that the tests of long records read.

Made with pandas 1.5.3 and PyTables 3.7.0 (Debian 12). Run in this folder: python3 make_files.py
The signal everywhere: aba[i] = 10 sin(2 pi 300 i/25000) + i/100 [g], sampled at 25 kHz; right is twice left; the
position rises by 1 mm a sample from 500 m on.
"""
import numpy as np
import pandas as pd


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
