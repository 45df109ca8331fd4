#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Simulated machines whose truth the program does not see: planned, measured and evaluated seven-line tests.

Usage: tests/seven_lines_oracle.py PROGRAM [COUNT] [SEED]

The program plans the lines from a station; this script moves a machine with scales, squareness, reversal errors and noise
along them, measures lengths from the true station, and has the program evaluate. Checked: the deviations and E, R, B of
every line against the definitions (ISO 230-2:2014 clause 3, with x = ±(ΔL − d)), slopes and squareness against the truth,
where the lines were planned against travel, range and elevation; and all of it again with one break of the beam in every
line. Shares nothing with the C++ code.
"""
import json
import math
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

SEVEN = ["x", "y", "z", "xy", "xz", "yz", "xyz"]


def run(program, *arguments, codes=(0,)):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in codes:
        raise SystemExit(f"{' '.join(map(str, arguments))}\nexit {done.returncode}: {done.stderr}")
    return done.stdout


def approaches(plan):
    """The standard cycle: run by run up and down."""
    m = len(plan["targets"])
    for run_index in range(plan["runs"]):
        for i in range(m):
            yield i, "up", run_index
        for i in reversed(range(m)):
            yield i, "down", run_index


def coordinates(plan, position):
    origin = np.array(plan["axis"]["line_origin_mm"])
    direction = np.array(plan["axis"]["line_direction"])
    return origin + position * direction / np.linalg.norm(direction)


class Machine:
    def __init__(self, rng):
        self.low = np.array([0.0, 0.0, rng.uniform(-600, -300)])
        self.high = np.array([rng.uniform(400, 1200), rng.uniform(350, 900), 0.0])
        self.tool = np.array([0.0, 0.0, -rng.uniform(80, 200)])
        frac = rng.uniform(0.05, 0.95, 3)
        self.station = np.round(self.low + frac * (self.high - self.low) + self.tool, 3)
        self.station[2] = round(self.low[2] + self.tool[2] + rng.uniform(5, 60), 3)
        e = rng.normal(0, 30e-6, 3)
        c, b, a = rng.normal(0, 40e-6, 3)  # C0Y, B0Z, A0Z
        self.truth = dict(e_x=e[0], e_y=e[1], e_z=e[2], C0Y=c, B0Z=b, A0Z=a)
        self.D = np.array([[e[0], -c, b], [0, e[1], -a], [0, 0, e[2]]])
        self.backlash = rng.choice([0.0, 1.0]) * rng.uniform(-0.006, 0.006, 3)
        self.noise = rng.choice([0.0, 0.0003, 0.001])

    def length(self, rng, q, way):
        """Distance of the reflector from the station when told to go to q, moving along `way`."""
        actual = q + self.D @ q - np.where(way < -1e-9, self.backlash, 0.0) * (np.abs(way) > 1e-9)
        return np.linalg.norm(actual + self.tool - self.station) + rng.normal(0, self.noise) if self.noise else \
            np.linalg.norm(actual + self.tool - self.station)


def parameters(x):
    """E, R, B of x[direction][target][run] in µm."""
    mean = x.mean(axis=2)
    s = x.std(axis=2, ddof=1)
    B_i = mean[0] - mean[1]
    up, down = 2 * 2 * s[0], 2 * 2 * s[1]
    both = np.maximum.reduce([2 * s[0] + 2 * s[1] + np.abs(B_i), up, down])
    return dict(E=mean.max() - mean.min(), R=both.max(), B=np.abs(B_i).max(), R_up=up.max(), E_up=np.ptp(mean[0]))


def check_broken(program, rng, index, folder, machine, rows, expected):
    """The same lengths with the beam broken once in every line: found at its reading, and the line as if it were whole."""
    broken, breaks, lost, line, number = [rows[0]], {}, 0.0, None, 0
    for row in rows[1:]:
        *place, length = row.split(",")
        number = number + 1 if place[0] == line else 0
        if place[0] != line:
            line = place[0]
            readings = expected[line][0].size
            size = 10.0 ** rng.uniform(-1, 2.7) * rng.choice([-1.0, 1.0])
            at = int(rng.integers(1, readings)) if abs(size) > 1.2 else int(rng.integers(2, readings - 1))
            breaks[line] = (at, size)
        lost += breaks[line][1] if number == breaks[line][0] else 0.0
        broken.append(",".join(place) + f",{round(float(length) + lost, 7)!r}")
    file = folder / "broken.csv"
    file.write_text("\n".join(broken) + "\n")
    answer = json.loads(run(program, "tracking", "evaluate", file, "--plan", folder / "plan.json", "--json", "-", "--quiet",
                            codes=(0, 3)))  # 3: a stretch that only a single reading ties is a serious finding
    for result in answer["lines"]:
        at, size = breaks[result["id"]]
        where = f"case {index}, {result['id']}, broken by {size} mm before reading {at + 1}"
        found = [(b["before_reading"] - 1, b["jump_mm"]) for b in result["breaks"]]
        if [k for k, _ in found] != [at] or abs(found[0][1] - size) > 1e-5 + 10 * machine.noise:
            raise SystemExit(f"{where}: found {found}")
        for key, value in parameters(expected[result["id"]][0]).items():
            if key in "ERB" and abs(result["test"]["parameters"][key] - value) > 1e-3 + 1e4 * machine.noise:
                raise SystemExit(f"{where}: {key} found {result['test']['parameters'][key]}, expected {value}")


def check(program, rng, index, folder):
    machine = Machine(rng)
    travel = ",".join(f"{a}={lo!r}:{hi!r}" for a, lo, hi in zip("XYZ", map(float, machine.low), map(float, machine.high)))
    vector = lambda v: ",".join(repr(float(x)) for x in v)
    plan_file, lengths_file = folder / "plan.json", folder / "lengths.csv"
    run(program, "tracking", "plan", "--travel", travel, "--tool", vector(machine.tool), "--station",
        vector(machine.station), "--seed", index + 1, "--out", plan_file, "--quiet")
    plan = json.loads(plan_file.read_text())
    ids = [line["id"] for line in plan["lines"]] + [line["id"] for line in plan["lost"]]
    if sorted(ids) != sorted(SEVEN):
        raise SystemExit(f"case {index}: found the lines {ids}, expected each of the seven once, planned or lost")
    zero = rng.uniform(100, 2000)
    rows, expected = ["line,target,direction,run,length_difference_mm"], {}
    for line in plan["lines"]:
        p = line["plan"]
        targets, origin = p["targets"], coordinates(p, 0.0)
        direction = coordinates(p, 1.0) - origin
        x = np.zeros((2, len(targets), p["runs"]))
        limits = plan["setup"]["limits"]
        for i, way, j in approaches(p):
            q = coordinates(p, targets[i])
            if np.any(q < machine.low - 1e-6) or np.any(q > machine.high + 1e-6):
                raise SystemExit(f"case {index}: line {line['id']} goes to {q}, outside the travel")
            r = q + machine.tool - machine.station
            d = np.linalg.norm(r)
            if not limits["range_least_mm"] - 1e-6 <= d <= limits["range_most_mm"] + 1e-6:
                raise SystemExit(f"case {index}: line {line['id']} measures at {d} mm, outside the range")
            elevation = math.degrees(math.asin(r[2] / d))
            if not limits["elevation_lowest_deg"] - 1e-6 <= elevation <= limits["elevation_highest_deg"] + 1e-6:
                raise SystemExit(f"case {index}: line {line['id']} is seen at {elevation}°")
            if np.linalg.norm(np.cross(r, direction)) > 2e-3:
                raise SystemExit(f"case {index}: line {line['id']} does not pass through the station")
            shown = machine.length(rng, q, direction * (1 if way == "up" else -1)) - zero
            shown = round(shown, 7)
            sign = 1.0 if r @ direction > 0 else -1.0
            x[0 if way == "up" else 1, i, j] = sign * (shown - d) * 1000.0
            rows.append(f"{line['id']},{i + 1},{way},{j + 1},{shown!r}")
        expected[line["id"]] = (x, direction, np.array(targets), line["plan"])
    lengths_file.write_text("\n".join(rows) + "\n")
    check_broken(program, rng, index, folder, machine, rows, expected)
    answer = json.loads(run(program, "tracking", "evaluate", lengths_file, "--plan", plan_file, "--json", "-", "--quiet"))
    for line in answer["lines"]:
        x, direction, targets, p = expected.pop(line["id"])
        test = line["test"]
        want = parameters(x)
        for key, value in want.items():
            if not abs(test["parameters"][key] - value) < 1e-5:
                raise SystemExit(f"case {index}, {line['id']}: {key} found {test['parameters'][key]}, expected {value}")
        means = np.array([[t["mean_up"], t["mean_down"]] for t in test["positions"]]).T
        shift = means - x.mean(axis=2)
        if np.ptp(shift) > 1e-5:
            raise SystemExit(f"case {index}, {line['id']}: deviations differ by more than a shift: {shift}")
        truth = direction @ machine.D @ direction * 1e6
        within = 1.0 + 5e6 * machine.noise / (np.std(targets) * math.sqrt(2 * len(targets) * p["runs"]))
        if abs(line["slope"]["um_per_m"] - truth) > within:
            raise SystemExit(f"case {index}, {line['id']}: slope found {line['slope']['um_per_m']}, expected {truth}")
    if expected:
        raise SystemExit(f"case {index}: no result for {list(expected)}")
    if len(answer["lines"]) == 7 and machine.noise == 0.0:
        found = {term["id"]: term["um_per_m"] for term in answer["squareness"]["terms"]}
        for key, value in machine.truth.items():
            if found[key] is None or abs(found[key] - value * 1e6) > 1.5:
                raise SystemExit(f"case {index}: {key} found {found[key]}, expected {value * 1e6}")
    return len(answer["lines"])


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 20
    rng = np.random.default_rng(int(sys.argv[3]) if len(sys.argv) > 3 else 20261122)
    with tempfile.TemporaryDirectory() as folder:
        lines = sum(check(program, rng, index, pathlib.Path(folder)) for index in range(count))
    print(f"seven lines oracle: {count} machines, {lines} lines agree")


if __name__ == "__main__":
    main()
