"""The command line, which the module is compared with."""

import os
import pathlib
import subprocess

SOURCE = pathlib.Path(os.environ["SQUAT_SOURCE"])


def squat(*words):
    """What `squat WORDS` prints."""
    call = [os.environ["SQUAT_PROGRAM"], *map(str, words)]
    return subprocess.run(call, check=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, text=True).stdout
