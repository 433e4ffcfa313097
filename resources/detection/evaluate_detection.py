#!/usr/bin/env python3
"""Judges squat detect by records whose squats are known: the table "How good it is" of the manual.

    evaluate_detection.py FOLDER [--examples FILE] [--noise 1.5,5] [--roughness FILE] [--squat PROGRAM] [--jobs N]

FOLDER holds vehicle-NNN folders as make_examples.py --passages and other_shapes.py make them. For each vehicle and each
level of noise the passages are laid into a record of their own, some 15 m apart, with noise: coloured, or of the
measured roughness in a table with a column for each wavelength ("1 cm [dB re 1 um]"), through a track of four
resonances. The program searches it, and what it finds is compared with what was laid. Records that stand in FOLDER/records already are not made again. FILE must not hold these vehicles: without --examples, the shipped ones count. Needs
Python 3, NumPy and squat.
"""
import argparse
import concurrent.futures
import csv
import json
import pathlib
import re
import subprocess

import numpy

RATE = 25000
LIMITS = ((35, 0.10), (60, 0.25))  # mm, of light and moderate squats
NAMES = ("light", "moderate", "severe")


def severity(length, depth):
    return next((i for i, (long, deep) in enumerate(LIMITS) if length <= long and depth <= deep), 2)


def all_boxes(folder):
    """Kind, length [mm], depth [mm], speed [m/s], positions, accelerations: a column for each axle box."""
    for path in sorted(folder.glob("*.csv")):
        with path.open() as file:
            head = re.match(r"# (\S+), (\S+) mm x (\S+) mm, (\S+) m/s", file.readline())
            values = numpy.loadtxt(file, delimiter=",", skiprows=1)
        yield head[1], float(head[2]), float(head[3]), float(head[4]), values[:, 1], values[:, 2:]


def passages(folder):
    """The same, with the accelerations of the first axle box alone."""
    for *known, accelerations in all_boxes(folder):
        yield *known, accelerations[:, 0]


def noise(rng, count, sigma):
    """Gaussian up to 2.5 kHz, a third of its power below 200 Hz."""
    frequency = numpy.fft.rfftfreq(count, 1 / RATE)
    density = (frequency < 2500) * (2 / 3 / 2500 + (frequency < 200) / 3 / 200)
    waves = numpy.fft.irfft(numpy.sqrt(density) * numpy.exp(2j * numpy.pi * rng.random(frequency.size)), count)
    return sigma * waves / waves.std()


def measured_spectra(path):
    """Wavelengths [m], and a list of levels [dB re 1 um]; the second half of the rows, so that the first can be learned from."""
    with open(path) as file:
        head, *rows = csv.reader(file)
    columns = [i for i, name in enumerate(head) if " cm [dB" in name]
    wavelengths = numpy.array([0.01 * float(head[i].split(" cm")[0]) for i in columns])
    levels = [numpy.array([float(row[i]) for i in columns]) for row in rows]
    return wavelengths, levels[len(levels) // 2:]


def rough_noise(rng, count, sigma, speed, spectra):
    wavelengths, levels = spectra
    frequency = numpy.fft.rfftfreq(count, 1 / RATE)
    own = levels[rng.integers(len(levels))]
    known = numpy.isfinite(own)
    level = numpy.interp(numpy.log(speed / numpy.maximum(frequency, 1e-3)), numpy.log(wavelengths[known]), own[known])
    track = 0
    for resonance, damping, gain in ((70, 0.25, 1), (300, 0.12, 1), (620, 0.08, 0.5), (1050, 0.05, 1.2)):
        s = 1j * frequency / resonance
        track = track + gain * s * s / (1 + 2 * damping * s + s * s)
    gain = numpy.abs(track) * frequency ** 2 / (1 + (frequency / 900) ** 2)
    power = 10 ** (level / 10) / numpy.maximum(frequency, 1) * gain ** 2 * (frequency > 20) * (frequency < 2500)
    random = rng.normal(size=frequency.size) + 1j * rng.normal(size=frequency.size)
    waves = numpy.fft.irfft(numpy.sqrt(power) * random, count)
    return sigma * waves / waves.std()


def record(folder, sigma, path, rng, spectra):
    """Writes the record; what is in it, and its speed."""
    known = path.with_suffix(".json")
    if known.exists():
        return json.loads(known.read_text())
    defects = list(passages(folder))
    speed = defects[0][3]
    signal = numpy.zeros(int((30 + 15.7 * len(defects)) / speed * RATE))
    truth = []
    for number, index in enumerate(rng.permutation(len(defects))):
        kind, length, depth, _, position, values = defects[index]
        place = 20 + 15.7 * number + rng.uniform(-2, 2)
        first = int(round((place + position[0]) / speed * RATE))
        fade = max(1, values.size // 20)
        window = numpy.minimum(1, numpy.arange(values.size)[::-1] / fade)
        signal[first:first + values.size] += window * values
        truth.append((first * speed / RATE - position[0], kind, length, depth))
    signal += rough_noise(rng, signal.size, sigma, speed, spectra) if spectra else noise(rng, signal.size, sigma)
    with path.open("w") as file:
        file.write("time [s],aba [m/s2]\n")
        file.writelines(f"{i / RATE:.5f},{value:.3f}\n" for i, value in enumerate(signal))
    known.write_text(json.dumps([truth, speed]))
    return truth, speed


def found(arguments, path, speed):
    folder = path.with_suffix("")
    call = [arguments.squat, "detect", str(path), "--speed", f"{speed:.4f}", "--threads", "1", "-o", str(folder)]
    if arguments.examples:
        call += ["--examples", arguments.examples]
    subprocess.run(call, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    with (folder / "squats.csv").open() as file:
        return [event for event in csv.DictReader(file) if event["false alarms [1/km]"]]  # no stretches


def compare(truth, events):
    """Rows: kind, true severity, found kind, found severity, metres apart, true length and depth inside their ranges."""
    rows, taken = [], set()
    for place, kind, length, depth in truth:
        apart, index = min(((abs(float(e["position [m]"]) - place), i) for i, e in enumerate(events)), default=(9, -1))
        row = {"kind": kind, "severity": severity(length, depth), "found": "", "name": f"{length:.0f} mm x {depth:.3f} mm"}
        if apart < 0.5:
            taken.add(index)
            event = events[index]
            row |= {"found": event["kind"], "apart": apart, "sureness": float(event["sureness"])}
            if event["kind"] == "squat":
                inside = [float(event[f"{name} low [mm]"]) - 1e-9 <= true <= float(event[f"{name} high [mm]"]) + 1e-9
                          for name, true in (("length", length), ("depth", depth))]
                row |= {"called": NAMES.index(event["severity"]), "inside": inside,
                        "given": float(event[NAMES[row["severity"]]])}
        rows.append(row)
    false = [e["kind"] for i, e in enumerate(events)
             if i not in taken and e["kind"] == "squat" and not any(abs(float(e["position [m]"]) - t[0]) < 1.5 for t in truth)]
    return rows, false


def calibration(rows, title):
    """How often events of each sureness are right. "other" is right for what is no squat: it claims no more."""
    if not rows:
        return
    print(f"{title}:")
    right = lambda row: row["found"] == row["kind"] or (row["found"] == "other" and row["kind"] != "squat")
    error = 0
    for low in range(0, 10):
        own = [row for row in rows if min(9, int(10 * row["sureness"] + 1e-9)) == low]
        if not own:
            continue
        stated, seen = numpy.mean([row["sureness"] for row in own]), numpy.mean([right(row) for row in own])
        error += len(own) / len(rows) * abs(stated - seen)
        print(f"  sureness {stated:.2f}: right {seen:.2f} of {len(own)}")
    print(f"  expected calibration error: {error:.3f}")


def report(rows, false):
    squats = [row for row in rows if row["kind"] == "squat"]
    others = [row for row in rows if row["kind"] != "squat"]
    for i, name in enumerate(NAMES):
        own = [row for row in squats if row["severity"] == i]
        print(f"{name}: {sum(row['found'] == 'squat' for row in own)} of {len(own)} as squats")
    as_squats = [row for row in others if row["found"] == "squat"]
    print(f"others called squats: {len(as_squats)} of {len(others)}, "
          f"with 90 % and more: {sum(row['sureness'] >= 0.9 for row in as_squats)}")
    for kind in sorted({row["kind"] for row in others}):
        called = [row["found"] or "nothing" for row in others if row["kind"] == kind]
        print(f"  {kind}: " + ", ".join(f"{name} {called.count(name)}" for name in sorted(set(called))))
    print(f"false alarms: {len(false)}")
    listed = [row for row in rows if row["found"]]
    calibration(listed, "all")
    calibration([row for row in listed if row["found"] != "other"], "those that are not called other")
    called = [row for row in squats if "called" in row]
    off = [abs(row["called"] - row["severity"]) for row in called]
    print(f"severity right: {100 * off.count(0) / len(off):.1f} % of {len(off)}; two classes off: {off.count(2)}; "
          f"given at least 30 %: {100 * numpy.mean([row['given'] >= 0.3 for row in called]):.1f} %")
    print(f"position: {1e3 * numpy.mean([row['apart'] for row in called]):.0f} mm on the average, "
          f"beyond 0.1 m: {sum(row['apart'] > 0.1 for row in called)}")
    inside = numpy.mean([row["inside"] for row in called], axis=0)
    print(f"true length, depth in the range given: {100 * inside[0]:.0f} %, {100 * inside[1]:.0f} %")
    for row in rows:
        is_sure = row["found"] != row["kind"] and row["found"] not in ("", "other") and row["sureness"] >= 0.8
        if is_sure or (row["kind"] == "squat") != (row["found"] == "squat"):
            print(f"  {row['kind']} {row['name']} ({row['vehicle']}): {row['found'] or 'not found'}"
                  f" {row.get('sureness', '')}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--examples", default="", help="table of the program's examples")
    parser.add_argument("--noise", default="1.5,5", help="m/s2, one or several")
    parser.add_argument("--roughness", default="", help="table of measured roughness")
    parser.add_argument("--squat", default="squat", help="the program")
    parser.add_argument("--jobs", type=int, default=2)
    arguments = parser.parse_args()
    work = arguments.folder / ("records-rough" if arguments.roughness else "records")
    spectra = measured_spectra(arguments.roughness) if arguments.roughness else None
    work.mkdir(exist_ok=True)

    def one(folder, sigma):
        rng = numpy.random.default_rng([int(folder.name[-3:]), int(10 * sigma)])
        path = work / f"{folder.name}-{sigma:g}.csv"
        truth, speed = record(folder, sigma, path, rng, spectra)
        rows, false = compare(truth, found(arguments, path, speed))
        return [row | {"vehicle": path.stem} for row in rows], false

    folders = sorted(path for path in arguments.folder.glob("vehicle-???") if path.with_suffix(".csv").exists())
    tasks = [(folder, float(sigma)) for folder in folders for sigma in arguments.noise.split(",")]
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        results = list(pool.map(lambda task: one(*task), tasks))
    report([row for rows, _ in results for row in rows], [each for _, false in results for each in false])


if __name__ == "__main__":
    main()
