#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Clause 3 of ISO 230-2 with forty digits, to prove the figures in conformance cases.

usage: oracle.py FILE.case...

Evaluates the readings written in each case and compares every `expect PARAMETER …` and
`expect position …` with a number or `not applicable`. Shares no code with the program. Cases that
name a file or correct readings, uncertainties and findings are left to `axiometry check`.
"""
import sys
from decimal import Decimal, getcontext

getcontext().prec = 40
NATIVE = {"um": 1, "µm": 1, "mm": 1000, "nm": Decimal("0.001"), "arcsec": 1, "deg": 3600}


def value_range(values):
    return max(values) - min(values) if values else None


def mean(values):
    return sum(values) / len(values) if values else None


def estimator(values):
    if len(values) < 2:
        return None
    centre = mean(values)
    return (sum((x - centre) ** 2 for x in values) / (len(values) - 1)).sqrt()


def evaluate_position(up, down):
    """3.13 to 3.20 at one target; None where the readings are missing."""
    p = {"mean_up": mean(up), "mean_down": mean(down), "s_up": estimator(up), "s_down": estimator(down)}
    both = up and down
    p["mean"] = (p["mean_up"] + p["mean_down"]) / 2 if both else None
    p["reversal"] = p["mean_up"] - p["mean_down"] if both else None
    s_up, s_down = p["s_up"] or Decimal(0), p["s_down"] or Decimal(0)
    p["R_up"] = 4 * s_up if p["s_up"] is not None else None
    p["R_down"] = 4 * s_down if p["s_down"] is not None else None
    p["bound"] = max(2 * s_up + 2 * s_down + abs(p["reversal"] or 0), 4 * s_up, 4 * s_down)
    p["R"] = p["bound"] if both and p["R_up"] is not None and p["R_down"] is not None else None
    return p


def evaluate_axis(positions):
    """3.16, 3.17 and 3.21 to 3.27."""
    def column(key):
        return [p[key] for p in positions if p[key] is not None]

    def boundaries(direction):
        return [p["mean_" + direction] + sign * 2 * (p["s_" + direction] or 0)
                for p in positions if p["mean_" + direction] is not None for sign in (1, -1)]

    a = {}
    for d in ("up", "down"):
        a["E_" + d] = value_range(column("mean_" + d))
        a["R_" + d] = max(column("R_" + d), default=None)
        a["A_" + d] = value_range(boundaries(d)) if column("R_" + d) else None
    both = column("mean_up") and column("mean_down")
    repeat = column("R_up") and column("R_down")
    reversal = column("reversal")
    a["E"] = value_range(column("mean_up") + column("mean_down")) if both else None
    a["A"] = value_range(boundaries("up") + boundaries("down")) if repeat else None
    a["R"] = max(p["bound"] for p in positions) if repeat and reversal else None
    a["M"] = value_range(column("mean"))
    a["B"] = max(map(abs, reversal), default=None)
    a["B_mean"] = mean(reversal)
    return a


def evaluate(operation):
    count = len(operation["targets"])
    cells = {d: [[run[i] for run in operation[d] if run[i] is not None] for i in range(count)] for d in ("up", "down")}
    positions = [evaluate_position(cells["up"][i], cells["down"][i]) for i in range(count)]
    return positions, evaluate_axis(positions)


def words_of(line):
    for relation in ("<=", ">=", "=", "<", ">"):
        if relation in line:
            line = line.replace(relation, f" {relation} ", 1)
            break
    return line.split("#")[0].split()


def compare(where, words, results, tolerance):
    """The disagreement as text, "" when there is none, None when the line is not about clause 3."""
    positions, axis = results
    if words[0] == "position":
        value, rest = positions[int(words[1]) - 1][words[2]], words[3:]
    elif words[0] in axis:
        value, rest = axis[words[0]], words[1:]
    else:
        return None
    if rest == ["not", "applicable"]:
        return "" if value is None else f"{where}: {' '.join(words)}: the oracle says {value:.12f}"
    if rest[0] != "=":
        return None
    expected = Decimal(rest[1]) * NATIVE[rest[2]]
    if len(rest) > 3:
        tolerance = Decimal(rest[4]) * NATIVE[rest[5]]
    if value is not None and abs(value - expected) <= tolerance:
        return ""
    return f"{where}: {' '.join(words)}: the oracle says {value}"


def check(path):
    operation, results, tolerance, count, wrong = None, None, Decimal("1e-9"), 0, []
    for number, line in enumerate(open(path, encoding="utf-8"), 1):
        words = words_of(line)
        verb = words[0] if words else ""
        if verb == "operation":
            operation, results, tolerance = {"targets": [], "up": [], "down": []}, None, Decimal("1e-9")
        elif verb == "targets":
            operation["targets"] = words[1:-1]
        elif verb in ("up", "down"):
            unit = NATIVE[words[-1]]
            operation[verb].append([None if w == "-" else Decimal(w) * unit for w in words[1:-1]])
        elif verb == "correct":
            operation["targets"] = []
        elif verb == "tolerance":
            tolerance = Decimal(words[1]) * NATIVE[words[2]]
        elif verb == "expect" and words[1] != "error" and operation["targets"]:
            results = results or evaluate(operation)
            disagreement = compare(f"{path}:{number}", words[1:], results, tolerance)
            count += disagreement is not None
            if disagreement:
                wrong.append(disagreement)
    print(f"{path}: {count} figures, {len(wrong)} disagreements", *wrong, sep="\n  ")
    return not wrong


if __name__ == "__main__":
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    sys.exit(0 if all([check(path) for path in sys.argv[1:]]) else 1)
