"""Receptance and decay rates, against the tables that `squat receptance` writes."""

import csv
import pathlib
import tempfile
import unittest

import numpy
import squat

import program


def table(path):
    with open(path, newline="") as file:
        head, *rows = csv.reader(file)
    return dict(zip(head, numpy.array([[float(cell or "nan") for cell in row] for row in rows]).T))


def computed(*words, ends=("-receptance", "-decay-rate")):
    """The table of a call for the light defect."""
    with tempfile.TemporaryDirectory() as folder:
        program.squat("receptance", "light-defect", "--mesh", "tiny", *words, "--format", "svg", "-o", folder)
        (path,) = [path for path in pathlib.Path(folder).glob("light-defect-*.csv") if path.stem.endswith(ends)]
        return table(path)


class Receptance(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.case = squat.load_case("light-defect", mesh="tiny")

    def assert_as_in(self, found, columns, unit):
        self.assertEqual(found.unit, unit)
        self.assertTrue(numpy.array_equal(found.frequency, columns["frequency [Hz]"]))
        for name in found:
            self.assertEqual(found[name].dtype, numpy.complex128)
            for values, part in ((found[name].real, "real"), (found[name].imag, "imaginary")):
                self.assertTrue(numpy.array_equal(values, columns[f"{name} {part} [{unit}]"]), f"{name} {part}")

    def test_over_a_sleeper_and_at_midspan(self):
        found = squat.receptance(self.case, lowest=100, highest=400, step=20)
        self.assertEqual(found.keys(), ["over a sleeper", "midspan"])
        self.assert_as_in(found, computed("--from", 100, "--to", 400, "--step", 20), "m/N")
        array = found["midspan"]
        self.assertIs(array.base, found)
        self.assertFalse(array.flags.writeable)
        # A force and the displacement at its place: on the whole the track dissipates, so that it lags.
        self.assertTrue(numpy.all(array.imag < 0))

    def test_places_directions_and_quantities(self):
        found = squat.receptance(
            self.case, at=[0.15], struck=0.3, lateral=True, one_rail=True, quantity="mobility",
            lowest=100, highest=200, step=50,
        )  # fmt: skip
        words = ["--at", 0.15, "--struck", 0.3, "--lateral", "--one-rail", "--quantity", "mobility"]
        self.assert_as_in(found, computed(*words, "--from", 100, "--to", 200, "--step", 50), "m/s/N")

    def test_a_sleeper_by_itself(self):
        found = squat.receptance(self.case, sleeper=True, lowest=100, highest=400)
        columns = computed("--sleeper", "--from", 100, "--to", 400)
        self.assertTrue(numpy.array_equal(found.frequency, columns["frequency [Hz]"]))

    def test_what_does_not_go_together_is_a_case_error(self):
        for wrong in (
            {"lowest": 500, "highest": 100},
            {"step": 0},
            {"quantity": "impedance"},
            {"endless": True, "step": 1},
            {"sleeper": True, "at": [0.1]},
            {"lowest": float("nan")},
            {"at": [1e6]},
        ):
            with self.assertRaises(squat.CaseError, msg=str(wrong)):
                squat.receptance(self.case, **wrong)

    def test_a_track_that_nothing_damps_is_a_run_error(self):
        case = self.case.copy()
        case.update({key: 0 for key in case if key.startswith(("pad.", "ballast.")) and key.endswith("damping")})
        with self.assertRaises(squat.RunError) as raised:
            squat.receptance(case, endless=True, lowest=100, highest=200)
        self.assertIn("nothing damps", str(raised.exception))
        self.assertEqual((raised.exception.step, raised.exception.partial), (0, None))
        self.assertIsInstance(raised.exception, squat.Error)

    def test_modes_say_whether_both_sides_move_alike(self):
        modes = squat.receptance(self.case, lowest=100, highest=200, step=50).modes
        columns = computed("--from", 100, "--to", 200, "--step", 50, ends="-wheelset-modes")
        self.assertEqual(len(modes["antisymmetric"]), len(modes["frequency"]))
        self.assertTrue(numpy.allclose(modes["frequency"], columns["frequency [Hz]"], rtol=1e-5))
        self.assertEqual([float(one) for one in modes["antisymmetric"]], list(columns["antisymmetric"]))
        # A free wheelset bends and twists in both ways.
        self.assertEqual({True, False}, set(modes["antisymmetric"]))

    def test_an_unknown_place_is_a_key_error(self):
        found = squat.receptance(self.case, lowest=100, highest=200, step=50)
        with self.assertRaises(KeyError) as raised:
            found["midspn"]
        self.assertIn("midspan", str(raised.exception))
        self.assertNotIn("midspn", found)


class DecayRates(unittest.TestCase):
    def test_decay_rates(self):
        rates = squat.decay_rates(squat.load_case("light-defect", mesh="tiny"))
        columns = computed("--decay")
        for values, name in ((rates.band, "frequency [Hz]"), (rates.vertical, "vertical [dB/m]"),
                             (rates.lateral, "lateral [dB/m]")):  # fmt: skip
            self.assertTrue(numpy.array_equal(values, columns[name]), name)
        self.assertIs(rates.vertical.base, rates)


if __name__ == "__main__":
    unittest.main()
