"""resources/examples/python_module.py: each of its three parts has at most ten lines, and prints what the command line
finds."""

import ast
import contextlib
import csv
import io
import json
import re
import runpy
import tempfile
import unittest

import h5py
import numpy

import program

EXAMPLE = program.SOURCE / "resources/examples/python_module.py"


def printed(part, *arguments):
    """The numbers of each line that a part of the example prints."""
    output = io.StringIO()
    with contextlib.redirect_stdout(output):
        runpy.run_path(str(EXAMPLE))[part](*arguments)
    return [[float(number) for number in re.findall(r"-?\d+\.\d+", line)] for line in output.getvalue().splitlines()]


class Example(unittest.TestCase):
    def test_each_part_has_at_most_ten_lines(self):
        parts = [node for node in ast.parse(EXAMPLE.read_text()).body if isinstance(node, ast.FunctionDef)]
        self.assertEqual([part.name for part in parts], ["run", "study", "detection"])
        for part in parts:
            self.assertLessEqual(part.end_lineno - part.lineno + 1, 10, part.name)

    def test_run(self):
        with tempfile.TemporaryDirectory() as folder:
            words = ["--mesh", "tiny", "--set", "motion.speed=25", "--no-figures", "-o", folder]
            program.squat("run", "light-defect", *words)
            with h5py.File(folder + "/light-defect.h5") as file:
                peak = file["features/peak"][()]
                aba, position = abs(file["signals/aba_filtered"][:]), file["signals/position"][:]
        ((said_peak, said_largest, said_place),) = printed("run", "tiny")
        self.assertAlmostEqual(said_peak, peak, delta=0.051)
        self.assertAlmostEqual(said_largest, aba.max(), delta=0.051)
        self.assertAlmostEqual(said_place, position[aba.argmax()], delta=0.00051)

    def test_study(self):
        with tempfile.TemporaryDirectory() as folder:
            words = ["--mesh", "tiny", "--vary", "defect.depth=0.04,0.08,0.12", "-o", folder]
            program.squat("study", "light-defect", *words)
            with open(folder + "/study.csv", newline="") as file:
                rows = list(csv.DictReader(file))
        lines = printed("study", "tiny")
        self.assertEqual(len(rows), len(lines))
        column = {re.sub(r" \[.*", "", name).replace(" ", "_"): name for name in rows[0]}
        for row, (depth, peak, force) in zip(rows, lines):
            self.assertEqual(float(row[column["defect.depth"]]), depth)
            self.assertAlmostEqual(float(row[column["peak"]]), peak, delta=0.051)
            self.assertAlmostEqual(float(row[column["smallest_contact_force"]]) / 1000, force, delta=0.051)

    def test_detection(self):
        with tempfile.TemporaryDirectory() as folder:
            words = ["--speed", "30", "--chainage", "12+300", "-o", folder, "--json"]
            events = json.loads(program.squat("detect", "example-record", *words))["events"]
        squats = [[event["position_m"], *event["depth_mm"][1:]] for event in events if event["kind"] == "squat"]
        self.assertTrue(numpy.allclose(printed("detection"), squats, rtol=0, atol=0.0101))  # printed to a hundredth


if __name__ == "__main__":
    unittest.main()
