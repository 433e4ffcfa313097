#!/usr/bin/env python3
"""Computes the table of examples that squat detect ships: passages over known squats and other irregularities.

    make_examples.py FOLDER [--vehicles N] [--first K] [--squat PROGRAM] [--seed S] [--passages] [--sides]

For each of N vehicles and tracks (presets of the program, their inputs varied within plausible ranges, any speed and any
distance from the sleeper) one call of squat examples on the mesh tiny writes FOLDER/vehicle-NNN.csv; a vehicle whose
table stands there already is not computed again. FOLDER/examples.csv is all of them. With --passages the signals are
kept in FOLDER/vehicle-NNN, for evaluate_detection.py. With --sides, models are whole, with the defect on the left rail
alone and pads of the right rail up to a fifth softer or stiffer; combine_examples.py adds such tables to others. Ranges are
assumed; none comes from a measurement. Needs Python 3 and squat. A vehicle with 15 squats, six others and two flats takes
some minutes on two cores, more where others run on a track of their own.
"""
import argparse
import math
import pathlib
import random
import subprocess


def vehicle(rng):
    """Keys of one vehicle on one track; a trailer wheelset half of the time."""
    keys = {
        "wheelset.preset": rng.choice(("estimated", "trailer")),
        "track.preset": rng.choice(("estimated", "soft-pads", "stiff-pads")),
        "motion.speed": rng.uniform(16, 44),
        "motion.angular_velocity": 0,
        "motion.torque": 0,
        "track.defect_from_sleeper": rng.uniform(-0.3, 0.3),
        "wheelset.axle_box_mass": rng.uniform(70, 170),
        "wheelset.web_thickness": rng.uniform(25, 36),
        "suspension.sprung_mass": rng.uniform(4500, 9000),
        "pad.stiffness": math.exp(rng.uniform(math.log(150), math.log(1800))),
        "pad.damping": rng.uniform(20, 60),
        "ballast.stiffness": rng.uniform(30, 100),
    }
    if keys["wheelset.preset"] == "trailer":
        keys["wheelset.journal_radius"] = rng.uniform(62, 75)
        keys["wheelset.bearing_centre"] = rng.uniform(232, 249)
    return keys


def compute(arguments, index, path):
    call = [arguments.squat, "examples", "light-defect", "--mesh", "tiny", "--squats", str(arguments.squats),
            "--others", str(arguments.others), "--flats", str(arguments.flats),
            "--seed", str(1000 * arguments.seed + index), "-o", str(path)]
    if arguments.passages:
        call += ["--passages", str(path.with_suffix(""))]
    rng = random.Random(1000 * arguments.seed + index)
    keys = vehicle(rng)
    if arguments.sides:
        keys |= {"model.extent": "whole", "right.defect.shape": "none",
                 "right.pad.stiffness": keys["pad.stiffness"] * math.exp(rng.uniform(-0.2, 0.2))}
    for key, value in keys.items():
        call += ["--set", f"{key}={value if isinstance(value, str) else format(value, '.5g')}"]
    ended = subprocess.run(call, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    if ended.returncode:
        print(f"{path}: exit {ended.returncode}: {ended.stderr.strip().splitlines()[-1:]}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--vehicles", type=int, default=24)
    parser.add_argument("--first", type=int, default=0, help="number of the first vehicle")
    parser.add_argument("--squats", type=int, default=15, help="passages over squats of each vehicle")
    parser.add_argument("--others", type=int, default=6, help="passages over joints, welds, crossings, corrugation")
    parser.add_argument("--flats", type=int, default=2, help="passages of wheels with a flat")
    parser.add_argument("--squat", default="squat", help="the program")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--passages", action="store_true", help="keep the signals")
    parser.add_argument("--sides", action="store_true", help="whole models with the defect on one rail")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    for index in range(arguments.first, arguments.first + arguments.vehicles):
        path = arguments.folder / f"vehicle-{index:03d}.csv"
        if not path.exists():
            compute(arguments, index, path)
    tables = [path.read_text().splitlines() for path in sorted(arguments.folder.glob("vehicle-*.csv"))]
    lines = tables[0][:1] + [line for table in tables for line in table[1:]] if tables else []
    (arguments.folder / "examples.csv").write_text("\n".join(lines) + "\n")


if __name__ == "__main__":
    main()
