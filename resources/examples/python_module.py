#!/usr/bin/env python3
"""python_module.py [MESH] - a run, a study over depth and a search for squats with the module squat, ten lines each.
Build it with `./bootstrap python`, which also says how it is found."""

import sys

import squat


def run(mesh):
    case = squat.load_case("light-defect", mesh=mesh)
    case["motion.speed"] = 25  # [m/s]
    result = squat.run(case)
    aba = result["aba_filtered"]  # an array of NumPy
    place = result.position[abs(aba).argmax()]
    print(f"run: peak {result.features['peak']:.1f} m/s2, largest value {abs(aba).max():.1f} m/s2 at {place:.3f} m")


def study(mesh):
    case = squat.load_case("light-defect", mesh=mesh)
    for depth in (0.04, 0.08, 0.12):  # [mm]
        case["defect.depth"] = depth
        features = squat.run(case, fields=False).features
        force = features["smallest_contact_force"] / 1000
        print(f"study: {depth} mm, peak {features['peak']:.1f} m/s2, smallest force {force:.1f} kN")


def detection():
    events = squat.detect("example-record", speed=30, chainage="12+300")
    for event in events:
        if event.kind == "squat":
            low, high = event.depth_range
            print(f"squat: {event.position:.2f} m, {event.severity}, {1e3 * low:.2f} to {1e3 * high:.2f} mm deep")


if __name__ == "__main__":
    mesh = sys.argv[1] if len(sys.argv) > 1 else "draft"
    run(mesh)
    study(mesh)
    detection()
