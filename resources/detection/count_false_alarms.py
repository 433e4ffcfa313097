#!/usr/bin/env python3
"""Counts what squat detect lists in noise that holds nothing: kilometres of made noise, with the rate that is accepted.

    count_false_alarms.py FOLDER [--kilometres 40] [--rate 5000] [--speed 30] [--noise 3] [--roughness FILE]
                          [--false-alarms 0.1] [--seed S] [--squat PROGRAM]

The noise is coloured, or of the measured roughness in a table with a column for each wavelength ("1 cm [dB re 1 um]"):
another spectrum in each kilometre, through a track of four resonances; its level is even over the logarithm from half
of --noise to twice that. FOLDER gets noise.h5, which stays, and the list. Prints a line for each event and the time that
the program took. Needs Python 3, NumPy, h5py and squat; memory for a kilometre, disk for all.
"""
import argparse
import csv
import pathlib
import resource
import subprocess
import time

import h5py
import numpy

import evaluate_detection


def make(path, arguments):
    evaluate_detection.RATE = arguments.rate
    spectra = evaluate_detection.measured_spectra(arguments.roughness) if arguments.roughness else None
    rng = numpy.random.default_rng(arguments.seed)
    count = int(1000 / arguments.speed * arguments.rate)
    with h5py.File(path, "w") as file:
        data = file.create_dataset("aba", (arguments.kilometres * count,), "f4")
        data.attrs["unit"], data.attrs["dt"] = "m/s2", 1 / arguments.rate
        for k in range(arguments.kilometres):
            sigma = arguments.noise * 2 ** rng.uniform(-1, 1)
            data[k * count:(k + 1) * count] = (
                evaluate_detection.rough_noise(rng, count, sigma, arguments.speed, spectra) if spectra
                else evaluate_detection.noise(rng, count, sigma))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--kilometres", type=int, default=40)
    parser.add_argument("--rate", type=int, default=5000, help="Hz")
    parser.add_argument("--speed", type=float, default=30, help="m/s")
    parser.add_argument("--noise", type=float, default=3, help="m/s2")
    parser.add_argument("--roughness", default="", help="table of measured roughness")
    parser.add_argument("--false-alarms", type=float, default=0.1, help="a kilometre")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--squat", default="squat", help="the program")
    arguments = parser.parse_args()
    arguments.folder.mkdir(parents=True, exist_ok=True)
    record, found = arguments.folder / "noise.h5", arguments.folder / "found"
    if not record.exists():
        make(record, arguments)
    start = time.time()
    subprocess.run([arguments.squat, "detect", str(record), "--speed", f"{arguments.speed}", "--false-alarms",
                    f"{arguments.false_alarms}", "-o", str(found)], check=True, stdout=subprocess.DEVNULL)
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    with (found / "squats.csv").open() as file:
        events = list(csv.DictReader(file))
    for event in events:
        print(f"{event['position [m]']} m: {event['kind']}, sureness {event['sureness']}, score {event['score']}, "
              f"false alarms {event['false alarms [1/km]']} /km {event['reason']}")
    print(f"{len(events)} events in {arguments.kilometres} km, {arguments.false_alarms * arguments.kilometres:g} accepted; "
          f"{time.time() - start:.0f} s, {used.ru_utime:.0f} s of processors, {used.ru_maxrss // 1024} MB")


if __name__ == "__main__":
    main()
