"""Profiles from passages, against `squat estimate` for the same signal, which a run has computed. Few runs: what is
shown is that both are one search, not how good it is."""

import json
import pathlib
import tempfile
import unittest

import numpy
import squat

import program


class Estimate(unittest.TestCase):
    def test_the_estimate_of_arrays_is_that_of_the_command(self):
        case = squat.load_case("light-defect", mesh="tiny")
        result = squat.run(case, fields=False)
        passage = {"time [s]": result.time, "position [m]": result.position, "aba [m/s2]": result["aba"]}
        with tempfile.TemporaryDirectory() as folder:
            result.save_signals(folder + "/passage.csv")
            words = ["--case", "light-defect", "--runs", 20, "--longest", 20, "--jobs", 1, "--threads", 1]
            program.squat("estimate", folder + "/passage.csv", *words, "--format", "svg", "-o", folder + "/out")
            other = json.loads(pathlib.Path(folder, "out/estimate.json").read_text())
        found = squat.estimate(case, passage, runs=20, longest=20, jobs=1, threads=1)
        self.assertEqual(found.runs, other["runs"])
        profile = {name: [row[name] for row in other["profile"]] for name in other["profile"][0]}
        for name, scale in (("position", 1e3), ("height", 1e6), ("lower", 1e6), ("upper", 1e6)):
            (column,) = [column for column in profile if column.startswith(name)]
            self.assertTrue(numpy.allclose(scale * found.profile[name], profile[column], rtol=1e-6, atol=1e-3), name)
            self.assertIs(found.profile[name].base, found)
        self.assertLess(found.depth[1], found.depth[0])
        self.assertLess(found.depth[0], found.depth[2])
        self.assertEqual(found.case["defect.shape"], "profile")
        self.assertEqual(len(found.passages), 1)
        self.assertEqual(found.passages[0]["measured"].shape, found.passages[0]["position"].shape)
        with tempfile.TemporaryDirectory() as folder:
            self.assertTrue(all(pathlib.Path(path).exists() for path in found.save(folder)))

    def test_a_passage_of_hum_has_no_event(self):
        # The peak of a sine is 1.4 times its standard deviation; an event has to have four times that of the noise.
        hum = numpy.sin(2 * numpy.pi * 500 / 25600 * numpy.arange(5000))
        case = squat.load_case("light-defect", mesh="tiny")
        with self.assertRaises(squat.FileError):
            squat.estimate(case, {"aba [m/s2]": hum}, rate=25600, speed=30)

    def test_wrong_arguments_are_case_errors(self):
        case = squat.load_case("light-defect", mesh="tiny")
        for wrong in ({"runs": 5}, {"longest": 500}, {"low_pass": 10}, {"jobs": -1}):
            with self.assertRaises(squat.CaseError):
                squat.estimate(case, "example-record", **wrong)


if __name__ == "__main__":
    unittest.main()
