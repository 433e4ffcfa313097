#!/usr/bin/env python3
"""Computes passages over joints, welds, corrugation and crossings of shapes that no example of the program has.

    other_shapes.py FOLDER [--vehicles N] [--first K] [--shapes N] [--squat PROGRAM] [--seed S] [--jobs N]

For the vehicles that make_examples.py draws with the same seed, each passage is a run of its own on the mesh tiny. They
are kept in FOLDER/vehicle-NNN beside those of make_examples.py --passages, for evaluate_detection.py. Shapes that are
too steep for the mesh are left out. Dimensions are assumed. Needs Python 3 and squat; a passage takes some 15 s.
"""
import argparse
import concurrent.futures
import math
import pathlib
import random
import shutil
import subprocess

import make_examples


def joint(rng):
    """Ends that dip as an exponential; heights in mm of positions in m."""
    angle, reach, gap = rng.uniform(5e-3, 20e-3), rng.uniform(0.05, 0.18), rng.uniform(5e-3, 20e-3)
    step = rng.uniform(-0.4, 0.4)

    def height(x):
        z = -5e2 * angle * reach * math.exp(-abs(x) / reach) + (step * math.exp(-x / 0.1) if x > 0 else 0)
        return min(z, -5e2 * angle * reach) - math.cos(math.pi * x / gap) if abs(x) < gap / 2 else z
    return "joint", height, 4 * reach


def insulated_joint(rng):
    """A flat filling, lips beside it."""
    low, width, lip, angle = rng.uniform(0.08, 0.3), rng.uniform(6e-3, 14e-3), rng.uniform(0, 0.05), rng.uniform(1e-3, 5e-3)

    def height(x):
        z = -75 * angle * math.exp(-abs(x) / 0.15)
        if abs(x) < width / 2:
            return z - low * (1 - (2 * x / width) ** 4)
        return z + (lip * math.sin(math.pi * (2 * abs(x) / width - 1)) if abs(x) < width else 0)
    return "joint", height, 0.5


def bell_weld(rng):
    width = rng.uniform(0.04, 0.3)
    size = rng.uniform(0.05, 0.4) * rng.choice((-1, 1))
    size = max(-8 * width, min(8 * width, size))
    return "weld", lambda x: size * math.exp(-0.5 * (2.5 * x / width) ** 2), 1.2 * width


def wave_weld(rng):
    length, size = rng.uniform(0.2, 0.8), rng.uniform(0.1, 0.35)
    return ("weld", lambda x: size * math.sin(2 * math.pi * x / length) * math.cos(math.pi * x / length) ** 2
            if abs(x) < length / 2 else 0.0, length / 2)


def corrugation(rng):
    """Two wavelengths that beat."""
    count, wave, size = rng.randint(4, 18), rng.uniform(0.025, 0.08), rng.uniform(0.03, 0.1)
    other, half = wave * rng.uniform(1.05, 1.2), count * wave / 2

    def height(x):
        if abs(x) >= half:
            return 0.0
        waves = 0.6 * math.sin(2 * math.pi * x / wave) + 0.4 * math.sin(2 * math.pi * x / other + 1)
        return 0.5 * size * math.sqrt(1 - (x / half) ** 2) * waves
    return "corrugation", height, half


def crossing(rng):
    angle, before, behind = rng.uniform(4e-3, 16e-3), rng.uniform(0.15, 0.4), rng.uniform(0.15, 0.4)
    step = rng.uniform(0.1, 0.6)

    def height(x):
        if x < 0:
            return -5e2 * angle * max(0.0, before + x)
        return (-5e2 * angle * before - step) * max(0.0, 1 - x / behind)
    return "other", height, max(before, behind)


SHAPES = (joint, bell_weld, corrugation, insulated_joint, joint, crossing, wave_weld, corrugation)


def passage(arguments, vehicle, index, keys):
    kind, height, half = SHAPES[index % len(SHAPES)](random.Random(7919 * vehicle + index))
    folder = arguments.folder / f"vehicle-{vehicle:03d}"
    table = folder / f"{kind}-{100 + index}.csv"
    if table.exists():
        return
    folder.mkdir(parents=True, exist_ok=True)
    half += 0.03
    step = 5e-4 if half < 0.1 else 1e-3
    count = int(2 * half / step)
    points = [(-half + step * i, 0.0) for i in range(count + 1)]
    points = [(x, height(x) * min(1, max(0, (half - abs(x)) / 0.03))) for x, _ in points]
    profile, run = folder / f"profile-{index}.txt", folder / f"run-{index}"
    profile.write_text("position [mm],height [mm]\n" + "".join(f"{1e3 * x:.2f},{z:.5f}\n" for x, z in points))
    deepest = min(points, key=lambda point: point[1])[0]
    run_up, beyond = max(0.35, half + deepest + 0.12), max(0.6, half - deepest + 0.25)
    keys = keys | {"defect.shape": "profile", "defect.file": str(profile.resolve()), "motion.run_up": run_up,
                   "motion.beyond": beyond, "track.length": run_up + beyond + 2.6}
    call = [arguments.squat, "run", "light-defect", "--mesh", "tiny", "--threads", "1", "--no-figures", "-o", str(run)]
    for key, value in keys.items():
        call += ["--set", f"{key}={value if isinstance(value, str) else format(value, '.5g')}"]
    ended = subprocess.run(call, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    found = next(run.glob("*.csv"), None)
    if ended.returncode or not found:
        print(f"{table}: left out: {ended.stderr.strip().splitlines()[-1:]}")
    else:
        lines = [line for line in found.read_text().splitlines() if not line.startswith("#")]
        names = [field.split(" [")[0] for field in lines[0].split(",")]
        columns = [names.index(name) for name in ("time", "position", "aba")]
        rows = (",".join(line.split(",")[c] for c in columns) for line in lines[1:])
        table.write_text(f"# {kind}, 0.00 mm x 0.0000 mm, {keys['motion.speed']:.3f} m/s\n"
                         "time [s],position [m],aba [m/s2]\n" + "\n".join(rows) + "\n")
    shutil.rmtree(run, ignore_errors=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--vehicles", type=int, default=4)
    parser.add_argument("--first", type=int, default=0, help="number of the first vehicle")
    parser.add_argument("--shapes", type=int, default=16, help="passages of each vehicle")
    parser.add_argument("--squat", default="squat", help="the program")
    parser.add_argument("--seed", type=int, default=9)
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    tasks = []
    for vehicle in range(arguments.first, arguments.first + arguments.vehicles):
        keys = make_examples.vehicle(random.Random(1000 * arguments.seed + vehicle))
        tasks += [(vehicle, index, keys) for index in range(arguments.shapes)]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        list(pool.map(lambda task: passage(arguments, *task), tasks))


if __name__ == "__main__":
    main()
