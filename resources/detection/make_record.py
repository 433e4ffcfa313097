#!/usr/bin/env python3
"""Makes the record that the program ships, resources/records/example-record.csv, and what is in it.

    make_record.py FOLDER [--squat PROGRAM] [--seed S]

300 m at 30 m/s and 5 kHz: three light, two moderate and two severe squats, two joints, two welds, a wheel flat of
0.46 m radius over the last third, and noise. Passages are computed by the solver on the mesh tiny (vehicle and track of
the case light-defect), noise is coloured Gaussian noise of 1.2 m/s2. FOLDER gets the passages, the record and
example-record-truth.csv. Needs Python 3 and squat.
"""
import argparse
import csv
import math
import pathlib
import random
import subprocess

SPEED, RATE, LENGTH, SIGMA = 30.0, 5000, 300.0, 1.2
CIRCUMFERENCE = 2 * math.pi * 0.46

# kind, place [m], shape keys; a profile is a function of the position [mm] and its half length [mm]
SQUATS = [
    (18.0, {"defect.shape": "cosine", "defect.length": 24, "defect.depth": 0.06}),
    (52.5, {"defect.shape": "w-shape", "defect.length": 48, "defect.depth": 0.16}),
    (74.2, {"defect.shape": "cosine", "defect.length": 30, "defect.depth": 0.09}),
    (101.0, {"defect.shape": "cosine", "defect.length": 75, "defect.depth": 0.32}),
    (137.7, {"defect.shape": "dip-with-wave", "defect.length": 50, "defect.depth": 0.2, "defect.wave_depth": 0.04}),
    (160.9, {"defect.shape": "cosine", "defect.length": 20, "defect.depth": 0.05}),
    (244.0, {"defect.shape": "w-shape", "defect.length": 85, "defect.depth": 0.4}),
]


def joint(x):
    ends = -0.4 * max(0.0, 1 - abs(x) / 220) ** 1.5
    return ends - (0.3 if abs(x) < 3.5 else 0.0)


def weld(x):
    return -0.11 * (1 + math.cos(2 * math.pi * x / 320)) if abs(x) < 160 else 0.0


OTHERS = [("joint", 36.3, joint, 240), ("weld", 88.1, weld, 180), ("joint", 121.4, joint, 240), ("weld", 181.0, weld, 180)]
FLAT_FROM, FLAT_TO = 200.0, 290.0
FLAT = {"defect.shape": "cosine", "defect.length": 34, "defect.depth": 0.07}


def passage(arguments, name, keys):
    """Positions [m] and axle box acceleration [m/s2] at 25 kHz."""
    folder = arguments.folder / "passages"
    table = folder / f"{name}.csv"
    if not table.exists():
        case = folder / f"{name}.toml"
        folder.mkdir(parents=True, exist_ok=True)
        case.write_text('[wheelset]\npreset = "estimated"\n[track]\npreset = "estimated"\n')
        call = [arguments.squat, "run", str(case), "--mesh", "tiny", "--no-figures", "-o", str(folder)]
        for key, value in {"motion.torque": 0, "motion.beyond": 0.5, **keys}.items():
            call += ["--set", f"{key}={value}"]
        subprocess.run(call, check=True, stdout=subprocess.DEVNULL)
    with table.open() as file:
        rows = list(csv.reader(line for line in file if not line.startswith("#")))
    names = [field.split(" [")[0] for field in rows[0]]
    position, aba = names.index("position"), names.index("aba")
    return [float(row[position]) for row in rows[1:]], [float(row[aba]) for row in rows[1:]]


def low_passed(values, factor):
    """Windowed sinc at 0.45 of the reduced rate, every factor-th value."""
    half = 12 * factor
    kernel = [(0.9 / factor if i == 0 else math.sin(0.9 * math.pi * i / factor) / (math.pi * i))
              * (0.5 + 0.5 * math.cos(math.pi * i / (half + 1))) for i in range(-half, half + 1)]
    result = []
    for centre in range(0, len(values), factor):
        result.append(sum(k * values[min(max(centre + i - half, 0), len(values) - 1)] for i, k in enumerate(kernel)))
    return result


def add(record, place, positions, values):
    step = SPEED / RATE
    first = (place + positions[0]) / step
    start, share = int(math.floor(first)), first - math.floor(first)
    fade = max(1, len(values) // 20)
    for i in range(len(values) - 1):
        gain = min(1.0, i / fade, (len(values) - 1 - i) / fade)
        index = start + i + 1
        if 0 <= index < len(record):
            record[index] += gain * (values[i] * share + values[i + 1] * (1 - share))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--squat", default="squat", help="the program")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    rng = random.Random(arguments.seed)
    count = int(LENGTH / SPEED * RATE)
    record, slow = [], 0.0
    for _ in range(count):  # noise with a third of its power below 200 Hz
        slow = 0.78 * slow + rng.gauss(0, 0.45 * SIGMA)
        record.append(rng.gauss(0, 0.75 * SIGMA) + 0.9 * slow)
    truth = []
    for number, (place, keys) in enumerate(SQUATS):
        positions, values = passage(arguments, f"squat-{number}", keys)
        add(record, place, positions[::5], low_passed(values, 5))
        truth.append((place, "squat", keys["defect.length"], keys["defect.depth"]))
    for number, (kind, place, height, half) in enumerate(OTHERS):
        path = arguments.folder / f"{kind}-{number}-profile.csv"
        arguments.folder.mkdir(parents=True, exist_ok=True)
        path.write_text("position [mm],height [mm]\n" + "".join(f"{x},{height(x):.5f}\n" for x in range(-half, half + 1)))
        keys = {"defect.shape": "profile", "defect.file": path.resolve(), "motion.run_up": 0.5, "track.length": 4}
        positions, values = passage(arguments, f"{kind}-{number}", keys)
        add(record, place, positions[::5], low_passed(values, 5))
        truth.append((place, kind, "", ""))
    positions, values = passage(arguments, "flat", FLAT)
    reduced, place = low_passed(values, 5), FLAT_FROM
    while place < FLAT_TO:
        add(record, place, positions[::5], reduced)
        truth.append((place, "flat", "", ""))
        place += CIRCUMFERENCE
    with (arguments.folder / "example-record.csv").open("w") as file:
        file.write("# Computed by resources/detection/make_record.py; what is in it: example-record-truth.csv. 30 m/s.\n")
        file.write("time [s],aba [m/s2]\n")
        file.writelines(f"{i / RATE:.4f},{value:.2f}\n" for i, value in enumerate(record))
    with (arguments.folder / "example-record-truth.csv").open("w") as file:
        file.write("position [m],kind,length [mm],depth [mm]\n")
        file.writelines(f"{place:.3f},{kind},{length},{depth}\n" for place, kind, length, depth in sorted(truth))


if __name__ == "__main__":
    main()
