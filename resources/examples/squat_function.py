"""squat_function.py - a run of squat as a function of numbers, for OpenTURNS, SALib or any other loop in Python."""

import pathlib
import subprocess
import tempfile


def evaluate(case, values, features, options=()):
    """Features of one run, a list of numbers. `values`: key to number, in the unit of the case file; `features`: their
    names in one word, without unit; `options`: more words of the call, for example ["--mesh", "draft"].
    RuntimeError with squat's own words where the run fails."""
    lines = [f"{len(values)} variables"] + [f"{value!r} {key}" for key, value in values.items()]
    lines += [f"{len(features)} functions"] + [f"1 ASV_{i + 1}:{name}" for i, name in enumerate(features)]
    with tempfile.TemporaryDirectory() as folder:
        parameters, results = pathlib.Path(folder, "params.in"), pathlib.Path(folder, "results.out")
        parameters.write_text("\n".join(lines) + "\n")
        call = ["squat", "run", case, *options, "--parameters", str(parameters), "--results", str(results)]
        ended = subprocess.run(call, capture_output=True, text=True)
        if ended.returncode != 0:
            raise RuntimeError(ended.stderr.strip().splitlines()[-1] if ended.stderr else "squat failed")
        return [float(line.split()[0]) for line in results.read_text().splitlines()]
