#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks `axiometry tracking locate` against eq. 14 and the nonlinear problem solved anew with numpy and scipy.

  location_oracle.py AXIOMETRY

Random layouts, exact and noisy; every critical surface; the program must name it, and its rank and condition must be
those of numpy for the matrix that docs/theory/station.md states.
"""
import json
import subprocess
import sys

import numpy as np
from scipy.optimize import least_squares

PROGRAM = sys.argv[1]
RNG = np.random.default_rng(20260118)
COMPARED = 0


def located(points, lengths, *options):
    rows = "x_mm,y_mm,z_mm,length_difference_mm\n" + "".join(
        ",".join(repr(float(v)) for v in (*p, d)) + "\n" for p, d in zip(points, lengths))
    run = subprocess.run([PROGRAM, "tracking", "locate", "-", "--json", "-", *options], input=rows, text=True,
                         capture_output=True, check=False)
    if run.returncode not in (0, 3):
        raise AssertionError(f"exit {run.returncode}: {run.stderr}\n{rows}")
    return json.loads(run.stdout), run.returncode


def expect(condition, what):
    global COMPARED
    COMPARED += 1
    if not condition:
        raise AssertionError(what)


def close(found, expected, tolerance, what):
    expect(np.all(np.abs(np.asarray(found) - np.asarray(expected)) <= tolerance), f"{what}: {found} is not {expected}")


def matrix_of(points, lengths):
    """Rows [2p, 2ΔL, −1], centred and divided by the rms radius."""
    p = points - points.mean(axis=0)
    d = lengths - lengths.mean()
    scale = np.sqrt((p**2).sum(axis=1).mean())
    return np.column_stack([2 * p / scale, 2 * d / scale, -np.ones(len(p))])


def eq14(points, lengths):
    """In the coordinates as they are, by another decomposition than the program's."""
    scale = np.array([1, 1, 1, 1, 1e3])
    m = np.column_stack([2 * points, 2 * lengths, -np.ones(len(points))]) * scale
    x, *_ = np.linalg.lstsq(m, (points**2).sum(axis=1) - lengths**2, rcond=None)
    x = x * scale
    return x[:3], x[3], x[4]


def sigma(points, s):
    return (0.2e-3 + 0.3e-6 * np.linalg.norm(points - s, axis=1)) / 2


def refined(points, lengths, start):
    s, weights = np.asarray(start, float), None
    for _ in range(4):
        weights = 1 / sigma(points, s)
        fit = least_squares(lambda z: (np.linalg.norm(points - z[:3], axis=1) - z[3] - lengths) * weights,
                            [*s, (np.linalg.norm(points - s, axis=1) - lengths).mean()], xtol=1e-15, ftol=1e-15,
                            gtol=1e-15, method="lm")
        s = fit.x[:3]
    u = (points - s) / np.linalg.norm(points - s, axis=1)[:, None]
    rows = np.column_stack([-u, -np.ones(len(u))])
    return fit.x, np.linalg.inv((rows * weights[:, None]).T @ (rows * weights[:, None])), np.linalg.cond(rows)


def check_layout(n, noise):
    s = RNG.uniform(-300, 900, 3)
    points = s + RNG.uniform([-500, -500, 150], [500, 500, 900], (n, 3))
    zero = RNG.uniform(-200, 600)
    lengths = np.linalg.norm(points - s, axis=1) - zero + noise * RNG.standard_normal(n)
    found, _ = located(points, lengths)
    matrix = matrix_of(points, lengths)
    condition = np.linalg.cond(matrix)
    close(found["linear"]["singular_values"], np.linalg.svd(matrix, compute_uv=False), 1e-9, "singular values")
    close(found["linear"]["condition"] / condition, 1, 1e-6, "condition")
    close(found["linear"]["numerical_rank"], np.linalg.matrix_rank(matrix), 0, "rank")
    z, covariance, cond_refined = refined(points, lengths, s)
    close(found["refined"]["station"], z[:3], 2e-6, "refined station")
    close(found["refined"]["L0"], z[3], 2e-6, "refined L0")
    close(np.array(found["refined"]["covariance_stated"]) / covariance[:3, :3], 1, 1e-4, "covariance")
    close(found["refined"]["condition"] / cond_refined, 1, 1e-6, "condition of the refined problem")
    if found["linear"]["rank"] < 5:
        return
    station, L0, psi = eq14(points, lengths)
    close(found["linear"]["station"], station, 1e-9 * condition + 1e-7, "linear station")
    close(found["linear"]["L0"], L0, 1e-9 * condition + 1e-7, "linear L0")
    close(found["misclosure"], psi - (station @ station - L0 * L0), 1e-6 * condition, "misclosure")
    close(found["difference"], z[:3] - station, 1e-9 * condition + 3e-6, "difference")
    if noise == 0:
        close(found["linear"]["station"], s, 1e-8, "truth")
        close(found["refined"]["station"], s, 1e-8, "truth")


def beams(n):
    u = RNG.normal(size=(n, 3))
    u[:, 2] = np.abs(u[:, 2]) + 0.4
    return u / np.linalg.norm(u, axis=1)[:, None]


def rotation():
    q, _ = np.linalg.qr(RNG.normal(size=(3, 3)))
    return q


def critical(kind, n):
    s = RNG.uniform(-300, 900, 3)
    u, axis = beams(n), np.array([0.0, 0.0, 1.0])
    if kind == "sphere":
        return s, s + RNG.uniform(300, 800) * u
    if kind in ("ellipsoid", "paraboloid"):
        e = RNG.uniform(0.2, 0.7) if kind == "ellipsoid" else 1.0
        side = axis if kind == "ellipsoid" else -axis  # away from the direction in which a paraboloid is open
        return s, s + (RNG.uniform(200, 500) / (1 - e * u @ side))[:, None] * u
    if kind == "hyperboloid":
        while min(u[:, 2]) < 0.5:
            u = beams(n)
        return s, s + (RNG.uniform(300, 600) / (RNG.uniform(2.8, 4.5) * u[:, 2] - 1))[:, None] * u
    if kind == "plane":
        normal = RNG.normal(size=3)
        normal /= np.linalg.norm(normal)
        basis = np.linalg.svd(normal[None, :])[2][1:]
        return s, s + 350 * normal + RNG.uniform(-500, 500, (n, 2)) @ basis
    turn = RNG.uniform(0, 2 * np.pi, n)
    half = RNG.uniform(0.4, 1.2)
    cone = np.column_stack([np.sin(half) * np.cos(turn), np.sin(half) * np.sin(turn), np.full(n, np.cos(half))])
    return s, s + RNG.uniform(200, 900, n)[:, None] * (cone @ rotation().T)


def check_critical(kind, n, noise):
    s, points = critical(kind, n)
    lengths = np.linalg.norm(points - s, axis=1) - 123.0 + noise * RNG.standard_normal(n)
    found, code = located(points, lengths, f"--near={s[0] + 20:.3f},{s[1] - 30:.3f},{s[2] + 25:.3f}")
    what = f"{kind}, {n} points, noise {noise}, {found['findings']}"
    expect(found["critical_surface"] == kind, f"found {found['critical_surface']}, expected {what}")
    expect(found["linear"]["rank"] == 4, f"rank {found['linear']['rank']} of {what}")
    expect(found["linear"]["condition"] > 1e4, f"condition of {what}")
    if kind == "cone":
        expect(code == 3, "a cone is serious")
        return
    u = np.sqrt(np.linalg.eigvalsh(found["refined"]["covariance"])[-1])
    close(found["refined"]["station"], s, 6 * u if noise else 1e-5, "station of " + what)
    if kind == "plane":
        expect(found["mirror"] is not None, "mirror of " + what)


for count in (6, 7, 10, 40):
    for size in (0.0, 0.2e-3, 2e-3):
        for _ in range(12):
            check_layout(count, size)
for name in ("plane", "sphere", "ellipsoid", "paraboloid", "hyperboloid", "cone"):
    for count in (6, 9):
        for size in (0.0, 0.1e-3):
            for _ in range(6):
                check_critical(name, count, size)
print(f"ok: {COMPARED} comparisons")
