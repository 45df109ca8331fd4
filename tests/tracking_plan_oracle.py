#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Judges plans of seven lines by brute force: what can be measured, and whether every move is free.

Usage: tests/tracking_plan_oracle.py PROGRAM [PLANS [SEED]]

Random machines, stations, limits and obstacles. Points every millimetre along every octant of every line are tested for travels,
range, elevation, incidence, clearance and line of sight, with distances to solids of this script's own. The planned targets must
cover the longest free piece but for overruns and the shift of the ends, lost lines must have none, coordinates rounded to
0.001 mm must not move a target along its line, and no move may come too near to anything or, unless the plan says so, lose
the beam. Needs numpy.
"""
import json
import math
import random
import subprocess
import sys

import numpy as np

PROGRAM = sys.argv[1]
PLANS = int(sys.argv[2]) if len(sys.argv) > 2 else 40
SEED = int(sys.argv[3]) if len(sys.argv) > 3 else 1
LINES = ["x", "y", "z", "xy", "xz", "yz", "xyz"]
OBSTACLE_MARGIN, BEAM_MARGIN = 50.0, 5.0


def solid_distance(solid, p):
    """Of points (n, 3) to a solid; 0 inside."""
    kind, *numbers = solid
    if kind == "box":
        low, high = np.array(numbers[0]), np.array(numbers[1])
        return np.linalg.norm(np.maximum(np.maximum(low - p, p - high), 0), axis=-1)
    if kind == "sphere":
        return np.maximum(np.linalg.norm(p - np.array(numbers[0]), axis=-1) - numbers[1], 0)
    base, radius, height = np.array(numbers[0]), numbers[1], numbers[2]
    beside = np.maximum(np.hypot(p[..., 0] - base[0], p[..., 1] - base[1]) - radius, 0)
    beyond = np.maximum(np.maximum(base[2] - p[..., 2], p[..., 2] - base[2] - height), 0)
    return np.hypot(beside, beyond)


def free(case, p, slack):
    """Where the reflector may be; slack > 0 is generous."""
    q = p - case["tool"]
    good = np.all((q >= case["low"] - 1e-5) & (q <= case["high"] + 1e-5), axis=-1)
    good &= np.linalg.norm(p - case["station"], axis=-1) >= case["safe"] - slack
    for solid in case["solids"]:
        good &= solid_distance(solid, p) >= OBSTACLE_MARGIN - slack
    return good


def seen(case, p, slack):
    r = p - case["station"]
    d = np.linalg.norm(r, axis=-1)
    good = (d >= case["range"][0] - slack) & (d <= case["range"][1] + slack)
    d = np.maximum(d, 1e-9)
    elevation = np.degrees(np.arcsin(np.clip(r[..., 2] / d, -1, 1)))
    axis = case["axis"] / np.linalg.norm(case["axis"])
    incidence = np.degrees(np.arccos(np.clip(-(r @ axis) / d, -1, 1)))
    loose = 0.05 * slack
    good &= (elevation >= case["elevation"][0] - 1e-5 - loose) & (elevation <= case["elevation"][1] + 1e-5 + loose)
    good &= incidence <= case["incidence"] + 1e-5 + loose
    if case["solids"]:
        for t in np.linspace(0, 1, 241):
            beam = case["station"] + t * r
            for solid in case["solids"]:
                good &= solid_distance(solid, beam) >= BEAM_MARGIN - max(slack, 1e-5)
    return good


def directions(line):
    result = [[]]
    for axis in "xyz":
        result = [u + [s] for u in result for s in ((-1.0, 1.0) if axis in line else (0.0,))]
    return [np.array(u) / np.linalg.norm(u) for u in result]


def longest(case, line, slack):
    best = 0.0
    for u in directions(line):
        d = np.arange(0.5, 1800.0)
        p = case["station"] + d[:, None] * u
        good = free(case, p, slack)
        if good.any():
            good[good] &= seen(case, p[good], slack)
        run = 0
        for g in good:
            run = run + 1 if g else 0
            best = max(best, run)
    return float(best)


def random_case(rng):
    low = np.array([rng.uniform(-200, 0), rng.uniform(-200, 0), -rng.uniform(300, 700)])
    high = low + np.array([rng.uniform(400, 1000), rng.uniform(300, 800), -low[2]])
    tool = np.array([rng.choice([0.0, rng.uniform(-50, 50)]), 0.0, -rng.uniform(50, 250)])
    reach = (low + tool, high + tool)
    station = np.array([rng.uniform(a - 30, b + 30) for a, b in zip(*reach)])
    station[2] = rng.uniform(reach[0][2] - 20, reach[0][2] + 0.4 * (reach[1][2] - reach[0][2]))
    solids = []
    for _ in range(rng.choice([0, 0, 1, 2])):
        at = [rng.uniform(a, b) for a, b in zip(*reach)]
        kind = rng.choice(["box", "sphere", "cylinder"])
        if kind == "box":
            solids.append((kind, at, [x + rng.uniform(20, 150) for x in at]))
        elif kind == "sphere":
            solids.append((kind, at, rng.uniform(10, 80)))
        else:
            solids.append((kind, at, rng.uniform(10, 80), rng.uniform(20, 150)))
    solids = [s for s in solids if solid_distance(s, station[None])[0] > 60]
    return dict(low=low, high=high, tool=tool, station=station, solids=solids,
                axis=np.array([rng.uniform(-1, 1), rng.uniform(-1, 1), -1.0]), incidence=rng.uniform(50, 120),
                range=(rng.uniform(100, 250), rng.uniform(700, 3000)), elevation=(rng.uniform(-30, 0), rng.uniform(60, 90)),
                safe=rng.uniform(60, 180))


def text(numbers):
    return ",".join(repr(float(x)) for x in numbers)


def solid_text(solid):
    if solid[0] == "box":
        return f"box:{text(solid[1])}:{text(solid[2])}"
    return f"{solid[0]}:{text(solid[1])}:" + ":".join(repr(x) for x in solid[2:])


def plan_of(case, seed):
    travel = ",".join(f"{a}={l!r}:{h!r}" for a, l, h in zip("XYZ", map(float, case["low"]), map(float, case["high"])))
    command = [PROGRAM, "tracking", "plan", "--travel", travel, f"--tool={text(case['tool'])}", f"--station={text(case['station'])}",
               f"--reflector={text(case['axis'])}", "--incidence", repr(case["incidence"]), "--safe-radius", repr(case["safe"]),
               f"--range={case['range'][0]!r}:{case['range'][1]!r}", f"--elevation={case['elevation'][0]!r}:{case['elevation'][1]!r}",
               "--seed", str(seed), "--out", "-"]
    for solid in case["solids"]:
        command += ["--obstacle", solid_text(solid)]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode == 2 and "no line that can be measured" in done.stderr:
        return None
    if done.returncode:
        raise SystemExit(f"plan {seed}: {done.stderr}")
    return json.loads(done.stdout)


def moves_of(plan):
    """Places of the axes in the order in which they are driven, with the line to which each stretch leads or belongs."""
    for line in plan["lines"]:
        p = line["plan"]
        origin, u = np.array(p["axis"]["line_origin_mm"]), np.array(p["axis"]["line_direction"])
        u = u / np.linalg.norm(u)
        low, high = p["targets"][0] - p["overrun"], p["targets"][-1] + p["overrun"]
        for at in p.get("way_in_mm", []):
            yield np.array(at), line["id"], False
        yield origin + low * u, line["id"], False
        yield origin + high * u, line["id"], True
        yield origin + low * u, line["id"], True
        for at in p.get("way_out_mm", []):
            yield np.array(at), "above", False


def judge(case, plan, seed):
    faults = []
    made = {line["id"]: line["plan"] for line in plan["lines"]} if plan else {}
    for line in LINES:
        tight, loose = longest(case, line, -0.6), longest(case, line, 0.6)
        if line in made:
            p = made[line]
            covered = p["targets"][-1] - p["targets"][0]
            if covered + 2 * p["overrun"] > loose + 2:
                faults.append(f"{line}: covers {covered:.1f} mm with overruns of {p['overrun']}, only {loose:.1f} mm are free")
            if covered < 0.9 * (tight - 2 * p["overrun"]) - 3:
                faults.append(f"{line}: covers {covered:.1f} mm of {tight:.1f} mm")
            origin, u = np.array(p["axis"]["line_origin_mm"]), np.array(p["axis"]["line_direction"])
            u = u / np.linalg.norm(u)
            r = case["station"] - case["tool"] - origin
            if np.linalg.norm(r - (r @ u) * u) > 0.0009:
                faults.append(f"{line}: does not lead through the station")
            for target in p["targets"]:
                q = origin + target * u
                off = np.round(q, 3) - q
                if abs(off @ u) > 1e-7 or np.linalg.norm(off) > 0.0005:
                    faults.append(f"{line}: rounding moves target {target} by {off}")
        elif tight > 100 + 3:
            faults.append(f"{line}: lost, but {tight:.1f} mm are free")
    if plan:
        at, previous = None, "above"
        for to, line, on_line in moves_of(plan):
            if at is not None:
                p = at + np.linspace(0, 1, 400)[:, None] * (to - at) + case["tool"]
                if not free(case, p, 0.01).all():
                    faults.append(f"{previous} to {line}: not free")
                said = any(f"from {previous} to {line}" in r or f"from {line} to {line}" in r for r in plan["remarks"])
                to_or_from_above = line == "above" or previous == "above"
                if (on_line or (not said and not to_or_from_above)) and not seen(case, p, 0.01).all():
                    faults.append(f"{previous} to {line}: the beam is lost without a word")
            at, previous = to, (line if on_line else previous)
    return faults


def main():
    rng = random.Random(SEED)
    kept = lost = bad = 0
    for k in range(PLANS):
        case = random_case(rng)
        plan = plan_of(case, k)
        kept += len(plan["lines"]) if plan else 0
        lost += len(plan["lost"]) if plan else 7
        for fault in judge(case, plan, k):
            bad += 1
            print(f"plan {k}: {fault}\n  {case}")
    print(f"{PLANS} plans: {kept} lines kept, {lost} lost, {bad} faults")
    if bad or not kept or not lost:
        raise SystemExit(1)


main()
