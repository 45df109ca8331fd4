#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random small multilaterations, solved by the program and by this independent script with dense matrices.

Usage: tests/multilateration_oracle.py PROGRAM [COUNT] [SEED]

The script iterates Gauss-Newton steps with numpy's pseudo-inverse of the full Jacobian over all points, stations, dead paths
and scales, lays the result onto the nominal points by the singular value decomposition of their product, and takes the
covariance from the pseudo-inverse brought to inner constraints by the S-transformation with dense matrices. It shares
nothing with the C++ code but eq. 2 of Lee et al. Also checks by numerical rank the least numbers of points and what coplanar
stations leave open.
"""
import json
import subprocess
import sys
import tempfile

import numpy as np


def make(rng):
    m = int(rng.integers(4, 9))
    model = str(rng.choice(["fixed", "fixed", "common", "free"]))
    n = int(rng.integers(16, 40))
    nominal = np.round(rng.uniform(0, 1, (n, 3)) * rng.uniform(200, 1500, 3) + rng.uniform(-2000, 2000, 3), 3)
    centre, size = nominal.mean(axis=0), np.ptp(nominal, axis=0).max()
    true = nominal + rng.normal(0, 0.02, (n, 3))
    angle = 2 * np.pi * (np.arange(m) + rng.uniform(0, 0.5, m)) / m
    stations = centre + size * np.c_[1.1 * np.cos(angle), 1.1 * np.sin(angle), rng.uniform(-0.7, 0.7, m)]
    kappa = 1 + (rng.normal(0, 1e-6, m) if model == "free" else np.zeros(m))
    a, b = rng.uniform(0.1, 2.0), rng.uniform(0.0, 1.0)
    repeatability = float(rng.choice([0.0, 0.5]))
    prior = float(rng.choice([0.0, 0.2, 5.0])) if model != "fixed" else 0.0
    readings, segments = [], {}
    for j in range(m):
        cut = int(rng.integers(8, n - 4)) if rng.random() < 0.3 else n
        for i in range(n):
            if rng.random() < 0.1 and (true[i] != 0).all():
                continue
            segment = int(i >= cut)
            dead = segments.setdefault((j, segment), rng.uniform(-500, 500))
            d = np.linalg.norm(true[i] - stations[j])
            sigma = np.hypot((a + b * d * 1e-3) / 2, repeatability) * 1e-3
            readings.append((i, j, segment, round(kappa[j] * d - dead + rng.normal(0, sigma), 8)))
    return dict(m=m, n=n, model=model, nominal=nominal, readings=readings, a=a, b=b, rep=repeatability, prior=prior,
                stations=stations)


def usable(case):
    """Every point seen by three stations or more, and enough of all."""
    seen = np.zeros((case["n"], case["m"]), bool)
    for i, j, _, _ in case["readings"]:
        seen[i, j] = True
    segments = {(j, s) for _, j, s, _ in case["readings"]}
    return seen.sum(axis=1).min() >= 4 and len(case["readings"]) > 3 * case["n"] + 5 * case["m"] + len(segments) + 10


def run(program, case, folder):
    with open(f"{folder}/p.csv", "w", encoding="utf-8") as file:
        file.write("point,x_mm,y_mm,z_mm\n" + "".join(f"P{i},{p[0]},{p[1]},{p[2]}\n" for i, p in enumerate(case["nominal"])))
    with open(f"{folder}/r.csv", "w", encoding="utf-8") as file:
        file.write("point,station,segment,length_mm\n" + "".join(f"P{i},S{j},{s},{l}\n" for i, j, s, l in case["readings"]))
    command = [program, "tracking", "multilaterate", f"{folder}/r.csv", "--points", f"{folder}/p.csv", "--json", "-",
               "--scale", case["model"], "--ranging", f"{case['a']!r}um+{case['b']!r}um/m",
               "--repeatability", f"{case['rep']!r}um", "--no-breaks"]
    if case["prior"]:
        command += ["--scale-prior", repr(case["prior"])]
    done = subprocess.run(command, capture_output=True, check=False)
    if done.returncode not in (0, 3):  # 3: a serious finding, which is none of the numbers' business
        sys.exit(f"{' '.join(command)}: {done.stderr.decode()}")
    return json.loads(done.stdout)


def gauge(points, stations, kappa, columns, with_size):
    """Columns of the null space over [points, stations, dead, kappa]."""
    centre = points.mean(axis=0)
    g = np.zeros((columns, 7 if with_size else 6))
    at = 0
    for p in np.vstack([points, stations]) - centre:
        g[at:at + 3, :3] = np.eye(3)
        g[at:at + 3, 3:6] = np.stack([np.cross(e, p) for e in np.eye(3)], axis=1)
        if with_size:
            g[at:at + 3, 6] = p
        at += 3
    if with_size:
        g[-len(kappa):, 6] = -kappa
    return g


def solve(case):
    n, m, model = case["n"], case["m"], case["model"]
    i, j, s, l = (np.array(x) for x in zip(*case["readings"]))
    l = l.astype(float)
    keys = sorted({(a, b) for a, b in zip(j, s)})
    k = np.array([keys.index((a, b)) for a, b in zip(j, s)])
    prior = case["prior"] * 1e-6
    with_size = model != "fixed" and not prior
    points, stations = case["nominal"] - case["nominal"].mean(axis=0), case["stations"] - case["nominal"].mean(axis=0)
    nominal = points.copy()
    kappa = np.ones(m)
    dead = np.array([np.mean(np.linalg.norm(points[i[k == q]] - stations[keys[q][0]], axis=1) - l[k == q]) for q in range(len(keys))])
    columns = 3 * n + 3 * m + len(keys) + m  # kappa always has columns; they are tied together or held where not free
    scale = np.ones(columns)
    scale[-m:] = 1e-3

    def linearise():
        beam = points[i] - stations[j]
        d = np.linalg.norm(beam, axis=1)
        u = beam / d[:, None]
        sigma = np.hypot((case["a"] + case["b"] * d * 1e-3) / 2, case["rep"]) * 1e-3
        rows = np.arange(len(l))
        jacobian = np.zeros((len(l), columns))
        for c in range(3):
            jacobian[rows, 3 * i + c] = kappa[j] * u[:, c]
            jacobian[rows, 3 * n + 3 * j + c] = -kappa[j] * u[:, c]
        jacobian[rows, 3 * n + 3 * m + k] = -1
        jacobian[rows, 3 * n + 3 * m + len(keys) + j] = d
        w = kappa[j] * d - l - dead[k]
        jacobian, w = jacobian / sigma[:, None], w / sigma
        if model == "fixed":
            jacobian[:, -m:] = 0
        if model == "common":  # one column for all, kept in the first
            jacobian[:, -m] = jacobian[:, -m:].sum(axis=1)
            jacobian[:, -m + 1:] = 0
        if prior:
            extra = np.zeros((m if model == "free" else 1, columns))
            for q in range(len(extra)):
                extra[q, columns - m + q] = 1 / prior
            jacobian = np.vstack([jacobian, extra])
            w = np.concatenate([w, (kappa[:len(extra)] - 1) / prior])
        return jacobian, w, jacobian * scale

    rank_lost = 7 if with_size else 6
    used = columns - (m if model == "fixed" else m - 1 if model == "common" else 0)

    def pseudo_inverse(scaled):
        u, values, v = np.linalg.svd(scaled, full_matrices=False)
        keep = used - rank_lost
        if values[keep - 1] < 1e-9 * values[0]:
            sys.exit(f"rank: {values[keep - 3:keep + 2] / values[0]}")
        return (v[:keep].T / values[:keep]) @ u[:, :keep].T, values[0] / values[keep - 1]

    for _ in range(12):
        jacobian, w, scaled = linearise()
        inverse, _ = pseudo_inverse(scaled)
        step = -scale * (inverse @ w)
        points = points + step[:3 * n].reshape(n, 3)
        stations = stations + step[3 * n:3 * n + 3 * m].reshape(m, 3)
        dead = dead + step[3 * n + 3 * m:3 * n + 3 * m + len(keys)]
        kappa = kappa + (step[-m:] if model == "free" else step[-m] if model == "common" else 0)
    from_, to = points.mean(axis=0), nominal.mean(axis=0)
    u, values, v = np.linalg.svd((nominal - to).T @ (points - from_))
    turn = u @ v  # mirrored where that fits better
    size = values.sum() / ((points - from_) ** 2).sum() if with_size else 1.0
    points, stations = [to + size * (x - from_) @ turn.T for x in (points, stations)]
    kappa = kappa / size
    jacobian, w, scaled = linearise()
    inverse, _ = pseudo_inverse(scaled)
    covariance = scale[:, None] * (inverse @ inverse.T) * scale
    if model == "common":  # spread the one column to all stations
        spread = np.eye(columns)
        spread[-m:, -m:] = 0
        spread[-m:, -m] = 1
        covariance = spread @ covariance @ spread.T
    g = gauge(points, stations, kappa, columns, with_size)
    h = np.zeros_like(g)
    h[:3 * n] = g[:3 * n]
    s = np.eye(columns) - g @ np.linalg.inv(h.T @ g) @ h.T
    covariance = s @ covariance @ s.T
    chi, nu = float(w @ w), len(w) - (used - rank_lost)
    factor = max(1.0, chi / nu)
    if model == "common" and prior:  # no residual tests the prior of a size, so that it is not made larger with them
        size = gauge(points, stations, kappa, columns, True)[:, 6] * prior
        covariance = covariance + (1 / factor - 1) * np.outer(size, size)
    offset = case["nominal"].mean(axis=0)
    return dict(points=points + offset, stations=stations + offset, dead=dead, keys=keys, kappa=kappa, chi=chi, nu=nu,
                covariance=covariance * factor)


def compare(case, ours, theirs):
    n, m = case["n"], case["m"]
    order = [int(p["name"][1:]) for p in ours["points"]]
    names = [int(s["name"][1:]) for s in ours["stations"]]
    worst = {}

    def see(what, value, limit):
        worst[what] = max(worst.get(what, 0.0), float(value) / limit)

    c = theirs["covariance"]
    for k, i in enumerate(order):
        see("point", np.abs(np.array(ours["points"][k]["position_mm"]) - theirs["points"][i]).max(), 1e-6)
        block = c[3 * i:3 * i + 3, 3 * i:3 * i + 3]
        see("covariance", np.abs(np.array(ours["points"][k]["covariance_mm2"]) - block).max() / np.abs(block).max(), 1e-4)
    for k, j in enumerate(names):
        see("station", np.abs(np.array(ours["stations"][k]["position_mm"]) - theirs["stations"][j]).max(), 1e-6)
        block = c[3 * n + 3 * j:3 * n + 3 * j + 3, 3 * n + 3 * j:3 * n + 3 * j + 3]
        see("covariance of stations", np.abs(np.array(ours["stations"][k]["covariance_mm2"]) - block).max() / np.abs(block).max(), 1e-4)
        for path in ours["stations"][k]["dead_paths"]:
            q = theirs["keys"].index((j, int(path["segment"])))
            see("dead path", abs(path["dead_path_mm"] - theirs["dead"][q]), 1e-6)
            u = np.sqrt(c[3 * n + 3 * m + q, 3 * n + 3 * m + q])
            see("u of dead path", abs(path["u_mm"] / u - 1), 1e-3)
        see("scale", abs(ours["stations"][k]["scale"] - theirs["kappa"][j]), 1e-9)
        u = np.sqrt(c[-m + j, -m + j])
        if case["model"] != "fixed":
            see("u of scale", abs(ours["stations"][k]["scale_u"] / u - 1), 1e-3)
    see("chi squared", abs(ours["chi_squared"] / theirs["chi"] - 1), 1e-5)
    if ours["degrees_of_freedom"] != theirs["nu"]:
        sys.exit(f"degrees of freedom {ours['degrees_of_freedom']} against {theirs['nu']}")
    bad = {k: v for k, v in worst.items() if not v <= 1}
    if bad:
        sys.exit(f"{case['model']}, prior {case['prior']}, {n} points, {m} stations: {bad} (1 is the tolerance)")
    return worst


def null_directions(rng, n, m, free, coplanar):
    p, s = rng.normal(size=(n, 3)), 2 * rng.normal(size=(m, 3))
    if coplanar:
        s[:, 2] = -3
    rows = []
    for i in range(n):
        for j in range(m):
            row = np.zeros(3 * n + (5 if free else 4) * m)
            d = np.linalg.norm(p[i] - s[j])
            row[3 * i:3 * i + 3] = (p[i] - s[j]) / d
            row[3 * n + 3 * j:3 * n + 3 * j + 3] = -row[3 * i:3 * i + 3]
            row[3 * n + 3 * m + j] = -1
            if free:
                row[3 * n + 4 * m + j] = d
            rows.append(row)
    values = np.linalg.svd(np.array(rows), compute_uv=False)
    return len(rows[0]) - int((values > 1e-10 * values[0]).sum()) - (7 if free else 6)


def check_counts(rng):
    for free, least in ((False, (10, 7, 6, 6, 6, 5, 5)), (True, (13, 9, 8, 7, 7, 7, 7))):
        for m, n in zip(range(4, 11), least):
            if null_directions(rng, n, m, free, False) != 0 or null_directions(rng, n - 1, m, free, False) == 0:
                sys.exit(f"{m} stations do not need {n} points (free scales: {free})")
        for m in range(4, 9):
            expected = max(0, (8 if free else 6) - m)
            if null_directions(rng, 20, m, free, True) != expected:
                sys.exit(f"{m} coplanar stations do not leave {expected} directions open (free scales: {free})")


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 40
    rng = np.random.default_rng(int(sys.argv[3]) if len(sys.argv) > 3 else 1)
    check_counts(rng)
    done, worst = 0, {}
    with tempfile.TemporaryDirectory() as folder:
        while done < count:
            case = make(rng)
            if not usable(case):
                continue
            for what, value in compare(case, run(program, case, folder), solve(case)).items():
                worst[what] = max(worst.get(what, 0.0), value)
            done += 1
    print(f"{count} problems agree; largest differences over their tolerances: " +
          ", ".join(f"{what} {value:.2g}" for what, value in worst.items()))


if __name__ == "__main__":
    main()
