"""Receptance of a Timoshenko rail on pads, bending half sleepers and ballast: writes timoshenko_receptance.csv.

Independent of the program: cubic Timoshenko beam elements with consistent mass (Przemieniecki 1968), assembled and solved
as a complex-symmetric system at every frequency. Rail 54E1: A 6977 mm2, I 2337.9 cm4 (EN 13674-1), shear coefficient
0.40, E 210 GPa, nu 0.3, rho 7800. Pad: six springs over 0.16 m. Half sleeper 1.26 x 0.26 x 0.152 m, 2450 kg/m3, symmetric
at the track centre, pad at the rail seat 0.75 m from it, ballast spread evenly over its length.
"""
import numpy as np
from scipy.sparse import coo_matrix
from scipy.sparse.linalg import splu

RAIL = dict(E=210e9, G=210e9 / 2.6, rho=7800.0, A=69.77e-4, I=2337.9e-8, kappa=0.40)
PAD_K, PAD_C, BALLAST_K, BALLAST_C = 1300e6, 45e3, 45e6, 32e3
PAD_LENGTH, PADS = 0.16, 6
HALF_LENGTH, WIDTH, HEIGHT, DENSITY, POISSON, SEAT = 1.26, 0.26, 0.152, 2450.0, 0.2, 0.75


def element(b, length):
    phi = 12 * b["E"] * b["I"] / (b["kappa"] * b["G"] * b["A"] * length**2)
    L, f = length, 1 + phi
    K = b["E"] * b["I"] / (L**3 * f) * np.array(
        [[12, 6 * L, -12, 6 * L], [6 * L, (4 + phi) * L * L, -6 * L, (2 - phi) * L * L],
         [-12, -6 * L, 12, -6 * L], [6 * L, (2 - phi) * L * L, -6 * L, (4 + phi) * L * L]])
    p = phi
    a1, a2 = 13 / 35 + 7 * p / 10 + p * p / 3, (11 / 210 + 11 * p / 120 + p * p / 24) * L
    a3, a4 = 9 / 70 + 3 * p / 10 + p * p / 6, -(13 / 420 + 3 * p / 40 + p * p / 24) * L
    a5, a6 = (1 / 105 + p / 60 + p * p / 120) * L * L, -(1 / 140 + p / 60 + p * p / 120) * L * L
    M = b["rho"] * b["A"] * L / f**2 * np.array(
        [[a1, a2, a3, a4], [a2, a5, -a4, a6], [a3, -a4, a1, -a2], [a4, a6, -a2, a5]])
    r1, r2 = 6 / 5, (1 / 10 - p / 2) * L
    r3, r4 = (2 / 15 + p / 6 + p * p / 3) * L * L, (-1 / 30 - p / 6 + p * p / 6) * L * L
    M += b["rho"] * b["I"] / (L * f**2) * np.array(
        [[r1, r2, -r1, r2], [r2, r3, -r2, r4], [-r1, -r2, r1, -r2], [r2, r4, -r2, r3]])
    return K, M


class System:
    def __init__(self):
        self.rows, self.cols, self.K, self.C, self.M, self.size = [], [], [], [], [], 0

    def add(self, dofs, K, C, M):
        d = np.asarray(dofs)
        self.rows.append(np.repeat(d, d.size)), self.cols.append(np.tile(d, d.size))
        for store, matrix in ((self.K, K), (self.C, C), (self.M, M)):
            store.append(np.broadcast_to(matrix, (d.size, d.size)).ravel())

    def beam(self, b, length, n):
        first = self.size
        K, M = element(b, length / n)
        for i in range(n):
            self.add(range(first + 2 * i, first + 2 * i + 4), K, 0.0, M)
        self.size += 2 * (n + 1)
        return first

    def spring(self, terms, k, c):
        dofs, w = zip(*terms)
        outer = np.outer(w, w)
        self.add(dofs, k * outer, c * outer, 0.0)

    def matrices(self):
        r, c = np.concatenate(self.rows), np.concatenate(self.cols)
        return [coo_matrix((np.concatenate(v), (r, c)), shape=(self.size,) * 2).tocsc() for v in (self.K, self.C, self.M)]


def shape(x, h):
    """Node left of x and cubic weights of w, theta left and right (Hermite: nodes are close, shear left out)."""
    i = int(np.floor(x / h + 1e-12))
    s = x / h - i
    if s < 1e-9:
        return i, [1.0, 0, 0, 0]
    return i, [1 - 3 * s**2 + 2 * s**3, h * (s - 2 * s**2 + s**3), 3 * s**2 - 2 * s**3, h * (s**3 - s**2)]


def receptance(frequencies, young, track=10.0, spacing=0.6):
    system = System()
    n = int(round(track / 0.02))
    h = track / n
    rail = system.beam(RAIL, track, n)
    area, inertia = WIDTH * HEIGHT, WIDTH * HEIGHT**3 / 12
    concrete = dict(E=young, G=young / 2 / (1 + POISSON), rho=DENSITY, A=area, I=inertia, kappa=5 / 6)
    m = 42  # 30 mm, a node at the seat
    at = lambda first, x, step: [(first + 2 * i + j, w) for i, ws in [shape(x, step)] for j, w in enumerate(ws) if w]
    held = []
    count = int(np.floor(track / 2 / spacing))
    for k in range(-count, count + 1):
        sleeper = system.beam(concrete, HALF_LENGTH, m)
        held.append(sleeper + 1)  # no rotation at the track centre
        for j in range(m + 1):
            share = (0.5 if j in (0, m) else 1.0) / m
            system.spring([(sleeper + 2 * j, 1.0)], BALLAST_K * share, BALLAST_C * share)
        for p in range(PADS):
            x = track / 2 + k * spacing + ((p + 0.5) / PADS - 0.5) * PAD_LENGTH
            if not 0 <= x <= track:
                continue
            terms = at(rail, x, h) + [(d, -w) for d, w in at(sleeper, SEAT, HALF_LENGTH / m)]
            system.spring(terms, PAD_K / PADS, PAD_C / PADS)
    K, C, M = system.matrices()
    free = np.setdiff1d(np.arange(system.size), held)
    K, C, M = (a[free][:, free] for a in (K, C, M))
    place = {d: i for i, d in enumerate(free)}
    out = []
    for x in (track / 2, track / 2 - spacing / 2):
        f = np.zeros(free.size, complex)
        for d, w in at(rail, x, h):
            f[place[d]] += w
        values = []
        for hz in frequencies:
            w = 2 * np.pi * hz
            u = splu((K + 1j * w * C - w * w * M).tocsc()).solve(f)
            values.append(f @ u)
        out.append(np.array(values))
    return out


if __name__ == "__main__":
    import os
    frequencies = np.arange(50.0, 2001.0, 5.0)
    columns = [frequencies]
    names = ["frequency [Hz]"]
    for label, young in (("concrete", 38.4e9), ("stiff", 2000e9)):
        for where, values in zip(("sleeper", "midspan"), receptance(frequencies, young)):
            names += [f"{label} {where} real", f"{label} {where} imaginary"]
            columns += [values.real, values.imag]
    path = os.path.join(os.path.dirname(os.path.abspath(__file__)), "timoshenko_receptance.csv")
    np.savetxt(path, np.column_stack(columns), delimiter=",", header=",".join(names), comments="", fmt="%.7g")
