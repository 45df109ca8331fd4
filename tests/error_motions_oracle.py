#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds `axiometry straightness`, `squareness` and `angles` against an independent computation, on seeded tests.

Usage: tests/error_motions_oracle.py PROGRAM [TESTS]

Shares nothing with the program: lines by numpy's lstsq and polyfit, the scatter by evaluating every run for itself, what
the instrument adds by numerical derivatives of the whole evaluation, Student's t by scipy, rotations of a rigid body by
matrices. At the end the coverage of U for truths that are known.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import scipy.spatial.transform
import scipy.stats

PROGRAM = sys.argv[1]
TESTS = int(sys.argv[2]) if len(sys.argv) > 2 else 60
ARCSEC = 180 * 3600 / math.pi
P = 0.5 * (1 + math.erf(2 / math.sqrt(2)))


def near(found, wanted, what, tolerance=1e-9):
    if not abs(found - wanted) <= tolerance * max(1.0, abs(wanted)):
        raise SystemExit(f"{what}: found {found!r}, expected {wanted!r}")


def line_of(x, y, reference):
    if reference == "end-points":
        slope = (y[-1] - y[0]) / (x[-1] - x[0])
        return y[0] - slope * x[0], slope
    middle = x.mean()
    at, slope = np.linalg.lstsq(np.stack([np.ones_like(x), x - middle], 1), y, rcond=None)[0]
    return at - slope * middle, slope


def measure(rng, directions=None, runs=None):
    m = int(rng.integers(3, 40))
    x = np.round(np.sort(rng.uniform(-300, 900, m * 2)), 3)
    x = np.unique(x)[:: 2]
    x = x if len(x) >= 3 else np.array([0.0, 10.0, 25.0])
    d = directions or int(rng.integers(1, 3))
    r = runs or int(rng.integers(1, 6))
    way = np.cumsum(rng.normal(0, 0.4, len(x))) + rng.uniform(-0.02, 0.02) * x
    y = np.array([[way + 0.3 * k + rng.normal(0, 0.15, len(x)) + rng.normal(0, 1e-4) * x for _ in range(r)]
                  for k in range(d)])
    return x, np.round(y, 4)  # [direction][run][position]


def write(folder, name, x, y, head, rng):
    rows = [f"{float(p)!r},{r + 1},{'up' if d == 0 else 'down'},{float(y[d][r][i])!r}"
            for d in range(y.shape[0]) for r in range(y.shape[1]) for i, p in enumerate(x)]
    rng.shuffle(rows)
    path = folder / name
    path.write_text(f"position_mm,run,direction,{head}\n" + "\n".join(rows) + "\n")
    return str(path)


def program(*arguments):
    done = subprocess.run([PROGRAM, *arguments, "--json", "-"], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"{arguments}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def u_of_runs(values, function, x, y):
    """Of the runs' own figures, or of the noise about their lines through the gradient, whichever has the larger U."""
    n = len(values)
    runs = (float(np.std(values, ddof=1) / math.sqrt(n)), n - 1)
    left = np.array([[run - np.polyval(np.polyfit(x - x.mean(), run, 1), x - x.mean()) for run in way] for way in y])
    left -= left.mean(axis=1, keepdims=True)
    degrees = y.shape[0] * (n - 1) * (len(x) - 2)
    means, squares = y.mean(axis=1), 0.0
    for d in range(y.shape[0]):
        for i in range(len(x)):
            more = means.copy()
            more[d][i] += 1.0
            squares += (function(more) - function(means)) ** 2
    noise = (math.sqrt(float(np.sum(left ** 2)) / degrees * squares / n), degrees)
    return max(runs, noise, key=lambda part: scipy.stats.t.ppf(P, part[1]) * part[0])


def bound(function, means, u):
    """Σ |∂f/∂y| u by differences, of a function that is linear where its extremes stay: means[direction][position]."""
    total, h = 0.0, 1e-6
    for d in range(means.shape[0]):
        for i in range(means.shape[1]):
            more, less = means.copy(), means.copy()
            more[d][i] += h
            less[d][i] -= h
            total += abs(function(more) - function(less)) / (2 * h) * u[i]
    return total


def check_estimate(found, value, scatter, instrument, what):
    near(found["value"], value, what)
    near(found["u_instrument"], instrument, what + " instrument", 1e-6)
    u, degrees = scatter if scatter else (0.0, math.inf)
    if scatter is None:
        assert found["scatter"] is None, what
    else:
        near(found["u_scatter"], u, what + " scatter", 1e-8)
    near(found["u"], math.hypot(u, instrument), what + " u", 1e-6)
    if u > 1e-9:
        effective = math.hypot(u, instrument) ** 4 / (u ** 4 / degrees)
        if abs(effective - round(effective)) > 1e-4 or instrument == 0:
            k = scipy.stats.t.ppf(P, max(1, math.floor(effective * (1 + 1e-12))))
            near(found["k"], k, what + " k", 1e-7)
            near(found["U"], k * found["u"], what + " U", 1e-7)


def check_courses(found, x, y, reference, a, b):
    u = (a + b * (x - x[0]) / 1000) / 2
    selections = [[0]] if y.shape[0] == 1 else [[0], [1], [0, 1]]
    means = y.mean(axis=1)
    for course, chosen in zip(found["courses"], selections):
        mean = means[chosen].mean(axis=0)
        a0, slope = line_of(x, mean, reference)
        rest = mean - a0 - slope * x
        p, q = int(rest.argmax()), int(rest.argmin())
        near(course["slope_per_m"]["value"], 1000 * slope, "slope")
        near(course["theta_arcsec"], math.atan(1e-6 * 1000 * slope) * ARCSEC, "theta")
        near(course["intercept"]["value"], a0, "intercept")

        def slope_of(means_, chosen=chosen):
            return 1000 * line_of(x, means_[chosen].mean(axis=0), reference)[1]

        def intercept_of(means_, chosen=chosen):
            return line_of(x, means_[chosen].mean(axis=0), reference)[0]

        def range_of(means_, chosen=chosen, p=p, q=q):
            own = means_[chosen].mean(axis=0)
            at, tilt = line_of(x, own, reference)
            left = own - at - tilt * x
            return left[p] - left[q]

        for key, function in (("slope_per_m", slope_of), ("intercept", intercept_of), ("range", range_of)):
            if y.shape[1] > 1:
                scatter = u_of_runs([function(y[:, r, :]) for r in range(y.shape[1])], function, x, y)
            elif key == "range":
                scatter = None
            else:
                at, tilt = line_of(x, mean, "least-squares")
                s = math.sqrt(float(np.sum((mean - at - tilt * x) ** 2)) / (len(x) - 2))
                gradient = [(function(means + h) - function(means)) for h in
                            (np.where(np.arange(len(x)) == i, 1.0, 0.0)[None, :] for i in range(len(x)))]
                scatter = (s * math.sqrt(sum(g * g for g in gradient)), len(x) - 2)
            check_estimate(course[key], function(means), scatter, bound(function, means, u), key)
    if y.shape[0] == 1:
        assert found["range_both"] is None and found["reversal"] is None
        return
    a0, slope = line_of(x, means.mean(axis=0), reference)
    both = means - a0 - slope * x
    near(found["range_both"]["value"], both.max() - both.min(), "range over both directions")
    reversal = means[0] - means[1]
    near(abs(found["reversal"]["value"]), np.abs(reversal).max(), "reversal")
    near(found["reversal_mean"], reversal.mean(), "mean reversal")
    if y.shape[1] > 1:
        s = y.std(axis=1, ddof=1)
        near(found["repeatability_up"], 4 * s[0].max(), "repeatability up")
        near(found["repeatability_down"], 4 * s[1].max(), "repeatability down")
        near(found["repeatability"], np.max([2 * s[0] + 2 * s[1] + np.abs(reversal), 4 * s[0], 4 * s[1]]), "R")


def check_squareness(found, lines, square, square_U):
    by_name = [{course["course"]: course for course in line["courses"]} for line in lines]
    both = [name for name in by_name[0] if name in by_name[1]]  # the mean of both directions last, where there is one
    theta = [courses[both[-1]] for courses in by_name]
    values = [math.atan(1e-6 * t["slope_per_m"]["value"]) * ARCSEC for t in theta]
    near(found["squareness_arcsec"]["value"], values[1] - values[0] + square, "squareness")
    factor = ARCSEC * 1e-6
    scatter = math.hypot(*(t["slope_per_m"]["u_scatter"] * factor for t in theta))
    instrument = sum(t["slope_per_m"]["u_instrument"] for t in theta) * factor
    near(found["squareness_arcsec"]["u"], math.sqrt(scatter ** 2 + instrument ** 2 + square_U ** 2 / 4), "u of S", 1e-6)


def check_senses(folder, rng):
    """Two axes of a machine as directions in space, read by sensors that are positive either way: the angle between both and
    which rotation about the third axis that is."""
    first, second = rng.choice(3, 2, replace=False)
    third = 3 - first - second
    x = np.arange(0.0, 501.0, 100.0)
    directions = np.eye(3)
    for a, b in ((first, second), (second, first)):
        directions[a][b] = rng.uniform(-3e-5, 3e-5)
    files, senses = [], []
    for a, b in ((first, second), (second, first)):
        sign = int(rng.choice([-1, 1]))
        bow = rng.normal(0, 0.2) * ((x - 250) ** 2 - 250 ** 2) / 250 ** 2  # symmetrical: no slope
        files.append(write(folder, f"sense{len(files)}.csv", x, sign * (1e3 * directions[a][b] * x + bow)[None, None, :],
                           f"E{'XYZ'[b]}{'XYZ'[a]}_um", rng))
        senses.append(("+" if sign > 0 else "-") + "XYZ"[b])
    found = program("squareness", *files, f"--positive={','.join(senses)}")
    angle = math.acos(np.dot(directions[first], directions[second]) /
                      np.linalg.norm(directions[first]) / np.linalg.norm(directions[second]))
    near(found["squareness_arcsec"]["value"], (angle - math.pi / 2) * ARCSEC, "squareness in axes", 1e-6)
    early, late = sorted((int(first), int(second)))
    normal = np.eye(3)[third]
    turned = [math.atan2(np.dot(normal, np.cross(np.eye(3)[a], directions[a])), directions[a][a]) for a in (late, early)]
    location = found["location_error"]
    assert location["name"] == "ABC"[third] + "0" + "XYZ"[late], location["name"]
    near(location["urad"]["value"], 1e6 * (turned[0] - turned[1]), "location error", 1e-6)


def check_angles(folder, rng):
    x = np.arange(0.0, 500.0, 100.0)
    angles = np.round(rng.normal(0, 20, (3, len(x))), 3)
    offset = np.round(rng.uniform(-400, 400, 3), 2)
    unit, urad = ("urad", 1.0) if rng.random() < 0.5 else ("arcsec", 1e6 / ARCSEC)
    there, back = angles + 1.5, angles - 1.5  # what counts is the mean of both directions
    files = [write(folder, f"{n}.csv", x, np.stack([there[k], back[k]])[:, None, :], f"{n}_{unit}", rng)
             for k, n in enumerate(("EAY", "EBY", "ECY"))]
    found = program("angles", *files, "--offset", ",".join(map(str, offset)))["abbe"]["change_um"]
    for i in range(len(x)):
        turned = scipy.spatial.transform.Rotation.from_rotvec(1e-6 * urad * angles[:, i]).apply(offset) - offset
        left_out = 1e3 * np.linalg.norm(1e-6 * urad * angles[:, i]) ** 2 * np.linalg.norm(offset)  # first order
        for k, name in enumerate(("EXY", "EYY", "EZY")):
            assert abs(found[name][i] - 1e3 * turned[k]) < left_out + 1e-9, (name, found[name][i], turned)


def coverage(folder, rng):
    """True slopes and squareness within U, of five runs with noise and a drift of each run's slope: 95 %."""
    inside, count = 0, 150
    x = np.arange(0.0, 501.0, 50.0)
    for _ in range(count):
        truth = rng.uniform(-20, 20, 2)
        files = []
        for k in (0, 1):
            y = np.array([[1e-3 * (truth[k] + rng.normal(0, 1)) * x + rng.normal(0, 0.2, len(x)) for _ in range(5)]])
            files.append(write(folder, f"s{k}.csv", x, y, "straightness_um", rng))
        s = program("squareness", *files)["squareness_arcsec"]
        inside += abs(s["value"] - (truth[1] - truth[0]) * 1e-6 * ARCSEC) <= s["U"]
    if not 0.90 <= inside / count <= 0.995:  # 95.45 % with a standard deviation of 1.7 %
        raise SystemExit(f"coverage of the squareness: {inside} of {count}")


def main():
    rng = np.random.default_rng(230)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for _ in range(TESTS):
            reference = str(rng.choice(["least-squares", "end-points"]))
            a, b = round(float(rng.uniform(0, 1)), 3), round(float(rng.uniform(0, 2)), 3)
            square, square_U = round(float(rng.normal(0, 2)), 3), round(float(rng.uniform(0, 1)), 3)
            tests = [measure(rng), measure(rng)]
            files = [write(folder, f"{k}.csv", *t, "straightness_um", rng) for k, t in enumerate(tests)]
            common = ["--reference", reference, "--instrument", f"{a},{b}"]
            found = program("squareness", *files, *common, "--square-error", str(square), "--square-uncertainty",
                            str(square_U))
            for line, (x, y) in zip(found["lines"], tests):
                check_courses(line, x, y, reference, a, b)
            check_squareness(found, found["lines"], square, square_U)
            alone = program("straightness", files[0], *common)["straightness"]
            assert alone["courses"] == found["lines"][0]["courses"]
        for _ in range(10):
            check_angles(folder, rng)
            check_senses(folder, rng)
        coverage(folder, rng)
    print(f"error motions: {TESTS} tests agree")


if __name__ == "__main__":
    main()
