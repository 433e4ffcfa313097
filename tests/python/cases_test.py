"""Cases: what they hold is judged by Python's own reader of TOML and by what `squat describe` prints."""

import json
import pathlib
import pickle
import tempfile
import tomllib
import unittest

import numpy
import squat

import program


class Cases(unittest.TestCase):
    def setUp(self):
        self.case = squat.load_case("light-defect", mesh="tiny")

    def test_a_key_is_read_in_the_unit_of_the_case_file(self):
        stated = tomllib.loads((program.SOURCE / "resources/cases/light-defect.toml").read_text())
        self.assertEqual(self.case["defect.depth"], stated["defect"]["depth"])

    def test_a_key_that_is_set_stands_in_the_text(self):
        self.case["defect.depth"] = 0.15
        self.case["title"] = "Assen, km 12.3"
        self.case["rail.plastic"] = True
        text = tomllib.loads(self.case.toml())
        self.assertEqual(text["defect"]["depth"], 0.15)
        self.assertEqual(text["title"], "Assen, km 12.3")
        self.assertIs(text["rail"]["plastic"], True)
        self.assertEqual(text["mesh"]["preset"], "tiny")

    def test_the_right_side_has_values_of_its_own(self):
        self.assertEqual(self.case["right.defect.depth"], self.case["defect.depth"])
        self.case.update({"model.extent": "whole", "right.defect.depth": 0.05, "right.defect.shape": "cosine"})
        self.assertEqual(self.case["right.defect.depth"], 0.05)
        right = tomllib.loads(self.case.toml())["right"]["defect"]
        self.assertEqual((right["depth"], right["shape"]), (0.05, "cosine"))
        self.assertIn("right.defect.depth", self.case)
        self.assertNotIn("right.motion.speed", self.case)
        with self.assertRaises(squat.CaseError):
            self.case["right.motion.speed"] = 20

    def test_a_unit_of_its_own_is_converted(self):
        self.case["motion.speed"] = "108 km/h"
        self.assertAlmostEqual(self.case["motion.speed"], 108 / 3.6, places=12)

    def test_arguments_of_load_case_are_keys(self):
        case = squat.load_case("light-defect", mesh="tiny", **{"defect.depth": 0.15, "motion.speed": 25})
        self.assertEqual((case["defect.depth"], case["motion.speed"]), (0.15, 25))

    def test_values_are_those_that_describe_prints(self):
        described = json.loads(program.squat("describe", "light-defect", "--mesh", "tiny", "--json"))
        self.assertEqual([row["key"] for row in described], self.case.keys())
        table = squat.parameters()
        for row in described:
            key, own = row["key"], table[row["key"]]
            if isinstance(self.case[key], (bool, int, float, str)):
                self.assertEqual(self.case[key], row["value"], key)
                self.assertEqual(own["default"], row["default"], key)
            self.assertEqual((own.get("minimum"), own.get("maximum")), (row["min"], row["max"]), key)
            self.assertEqual((own["unit"], own["kind"], own["doc"]), (row["unit"], row["kind"], row["doc"]), key)

    def test_a_profile_is_a_list_or_an_array(self):
        points = [[-20, 0], [0, -0.1], [20, 0]]
        self.case.update({"defect.shape": "profile", "defect.points": points})
        self.assertEqual(self.case["defect.points"], points)
        other = squat.load_case("light-defect", mesh="tiny")
        other.update({"defect.shape": "profile", "defect.points": numpy.array(points)})
        self.assertEqual(other.hash, self.case.hash)

    def test_a_mesh_preset_acts_as_on_the_command_line(self):
        self.case["mesh.preset"] = "draft"
        described = json.loads(program.squat("describe", "light-defect", "--mesh", "draft", "--json"))
        for row in described:
            if row["key"].startswith("mesh."):
                self.assertEqual(self.case[row["key"]], row["value"], row["key"])

    def test_an_unknown_key_is_named_with_the_nearest(self):
        with self.assertRaises(squat.CaseError) as raised:
            self.case["motion.spede"] = 30
        self.assertIn("motion.spede", str(raised.exception))
        self.assertIn("motion.speed", raised.exception.problems[0]["advice"])
        with self.assertRaises(squat.CaseError):
            self.case["motion.spede"]
        self.assertNotIn("motion.spede", self.case)

    def test_a_wrong_value_says_what_is_allowed_and_changes_nothing(self):
        row = squat.parameters()["motion.speed"]
        before = self.case.hash
        with self.assertRaises(squat.CaseError) as raised:
            self.case.update({"defect.depth": 0.1, "motion.speed": 400})
        problem = raised.exception.problems[0]
        self.assertEqual((problem["key"], problem["value"]), ("motion.speed", "400"))
        self.assertEqual(problem["allowed"], f"{row['minimum']:g} to {row['maximum']:g} m/s")
        self.assertIn("motion.speed is 400, must be " + problem["allowed"], str(raised.exception))
        self.assertEqual(self.case.hash, before)

    def test_all_mistakes_are_named_at_once(self):
        with self.assertRaises(squat.CaseError) as raised:
            squat.load_case("light-defect", mesh="tiny", **{"motion.spede": 30, "pad.stiffness": -1})
        self.assertEqual({problem["key"] for problem in raised.exception.problems}, {"motion.spede", "pad.stiffness"})

    def test_no_message_names_an_option_of_the_command_line(self):
        for values in ({"defect.points": [[0, -0.1], [5, 0]]}, {"motion.speed": "fast"}):
            with self.assertRaises(squat.CaseError) as raised:
                squat.load_case("light-defect", **values)
            self.assertNotIn("--", str(raised.exception))

    def test_what_is_no_value_is_a_type_error(self):
        with self.assertRaises(TypeError):
            self.case["defect.depth"] = None

    def test_a_case_that_is_not_there_is_a_file_error(self):
        with self.assertRaises(squat.FileError) as raised:
            squat.load_case("light-defct")
        self.assertEqual(raised.exception.path, "light-defct")
        self.assertIn("Did you mean light-defect?", str(raised.exception))

    def test_a_case_is_a_mapping(self):
        values = dict(self.case)
        self.assertEqual(list(values), self.case.keys())
        self.assertEqual(len(values), len(self.case))
        again = squat.load_case("smooth-rail", mesh="tiny")
        again.update({key: value for key, value in values.items() if value != again[key]})
        self.assertEqual(again.hash, self.case.hash)

    def test_the_path_in_a_message_stays_as_it_is(self):
        with self.assertRaises(squat.FileError) as raised:
            squat.load_case("folder/a --speed b--c.toml")
        self.assertTrue(str(raised.exception).startswith("folder/a --speed b--c.toml: "), raised.exception)

    def test_a_copy_is_changed_by_itself(self):
        copy = self.case.copy()
        copy["defect.depth"] = 0.2
        self.assertNotEqual(self.case["defect.depth"], 0.2)

    def test_a_case_can_be_pickled(self):
        self.case.update({"defect.shape": "profile", "defect.points": [[-20, 0], [0, -0.1], [20, 0]]})
        again = pickle.loads(pickle.dumps(self.case))
        self.assertEqual(dict(again), dict(self.case))
        self.assertEqual((again.hash, again.name), (self.case.hash, self.case.name))

    def test_text_and_file_give_the_same_case_back(self):
        self.case["pad.stiffness"] = 900
        self.assertEqual(squat.parse_case(self.case.toml()).hash, self.case.hash)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "own.toml")
            self.case.save(path)
            self.assertEqual(squat.load_case(path).hash, self.case.hash)

    def test_shipped_cases_are_the_files_of_their_folder(self):
        files = sorted(path.stem for path in (program.SOURCE / "resources/cases").glob("*.toml"))
        self.assertEqual(squat.shipped_cases(), files)

    def test_every_name_has_a_docstring(self):
        for name in squat.__all__:
            if name.startswith("__"):
                continue
            thing = getattr(squat, name)
            self.assertTrue(thing.__doc__, name)
            if isinstance(thing, type):
                for member, value in vars(thing).items():
                    if not member.startswith("_"):
                        self.assertTrue(value.__doc__, f"{name}.{member}")


if __name__ == "__main__":
    unittest.main()
