#!/usr/bin/env python3
"""Writes the HDF5 files that the tests of measured signals read; a MATLAB 7.3 file as MATLAB lays it out.

Made with h5py 3.7.0 (Debian 12: python3-h5py). Run in this folder: python3 make_files.py
The signal everywhere: aba[i] = 10 sin(2 pi 300 i/25000) + i/100, i = 0 .. 99; a second run has twice that.
"""
import h5py
import numpy as np

n, rate = 100, 25000.0
i = np.arange(n)
aba = 10 * np.sin(2 * np.pi * 300 * i / rate) + i / 100

# MATLAB 7.3: 512 bytes of user block, row vectors as n x 1, class attributes, references for cell arrays
with h5py.File("matlab73.mat", "w", userblock_size=512) as f:
    def matlab(name, values, kind="double"):
        d = f.create_dataset(name, data=values)
        d.attrs["MATLAB_class"] = np.bytes_(kind)
        return d
    matlab("aba", aba.reshape(n, 1))
    matlab("Fs", np.array([[rate]]))
    matlab("note", np.array([[ord(c)] for c in "train 3"], dtype=np.uint16), "char")
    run = f.create_group("run2")
    run.attrs["MATLAB_class"] = np.bytes_("struct")
    fields = np.empty(3, dtype=object)
    for k, name in enumerate(("aba", "time", "speed")):
        fields[k] = np.array([c.encode() for c in name], dtype="S1")
    run.attrs.create("MATLAB_fields", fields, dtype=h5py.vlen_dtype(np.dtype("S1")))
    run.create_dataset("aba", data=(2 * aba).reshape(n, 1))
    run.create_dataset("time", data=(i / rate).reshape(n, 1))
    run.create_dataset("speed", data=np.full((n, 1), 28.0))
    refs = f.create_group("#refs#")
    refs.create_dataset("a", data=np.array([[1.0]]))
    cell = f.create_dataset("cell", (1, 1), dtype=h5py.ref_dtype)
    cell[0, 0] = refs["a"].ref
    cell.attrs["MATLAB_class"] = np.bytes_("cell")
with open("matlab73.mat", "r+b") as raw:
    head = b"MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Mon Jan 6 10:00:00 2014 HDF5 schema 1.00 ."
    raw.write(head.ljust(116) + b"\0" * 8 + b"\x00\x02IM")

# Several runs in one dataset, rate as an attribute, g as unit, single precision, 16-bit counts beside it
with h5py.File("runs.h5", "w") as f:
    g = f.create_group("line/track1")
    d = g.create_dataset("aba", data=np.stack([aba, 2 * aba]).astype("f4"), chunks=(1, 50), compression="gzip")
    d.attrs["unit"] = "g"
    d.attrs["sampling_rate"] = rate
    counts = g.create_dataset("counts", data=(100 * aba).astype("i2"))
    bad = f.create_group("mixed")
    bad.create_dataset("aba", data=aba)
    bad.create_dataset("time", data=i[:90] / rate)
    f["soft"] = h5py.SoftLink("/line/track1/aba")
    f.create_dataset("complex", data=aba + 1j * aba)
