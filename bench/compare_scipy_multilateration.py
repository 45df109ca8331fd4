#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Multilateration twice in one run: by axiometry, and by scipy's sparse least squares.

Usage: bench/compare_scipy_multilateration.py PROGRAM [POINTS [SCIPY_POINTS [STATIONS]]]

Work: STATIONS stations (8) around a machine of 1 m x 0.6 m x 0.5 m see POINTS points (100 000); points, stations and dead
paths are found from the lengths. The scipy side is what one would write: scipy.optimize.least_squares with an analytic
sparse Jacobian (trf, lsmr), started where axiometry starts, from the nominal points and stations located on them. It gets
SCIPY_POINTS of the points (5000), because it takes minutes for all of them. Checked is that both find the same shape at the
same size, and printed the ratio there, the time per reading of both, and what all points take.

Only the solution is timed on the scipy side; of axiometry the whole program, with reading, and writing the result.
"""
import os
import resource
import subprocess
import sys
import tempfile
import time

import numpy as np
from scipy.optimize import least_squares
from scipy.sparse import coo_matrix


def simulate(points, stations, seed=1):
    rng = np.random.default_rng(seed)
    nominal = np.round(rng.uniform(0, 1, (points, 3)) * [1000, 600, 500], 3)
    true = nominal + rng.normal(0, 0.01, nominal.shape)
    angle = 2 * np.pi * np.arange(stations) / stations
    places = np.c_[500 + 800 * np.cos(angle), 300 + 700 * np.sin(angle), rng.uniform(-200, 600, stations)]
    dead = rng.uniform(200, 300, stations)
    lengths = np.linalg.norm(true[:, None, :] - places[None], axis=2)
    sigma = (0.2e-3 + 0.3e-6 * lengths) / 2
    return nominal, lengths - dead + rng.normal(0, 1, lengths.shape) * sigma, sigma, places


def write(folder, nominal, lengths):
    with open(f"{folder}/points.csv", "w", encoding="utf-8") as file:
        file.write("point,x_mm,y_mm,z_mm\n")
        file.writelines(f"{i},{p[0]:.3f},{p[1]:.3f},{p[2]:.3f}\n" for i, p in enumerate(nominal))
    with open(f"{folder}/ranges.csv", "w", encoding="utf-8") as file:
        file.write("point,station,length_mm\n")
        for j in range(lengths.shape[1]):
            file.writelines(f"{i},S{j + 1},{l:.7f}\n" for i, l in enumerate(lengths[:, j]))


def ours(program, folder, *options):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    begin = time.perf_counter()
    subprocess.run([program, "tracking", "multilaterate", f"{folder}/ranges.csv", "--points", f"{folder}/points.csv",
                    "--out", f"{folder}/found.csv", "--quiet", *options], check=True)
    wall = time.perf_counter() - begin
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return wall, after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, after.ru_maxrss / 1024


def located(nominal, length):
    """A station from its lengths to the nominal points, the mean of their errors away from the best."""
    centre = nominal.mean(axis=0)
    a = np.c_[2 * (nominal - centre), 2 * length, -np.ones(len(length))]
    b = ((nominal - centre) ** 2).sum(axis=1) - length ** 2
    x = np.linalg.lstsq(a, b, rcond=None)[0]
    return x[:3] + centre, x[3]


def theirs(nominal, lengths, sigma):
    n, m = lengths.shape
    starts = [located(nominal, lengths[:, j]) for j in range(m)]
    x0 = np.concatenate([nominal.ravel(), np.concatenate([s for s, _ in starts]), [d for _, d in starts]])
    i, j = np.repeat(np.arange(n), m), np.tile(np.arange(m), n)
    rows = np.repeat(np.arange(n * m), 7)
    columns = np.stack([3 * i, 3 * i + 1, 3 * i + 2, 3 * n + 3 * j, 3 * n + 3 * j + 1, 3 * n + 3 * j + 2,
                        3 * n + 3 * m + j], axis=1).ravel()
    w = 1 / sigma.ravel()

    def split(x):
        return x[:3 * n].reshape(n, 3), x[3 * n:3 * n + 3 * m].reshape(m, 3), x[3 * n + 3 * m:]

    def residual(x):
        p, s, d = split(x)
        return w * (np.linalg.norm(p[i] - s[j], axis=1) - d[j] - lengths.ravel())

    def jacobian(x):
        p, s, _ = split(x)
        beam = p[i] - s[j]
        u = beam / np.linalg.norm(beam, axis=1)[:, None]
        values = np.c_[u, -u, -np.ones(len(u))] * w[:, None]
        return coo_matrix((values.ravel(), (rows, columns)), shape=(n * m, len(x))).tocsr()

    begin = time.perf_counter()
    fit = least_squares(residual, x0, jacobian, method="trf", tr_solver="lsmr", x_scale="jac", xtol=1e-12, ftol=1e-12,
                        gtol=1e-12, max_nfev=200)
    return split(fit.x)[0], 2 * fit.cost, time.perf_counter() - begin, fit.nfev


def shape_difference(a, b):
    """Both laid onto each other by least squares: root mean square and largest distance, um."""
    a, b = a - a.mean(axis=0), b - b.mean(axis=0)
    u, _, v = np.linalg.svd(b.T @ a)
    turn = u @ np.diag([1, 1, np.sign(np.linalg.det(u @ v))]) @ v
    off = np.linalg.norm(a - b @ turn, axis=1) * 1000
    return np.sqrt((off ** 2).mean()), off.max()


def main():
    program = sys.argv[1]
    points = int(float(sys.argv[2])) if len(sys.argv) > 2 else 100_000
    scipy_points = min(points, int(float(sys.argv[3])) if len(sys.argv) > 3 else 5000)
    stations = int(sys.argv[4]) if len(sys.argv) > 4 else 8
    nominal, lengths, sigma, _ = simulate(points, stations)
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR", "/var/tmp")) as folder:
        write(folder, nominal[:scipy_points], lengths[:scipy_points])
        small, small_cpu, _ = ours(program, folder)
        found = np.loadtxt(f"{folder}/found.csv", delimiter=",", skiprows=1, usecols=(1, 2, 3))
        p, chi, seconds, evaluations = theirs(nominal[:scipy_points], lengths[:scipy_points], sigma[:scipy_points])
        rms, largest = shape_difference(found, p)
        print(f"{stations} stations, {scipy_points} points: axiometry {small:.2f} s (processor {small_cpu:.2f} s), "
              f"scipy {seconds:.2f} s ({evaluations} evaluations), ratio {seconds / small:.1f}")
        print(f"they differ by {rms:.2e} um (root mean square), {largest:.2e} um (largest); chi squared of scipy "
              f"{chi:.1f} with {lengths[:scipy_points].size - 3 * scipy_points - 4 * stations + 6} degrees of freedom")
        if not largest < 0.1:
            sys.exit("the results differ")
        write(folder, nominal, lengths)
        for options in ([], ["--no-covariances"]):
            wall, cpu, memory = ours(program, folder, *options)
            print(f"{stations} stations, {points} points{' without covariances' if options else ''}: axiometry {wall:.2f} s "
                  f"(processor {cpu:.2f} s), {memory:.0f} MiB peak, {1e6 * wall / lengths.size:.2f} us per reading "
                  f"(scipy {1e6 * seconds / (scipy_points * stations):.2f} us at its size)")


if __name__ == "__main__":
    main()
