#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Random station locations, written as CSV, solved by the program and by this independent script.

Usage: tests/station_oracle.py PROGRAM [COUNT] [SEED]

Equation 14 of Lee et al., Sensors 16 (2016) 482, by numpy's least squares; the refinement by scipy's; rank and condition
from numpy's singular values of the matrix centred by the mean of the points and of the lengths and divided by the rms
distance of the points from their mean; covariance as (J^T W J)^-1 with chi^2/nu where that is above 1. Shares nothing with
the C++ code but the paper.
"""
import json
import subprocess
import sys
import tempfile

import numpy as np
from scipy.optimize import least_squares

CONSTANT_UM, PER_LENGTH_UM_PER_M = 0.2, 0.3  # U = a + b L, k = 2: the program's defaults


def scaled_matrix(p, dl):
    centre, mean = p.mean(axis=0), dl.mean()
    radius = np.sqrt(((p - centre) ** 2).sum(axis=1).mean())
    q, d = (p - centre) / radius, (dl - mean) / radius
    return np.column_stack([2 * q, 2 * d, -np.ones(len(q))]), (q**2).sum(axis=1) - d**2, centre, mean, radius


def linear(p, dl):
    m, b, centre, mean, radius = scaled_matrix(p, dl)
    x, _, rank, sv = np.linalg.lstsq(m, b, rcond=None)
    return x[:3] * radius + centre, x[3] * radius - mean, int(rank), sv[0] / sv[-1]


def refined(p, dl, start, l0):
    def sigma(s):
        lengths = np.linalg.norm(p - s, axis=1)
        return (CONSTANT_UM * 1e-3 + PER_LENGTH_UM_PER_M * 1e-6 * lengths) / 2

    weights = sigma(start)
    for _ in range(3):  # the weights follow the distances
        fit = least_squares(lambda x: (np.linalg.norm(p - x[:3], axis=1) - x[3] - dl) / weights, [*start, l0],
                            x_scale=[1, 1, 1, 1], xtol=1e-15, ftol=1e-15, gtol=1e-15)
        start, l0 = fit.x[:3], fit.x[3]
        weights = sigma(start)
    u = (p - start) / np.linalg.norm(p - start, axis=1)[:, None]
    jacobian = np.column_stack([-u, -np.ones(len(p))]) / weights[:, None]
    residuals = np.linalg.norm(p - start, axis=1) - l0 - dl
    chi2, dof = ((residuals / weights) ** 2).sum(), len(p) - 4
    covariance = np.linalg.inv(jacobian.T @ jacobian)[:3, :3] * max(1.0, chi2 / dof if dof > 0 else 1.0)
    return start, l0, covariance, residuals


def make(rng):
    n = int(rng.integers(6, 13))
    station = rng.uniform([-800, -800, -600], [800, 800, 100])
    points = np.round(station + np.column_stack([rng.uniform(-600, 600, n), rng.uniform(-600, 600, n),
                                                 rng.uniform(80, 700, n)]), 3)
    lengths = np.linalg.norm(points - station, axis=1)
    noise = rng.choice([0.0, 0.0002, 0.001, 0.004])
    zero = lengths[0] if rng.random() < 0.7 else rng.uniform(0, 500)
    return points, np.round(lengths - zero + rng.normal(0, noise, n), 7), station, noise


def check(program, rng, index):
    p, dl, station, noise = make(rng)
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        file.write("x_mm,y_mm,z_mm,length_difference_mm\n")
        for point, d in zip(p, dl):
            file.write(",".join(repr(float(v)) for v in [*point, d]) + "\n")
        file.flush()
        done = subprocess.run([program, "tracking", "locate", file.name, "--json", "-", "--near",
                               ",".join(f"{v:.0f}" for v in station)], capture_output=True, text=True)
    if done.returncode not in (0, 3):
        raise SystemExit(f"case {index}: {done.stderr}")
    answer = json.loads(done.stdout)

    def near(what, found, expected, within):
        worst = np.max(np.abs(np.asarray(found, float) - np.asarray(expected, float)))
        if not worst <= within:
            raise SystemExit(f"case {index}, {what}: found {found}, expected {expected} within {within}\n"
                             f"{np.column_stack([p, dl]).tolist()}")

    s14, l14, rank, condition = linear(p, dl)
    if answer["linear"]["rank"] != rank:
        raise SystemExit(f"case {index}: found rank {answer['linear']['rank']}, expected {rank}")
    near("condition, relative", answer["linear"]["condition"] / condition, 1.0, 1e-6)
    # Both solvers lose as many digits as the condition has.
    loss = 1e-12 * condition * 1000
    near("linear station", answer["linear"]["station"], s14, loss)
    near("linear L0", answer["linear"]["L0"], l14, loss)
    s, l0, covariance, residuals = refined(p, dl, s14 if condition < 1e4 else station, l14)
    near("refined station", answer["refined"]["station"], s, 2e-6)
    near("refined L0", answer["refined"]["L0"], l0, 2e-6)
    near("covariance, relative", np.asarray(answer["refined"]["covariance"]) / np.abs(covariance).max(),
         covariance / np.abs(covariance).max(), 2e-3)
    near("residuals", answer["refined"]["residuals"], residuals, 2e-6)
    if noise == 0.0:
        near("truth", answer["refined"]["station"], station, 1e-4)


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 60
    rng = np.random.default_rng(int(sys.argv[3]) if len(sys.argv) > 3 else 20261122)
    for index in range(count):
        check(program, rng, index)
    print(f"station oracle: {count} locations agree")


if __name__ == "__main__":
    main()
