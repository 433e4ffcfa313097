#!/usr/bin/env python3
"""Combines tables of examples into the one that squat detect ships.

    combine_examples.py OUT TABLE...

Passages of whole models, with a defect on one rail, are those with a first arrival. Of squats they get the weight by
which they count as much, all together, as those of half models, which have the squat on both rails; the mean weight of
the vehicles is 1. All else has the weight 1: joints and welds are on both rails as often as on one. Needs Python 3.
"""
import csv
import sys

ARRIVAL = "first arrival [m2/s3]"


def weigh(rows):
    squats = [row for row in rows if row["kind"] == "squat"]
    vehicles = {whole: {row["vehicle"] for row in squats if bool(row[ARRIVAL]) == whole} for whole in (False, True)}
    count = sum(len(each) for each in vehicles.values())
    for row in rows:
        row["weight"] = 1
    for row in squats if all(vehicles.values()) else []:
        row["weight"] = format(count / 2 / len(vehicles[row["vehicle"] in vehicles[True]]), ".3f")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    rows, names = [], []
    for path in sys.argv[2:]:
        with open(path) as file:
            table = csv.DictReader(file)
            names = max(names, table.fieldnames, key=len)
            rows += [row for row in table]
    for row in rows:
        for name in names:
            row.setdefault(name, "")
    weigh(rows)
    with open(sys.argv[1], "w") as file:
        writer = csv.DictWriter(file, names, lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


if __name__ == "__main__":
    main()
