#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random polar measurements joined with lengths, adjusted by the program and by this independent script.

Usage: tests/polar_oracle.py PROGRAM [COUNT] [SEED]

The script takes eq. 1 of Lee et al. as it stands: predicted lengths, azimuths and elevations by arctangents, a Jacobian by
central differences in all unknowns (turns as rotation vectors), Gauss-Newton steps with numpy's pseudo-inverse, and
covariances by the pseudo-inverse brought to the datum by the S-transformation with dense matrices. It shares nothing with the
C++ code, which eliminates points and compares directions by unit vectors. Also checks the study of methods: the same
covariances for polar measurement and for multilateration.
"""
import json
import subprocess
import sys
import tempfile

import numpy as np

ARCSEC = np.pi / 648000


def turn_of(v):
    angle = np.linalg.norm(v)
    k = np.array([[0, -v[2], v[1]], [v[2], 0, -v[0]], [-v[1], v[0], 0]])
    if angle < 1e-12:
        return np.eye(3) + k
    return np.eye(3) + np.sin(angle) / angle * k + (1 - np.cos(angle)) / angle**2 * k @ k


def shown(p, s, turn):
    q = turn.T @ (p - s)
    return np.linalg.norm(q), np.arctan2(q[1], q[0]), np.arctan2(q[2], np.hypot(q[0], q[1]))


def make(rng):
    trackers, tracers = int(rng.integers(1, 4)), int(rng.integers(0, 3))
    n = int(rng.integers(8, 16))
    box = rng.uniform(300, 2000, 3)
    points = rng.uniform(0, 1, (n, 3)) * box
    stations, turns = [], []
    for j in range(trackers + tracers):
        angle = rng.uniform(0, 2 * np.pi)
        stations.append(box / 2 + np.linalg.norm(box) * np.r_[np.cos(angle), np.sin(angle), rng.uniform(-0.3, 0.5)])
        turns.append(turn_of(rng.uniform(-1, 1, 3) * [0.05, 0.05, 3]))
    rows = []
    for j, (s, turn) in enumerate(zip(stations, turns)):
        dead = rng.uniform(-500, 500, 2)
        for i in range(n):
            if j > 0 and rng.random() < 0.15:
                continue
            d, az, el = shown(points[i], s, turn)
            if j < trackers:
                u = [rng.uniform(2, 20), rng.uniform(0.5, 5), rng.uniform(0.5, 5)]
                rows.append((i, j, 0, d + rng.normal() * u[0] * 1e-3, az + rng.normal() * u[1] * ARCSEC,
                             el + rng.normal() * u[2] * ARCSEC, u))
            else:
                u, segment = rng.uniform(0.2, 2), int(i >= n - 3 and trackers + tracers > 2)
                rows.append((i, j, segment, d - dead[segment] + rng.normal() * u * 1e-3, None, None, [u]))
    nominal = points + rng.normal(0, 0.05, points.shape) + rng.uniform(-100, 100, 3)
    return dict(points=points, stations=stations, turns=turns, trackers=trackers, rows=rows, nominal=nominal)


def solve(case, with_nominal):
    n, m, k = len(case["points"]), len(case["stations"]), case["trackers"]
    segments = {}
    for i, j, segment, *_ in case["rows"]:
        if j >= k:
            segments.setdefault((j, segment), 3 * n + 3 * m + 3 * k + len(segments))
    size = 3 * n + 3 * m + 3 * k + len(segments)
    x = np.zeros(size)
    x[:3 * n] = case["points"].ravel()
    x[3 * n:3 * n + 3 * m] = np.array(case["stations"]).ravel()
    base = [t.copy() for t in case["turns"]]

    def residuals(x):
        out = []
        for i, j, segment, length, az, el, u in case["rows"]:
            p, s = x[3 * i:3 * i + 3], x[3 * n + 3 * j:3 * n + 3 * j + 3]
            if j < k:
                at = 3 * n + 3 * m + 3 * j
                d, a, e = shown(p, s, turn_of(x[at:at + 3]) @ base[j])
                out += [(d - length) / (u[0] * 1e-3), (np.angle(np.exp(1j * (a - az)))) / (u[1] * ARCSEC),
                        (e - el) / (u[2] * ARCSEC)]
            else:
                out.append((np.linalg.norm(p - s) - length - x[segments[j, segment]]) / (u[0] * 1e-3))
        return np.array(out)

    def jacobian(x):
        columns = []
        for c in range(size):
            h = 1e-6 if 3 * n + 3 * m <= c < 3 * n + 3 * m + 3 * k else 1e-2
            up, down = x.copy(), x.copy()
            up[c] += h
            down[c] -= h
            columns.append((residuals(up) - residuals(down)) / (2 * h))
        return np.array(columns).T

    for (j, segment), at in segments.items():
        lengths = [(np.linalg.norm(case["points"][r[0]] - case["stations"][j]) - r[3]) for r in case["rows"]
                   if r[1] == j and r[2] == segment]
        x[at] = np.mean(lengths)
    scale = np.ones(size)
    scale[3 * n + 3 * m:3 * n + 3 * m + 3 * k] = 1e-3
    for _ in range(8):
        j_scaled = jacobian(x) * scale
        step = scale * (np.linalg.pinv(j_scaled, rcond=1e-9) @ -residuals(x))
        x += step
        if np.abs(step[:3 * n]).max() < 1e-9:
            break
    r = residuals(x)
    jac = jacobian(x)
    points = x[:3 * n].reshape(n, 3)
    stations = x[3 * n:3 * n + 3 * m].reshape(m, 3)
    turns = [turn_of(x[3 * n + 3 * m + 3 * j:3 * n + 3 * m + 3 * j + 3]) @ base[j] for j in range(k)]
    if with_nominal:
        a, b = points.mean(axis=0), case["nominal"].mean(axis=0)
        u, _, vt = np.linalg.svd((case["nominal"] - b).T @ (points - a))
        rotation = u @ np.diag([1, 1, np.linalg.det(u @ vt)]) @ vt
        shift = b - rotation @ a
    else:
        rotation = turns[0].T
        shift = -rotation @ stations[0]
    move = np.zeros((size, size))  # everything in the coordinates of the result, turns by vectors in them
    for c in range((size - len(segments)) // 3):
        move[3 * c:3 * c + 3, 3 * c:3 * c + 3] = rotation
    for c in range(size - len(segments), size):
        move[c, c] = 1
    points, stations = points @ rotation.T + shift, stations @ rotation.T + shift
    normal = (jac * scale).T @ (jac * scale)
    covariance = (scale[:, None] * np.linalg.pinv(normal, rcond=1e-15, hermitian=True)) * scale
    # The pseudo-inverse is right on the complement of the gauge alone: six singular values are cut by hand.
    w, v = np.linalg.eigh(normal)
    inverse = np.r_[np.zeros(6), 1 / w[6:]]
    covariance = (scale[:, None] * (v * inverse) @ v.T) * scale
    covariance = move @ covariance @ move.T
    g = np.zeros((size, 6))
    for c, p in enumerate(np.r_[points, stations]):
        g[3 * c:3 * c + 3, :3] = np.eye(3)
        q = p - points.mean(axis=0)
        g[3 * c:3 * c + 3, 3:] = -np.array([[0, -q[2], q[1]], [q[2], 0, -q[0]], [-q[1], q[0], 0]])
    for j in range(k):
        g[3 * n + 3 * m + 3 * j:3 * n + 3 * m + 3 * j + 3, 3:] = np.eye(3)
    held = np.zeros((size, 6))
    if with_nominal:
        held[:3 * n] = g[:3 * n]
    else:
        held[3 * n:3 * n + 3, :3] = np.eye(3)
        held[3 * n + 3 * m:3 * n + 3 * m + 3, 3:] = np.eye(3)
    t = np.eye(size) - g @ np.linalg.solve(held.T @ g, held.T)
    covariance = t @ covariance @ t.T
    nu = len(r) - (size - 6)
    factor = max(1.0, (r @ r) / nu) if nu > 0 else 1.0
    return points, stations, factor * covariance, r @ r, nu


def write(case, folder):
    names = [folder + "/trackers.csv"]
    with open(names[0], "w", encoding="utf-8") as out:
        out.write("point,station,length_mm,azimuth_deg,elevation_deg,u_length_um,u_azimuth_arcsec,u_elevation_arcsec\n")
        for i, j, _, length, az, el, u in case["rows"]:
            if az is not None:
                out.write(f"P{i},T{j},{length:.17g},{np.degrees(az):.17g},{np.degrees(el):.17g},{u[0]!r},{u[1]!r},{u[2]!r}\n")
    if any(r[4] is None for r in case["rows"]):
        names.append(folder + "/tracers.csv")
        with open(names[1], "w", encoding="utf-8") as out:
            out.write("point,station,segment,length_mm,u_length_um\n")
            for i, j, segment, length, az, _, u in case["rows"]:
                if az is None:
                    out.write(f"P{i},T{j},{segment},{length:.17g},{u[0]!r}\n")
    with open(folder + "/nominal.csv", "w", encoding="utf-8") as out:
        out.write("point,x_mm,y_mm,z_mm\n")
        for i, p in enumerate(case["nominal"]):
            out.write(f"P{i},{p[0]!r},{p[1]!r},{p[2]!r}\n".replace("np.float64(", "").replace(")", ""))
    return names


def ask(program, *arguments):
    done = subprocess.run([program, "tracking", *arguments, "--json", "-"], capture_output=True, text=True, timeout=300)
    if done.returncode not in (0, 3):
        sys.exit(f"{arguments}: exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def compare(program, case, folder, with_nominal):
    files = write(case, folder)
    got = ask(program, "polar", *files, *(["--points", folder + "/nominal.csv"] if with_nominal else []))
    points, stations, covariance, chi_squared, nu = solve(case, with_nominal)
    assert got["degrees_of_freedom"] == nu, (got["degrees_of_freedom"], nu)
    assert abs(got["chi_squared"] - chi_squared) < 1e-3 * max(1.0, chi_squared), (got["chi_squared"], chi_squared)
    for point in got["points"]:
        i = int(point["name"][1:])
        assert np.abs(np.array(point["position_mm"]) - points[i]).max() < 5e-5, (point, points[i])
        mine, theirs = covariance[3 * i:3 * i + 3, 3 * i:3 * i + 3], np.array(point["covariance_mm2"])
        assert np.abs(theirs - mine).max() < 2e-3 * np.trace(mine), (theirs, mine)
    n = len(points)
    for station in got["stations"]:
        j = int(station["name"][1:])
        at = 3 * n + 3 * j
        weakest = np.sqrt(np.linalg.eigvalsh(covariance[at:at + 3, at:at + 3]).max())
        off = np.abs(np.array(station["position_mm"]) - stations[j]).max()
        assert off < 5e-5 + 1e-2 * weakest, (station, stations[j], weakest)
        mine, theirs = covariance[at:at + 3, at:at + 3], np.array(station["covariance_mm2"])
        assert np.abs(theirs - mine).max() < 2e-3 * np.trace(mine) + 1e-12, (theirs, mine)


def study(program, rng, folder):
    """u of the points by polar measurement and by lengths alone, again from dense Jacobians."""
    points = rng.uniform(0, 1, (14, 3)) * [800, 600, 500]  # four stations need ten
    stations = np.array([[-700, -500, 100], [1500, -400, 0], [1300, 1200, 800], [-500, 1000, 200]]) + rng.uniform(-50, 50, (4, 3))
    with open(folder + "/points.csv", "w", encoding="utf-8") as out:
        out.write("point,x_mm,y_mm,z_mm\n")
        out.writelines(f"{i},{p[0]:.17g},{p[1]:.17g},{p[2]:.17g}\n" for i, p in enumerate(points))
    places = [f"--station={','.join(f'{float(x):.17g}' for x in s)}" for s in stations]
    got = ask(program, "compare-methods", "--points", folder + "/points.csv", *places, "--instrument", "faro-ion",
              "--trials", "400")
    by = {m["id"]: m for m in got["methods"]}
    root3 = np.sqrt(3)

    def rows_of(angles, j, i):
        d, az, el = shown(points[i], stations[j], np.eye(3))
        if not angles:
            return [(0.2 + 0.3 * d * 1e-3) / 2 * 1e-3]
        across = (20 + 5 * d * 1e-3) / root3 * 1e-3
        return [(16 + 0.8 * d * 1e-3) / root3 * 1e-3, across / d / np.cos(el), across / d]

    for name, chosen, angles in (("polar-1", [0], True), ("polar-all", range(4), True), ("multilateration", range(4), False)):
        chosen = list(chosen)
        n, m = len(points), len(chosen)
        size = 3 * n + 6 * m if angles else 3 * n + 4 * m

        def residuals(x):
            out = []
            for k, j in enumerate(chosen):
                at = 3 * n + (6 if angles else 4) * k
                for i in range(n):
                    u = rows_of(angles, j, i)
                    p, s = points[i] + x[3 * i:3 * i + 3], stations[j] + x[at:at + 3]
                    if angles:
                        out += list(np.array(shown(p, s, turn_of(x[at + 3:at + 6]))) / u)
                    else:
                        out.append((np.linalg.norm(p - s) - x[at + 3]) / u[0])
            return np.array(out)
        columns = []
        scale = np.ones(size)
        for c in range(size):
            if angles and c >= 3 * n and (c - 3 * n) % 6 >= 3:
                scale[c] = 1e-3
            step = np.zeros(size)
            step[c] = 1e-3 * scale[c]
            columns.append((residuals(step) - residuals(-step)) / 2e-3)
        jac = np.array(columns).T
        w, v = np.linalg.eigh(jac.T @ jac)
        covariance = scale[:, None] * ((v * np.r_[np.zeros(6), 1 / w[6:]]) @ v.T) * scale
        g = np.zeros((size, 6))
        centre = points.mean(axis=0)

        def put(at, p):
            q = p - centre
            g[at:at + 3, :3] = np.eye(3)
            g[at:at + 3, 3:] = -np.array([[0, -q[2], q[1]], [q[2], 0, -q[0]], [-q[1], q[0], 0]])
        for i, p in enumerate(points):
            put(3 * i, p)
        for k, j in enumerate(chosen):
            put(3 * n + (6 if angles else 4) * k, stations[j])
            if angles:
                g[3 * n + 6 * k + 3:3 * n + 6 * k + 6, 3:] = np.eye(3)
        held = np.zeros((size, 6))
        held[:3 * n] = g[:3 * n]
        t = np.eye(size) - g @ np.linalg.solve(held.T @ g, held.T)
        covariance = t @ covariance @ t.T
        u = 1000 * np.sqrt(np.trace(covariance[:3 * n, :3 * n]) / n)
        assert abs(by[name]["u_point_um"] / u - 1) < 1e-4, (name, by[name], u)
        assert abs(by[name]["trials_point_um"] / u - 1) < 0.15, (name, by[name], u)
    assert by["multilateration"]["u_point_um"] < by["polar-all"]["u_point_um"]


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    rng = np.random.default_rng(int(sys.argv[3]) if len(sys.argv) > 3 else 20260101)
    for k in range(count):
        with tempfile.TemporaryDirectory() as folder:
            case = make(rng)
            compare(program, case, folder, bool(k % 2))
            if k < 2:
                study(program, rng, folder)
    print(f"{count} polar adjustments agree")


if __name__ == "__main__":
    main()
