#!/usr/bin/env python3
"""salib_points.py - SALib makes the points of a study and judges its table. Needs SALib (not in Debian).
    salib_points.py points                    writes points.csv, for squat study CASE --points points.csv -o out
    salib_points.py indices out/study.csv     first-order and total indices of the peak"""

import csv
import sys

from SALib.analyze import sobol as analysis
from SALib.sample import sobol as sampling

PROBLEM = {
    "num_vars": 2,
    "names": ["defect.depth", "pad.stiffness"],
    "bounds": [[0.08, 0.16], [800, 2000]],
}

if sys.argv[1:] == ["points"]:
    with open("points.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(PROBLEM["names"])
        table.writerows(sampling.sample(PROBLEM, 64).tolist())
elif len(sys.argv) == 3 and sys.argv[1] == "indices":
    import numpy

    with open(sys.argv[2], newline="") as file:
        rows = list(csv.DictReader(file))
    print(analysis.analyze(PROBLEM, numpy.array([float(row["peak [m/s2]"]) for row in rows])).to_df())
else:
    sys.exit(__doc__)
