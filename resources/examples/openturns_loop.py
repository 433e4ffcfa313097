#!/usr/bin/env python3
"""openturns_loop.py - OpenTURNS drives squat: mean and spread of the peak over two uncertain inputs, 16 runs.
Needs python3-openturns, and squat on the PATH."""

import openturns

from squat_function import evaluate

LIMITS = {"defect.depth": (0.08, 0.16), "pad.stiffness": (800.0, 2000.0)}

inputs = openturns.ComposedDistribution([openturns.Uniform(low, high) for low, high in LIMITS.values()])
inputs.setDescription(list(LIMITS))
peak = openturns.PythonFunction(
    len(LIMITS), 1, lambda x: evaluate("light-defect", dict(zip(LIMITS, map(float, x))), ["peak"], ["--mesh", "tiny"])
)
sample = openturns.LowDiscrepancyExperiment(openturns.SobolSequence(), inputs, 16).generate()
peaks = peak(sample)
mean, deviation = peaks.computeMean()[0], peaks.computeStandardDeviation()[0]
print(f"peak: mean {mean:.4g} m/s2, standard deviation {deviation:.4g} m/s2")
