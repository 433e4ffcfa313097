#!/usr/bin/python3
"""Writes monotone_cubic.csv: SciPy's PchipInterpolator (the same monotone cubic) through a small measured-style dip.

The flat points at both ends make the slopes there zero, as where a defect joins the plane rail.
"""
import numpy
from scipy.interpolate import PchipInterpolator

position = numpy.array([-40, -35, -28, -20, -11, -6, 0, 4, 9, 15, 22, 30, 35, 40], float)  # mm
height = numpy.array([0, 0, -12, -30, -30, -95, -150, -120, -130, -60, -5, -9, 0, 0], float)  # um
curve = PchipInterpolator(position, height)
with open(__file__.replace(".py", ".csv"), "w") as out:
    out.write("position_mm,height_um,slope_um_per_mm\n")
    for x in numpy.arange(-36, 36.5, 0.75):
        out.write(f"{x},{curve(x):.15g},{curve.derivative()(x):.15g}\n")
