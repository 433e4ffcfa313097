"""ishigami.py SENSITIVITY - judges the example by a function whose indices are known in closed form: Ishigami's,
sin x + 7 sin^2 y + 0.1 z^4 sin x on [-pi, pi]^3 (T. Ishigami and T. Homma, 1990): first order 0.3139, 0.4424, 0; total
0.5576, 0.4424, 0.2437."""

import csv
import math
import re
import subprocess
import sys
import tempfile

import openturns

EXACT = [(0.3139, 0.5576), (0.4424, 0.4424), (0.0, 0.2437)]
TOLERANCE = 0.02  # of a fit of degree 8 to a function that is no polynomial

with tempfile.TemporaryDirectory() as folder:
    box = openturns.ComposedDistribution([openturns.Uniform(-math.pi, math.pi)] * 3)
    with open(folder + "/study.csv", "w", newline="") as file:
        table = csv.writer(file, lineterminator="\n")
        table.writerow(["a.x", "a.y", "a.z", "state", "peak [m/s2]", "message"])
        table.writerow(["0", "0", "0", "failed", "", "left out"])
        for x, y, z in openturns.LowDiscrepancyExperiment(openturns.SobolSequence(), box, 256).generate():
            value = math.sin(x) + 7 * math.sin(y) ** 2 + 0.1 * z**4 * math.sin(x)
            table.writerow([repr(x), repr(y), repr(z), "done", repr(value), ""])
    output = subprocess.run(
        [sys.executable, sys.argv[1], folder + "/study.csv", "peak"], check=True, capture_output=True, text=True
    ).stdout
print(output)
index = r" +([\d.-]+) \(([\d.-]+) to ([\d.-]+)\)"
found = re.findall(r"^a\.[xyz]" + index + index + "$", output, re.M)
assert len(found) == 3, "a line for each key"
for row, (first, total) in zip(found, EXACT):
    numbers = [float(number) for number in row]
    assert abs(numbers[0] - first) < TOLERANCE and abs(numbers[3] - total) < TOLERANCE, row
    assert numbers[1] <= numbers[2] < numbers[1] + 0.1 and numbers[4] <= numbers[5] < numbers[4] + 0.1, row
