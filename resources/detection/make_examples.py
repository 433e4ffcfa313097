#!/usr/bin/env python3
"""Computes the passages from which squat detect takes kinds and severities, with the solver itself.

    make_examples.py FOLDER [--vehicles N] [--first K] [--squat PROGRAM] [--seed S]

For each of N vehicles and tracks (presets of the program, varied within plausible ranges, any speed and distance from
the sleeper) one study of squats and one of other irregularities on the mesh tiny. The result files stay in
FOLDER/VEHICLE/squats and FOLDER/VEHICLE/others; a call that was stopped resumes. Then

    squat examples FOLDER -o examples.csv

makes the table that the program ships. Needs nothing but Python and squat on the PATH.
"""
import argparse
import math
import pathlib
import random
import subprocess

# Squats by convention (solver/detection/Severity.h): light up to 35 mm x 0.10 mm, moderate up to 60 mm x 0.25 mm.
LENGTHS = ((12, 35), (36, 60), (61, 95))  # mm
DEPTHS = ((0.03, 0.10), (0.105, 0.25), (0.26, 0.5))  # mm


def profile(path, heights, half, step):
    """A profile as a file: heights(x) in mm over -half..half mm."""
    count = int(round(2 * half / step))
    rows = [(-half + i * step) for i in range(count + 1)]
    path.write_text("position [mm],height [mm]\n" + "".join(f"{x:.2f},{heights(x):.5f}\n" for x in rows))


def joint(rng):
    """Insulated joint: a gap, rail ends that dip towards it, a step in height."""
    gap, dip, reach = rng.uniform(5, 9), rng.uniform(0.1, 0.8), rng.uniform(120, 350)
    step = rng.choice((-1, 1)) * rng.uniform(0.0, 0.2)

    def height(x):
        ends = -dip * max(0.0, 1 - abs(x) / reach) ** 1.5
        kink = step * max(0.0, 1 - x / reach) if x > 0 else 0.0
        return ends + kink - (0.3 if abs(x) < gap / 2 else 0.0)

    return height, reach + 20, 1.0


def weld(rng):
    """Weld: a smooth dip or hump of some decimetres, with a shallower waviness inside."""
    length, height, wave = rng.uniform(120, 600), rng.uniform(0.08, 0.4), rng.uniform(60, 150)
    sign, ripple = rng.choice((-1, -1, 1)), rng.uniform(0.0, 0.03)

    def shape(x):
        if abs(x) >= length / 2:
            return 0.0
        bell = 0.5 * (1 + math.cos(2 * math.pi * x / length))
        return bell * (sign * height + ripple * math.sin(2 * math.pi * x / wave))

    return shape, length / 2 + 20, 2.0


def vehicle(rng):
    """Keys of one vehicle on one track."""
    preset = rng.choice(("estimated", "trailer"))
    keys = {
        "motion.speed": rng.uniform(18, 42),
        "motion.torque": 0,
        "track.defect_from_sleeper": rng.uniform(-0.3, 0.3),
        "wheelset.axle_box_mass": rng.uniform(70, 170),
        "wheelset.web_thickness": rng.uniform(25, 36),
        "suspension.sprung_mass": rng.uniform(4500, 9000),
        "pad.stiffness": math.exp(rng.uniform(math.log(150), math.log(1800))),
        "pad.damping": rng.uniform(20, 60),
        "ballast.stiffness": rng.uniform(30, 100),
    }
    if preset == "trailer":
        keys["wheelset.journal_radius"] = rng.uniform(62, 75)
        keys["wheelset.bearing_centre"] = rng.uniform(232, 249)
    return preset, rng.choice(("estimated", "soft-pads", "stiff-pads")), keys


def study(arguments, keys, varied, folder, fixed):
    call = [arguments.squat, "study", "light-defect", "--mesh", "tiny", "--keep-results", "--no-figures", "-o", str(folder)]
    for key, value in {**keys, **fixed}.items():
        call += ["--set", f"{key}={value if isinstance(value, (int, str)) else format(value, '.5g')}"]
    for key, values in varied.items():
        call += ["--vary", f"{key}=" + ",".join(values)]
    folder.mkdir(parents=True, exist_ok=True)
    ended = subprocess.run(call, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if ended.returncode:
        print(f"{folder}: exit {ended.returncode}: {ended.stderr.strip().splitlines()[-1:]}")


def make(arguments, index):
    rng = random.Random(arguments.seed * 1000 + index)
    wheelset, track, keys = vehicle(rng)
    folder = pathlib.Path(arguments.folder) / f"vehicle-{index:03d}"
    presets = {"wheelset.preset": wheelset, "track.preset": track}
    shape = rng.choice(("cosine", "w-shape", "dip-with-wave", "cosine"))
    fixed = {**presets, "motion.beyond": 0.4, "defect.shape": shape}
    if shape == "dip-with-wave":
        fixed["defect.wave_depth"] = rng.uniform(0.01, 0.05)
    varied = {"defect.length": [f"{rng.uniform(*span):.1f}" for span in LENGTHS],
              "defect.depth": [f"{rng.uniform(*span):.3f}" for span in DEPTHS]}
    study(arguments, keys, varied, folder / "squats", fixed)
    files = []
    for kind, shaped, count in (("joint", joint, 2), ("weld", weld, 2)):
        for number in range(count):
            path = folder / f"{kind}-{number}.csv"
            folder.mkdir(parents=True, exist_ok=True)
            height, half, step = shaped(rng)
            profile(path, height, half, step)
            files.append(str(path.resolve()))
    fixed = {**presets, "motion.beyond": 0.6, "motion.run_up": 0.5, "track.length": 4, "defect.shape": "profile",
             "defect.file": files[0]}
    study(arguments, keys, {"defect.file": files}, folder / "others", fixed)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder")
    parser.add_argument("--vehicles", type=int, default=24)
    parser.add_argument("--first", type=int, default=0, help="number of the first vehicle")
    parser.add_argument("--squat", default="squat", help="the program")
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    for index in range(arguments.first, arguments.first + arguments.vehicles):
        make(arguments, index)


if __name__ == "__main__":
    main()
