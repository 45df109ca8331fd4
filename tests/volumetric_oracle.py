#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Volumetric calibrations of simulated machines against their truth.

The simulator is another one than the program's: homogeneous transformations in numpy, errors as sums of waves. Compared
are the field at places that were not measured (but for what no length tells: a rigid motion, and a place for each tool),
the curves, and that the stated uncertainties hold the truth.

Usage: tests/volumetric_oracle.py PROGRAM
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

AXES, MOTIONS = "XYZ", "XYZABC"
TRAVEL = {"X": [0, 800], "Y": [-300, 300], "Z": [-450, 0]}
TOOLS = {"short": [0, 0, -120], "long": [0, 0, -260], "side": [110, -70, -150]}
STATIONS = {"A": [-150, -420, -600], "B": [950, -400, -560], "C": [400, 420, -580], "D": [150, 50, -700]}


def turn(angles):
    (ca, cb, cc), (sa, sb, sc) = np.cos(angles), np.sin(angles)
    x = np.array([[1, 0, 0], [0, ca, -sa], [0, sa, ca]])
    y = np.array([[cb, 0, sb], [0, 1, 0], [-sb, 0, cb]])
    z = np.array([[cc, -sc, 0], [sc, cc, 0], [0, 0, 1]])
    return z @ y @ x


class Machine:
    def __init__(self, chain, chance):
        self.chain = chain
        self.waves = {m + a: (chance.normal(size=3) * [8, 4, 2], chance.uniform(0, 2 * np.pi, 3)) for a in AXES for m in MOTIONS}
        self.square = chance.normal(size=3) * 15e-6  # C0Y, B0Z, A0Z

    def error(self, name, q):
        low, high = TRAVEL[name[1]]
        size, phase = self.waves[name]
        return sum(s * np.sin(math.pi * (k + 1) * (np.asarray(q) - low) / (high - low) + p) for k, (s, p) in enumerate(zip(size, phase)))

    def point(self, q, tool):
        c, b, a = self.square
        ways = {"X": np.array([1.0, 0, 0]), "Y": np.array([-math.sin(c), math.cos(c), 0]), "Z": turn((a, b, 0)) @ [0, 0, 1.0]}
        before, behind = self.chain.split("F")
        p = np.array(tool, float)
        for axis in reversed(before + behind):
            k = AXES.index(axis)
            shift = 1e-3 * np.array([self.error(m + axis, q[k]) for m in "XYZ"])
            turned = turn(1e-6 * np.array([self.error(m + axis, q[k]) for m in "ABC"]))
            p = shift + turned @ (q[k] * ways[axis] + p) if axis in before else q[k] * ways[axis] + shift + turned @ p
        return p


def place(chance):
    return np.array([chance.uniform(*TRAVEL[a]) for a in AXES])


def lengths(machine, chance, points, sigma_machine):
    rows = ["station,tool,segment,x_mm,y_mm,z_mm,length_mm"]
    for station, at in STATIONS.items():
        for tool, offset in TOOLS.items():
            dead = chance.uniform(100, 500)
            for k in range(points):
                q = place(chance)
                far = np.linalg.norm(machine.point(q, offset) - at)
                noise = 1e-3 * math.hypot(0.5 * (0.2 + 0.3e-3 * far), sigma_machine) * chance.normal()
                rows.append(f"{station},{tool},{1 if k < points // 2 else 2},{q[0]:.6f},{q[1]:.6f},{q[2]:.6f},"
                            f"{far - dead + noise + (3.5 if k >= points // 2 else 0):.9f}")
    return "\n".join(rows) + "\n"


def curve_truth(machine, name, q):
    """With its mean over the travel taken off, of straightness its straight line too."""
    low, high = TRAVEL[name[1]]
    all_q = np.linspace(low, high, 4001)
    values = machine.error(name, all_q)
    weights = np.full(all_q.size, 1.0)
    weights[[0, -1]] = 0.5
    weights /= weights.sum()
    x = (2 * all_q - low - high) / (high - low)
    slope = (weights * values * x).sum() / (weights * x * x).sum()
    straight = name[0] in AXES and name[0] != name[1]
    return machine.error(name, q) - (weights * values).sum() - (slope * (2 * q - low - high) / (high - low) if straight else 0)


def field_differences(machine, points, found):
    """Found less true, without the rigid motion and the place of each tool that fit best; and over u."""
    names = list(TOOLS)
    rows, off = [], []
    for (tool, q), f in zip(points, found):
        p = 1e-3 * (q + TOOLS[tool])
        row = np.zeros((3, 3 * len(names) + 3))
        row[:, 3 * names.index(tool):3 * names.index(tool) + 3] = np.eye(3)
        row[:, -3:] = [[0, p[2], -p[1]], [-p[2], 0, p[0]], [p[1], -p[0], 0]]
        rows.append(row)
        off.append(np.array(f["error_um"]) - 1e3 * (machine.point(q, TOOLS[tool]) - q - TOOLS[tool]))
    rows, off = np.vstack(rows), np.hstack(off)
    rest = off - rows @ np.linalg.lstsq(rows, off, rcond=None)[0]
    u = np.sqrt(np.hstack([np.diag(np.reshape(f["covariance_um2"], (3, 3))) for f in found]))
    return rest.reshape(-1, 3), rest / u


def main():
    program, faults, held, ratios = sys.argv[1], [], [], []
    folder = pathlib.Path(tempfile.mkdtemp())
    def run(*words):
        done = subprocess.run([program, "volumetric", *map(str, words)], capture_output=True, text=True)
        if done.returncode not in (0, 3):
            raise SystemExit(f"volumetric {words}: {done.stderr}")
        return json.loads(done.stdout)
    for number, chain in enumerate(["XFYZ", "FXYZ", "YXFZ", "XYZF", "FZYX", "ZFXY", "YFXZ", "XFZY"]):
        chance = np.random.default_rng(number)
        machine, sigma = Machine(chain, chance), 0.3
        (folder / "machine.json").write_text(json.dumps({
            "chain": chain, "travel_mm": TRAVEL, "tools_mm": TOOLS, "instrument": {"a_um": 0.2, "b_um_per_m": 0.3},
            "repeatability_um": sigma}))
        (folder / "lengths.csv").write_text(lengths(machine, chance, 80, sigma))
        result = run("identify", folder / "lengths.csv", "--machine", folder / "machine.json", "--out", folder / "result.json", "--json", "-")
        points = [(tool, place(chance)) for tool in TOOLS for _ in range(60)]
        (folder / "points.csv").write_text("tool,x_mm,y_mm,z_mm\n" + "".join(f"{t},{q[0]},{q[1]},{q[2]}\n" for t, q in points))
        found = run("field", folder / "result.json", "--at", folder / "points.csv", "--json", "-")["points"]
        rest, over_u = field_differences(machine, points, found)
        ratios.append(result["chi2_per_dof"])
        if result["unseen"] or result["rank"]["null_directions"]:
            faults.append(f"{chain}: not told: {result['unseen']}")
        if len(result["stations"]) != 12 or any(len(s["segments"]) != 2 for s in result["stations"]):
            faults.append(f"{chain}: stations or segments are not as they were")
        if np.sqrt((rest ** 2).sum(1).mean()) > 0.9:
            faults.append(f"{chain}: the field is wrong by {np.sqrt((rest ** 2).sum(1).mean()):.2f} µm rms")
        if np.sqrt((over_u ** 2).mean()) > 1.2:
            faults.append(f"{chain}: the field is {np.sqrt((over_u ** 2).mean()):.2f} u from the truth")
        for axis in AXES:
            for motion in MOTIONS:
                nodes = result["errors"]["E" + motion + axis]
                q = np.array([n["position"] for n in nodes])
                off = np.array([n["value"] for n in nodes]) - curve_truth(machine, motion + axis, q)
                held.append((np.abs(off) < 1.96 * np.array([n["u"] for n in nodes])).mean())
    # 144 curves with some 6 independent values each: 0.7 % by chance; spans are chosen from the same data, 2 % more.
    if not 0.92 < np.mean(held) < 0.98:
        faults.append(f"curves: {100 * np.mean(held):.1f} % of values within 1.96 u")
    if not 0.95 < np.mean(ratios) < 1.05:
        faults.append(f"chi² per degree of freedom is {np.mean(ratios):.3f} on average")
    print("\n".join(faults) if faults else f"volumetric: ok, {100 * np.mean(held):.1f} % of curve values within 1.96 u, "
          f"chi²/dof {np.mean(ratios):.3f}")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
