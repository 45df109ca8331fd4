#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds `axiometry compare-rules` against an independent computation of every figure of every rule.

Usage: tests/rules_oracle.py PROGRAM [TESTS]

Shares nothing with the program: readings are lists, sums are exact (fractions), roots by decimal with 40 digits; of seeded
tests and of ISO 230-2:2014, Table 2. Where readings are missing or too few it must say so and give no number.
"""
import csv
import json
import pathlib
import random
import subprocess
import sys
import tempfile
from decimal import Decimal, getcontext
from fractions import Fraction

getcontext().prec = 40
PROGRAM = sys.argv[1]
TESTS = int(sys.argv[2]) if len(sys.argv) > 2 else 40
TABLE_2 = pathlib.Path(__file__).resolve().parent.parent / "examples" / "iso230-2-table2.csv"


def mean(values):
    return sum(values, Fraction(0)) / len(values)


def root(x):
    return Fraction((Decimal(x.numerator) / Decimal(x.denominator)).sqrt())


def sd(values, centre=None, divisor=None):
    centre = mean(values) if centre is None else centre
    return root(sum(((x - centre) ** 2 for x in values), Fraction(0)) / (divisor or len(values) - 1))


def nearest_middle(targets):
    middle = (targets[0] + targets[-1]) / 2
    return min(range(len(targets)), key=lambda i: (abs(targets[i] - middle), i))


def line_residual(targets, values):
    p, v = mean(targets), mean(values)
    slope = sum((t - p) * (x - v) for t, x in zip(targets, values)) / sum((t - p) ** 2 for t in targets)
    return max(abs(x - v - slope * (t - p)) for t, x in zip(targets, values))


def figures(targets, up, down, linear=True):
    """{(rule, key): value}; up[i] and down[i] are the runs of target i, all of them there or the direction empty."""
    m, both = len(targets), bool(up and down)
    found = {}
    directions = [(name, x) for name, x in (("up", up), ("down", down)) if x]
    runs = len(directions[0][1][0])
    means = {name: [mean(cell) for cell in x] for name, x in directions}
    s = {name: [sd(cell) for cell in x] for name, x in directions} if runs > 1 else None
    older = {}
    for name, _ in directions:
        older[f"E_{name}"] = max(means[name]) - min(means[name])
        if s:
            band = [(a + 2 * b, a - 2 * b) for a, b in zip(means[name], s[name])]
            older[f"A_{name}"] = max(b[0] for b in band) - min(b[1] for b in band)
            older[f"R_{name}"] = 4 * max(s[name])
    if both:
        B = [a - b for a, b in zip(means["up"], means["down"])]
        middle = [(a + b) / 2 for a, b in zip(means["up"], means["down"])]
        every = means["up"] + means["down"]
        older |= {"E": max(every) - min(every), "M": max(middle) - min(middle), "B": max(map(abs, B)), "B_mean": mean(B)}
        if s:
            pairs = list(zip(every, s["up"] + s["down"]))
            wide = lambda k: max(x + k * y for x, y in pairs) - min(x - k * y for x, y in pairs)
            repeat = lambda k: max(max(k * a + k * b + abs(c), 2 * k * a, 2 * k * b) for a, b, c in zip(s["up"], s["down"], B))
            older |= {"A": wide(2), "R": repeat(2)}
            found |= {("jis-b-0182-1993", "A"): wide(3), ("jis-b-0182-1993", "R"): repeat(3)}
            scatter = [3 * (a + b) for a, b in zip(s["up"], s["down"])]
            half = [(abs(b) + p) / 2 for b, p in zip(B, scatter)]
            found |= {("vdi-dgq-3441", "P"): max(x + h for x, h in zip(middle, half)) - min(x - h for x, h in zip(middle, half)),
                      ("vdi-dgq-3441", "P_s_max"): max(scatter), ("vdi-dgq-3441", "P_s_mean"): mean(scatter)}
            if linear:
                found |= {("export-lists", "2B001"): min(older["R_up"], older["R_down"]), ("export-lists", "2B201"): older["A"]}
        found |= {("jis-b-0182-1993", "E"): older["E"], ("jis-b-0182-1993", "B"): older["B"],
                  ("vdi-dgq-3441", "P_a"): older["M"], ("vdi-dgq-3441", "U_max"): older["B"],
                  ("vdi-dgq-3441", "U_mean"): mean([abs(b) for b in B]), ("gb-t-38614-2020", "hysteresis"): older["B"]}
        if runs > 2:
            cells = [(u[1:], d[1:]) for u, d in zip(up, down)]
            found[("gb-t-38614-2020", "repeatability")] = max(
                sd(cell, (mean(u) + mean(d)) / 2, runs - 2) for u, d in cells for cell in (u, d))
    for rule in ("iso-230-2-1997", "iso-230-2-2006", "gb-t-17421-2-2000", "jis-b-6190-2"):
        found |= {(rule, key): value for key, value in older.items()}
    places = (0, nearest_middle(targets), m - 1)
    for name, x in directions:
        first = [cell[0] for cell in x]
        found[("jis-b-6201", f"positioning_{name}")] = max(first) - min(first)
        found[("gb-t-38614-2020", f"accuracy_{name}")] = max(map(abs, means[name]))
        found[("gb-t-38614-2020", f"linearity_{name}")] = line_residual(targets, means[name])
        if s:
            found[("gb-t-38614-2020", f"repeatability_{name}")] = max(s[name])
        if runs >= 7:
            found[("jis-b-6201", f"repeatability_{name}")] = max((max(x[i][:7]) - min(x[i][:7])) / 2 for i in places)
    if both and runs >= 7:
        found[("jis-b-6201", "lost_motion")] = max(abs(mean(up[i][:7]) - mean(down[i][:7])) for i in places)
    return found


def program(path):
    done = subprocess.run([PROGRAM, "compare-rules", path, "--json", "-"], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def compare(result, expected, travel, per_position, what):
    seen = 0
    unchecked = "not checked against the text of the rule"
    for rule in result["rules"]:
        for figure in rule["figures"]:
            want, got = expected.get((rule["id"], figure["key"])), figure["value"]
            name = f"{what}: {rule['id']} {figure['key']}"
            if want is None:
                assert got is None and figure["absent_because"], f"{name}: {got}, expected none and why"
                continue
            assert got is not None, f"{name}: none ({figure['absent_because']}), expected {float(want)}"
            assert abs(got - float(want)) <= 1e-9 + 1e-11 * abs(float(want)), f"{name}: {got}, expected {float(want)}"
            assert figure["checked_against_text"] != (unchecked in figure["evidence_text"]), name
            share = figure["share_of_travel"]
            assert share is None or abs(share - float(want) / (travel * per_position)) <= 1e-9 * abs(share) + 1e-15, name
            seen += 1
    assert seen == len(expected), f"{what}: {seen} figures, expected {len(expected)}"
    for warning in result["warnings"]:
        assert warning["message"].count(unchecked) + warning["message"].count("read in the text of the rule") == 1
    return seen


def written(targets, up, down, rotary):
    file = tempfile.NamedTemporaryFile("w", suffix=".csv")
    file.write("# axis.kind: rotary\n# unit: arcsec\n# target unit: deg\n" if rotary else "# unit: um\n# target unit: mm\n")
    file.write("target,direction,run,deviation\n")
    for name, x in (("up", up), ("down", down)):
        for target, cell in zip(targets, x):
            file.writelines(f"{float(target)!r},{name},{j + 1},{float(v)!r}\n" for j, v in enumerate(cell))
    file.flush()
    return file


def seeded(seed):
    rng = random.Random(seed)
    m, runs = rng.choice([2, 3, 5, 8, 11]), rng.choice([1, 2, 3, 5, 7, 10])
    step = Fraction(rng.randint(50, 20000), 1000)
    targets = [Fraction(rng.randint(-300, 300)) + step * i for i in [*range(m)]]
    targets = [targets[0] + step * i + (Fraction(rng.randint(-100, 100), 1000) * step if rng.random() < .5 else 0) for i in range(m)]
    size = rng.choice([Fraction(1, 50), Fraction(1), Fraction(40)])
    cell = lambda: [size * Fraction(rng.randint(-3000, 3000), 1000) for _ in range(runs)]
    which = rng.choice(["both", "both", "both", "up", "down"])
    up = [cell() for _ in targets] if which != "down" else []
    down = [cell() for _ in targets] if which != "up" else []
    floats = lambda x: [[Fraction(float(v)) for v in c] for c in x]
    return [Fraction(float(t)) for t in targets], floats(up), floats(down), rng.random() < .3


def table_2():
    readings = {}
    lines = [line for line in TABLE_2.read_text().splitlines() if not line.startswith("#")]
    for row in csv.DictReader(lines):
        readings.setdefault((Fraction(row["target_mm"]), row["direction"]), []).append(Fraction(row["deviation_um"]))
    targets = sorted({target for target, _ in readings})
    return targets, [readings[t, "up"] for t in targets], [readings[t, "down"] for t in targets]


def main():
    targets, up, down = table_2()
    expected = figures(targets, up, down)
    seen = compare(program(str(TABLE_2)), expected, float(targets[-1] - targets[0]), 1000, "Table 2")
    for key in sorted(expected):
        if "-v" in sys.argv:
            print(*key, float(expected[key]))
    for seed in range(TESTS):
        targets, up, down, rotary = seeded(seed)
        with written(targets, up, down, rotary) as file:
            seen += compare(program(file.name), figures(targets, up, down, not rotary), float(targets[-1] - targets[0]),
                            3600 if rotary else 1000, f"test {seed}")
    print(f"{seen} figures of {TESTS + 1} tests agree")


if __name__ == "__main__":
    main()
