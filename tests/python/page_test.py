"""Every block of Python on the manual's page is run, in order and as it stands, in an empty folder; estimates with
fewer runs."""

import functools
import os
import re
import tempfile
import unittest

import squat

import program

PAGE = program.SOURCE / "resources/manual/python.md"
FOR_A_SHELL = re.compile(r"\./bootstrap|export |cmake |/usr/bin/python3 |python3 |PYTHONPATH=")


def blocks():
    """First line and text of each indented block that is Python."""
    lines, block, first = PAGE.read_text().splitlines(), [], 0
    for number, line in enumerate([*lines, "end"], start=1):
        if line.startswith("    ") or (block and not line):
            first = first or number
            block.append(line[4:])
        elif block:
            text = "\n".join(block)
            if not FOR_A_SHELL.match(text):
                yield first, text
            block, first = [], 0


class Page(unittest.TestCase):
    def test_every_block_runs(self):
        names, count, before = {}, 0, os.getcwd()
        whole = squat.estimate
        squat.estimate = functools.partial(whole, runs=20, longest=20)
        with tempfile.TemporaryDirectory() as folder:
            os.chdir(folder)
            try:
                for first, text in blocks():
                    with self.subTest(line=first):
                        exec(compile("\n" * (first - 1) + text, str(PAGE), "exec"), names)
                        count += 1
            finally:
                os.chdir(before)
                squat.estimate = whole
        self.assertGreater(count, 8)


if __name__ == "__main__":
    unittest.main()
