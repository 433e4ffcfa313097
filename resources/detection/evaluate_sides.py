#!/usr/bin/env python3
"""Judges the sides that squat detect gives by records whose defects are known: "Which rail" of the manual.

    evaluate_sides.py FOLDER [--noise 1.5,5] [--roughness FILE] [--squat PROGRAM]

FOLDER holds vehicle-NNN folders as make_examples.py --sides --passages makes them. For each vehicle and each level of
noise the passages are laid into a record of two channels, some 15 m apart, with the defect on the left rail or the right
one; one in ten has another opposite to it, whose signal is added. Each channel has noise of its own, as in
evaluate_detection.py. Needs Python 3, NumPy and squat.
"""
import argparse
import csv
import pathlib
import subprocess

import numpy

import evaluate_detection as one_channel

SIDES = ("left", "right", "both")


def record(folder, sigma, path, rng, spectra):
    """Writes the record; place, kind, length, depth and side of what is in it, and its speed."""
    defects = list(one_channel.all_boxes(folder))
    speed, rate = defects[0][3], one_channel.RATE
    signal = numpy.zeros((int((30 + 15.7 * len(defects)) / speed * rate), 2))
    truth = []

    def lay(defect, first, right):
        values = defect[5][:, ::-1] if right else defect[5]
        fade = max(1, len(values) // 20)
        window = numpy.minimum(1, numpy.arange(len(values))[::-1] / fade)
        signal[first:first + len(values)] += window[:, None] * values

    order = rng.permutation(len(defects))
    for number, index in enumerate(order):
        defect, side = defects[index], "both" if rng.random() < 0.1 else SIDES[int(rng.integers(2))]
        place = 20 + 15.7 * number + rng.uniform(-2, 2)
        lay(defect, int(round((place + defect[4][0]) / speed * rate)), side == "right")
        if side == "both":
            opposite = defects[order[number - 1]]
            lay(opposite, int(round((place + opposite[4][0]) / speed * rate)), True)
        truth.append((place, *defect[:3], side))
    for channel in signal.T:
        channel += (one_channel.rough_noise(rng, len(channel), sigma, speed, spectra) if spectra
                    else one_channel.noise(rng, len(channel), sigma))
    with path.open("w") as file:
        file.write("time [s],axle 1 left [m/s2],axle 1 right [m/s2]\n")
        file.writelines(f"{i / rate:.5f},{left:.3f},{right:.3f}\n" for i, (left, right) in enumerate(signal))
    return truth, speed


def found(program, path, speed):
    folder = path.with_suffix("")
    subprocess.run([program, "detect", str(path), "--speed", f"{speed:.4f}", "--no-figures", "-o", str(folder)],
                   check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with (folder / "squats.csv").open() as file:
        return [event for event in csv.DictReader(file) if event["false alarms [1/km]"]]  # no stretches


def report(rows, false):
    for side in SIDES:
        own = [row for row in rows if row["side"] == side]
        called = [row["called"] for row in own]
        print(f"{side}: {len(own)}; " + ", ".join(f"{name} {called.count(name)}" for name in (*SIDES, "")))
    listed = [row for row in rows if row["called"]]
    error = 0
    for low in (0.3, 0.5, 0.6, 0.7, 0.8, 0.9, 0.99):
        high = {0.3: 0.5, 0.9: 0.99, 0.99: 1.01}.get(low, low + 0.1)
        own = [row for row in listed if low <= row["sureness"] < high]
        if not own:
            continue
        right = numpy.mean([row["called"] == row["side"] for row in own])
        stated = numpy.mean([row["sureness"] for row in own])
        error += len(own) / len(listed) * abs(stated - right)
        print(f"  sureness {stated:.3f}: right {right:.3f} of {len(own)}")
    print(f"  expected calibration error: {error:.3f}")
    one = [row for row in listed if row["side"] != "both"]
    print(f"defects on one rail: {numpy.mean([row['rows'] == 1 for row in one]):.3f} of {len(one)} have one row; "
          f"the other box has {numpy.median([row['other'] for row in one]):.0f} % of the peak "
          f"({numpy.percentile([row['other'] for row in one], 5):.0f} to "
          f"{numpy.percentile([row['other'] for row in one], 95):.0f})")
    squats = [row for row in one if row["kind"] == "squat"]
    print(f"squats on one rail called squats: {sum(row['found'] == 'squat' for row in squats)} of {len(squats)}; severity "
          f"right: {sum(row['severity'] == row['true'] for row in squats if row['found'] == 'squat')}")
    print(f"events where none is: {false}")
    for row in rows:
        if row["called"] != row["side"]:
            print(f"  {row['name']}: {row['side']}, called {row['called'] or 'nothing'} {row.get('sureness', '')}")


def compare(truth, events, name):
    rows, taken = [], set()
    for place, kind, length, depth, side in truth:
        near = [(abs(float(e["position [m]"]) - place), i) for i, e in enumerate(events)
                if abs(float(e["position [m]"]) - place) < 0.5]
        taken |= {i for _, i in near}
        true = one_channel.NAMES[one_channel.severity(length, depth)]
        row = {"kind": kind, "side": side, "called": "", "true": true, "rows": len(near),
               "name": f"{name}: {kind} {length:.0f} mm x {depth:.3f} mm"}
        if near:
            event = max((events[i] for _, i in near), key=lambda e: float(e["score"]))
            row |= {"called": event["side"], "sureness": float(event["side sureness"]), "found": event["kind"],
                    "severity": event["severity"], "other": float(event["other side [%]"])}
        rows.append(row)
    return rows, len(events) - len(taken)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--noise", default="1.5,5", help="m/s2, one or several")
    parser.add_argument("--roughness", default="", help="table of measured roughness")
    parser.add_argument("--squat", default="squat", help="the program")
    arguments = parser.parse_args()
    spectra = one_channel.measured_spectra(arguments.roughness) if arguments.roughness else None
    work = arguments.folder / "records-sides"
    work.mkdir(exist_ok=True)
    rows, false = [], 0
    for folder in sorted(path for path in arguments.folder.glob("vehicle-???") if path.with_suffix(".csv").exists()):
        for sigma in map(float, arguments.noise.split(",")):
            rng = numpy.random.default_rng([int(folder.name[-3:]), int(10 * sigma)])
            path = work / f"{folder.name}-{sigma:g}.csv"
            truth, speed = record(folder, sigma, path, rng, spectra)
            own, none = compare(truth, found(arguments.squat, path, speed), path.stem)
            rows += own
            false += none
    report(rows, false)


if __name__ == "__main__":
    main()
