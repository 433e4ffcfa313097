"""A run is ended by Ctrl-C and by an exception of its progress function, soon, and other threads go on meanwhile."""

import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import squat

SOON = 3.0  # [s]: a user waits no longer; ten times what an idle machine takes

SCRIPT = """
import squat, sys
squat.run(squat.load_case("light-defect", mesh="draft"), progress=lambda phase, fraction: print(phase, flush=True))
"""


class Told(Exception):
    pass


def long_case():
    return squat.load_case("light-defect", mesh="draft")  # half a minute on one core


class Cancel(unittest.TestCase):
    def test_ctrl_c_in_each_phase_ends_a_script(self):
        for wanted in ("equilibrium", "rolling"):
            with self.subTest(wanted):
                script = subprocess.Popen(
                    [sys.executable, "-c", SCRIPT], stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True
                )
                for line in script.stdout:
                    if line.strip() == wanted:
                        break
                sent = time.monotonic()
                script.send_signal(signal.SIGINT)
                _, said = script.communicate(timeout=60)
                took = time.monotonic() - sent
                print(f"Ctrl-C in {wanted}: {took:.2f} s", file=sys.stderr)
                self.assertIn("KeyboardInterrupt", said)
                self.assertEqual(script.returncode, -signal.SIGINT)
                self.assertLess(took, SOON)

    def test_a_run_after_ctrl_c_is_as_any_other(self):
        threading.Timer(1, os.kill, (os.getpid(), signal.SIGINT)).start()
        with self.assertRaises(KeyboardInterrupt):
            squat.run(long_case())
        self.assertTrue(squat.run(squat.load_case("light-defect", mesh="tiny"), fields=False).complete)

    def test_an_exception_of_progress_ends_the_run(self):
        raised = []

        def stop(phase, fraction):
            if phase == "rolling" and not raised:
                raised.append(time.monotonic())
                raise Told("enough")

        with self.assertRaises(Told) as told:
            squat.run(long_case(), progress=stop)
        took = time.monotonic() - raised[0]
        print(f"exception of progress: {took:.2f} s", file=sys.stderr)
        self.assertEqual(str(told.exception), "enough")
        self.assertLess(took, SOON)

    def test_progress_is_called_in_the_calling_thread(self):
        seen = set()
        squat.run(
            squat.load_case("light-defect", mesh="tiny"),
            progress=lambda phase, fraction: seen.add(threading.get_ident()),
        )
        self.assertEqual(seen, {threading.get_ident()})

    def test_other_threads_go_on(self):
        turns = []
        run = threading.Thread(target=squat.run, args=(squat.load_case("light-defect", mesh="tiny"),))
        run.start()
        while run.is_alive():
            turns.append(time.monotonic())
            time.sleep(0.01)
        longest = max(later - earlier for earlier, later in zip(turns, turns[1:]))
        self.assertGreater(len(turns), 20)
        self.assertLess(longest, 1.0)  # of a run of some seconds, had it kept the lock

    def test_search_and_receptance_are_cancelled_too(self):
        def stop(phase, fraction):
            raise Told

        case = squat.load_case("light-defect", mesh="tiny")
        for call in (
            lambda: squat.detect("example-record", speed=30, progress=stop),
            lambda: squat.receptance(case, progress=stop),
            lambda: squat.decay_rates(case, progress=stop),
        ):
            begun = time.monotonic()
            self.assertRaises(Told, call)
            self.assertLess(time.monotonic() - begun, 20)

    def test_an_impossible_number_of_threads_is_a_case_error(self):
        for threads in (-1, 5000):
            with self.assertRaises(squat.CaseError):
                squat.run(squat.load_case("light-defect", mesh="tiny"), threads=threads)


if __name__ == "__main__":
    unittest.main()
