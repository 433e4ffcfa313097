#!/usr/bin/env python3
"""depth_loop.py [MESH [PICTURE]] - a loop over the depth of the defect: each turn calls `squat run --json` and reads the
features that it prints; peak and smallest contact force against depth (default: depths.png).
Needs squat on the PATH and python3-matplotlib. `squat study` makes such loops without a script."""

import json
import subprocess
import sys

import matplotlib

matplotlib.use("Agg")  # needs no display
from matplotlib import pyplot

mesh = sys.argv[1] if len(sys.argv) > 1 else "draft"
picture = sys.argv[2] if len(sys.argv) > 2 else "depths.png"

depths = [0.04, 0.08, 0.12]  # [mm]
peaks, forces = [], []
for depth in depths:
    words = ["--mesh", mesh, "--set", f"defect.depth={depth}", "--name", f"depth-{depth}", "--no-figures", "--json"]
    # Progress and warnings go to stderr, the report alone to stdout; a failed run raises CalledProcessError.
    call = subprocess.run(["squat", "run", "light-defect", *words], check=True, stdout=subprocess.PIPE)
    report = json.loads(call.stdout)
    peaks.append(report["features"]["peak"]["value"])
    forces.append(report["features"]["smallest_contact_force"]["value"] / 1000)
    print(f"{depth} mm: peak {peaks[-1]:.1f} m/s2, smallest force {forces[-1]:.1f} kN, {report['files'][0]}", flush=True)

figure, (upper, lower) = pyplot.subplots(2, 1, figsize=(7, 6), sharex=True, layout="constrained")
upper.plot(depths, peaks, "o-")
upper.set(ylabel="Peak of the ABA [m/s2]", ylim=(0, None))
lower.plot(depths, forces, "o-")
lower.set(xlabel="Depth of the defect [mm]", ylabel="Smallest contact force [kN]")
figure.savefig(picture, dpi=150)
