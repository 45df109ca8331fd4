#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The 21 errors of a machine by scipy, Ceres and us, on the same lengths: 217 unknowns, cubic B-splines of eight spans.

scipy: least_squares (trf, analytic Jacobian) with numpy's BLAS; and Gauss–Newton on normal equations in numpy, the
fastest that can be written there. Both start where our program ends but for 0.1 mm of the stations; ours has to find them.

Ceres: bench/volumetric_ceres.cpp, which is built with the benchmarks where Ceres is installed; from the same start.

Usage: bench/compare_scipy_volumetric.py PROGRAM [OBSERVATIONS [VOLUMETRIC_CERES]]
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import time

import numpy as np
from scipy.optimize import least_squares

SPANS = 8
FUNCTIONS = SPANS + 3
LOW, HIGH = np.array([0.0, 0.0, -500.0]), np.array([1000.0, 600.0, 0.0])
TOOLS = np.array([[0, 0, -150], [0, 0, -300], [120, 60, -180]], float)
STATIONS = np.array([[-150, -120, -700], [1150, -100, -650], [500, 720, -680], [200, 300, -750]], float)


def basis(q, axis):
    along = (q - LOW[axis]) / (HIGH[axis] - LOW[axis]) * SPANS
    span = np.clip(np.floor(along), 0, SPANS - 1).astype(int)
    t = along - span
    s = 1 - t
    values = np.stack([s ** 3, 3 * t ** 3 - 6 * t ** 2 + 4, -3 * t ** 3 + 3 * t ** 2 + 3 * t + 1, t ** 3], 1) / 6
    rows = np.zeros((len(q), FUNCTIONS))
    for k in range(4):
        rows[np.arange(len(q)), span + k] = values[:, k]
    return rows


def gauge():
    """Coefficients with mean 0, of straightness also level: an orthonormal basis of them for each function."""
    q = [np.linspace(LOW[a], HIGH[a], 20001) for a in range(3)]
    means = [basis(q[a], a).mean(0) for a in range(3)]
    slopes = [(basis(q[a], a) * np.linspace(-1, 1, 20001)[:, None]).mean(0) for a in range(3)]
    parts = []
    for a in range(3):
        for m in range(6):
            rows = [means[a]] + ([slopes[a]] if m < 3 and m != a else [])
            parts.append(np.linalg.svd(np.array(rows))[2][len(rows):].T)
    return parts


class Problem:
    """Errors in µm and µrad, stations and dead paths in µm from where they are said to be."""

    def __init__(self, axes, tool, station, virtual, lengths):
        self.axes, self.p, self.l, self.virtual = axes, axes + TOOLS[tool], lengths, virtual
        self.at = STATIONS[station]
        far = np.linalg.norm(self.p - self.at, axis=1)
        self.weight = 1 / (0.5 * (0.2 + 0.3e-3 * far))
        self.bases = [basis(axes[:, a], a) for a in range(3)]
        behind = TOOLS[tool] + axes * [1, 1, 1]
        levers = [behind, TOOLS[tool] + axes * [0, 0, 1], TOOLS[tool]]  # XFYZ
        self.levers = [1e-3 * r for r in levers]
        parts = gauge()
        self.curves = [[self.bases[a] @ parts[6 * a + m] for m in range(6)] for a in range(3)]
        self.ends = np.cumsum([0] + [c.shape[1] for curves in self.curves for c in curves])

    def rows(self, u):
        parts = []
        for a in range(3):
            plucker = np.hstack([u, np.cross(self.levers[a], u)])
            for m in range(6):
                parts.append(plucker[:, m:m + 1] * self.curves[a][m])
        y, z = 1e-3 * self.axes[:, 1], 1e-3 * self.axes[:, 2]
        parts.append(np.stack([-u[:, 0] * y, u[:, 0] * z, -u[:, 1] * z], 1))
        stations = np.zeros((len(u), 40))
        for k in range(3):
            stations[np.arange(len(u)), 4 * self.virtual + k] = -u[:, k]
        stations[np.arange(len(u)), 4 * self.virtual + 3] = -1
        return np.hstack(parts + [stations])

    def beam(self, x):
        s = self.at + 1e-3 * x[-40:].reshape(10, 4)[self.virtual, :3]
        y, z = 1e-3 * self.axes[:, 1], 1e-3 * self.axes[:, 2]
        delta = np.stack([-x[174] * y + x[175] * z, -x[176] * z, 0 * z], 1)
        for a in range(3):
            e = np.stack([self.curves[a][m] @ x[self.ends[6 * a + m]:self.ends[6 * a + m + 1]] for m in range(6)], 1)
            delta += e[:, :3] + np.cross(e[:, 3:], self.levers[a])
        beam = self.p + 1e-3 * delta - s
        return beam, np.linalg.norm(beam, axis=1)

    def residuals(self, x):
        _, far = self.beam(x)
        return self.weight * (1e3 * (far - self.l) - x[-40:].reshape(10, 4)[self.virtual, 3] - 300e3)

    def jacobian(self, x):
        beam, far = self.beam(x)
        return self.weight[:, None] * self.rows(beam / far[:, None])


def blas():
    """The library that numpy's products are made by."""
    with open("/proc/self/maps") as maps:
        libraries = {line.split()[-1] for line in maps if "blas" in line}
    return "OpenBLAS" if any("openblas" in path for path in libraries) else "not OpenBLAS"


def ceres_of(program, problem, axes, tool, station, start):
    """Seconds, steps and χ²; the stations start where scipy's do."""
    at = STATIONS[station] + 1e-3 * start[-40:].reshape(10, 4)[problem.virtual, :3]
    with tempfile.NamedTemporaryFile("w", suffix=".txt") as file:
        np.savetxt(file, np.column_stack([axes, TOOLS[tool], at, problem.weight, problem.l, problem.virtual]), fmt=["%.17g"] * 11 + ["%d"])
        file.flush()
        best = None
        for _ in range(3):
            words = subprocess.run([program, file.name, "2"], capture_output=True, text=True, check=True).stdout.split()
            best = words if best is None or float(words[0]) < float(best[0]) else best
    return float(best[0]), int(best[1]), float(best[2])


def main():
    program, n = sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 2000
    chance = np.random.default_rng(1)
    virtual = 10 * np.arange(n) // n
    tool = np.where(virtual < 4, 0, np.where(virtual < 7, 1, 2))
    station = np.where(virtual < 4, virtual, (virtual - 4) % 3 + (virtual >= 7))
    axes = np.round(chance.uniform(LOW, HIGH, (n, 3)), 3)
    problem = Problem(axes, tool, station, virtual, np.zeros(n))
    truth = np.concatenate([5 * chance.normal(size=177), np.zeros(40)])
    _, far = problem.beam(truth)
    problem.l = far - 300 + 1e-3 * chance.normal(size=n) / problem.weight
    folder = pathlib.Path(tempfile.mkdtemp())
    (folder / "machine.json").write_text(json.dumps({
        "chain": "XFYZ", "travel_mm": {a: [LOW[k], HIGH[k]] for k, a in enumerate("XYZ")},
        "tools_mm": {f"t{k}": list(TOOLS[k]) for k in range(3)}, "instrument": {"a_um": 0.2, "b_um_per_m": 0.3}}))
    (folder / "lengths.csv").write_text("station,tool,x_mm,y_mm,z_mm,length_mm\n" + "".join(
        f"s{s},t{t},{q[0]:.3f},{q[1]:.3f},{q[2]:.3f},{l:.7f}\n" for s, t, q, l in zip(station, tool, axes, problem.l)))
    start = np.concatenate([np.zeros(177), 100 * chance.normal(size=40)])

    begin = time.perf_counter()
    found = least_squares(problem.residuals, start, jac=problem.jacobian, method="trf", x_scale="jac", xtol=1e-12, ftol=1e-12)
    scipy_s = time.perf_counter() - begin

    begin = time.perf_counter()
    x = start.copy()
    for _ in range(3):
        rows, off = problem.jacobian(x), problem.residuals(x)
        x -= np.linalg.solve(rows.T @ rows, rows.T @ off)
    covariance = np.linalg.inv(rows.T @ rows)
    numpy_s = time.perf_counter() - begin

    done = subprocess.run([program, "bench", "volumetric", "--observations", str(n), "--threads", "0"], capture_output=True, text=True, check=True)
    ours_s = json.loads(done.stdout)["seconds"]
    result = json.loads(subprocess.run([program, "volumetric", "identify", folder / "lengths.csv", "--machine", folder / "machine.json", "--spans",
                                        str(SPANS), "--drift", "none", "--no-breaks", "--no-outliers", "--no-part-scales", "--json", "-"],
                                       capture_output=True, text=True).stdout)
    ours = np.array([result["errors"][k]["value"] for k in ("C0Y", "B0Z", "A0Z")])
    u = np.array([result["errors"][k]["u"] for k in ("C0Y", "B0Z", "A0Z")])
    print(f"numpy with {blas()}")
    print(f"{n} lengths, 217 unknowns, seconds: scipy trf {scipy_s:.3f}, numpy Gauss-Newton {numpy_s:.3f}, ours {ours_s:.4f}")
    print(f"ratio: scipy {scipy_s / ours_s:.1f}, numpy {numpy_s / ours_s:.1f}")
    print(f"squareness differs by {np.abs(ours - x[174:177]).max():.1e} µrad from numpy's, {np.abs(ours - found.x[174:177]).max():.1e} from "
          f"scipy's; u by {np.abs(u / result['variance_factor'] ** 0.5 / np.sqrt(np.diag(covariance))[174:177] - 1).max():.1e} of itself")

    if len(sys.argv) > 3:
        seconds, steps, chi = ceres_of(sys.argv[3], problem, axes, tool, station, start)
        own = result["chi2_per_dof"] * (n - 217)
        print(f"Ceres {seconds:.4f} s in {steps} steps, solution only; ratio {seconds / ours_s:.1f}; its χ² is {chi:.2f}, ours {own:.2f}")


if __name__ == "__main__":
    main()
