"""Runs and results: a run gives what `squat run` writes for the same case, bit for bit, as h5py and csv read it; arrays
show the memory of the result."""

import csv
import gc
import pathlib
import tempfile
import tracemalloc
import unittest
import weakref

import h5py
import numpy
import squat

import program


def tiny():
    return squat.load_case("light-defect", mesh="tiny", **{"defect.depth": 0.15})


class YieldingRail(unittest.TestCase):
    def test_permanent_change_and_plastic_strain(self):
        case = tiny()
        case["rail.plastic"] = True
        result = squat.run(case)
        with tempfile.TemporaryDirectory() as folder:
            words = ["--mesh", "tiny", "--set", "defect.depth=0.15", "--set", "rail.plastic=true", "--no-figures"]
            program.squat("run", "light-defect", *words, "-o", folder)
            with h5py.File(folder + "/light-defect.h5") as file:
                self.assertEqual(set(result.permanent), set(file["permanent"]))
                for name, array in result.permanent.items():
                    self.assertEqual(array.shape, file["permanent/" + name].shape)
                    self.assertTrue(numpy.array_equal(array, file["permanent/" + name][()]), name)
                self.assertEqual(result.plasticity, {name: value[()] for name, value in file["plasticity"].items()})
                last = list(file["fields"].values())[-1]
                self.assertTrue(numpy.array_equal(result.snapshots[-1]["plastic_strain"], last["plastic_strain"][()]))


class WholeModel(unittest.TestCase):
    def test_patches_hold_both_contacts(self):
        case = tiny()
        case.update({"model.extent": "whole", "right.defect.shape": "none"})
        case.update({"motion.run_up": 0.06, "motion.beyond": 0.06})
        result = squat.run(case)
        for patch in result.patches:
            # The right rail is smooth: its contact carries the load at rest, but for the ripple of a coarse mesh.
            force = float((patch["pressure_right"].astype(float) * patch["area_right"]).sum())
            at_rest = result.equilibrium["contact_force_right"]
            self.assertLess(abs(force - at_rest), 0.2 * at_rest, patch["name"])


class Results(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.place = tempfile.TemporaryDirectory()
        cls.folder = pathlib.Path(cls.place.name)
        words = ["--mesh", "tiny", "--set", "defect.depth=0.15", "--no-figures", "-o", cls.folder]
        program.squat("run", "light-defect", *words)
        cls.reports = []
        cls.result = squat.run(tiny(), progress=lambda phase, fraction: cls.reports.append((phase, fraction)))
        cls.file = h5py.File(cls.folder / "light-defect.h5")

    @classmethod
    def tearDownClass(cls):
        cls.file.close()
        cls.place.cleanup()

    def assert_same(self, array, name):
        dataset = self.file[name]
        self.assertEqual(array.dtype, dataset.dtype, name)
        self.assertEqual(array.shape, dataset.shape, name)
        self.assertTrue(numpy.array_equal(array, dataset[()]), name)

    def test_signals(self):
        self.assertEqual(set(self.result.keys()), set(self.file["signals"]))
        for name in self.result.keys():
            self.assert_same(self.result[name], "signals/" + name)
            self.assertEqual(self.result.units[name], self.file["signals/" + name].attrs["unit"])
        self.assert_same(self.result.time, "signals/time")
        self.assert_same(self.result.position, "signals/position")

    def test_signals_as_csv(self):
        with open(self.folder / "light-defect.csv", newline="") as file:
            head, *rows = csv.reader(file)
        columns = numpy.array(rows, dtype=float).T
        self.assertEqual(len(head), len(self.result))
        for heading, column in zip(head, columns):
            name, unit = heading.rstrip("]").split(" [")
            self.assertTrue(numpy.array_equal(self.result[name], column), heading)
            self.assertEqual(self.result.units[name], unit)

    def test_spectra(self):
        for name in ("frequency", "psd", "psd_wheel"):
            self.assert_same(getattr(self.result, name), "spectra/" + name)
        for name in ("frequency", "time", "position"):
            self.assert_same(getattr(self.result, "scalogram_" + name), "scalogram/" + name)
        self.assert_same(self.result.scalogram, "scalogram/power")
        self.assert_same(self.result.cone_of_influence, "scalogram/cone_of_influence")
        for name, dataset in (("psd", "spectra/psd"), ("scalogram", "scalogram/power")):
            self.assertEqual(self.result.units[name], self.file[dataset].attrs["unit"])

    def test_numbers(self):
        for group in ("features", "equilibrium"):
            numbers = getattr(self.result, group)
            self.assertEqual(set(numbers), set(self.file[group]))
            for name, value in numbers.items():
                numpy.testing.assert_equal(value, self.file[f"{group}/{name}"][()], name)  # nan where there is none
                self.assertEqual(self.result.units[f"{group}/{name}"], self.file[f"{group}/{name}"].attrs["unit"])
        self.assertEqual(self.result.mesh["elements"], self.file["mesh/elements"][()])

    def test_energy_profile_and_modes(self):
        for name, array in self.result.energy.items():
            self.assert_same(array, "energy/" + name)
            if name != "time":
                self.assertEqual(self.file["energy/" + name].attrs["unit"], "J")  # as the docstring says of all
        for group in ("profile", "modes"):
            arrays = getattr(self.result, group)
            self.assertEqual(set(arrays), set(self.file[group]))
            for name, array in arrays.items():
                self.assert_same(array, f"{group}/{name}")

    def test_fields(self):
        for name in ("points", "quads", "part", "springs"):
            self.assert_same(self.result.surface[name], "mesh/surface/" + name)
        self.assertEqual(len(self.result.snapshots), len(self.file["fields"]))
        for snapshot, group in zip(self.result.snapshots, self.file["fields"].values()):
            self.assertEqual(snapshot["name"], group.attrs["name"])
            self.assert_same(snapshot["displacement"], group.name + "/displacement")
            self.assert_same(snapshot["von_mises"], group.name + "/von_mises")
        self.assertEqual(len(self.result.patches), len(self.file["patch"]))
        for patch, group in zip(self.result.patches, self.file["patch"].values()):
            for name in ("x", "y", "pressure", "traction_x", "traction_y", "slipping", "area"):
                self.assert_same(patch[name], f"{group.name}/{name}")
                self.assertNotIn(name + "_right", patch)  # of a half model

    def test_facts(self):
        for name in ("complete", "stop_reason", "title", "case_hash"):
            self.assertEqual(getattr(self.result, name), self.file.attrs[name])
        self.assertEqual(self.result.name, self.file.attrs["stem"])
        self.assertEqual(self.result.case["defect.depth"], 0.15)
        self.assertEqual(self.result.case.hash, tiny().hash)

    def test_progress_goes_through_the_phases(self):
        phases = [phase for phase, _ in self.reports]
        self.assertIn("rolling", phases)
        self.assertLess(phases.index("equilibrium"), phases.index("rolling"))
        rolling = [fraction for phase, fraction in self.reports if phase == "rolling"]
        self.assertEqual(rolling, sorted(rolling))
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction in self.reports))

    def test_a_result_that_is_read_and_saved_stays_the_same(self):
        read = squat.read_result(self.folder / "light-defect.h5")
        for name in self.result.keys():
            self.assertTrue(numpy.array_equal(read[name], self.result[name]), name)
        self.result.save(self.folder / "saved.h5")
        with h5py.File(self.folder / "saved.h5") as saved:
            for name in self.file["signals"]:
                self.assertTrue(numpy.array_equal(saved["signals/" + name][()], self.file["signals/" + name][()]), name)
        self.result.save_signals(self.folder / "saved.csv")
        self.assertEqual((self.folder / "saved.csv").read_text(), (self.folder / "light-defect.csv").read_text())

    def test_without_fields(self):
        read = squat.read_result(self.folder / "light-defect.h5", fields=False)
        self.assertEqual((read.snapshots, read.patches), ([], []))
        self.assert_same(read["aba"], "signals/aba")

    def test_arrays_are_the_memory_of_the_result(self):
        for get in (
            lambda: self.result.time,
            lambda: self.result["aba_filtered"],
            lambda: self.result.scalogram,
            lambda: self.result.modes["frequency"],
            lambda: self.result.snapshots[0]["displacement"],
        ):
            self.assertIs(get().base, self.result)
            self.assertEqual(get().__array_interface__["data"][0], get().__array_interface__["data"][0])
            self.assertFalse(get().flags.owndata)

    def test_no_array_is_copied(self):
        # NumPy tells tracemalloc of every buffer that it takes.
        tracemalloc.start()
        arrays = [self.result.scalogram, self.result["aba"], self.result.surface["points"]]
        arrays += [snapshot["displacement"] for snapshot in self.result.snapshots]
        _, peak = tracemalloc.get_traced_memory()
        tracemalloc.stop()
        size = sum(array.nbytes for array in arrays)
        self.assertGreater(size, 1e6)
        self.assertLess(peak, size / 20)  # objects and dicts

    def test_arrays_are_read_only(self):
        for array in (self.result.time, self.result.scalogram, self.result.surface["points"]):
            with self.assertRaises(ValueError):
                array[0] = 0
            with self.assertRaises(ValueError):
                array.setflags(write=True)

    def test_an_array_keeps_its_result_alive(self):
        result = squat.read_result(self.folder / "light-defect.h5")
        alive = weakref.ref(result)
        array = result["aba"]
        del result
        gc.collect()
        self.assertIsNotNone(alive())
        self.assert_same(array, "signals/aba")
        del array
        gc.collect()
        self.assertIsNone(alive())

    def test_what_is_no_signal_is_a_key_error(self):
        with self.assertRaises(KeyError) as raised:
            self.result["abba"]
        self.assertIn("aba_filtered", str(raised.exception))

    def test_a_file_that_is_no_result_is_a_file_error(self):
        with self.assertRaises(squat.FileError) as raised:
            squat.read_result(self.folder / "light-defect.csv")
        self.assertEqual(raised.exception.path, str(self.folder / "light-defect.csv"))


if __name__ == "__main__":
    unittest.main()
