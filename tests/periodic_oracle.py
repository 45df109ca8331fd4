#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds `axiometry periodic` against an independent computation, on seeded tests of known truth.

Usage: tests/periodic_oracle.py PROGRAM [TESTS]

Shares nothing with the program: the fit by scipy's trust region least squares on the nonlinear model, the spectrum by
numpy's lstsq at every period of a finer comb, the peak to valley by a dense table, chances by scipy's F distribution.
"""
import json
import math
import subprocess
import sys
import tempfile

import numpy as np
import scipy.optimize
import scipy.special
import scipy.stats

PROGRAM = sys.argv[1]
TESTS = int(sys.argv[2]) if len(sys.argv) > 2 else 120
TAU = 2 * math.pi


def measure(rng):
    """One test: targets, readings of one direction, and its truth."""
    n = int(rng.integers(24, 120))
    period = float(rng.choice([0.02, 5.0, 10.0, 16.0]) * rng.uniform(0.9, 1.1))
    per_period = rng.uniform(6, 14)
    step = period / per_period
    first = rng.uniform(-40, 300) * step
    jitter = 0.0 if rng.random() < 0.3 else 0.35
    x = first + step * (np.arange(n) + jitter * rng.uniform(-1, 1, n))
    x = np.round(np.sort(x), 9)
    amplitude, phase, noise = rng.uniform(0.5, 3), rng.uniform(-3, 3), rng.uniform(0.02, 0.3)
    second = rng.uniform(0.3, 0.8) if rng.random() < 0.4 else 0.0
    offset, slope = rng.uniform(-5, 5), rng.uniform(-1, 1) / (n * step)
    truth = lambda p: (offset + slope * (p - x[0]) + amplitude * np.sin(TAU * p / period + phase)
                       + second * np.sin(2 * TAU * p / period + 1))
    runs = int(rng.integers(1, 4))
    readings = np.array([truth(x) + rng.normal(0, noise, n) for _ in range(runs)])
    return x, readings, {"period": period, "amplitude": amplitude, "phase_at_zero": phase}


def program(x, readings, *options):
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        file.write("# unit: um\n# target unit: mm\n# test.cycle: unidirectional\ntarget,direction,run,deviation\n")
        for j, run in enumerate(readings):
            file.writelines(f"{float(p)!r},up,{j + 1},{float(v)!r}\n" for p, v in zip(x, run))
        file.flush()
        done = subprocess.run([PROGRAM, "periodic", file.name, "--json", "-", *options], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)["directions"][0]


def design(x, period, orders):
    u = x - x[0]
    columns = [np.ones_like(x), u]
    for h in orders:
        columns += [np.sin(TAU * h * u / period), np.cos(TAU * h * u / period)]
    return np.stack(columns, 1)


def line_rest(x, y):
    A = np.stack([np.ones_like(x), x - x[0]], 1)
    return float(np.sum((y - A @ np.linalg.lstsq(A, y, rcond=None)[0]) ** 2))


def reduction(x, y, period):
    A = design(x, period, [1])
    return 1 - float(np.sum((y - A @ np.linalg.lstsq(A, y, rcond=None)[0]) ** 2)) / line_rest(x, y)


def fit(x, y, start, orders, free):
    """Coefficients (… and the period), covariance, residual sum, by scipy on the nonlinear model."""
    A = design(x, start, orders)
    beta = np.linalg.lstsq(A, y, rcond=None)[0]
    if not free:
        rest = y - A @ beta
        nu = len(x) - A.shape[1]
        return beta, np.linalg.inv(A.T @ A) * float(rest @ rest) / nu, rest, nu
    model = lambda q: design(x, q[-1] * start, orders) @ q[:-1] - y
    scale = np.append(np.maximum(np.abs(beta), 1e-3), 1.0)
    found = scipy.optimize.least_squares(model, np.append(beta, 1.0), x_scale=scale, jac="3-point", method="trf",
                                         xtol=1e-15, ftol=1e-15, gtol=1e-15)
    nu = len(x) - len(found.x)
    covariance = np.linalg.inv(found.jac.T @ found.jac) * 2 * found.cost / nu
    unit = np.append(np.ones(len(beta)), start)
    return found.x * unit, covariance * np.outer(unit, unit), -found.fun, nu


def false_alarm(x, z, shortest, longest):
    """Baluev (2008), eqs. 5 and 24, with a line as base model."""
    n_h, n_k = len(x) - 2, len(x) - 4
    single = (1 - z) ** (n_k / 2)
    width = (1 / shortest - 1 / longest) * math.sqrt(4 * math.pi * np.var(x))
    gamma = math.sqrt(2 / n_h) * math.exp(scipy.special.gammaln(n_h / 2) - scipy.special.gammaln((n_h - 1) / 2))
    crossings = gamma * width * (1 - z) ** ((n_k - 1) / 2) * math.sqrt(n_h * z / 2)
    return -math.expm1(math.log1p(-single) - crossings)


def enlargement(rest, nu, targets_per_period):
    """√g of docs/theory/periodic-error.md, by which U is larger where residuals go on from target to target; else 1."""
    n = len(rest)
    seen = float(rest[:-1] @ rest[1:] / (rest @ rest))
    corrected = seen + (1 + seen) * (n - nu - 1) / n
    if corrected <= 1.6449 / math.sqrt(n):
        return 1.0
    most = min(max(corrected + 2 * math.sqrt((1 - seen * seen) / n), 0), 1)
    rho, cosine = np.linspace(0, most, 100001), math.cos(TAU / targets_per_period)
    return math.sqrt(max(1.0, float(np.max((1 - rho**2) / (1 - 2 * rho * cosine + rho**2)))))


class Checks:
    def __init__(self):
        self.failed = 0
        self.count = 0
        self.where = ""

    def near(self, what, found, expected, tolerance):
        self.count += 1
        if not abs(found - expected) <= tolerance:
            self.failed += 1
            print(f"{self.where}: {what} is {found!r}, expected {expected!r} within {tolerance:.3g}")


def check(checks, x, readings, known):
    y = readings.mean(0)
    d = program(x, readings, *(["--period", repr(known)] if known else []))
    step = (x[-1] - x[0]) / (len(x) - 1)
    orders = [h["order"] for h in d["harmonics"] if h["in_curve"]]
    if not known:
        shortest, longest = 2.1 * step, (x[-1] - x[0]) / 2
        comb = 1 / np.linspace(1 / longest, 1 / shortest, 25 * len(x))
        z = np.array([reduction(x, y, p) for p in comb])
        best = comb[int(np.argmax(z))]
        width = best * best / (x[-1] - x[0]) / 10
        peak = scipy.optimize.minimize_scalar(lambda p: -reduction(x, y, p), bounds=(best - width, best + width),
                                              method="bounded", options={"xatol": 1e-10 * best})
        p = false_alarm(x, -peak.fun, shortest, longest)
        checks.near("log chance", math.log(max(d["false_alarm_probability"], 1e-12)), math.log(max(p, 1e-12)), 1e-3)
    start = known or d["period"]["value"]
    beta, covariance, rest, nu = fit(x, y, start, orders, not known)
    per_period = (known or beta[-1]) / step
    times = np.full(len(beta), enlargement(rest, nu, per_period))
    times[:2] = enlargement(rest, nu, 2 * len(x))
    covariance = covariance * np.outer(times, times)
    u = np.sqrt(np.diag(covariance))
    s, c = beta[2], beta[3]
    amplitude = math.hypot(s, c)
    by = np.array([s, c]) / amplitude
    scale = u[2]
    checks.near("degrees of freedom", d["degrees_of_freedom"], nu, 0)
    if not known:
        checks.near("period", d["period"]["value"], beta[-1], 1e-4 * u[-1])
        checks.near("u of the period", d["period"]["u"], u[-1], 1e-3 * u[-1])
    checks.near("amplitude", d["amplitude"]["value"], amplitude, 1e-4 * scale)
    checks.near("u of the amplitude", d["amplitude"]["u"], math.sqrt(by @ covariance[2:4, 2:4] @ by), 1e-3 * scale)
    phase = math.degrees(math.atan2(c, s))
    checks.near("phase", math.remainder(d["phase_deg"]["value"] - phase, 360), 0,
                1e-3 * math.degrees(scale / amplitude))
    across = np.array([-c, s]) / amplitude**2
    checks.near("u of the phase", d["phase_deg"]["u"], math.degrees(math.sqrt(across @ covariance[2:4, 2:4] @ across)),
                1e-3 * math.degrees(scale / amplitude))
    gradient = np.zeros(len(beta))
    gradient[2:4] = across
    period = known or beta[-1]
    if not known:
        gradient[-1] = TAU * x[0] / period**2
    checks.near("phase at 0", math.remainder(d["phase_at_zero_deg"]["value"] - phase + 360 * x[0] / period, 360), 0,
                1e-3 * d["phase_at_zero_deg"]["u"])
    checks.near("u of the phase at 0", d["phase_at_zero_deg"]["u"],
                min(math.degrees(math.sqrt(gradient @ covariance @ gradient)), 360 / math.sqrt(12)),
                2e-3 * d["phase_at_zero_deg"]["u"])
    checks.near("slope", d["slope"]["value"], beta[1], 1e-4 * u[1])
    checks.near("u of the slope", d["slope"]["u"], u[1], 1e-3 * u[1])
    checks.near("offset", d["offset"]["value"], beta[0], 1e-4 * u[0])
    dense = x[0] + np.linspace(0, period, 200001)
    curve = design(np.append(x[0], dense), period, orders)[1:, 2:] @ beta[2:2 + 2 * len(orders)]
    checks.near("peak to valley", d["peak_to_valley"]["value"], np.ptp(curve), 1e-4 * scale)
    top, bottom = (design(np.append(x[0], dense[[k]]), period, orders)[1, 2:] for k in (curve.argmax(), curve.argmin()))
    lever = top - bottom
    part = covariance[2:2 + len(lever), 2:2 + len(lever)]
    checks.near("u of the peak to valley", d["peak_to_valley"]["u"], math.sqrt(lever @ part @ lever), 2e-3 * scale)
    checks.near("residual sd", d["residual_sd"], math.sqrt(rest @ rest / nu), 1e-6)
    checks.near("k", d["coverage_factor"], scipy.stats.t.ppf(scipy.stats.norm.cdf(2), nu), 1e-7)
    for h in d["harmonics"][1:]:
        several = sorted(set(range(1, len(d["harmonics"]) + 1))) if not h["in_curve"] else orders
        b, V, _, free = fit(x, y, period, several, not known and h["in_curve"])
        at = 2 + 2 * several.index(h["order"])
        checks.near(f"amplitude {h['order']}", h["amplitude"]["value"], math.hypot(b[at], b[at + 1]), 2e-3 * scale)
        F = b[at:at + 2] @ np.linalg.solve(V[at:at + 2, at:at + 2], b[at:at + 2]) / 2
        chance = scipy.stats.f.sf(F, 2, free)
        if chance > 1e-12:
            checks.near(f"chance of {h['order']}", h["chance"], chance, 1e-2 * chance + 1e-12)
    return d


def main():
    checks = Checks()
    within = {"period": 0, "amplitude": 0, "phase_at_zero": 0}
    for seed in range(TESTS):
        x, readings, truth = measure(np.random.default_rng([230, seed]))
        checks.where = f"test {seed}"
        d = check(checks, x, readings, None)
        check(checks, x, readings, truth["period"])
        within["period"] += abs(d["period"]["value"] - truth["period"]) <= d["period"]["U"]
        within["amplitude"] += abs(d["amplitude"]["value"] - truth["amplitude"]) <= d["amplitude"]["U"]
        off = math.remainder(d["phase_at_zero_deg"]["value"] - math.degrees(truth["phase_at_zero"]), 360)
        within["phase_at_zero"] += abs(off) <= d["phase_at_zero_deg"]["U"]
    # 95.45 % less three standard deviations of a binomial count
    least = 0.9545 * TESTS - 3 * math.sqrt(TESTS * 0.9545 * 0.0455)
    for what, count in within.items():
        print(f"truth within U: {what} in {count} of {TESTS} tests")
        if count < least:
            checks.failed += 1
            print(f"expected at least {least:.0f}")
    print(f"{checks.count} figures compared, {checks.failed} failed")
    return 1 if checks.failed else 0


if __name__ == "__main__":
    sys.exit(main())
