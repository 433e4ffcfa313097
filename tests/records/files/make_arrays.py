#!/usr/bin/env python3
"""Writes the files of arrays that ArrayFormsTest reads, with the programs that write such files elsewhere.

Made with SciPy 1.10.1, h5py 3.7.0, pandas 1.5.3 with PyTables 3.7.0, and xarray 2023.1.0 with netCDF4 1.6.2 (Debian
12). The file of MATLAB 7.3 is laid out as MATLAB does it. Run in this folder: python3 make_arrays.py
The signal everywhere: left[i] = 10 sin(2 pi 300 i/25000) + i/100 [g], i = 0 .. 399, sampled at 25 kHz; right is twice
left.
"""
import h5py
import numpy as np
import pandas as pd
import scipy.io
import xarray as xr

n, rate = 400, 25000.0
i = np.arange(n)
left = 10 * np.sin(2 * np.pi * 300 * i / rate) + i / 100
right = 2 * left

# Simulink, "structure with time"; the label of a signal holds its name and unit.
signals = np.empty(2, dtype=[("values", object), ("dimensions", object), ("label", object), ("title", object)])
signals[0] = (left.reshape(n, 1), 1.0, "left [g]", "model/left")
signals[1] = (right.reshape(n, 1), 1.0, "right [g]", "model/right")
scipy.io.savemat("simulink.mat", {"simout": {"time": (i / rate).reshape(n, 1), "signals": signals,
                                             "blockName": "model/To Workspace"}}, do_compression=True)

# A cell of structures, each with its own name, unit and rate.
cell = np.empty(2, dtype=object)
cell[0] = {"name": "left", "unit": "g", "fs": rate, "data": left}
cell[1] = {"name": "right", "unit": "g", "fs": rate, "data": right}
scipy.io.savemat("cells.mat", {"channels": cell})
cell[1]["fs"] = rate / 2
scipy.io.savemat("two-rates.mat", {"channels": cell})

# The same cell, and an array of structures, in MATLAB 7.3: references.
with h5py.File("cells73.mat", "w", userblock_size=512) as f:
    refs = f.create_group("#refs#")
    count = [0]

    def add(values, kind):
        count[0] += 1
        d = refs.create_dataset("x%d" % count[0], data=values)
        d.attrs["MATLAB_class"] = np.bytes_(kind)
        return d.ref

    def text(words):
        return np.array([[ord(c)] for c in words], dtype=np.uint16)

    cells = f.create_dataset("channels", (1, 2), dtype=h5py.ref_dtype)
    cells.attrs["MATLAB_class"] = np.bytes_("cell")
    for k, (name, values) in enumerate((("left", left), ("right", right))):
        group = refs.create_group("g%d" % k)
        group.attrs["MATLAB_class"] = np.bytes_("struct")
        for field, value, kind in (("name", text(name), "char"), ("unit", text("g"), "char"),
                                   ("fs", np.array([[rate]]), "double"), ("data", values.reshape(1, n), "double")):
            group.create_dataset(field, data=value).attrs["MATLAB_class"] = np.bytes_(kind)
        cells[0, k] = group.ref
with h5py.File("structures73.mat", "w", userblock_size=512) as f:
    refs = f.create_group("#refs#")
    count = [0]
    run = f.create_group("simout")
    run.attrs["MATLAB_class"] = np.bytes_("struct")
    run.create_dataset("time", data=(i / rate).reshape(1, n)).attrs["MATLAB_class"] = np.bytes_("double")
    array = run.create_group("signals")
    array.attrs["MATLAB_class"] = np.bytes_("struct")
    for field, parts in (("values", [add(left.reshape(1, n), "double"), add(right.reshape(1, n), "double")]),
                         ("label", [add(text("left [g]"), "char"), add(text("right [g]"), "char")])):
        d = array.create_dataset(field, (1, 2), dtype=h5py.ref_dtype)
        for k, part in enumerate(parts):
            d[0, k] = part
for name in ("cells73.mat", "structures73.mat"):
    with open(name, "r+b") as raw:
        head = b"MATLAB 7.3 MAT-file, Platform: GLNXA64, Created on: Mon Jan 6 10:00:00 2014 HDF5 schema 1.00 ."
        raw.write(head.ljust(116) + b"\0" * 8 + b"\x00\x02IM")

# Records of fields, as h5py writes them from a structured array, and as pandas writes a table.
rows = np.empty(n, dtype=[("time [s]", "f8"), ("left (m/s2)", "f4"), ("right [g]", "f8"), ("count", "i4"),
                          ("tag", "S4"), ("pair", "f8", 2)])
rows["time [s]"], rows["left (m/s2)"], rows["right [g]"], rows["count"] = i / rate, 9.80665 * left, right, i
rows["pair"][:, 0], rows["pair"][:, 1] = left, right
with h5py.File("compound.h5", "w") as f:
    f.create_dataset("measurement/rows", data=rows, chunks=(64,), compression="gzip")
frame = pd.DataFrame({"left": left, "right": right}, index=pd.Index(i / rate, name="time"))
frame.to_hdf("pandas-table.h5", "run", format="table", data_columns=True, index=False,
             complib="zlib", complevel=9)

# Channels as groups, each with its unit and step as attributes.
with h5py.File("channels.h5", "w") as f:
    for name, values in (("left", left), ("right", right)):
        d = f.create_dataset("train/" + name + "/data", data=values)
        d.attrs["unit_string"] = "g"
        d.attrs["wf_increment"] = 1 / rate

# netCDF: times since a date, packed numbers.
data = xr.Dataset({"left": ("time", 9.80665 * left, {"units": "m s-2"}),
                   "right": ("time", 9.80665 * right, {"units": "m s-2"})},
                  coords={"time": ("time", i / rate, {"units": "seconds since 2024-05-01 10:00:00"})})
packed = {"left": {"dtype": "i2", "scale_factor": 0.01, "add_offset": 50.0, "_FillValue": -32768}}
data.to_netcdf("packed.nc", format="NETCDF4", encoding=packed)
data.isel(time=slice(0, 3)).to_netcdf("classic.nc", format="NETCDF3_CLASSIC")
