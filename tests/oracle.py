#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Random tests, written as CSV in random dialects, evaluated by the program and by this independent script.

Usage: tests/oracle.py PROGRAM [COUNT] [SEED]

Everything is computed from the definitions of ISO 230-2:2014 clause 3 and Annex A, verdicts from ISO 14253-1, with exact sums
(math.fsum), and shares nothing with the C++ code but the standard.
"""
import json
import math
import random
import subprocess
import sys
import tempfile

TOLERANCE = 1e-9  # µm or ″
Z95 = 1.6448536269514722  # 95 % of a normal distribution lie below it


def make_test(rng):
    """Targets, readings[direction][target][run] (None: missing) and whether the axis is rotary."""
    rotary = rng.random() < 0.25
    m = rng.choice([2, 3, 5, 8, 11, 11, 23])
    n = rng.choice([1, 2, 3, 5, 5, 5, 10])
    both = rng.random() < 0.85
    span = 360.0 if rotary else rng.choice([50.0, 500.0, 1750.0, 4000.0])
    start = rng.choice([0.0, -span / 2, 6.711])
    targets = sorted({round(start + span * (i + rng.uniform(-0.3, 0.3)) / m, 3) for i in range(m)})
    scale = rng.choice([0.05, 1.0, 30.0])
    offset = rng.choice([0.0, 0.0, 900.0])
    decimals = rng.choice([1, 3, 6])
    readings = {}
    for direction in ("up", "down") if both else (rng.choice(("up", "down")),):
        shift = rng.gauss(0, 3 * scale)
        readings[direction] = [[round(offset + shift + scale * (math.sin(i) + rng.gauss(0, 0.3)), decimals) for _ in range(n)]
                               for i in range(len(targets))]
    if rng.random() < 0.2:
        for rows in readings.values():
            for row in rows:
                if rng.random() < 0.2 and sum(x is not None for x in row) > 1:
                    row[rng.randrange(n)] = None
    return targets, readings, rotary


def write_csv(rng, targets, readings, rotary):
    comma = rng.random() < 0.5
    delimiter = rng.choice([";", "\t"]) if comma else rng.choice([",", ";", "\t"])
    end = rng.choice(["\n", "\r\n"])
    unit, factor = ("arcsec", 1.0) if rotary else rng.choice([("um", 1.0), ("mm", 1e-3), ("nm", 1e3)])
    words = rng.choice([("up", "down"), ("+", "-"), ("forward", "backward"), ("↑", "↓")])
    words = dict(zip(("up", "down"), words))

    def number(x):
        text = repr(x)
        return text.replace(".", ",") if comma else text

    lines = [f"# axis: {'C' if rotary else 'X'}"] if rng.random() < 0.5 else []
    wide = rng.random() < 0.3
    n = max(len(row) for rows in readings.values() for row in rows)
    position = "target_deg" if rotary else "target_mm"
    if wide:
        header = [position] + [f"{d}{j + 1}_{unit}" for j in range(n) for d in readings]
        lines.append(delimiter.join(header))
        for i, target in enumerate(targets):
            cells = [readings[d][i][j] for j in range(n) for d in readings]
            lines.append(delimiter.join([number(target)] + ["" if x is None else number(x * factor) for x in cells]))
    else:
        lines.append(delimiter.join([position, "direction", "run", f"deviation_{unit}"]))
        rows = [(d, i, j) for d in readings for i in range(len(targets)) for j in range(n) if readings[d][i][j] is not None]
        rng.shuffle(rows)
        for d, i, j in rows:
            lines.append(delimiter.join([number(targets[i]), words[d], str(j + 1), number(readings[d][i][j] * factor)]))
    text = end.join(lines) + end
    return (b"\xef\xbb\xbf" if rng.random() < 0.3 else b"") + text.encode()


def evaluate(targets, readings):
    positions = []
    for i, target in enumerate(targets):
        p = {"target": target, "mean_up": None, "mean_down": None, "mean": None, "reversal": None, "s_up": None, "s_down": None}
        for d, rows in readings.items():
            values = [x for x in rows[i] if x is not None]
            if values:
                p[f"mean_{d}"] = math.fsum(values) / len(values)
            if len(values) > 1:
                mean = math.fsum(values) / len(values)
                p[f"s_{d}"] = math.sqrt(math.fsum((x - mean) ** 2 for x in values) / (len(values) - 1))
        if p["mean_up"] is not None and p["mean_down"] is not None:
            p["mean"] = (p["mean_up"] + p["mean_down"]) / 2
            p["reversal"] = p["mean_up"] - p["mean_down"]
        positions.append(p)

    def some(key):
        return [p[key] for p in positions if p[key] is not None]

    def span(values):
        return max(values) - min(values) if values else None

    def boundaries(d):
        have = [p for p in positions if p[f"mean_{d}"] is not None]
        return [p[f"mean_{d}"] + sign * 2 * (p[f"s_{d}"] or 0.0) for p in have for sign in (1, -1)]

    r = {"E_up": span(some("mean_up")), "E_down": span(some("mean_down")), "M": span(some("mean"))}
    up, down = some("mean_up"), some("mean_down")
    r["E"] = span(up + down) if up and down else None
    r["R_up"] = 4 * max(some("s_up")) if some("s_up") else None
    r["R_down"] = 4 * max(some("s_down")) if some("s_down") else None
    r["A_up"] = span(boundaries("up")) if some("s_up") else None
    r["A_down"] = span(boundaries("down")) if some("s_down") else None
    both = bool(some("s_up")) and bool(some("s_down"))
    r["A"] = span(boundaries("up") + boundaries("down")) if both else None
    r["B"] = max(map(abs, some("reversal")), default=None)
    r["B_mean"] = math.fsum(some("reversal")) / len(some("reversal")) if some("reversal") else None
    r["R"] = None
    if both and some("reversal"):
        r["R"] = max(max(2 * (p["s_up"] or 0) + 2 * (p["s_down"] or 0) + abs(p["reversal"] or 0), 4 * (p["s_up"] or 0),
                         4 * (p["s_down"] or 0)) for p in positions)
    return r, positions


def annex_a(parameters, length_m, n, inputs):
    device = 0.6 * inputs["range"] * length_m
    misalignment = 0.3 * inputs["misalignment"] ** 2 / length_m
    temperature = 0.6 * 12.0 * length_m * inputs["theta"]
    expansion = 0.6 * inputs["dT"] * length_m * 2.0
    eve = 0.6 * inputs["eve"]
    common = device ** 2 + misalignment ** 2 + temperature ** 2 + expansion ** 2
    E = math.sqrt(common + eve ** 2 / n)
    one_way, both_ways = (4 / math.sqrt(n - 1), math.sqrt(16 / (n - 1) + 4 / n)) if 1 < n < 5 else (2, 2.2)
    U = {"E": E, "E_up": E, "E_down": E, "M": math.sqrt(common + eve ** 2 / (2 * n)), "R": both_ways * eve,
         "R_up": one_way * eve, "R_down": one_way * eve, "B": (0.9 if n == 5 else 2 / math.sqrt(n)) * eve}
    U["B_mean"] = U["B"]
    for key in ("A", "A_up", "A_down"):
        U[key] = math.hypot(E, one_way * eve)
    return {key: (U[key] if parameters[key] is not None else None) for key in parameters}


def differs(found, expected):
    if found is None or expected is None:
        return found is not expected
    return not abs(found - expected) <= TOLERANCE * max(1.0, abs(expected) * 1e-3)


def phi(z):
    return 0.5 * math.erfc(-z / math.sqrt(2))


def make_demands(rng, parameters):
    """Limits about the measured magnitudes, and a rule."""
    chosen = [key for key in parameters if rng.random() < 0.4]
    limits = {}
    for key in chosen:
        magnitude = abs(parameters[key]) if parameters[key] is not None else 1.0
        limits[key] = max(round(magnitude * rng.choice([0.3, 0.8, 1.0, 1.2, 3.0]), 3), 0.001)
    return limits, rng.choice(["simple", "iso14253-1", "guard-band"]), round(rng.uniform(0, 3), 2)


def demand_arguments(limits, rule, width):
    arguments = [f"--set=tolerance.{key}={limit!r}" for key, limit in limits.items()]
    arguments.append(f"--set=tolerance.rule={rule}")
    return arguments + ([f"--set=tolerance.guard_band={width!r}"] if rule == "guard-band" else [])


def decide(key, value, u, limit, rule, width):
    """Verdict, guard band and probability of conformity: ISO 14253-1, JCGM 106."""
    if value is None:
        return "not applicable", None, None
    y = abs(value)
    p = None
    if u:
        p = phi((limit - y) / u) - (phi((-limit - y) / u) if key == "B_mean" else 0)
    elif u == 0:
        p = 1.0 if y <= limit else 0.0
    if rule == "simple":
        return ("conforms" if y <= limit else "does not conform"), 0.0, p
    if u is None:
        return "undecided", None, None
    if rule == "iso14253-1":
        g = None if key == "B_mean" else Z95 * u  # that of a magnitude has no closed form
        return ("conforms" if p >= 0.95 else "does not conform" if p <= 1 - 0.95 else "undecided"), g, p
    g = width
    return ("conforms" if y <= limit - g else "does not conform" if y > limit + g else "undecided"), g, p


def lacks_a_term(key, positions):
    """Whether some target lacks a reading that the parameter is taken from: it is then a lower bound, and B_mean that of a part."""
    sides = ["up"] if key.endswith("_up") else ["down"] if key.endswith("_down") else ["up", "down"]
    terms = [f"{term}_{side}" for side in sides for term in (("mean", "s") if key[0] in "AR" else ("mean",))]
    return any(p[term] is None for p in positions for term in terms)


def compare_verdicts(result, code, parameters, positions, U, demands):
    limits, rule, width = demands
    expected = {}
    for row in result.get("tolerances", []):
        key = row["parameter"]
        u = U[key] / 2 if U and U[key] is not None else None
        y = abs(parameters[key]) if parameters[key] is not None else None
        verdict, g, p = decide(key, parameters[key], u, limits[key], rule, width)
        edges = [limits[key] - (g or 0), limits[key] + (g or 0)]
        if y is not None and min(abs(y - edge) for edge in edges) < 1e-9:
            verdict = row["verdict"]  # too near an edge for two ways of rounding to agree
        if y is not None and lacks_a_term(key, positions) and (verdict != "does not conform" or key == "B_mean"):
            verdict, g, p = "undecided", None, None
        expected[key] = verdict
        risk = {"conforms": ("consumer_risk", None if p is None else 1 - p), "does not conform": ("producer_risk", p)}
        named = risk.get(verdict, (None, None))
        if row["verdict"] != verdict or row["limit"] != limits[key]:
            yield f"{key} against {limits[key]}: found {row['verdict']}, expected {verdict}"
        if y is not None and rule == "iso14253-1" and key == "B_mean":
            g = row["guard_band"]
        for name, value in {"guard_band": g, "probability_conforming": p, "consumer_risk": None, "producer_risk": None}.items():
            value = named[1] if name == named[0] else value
            if differs(row[name], value):
                yield f"{name} of {key}: found {row[name]}, expected {value}"
    if set(expected) != set(limits):
        yield f"verdicts on {sorted(expected)}, expected {sorted(limits)}"
    worst = [v for v in ("does not conform", "undecided", "conforms", "not applicable") if v in expected.values()][:1]
    if worst == ["conforms"] and "not applicable" in expected.values():
        worst = ["undecided"]  # a part of what was demanded could not be looked at
    if (result.get("verdict"), code) != (worst[0], {"conforms": 0, "does not conform": 3}.get(worst[0], 4)) if worst else code:
        yield f"verdict {result.get('verdict')} with exit code {code}, expected {worst}"


def compare(result, targets, readings, rotary, inputs, code, demands):
    parameters, positions = evaluate(targets, readings)
    for key, expected in parameters.items():
        if differs(result["parameters"][key], expected):
            yield f"{key}: found {result['parameters'][key]}, expected {expected}"
    for found, expected in zip(result["positions"], positions, strict=True):
        for key, value in expected.items():
            if differs(found[key], value):
                yield f"{key} at {expected['target']}: found {found[key]}, expected {value}"
    if result["unit"] != ("arcsec" if rotary else "um"):
        yield f"unit {result['unit']}"
    U = None
    if inputs:
        n = min(sum(x is not None for x in row) for rows in readings.values() for row in rows)
        U = annex_a(parameters, (targets[-1] - targets[0]) / 1000, n, inputs)
        for key, expected in U.items():
            if differs(result["uncertainty"]["annex_a"][key], expected):
                yield f"U({key}): found {result['uncertainty']['annex_a'][key]}, expected {expected}"
    yield from compare_verdicts(result, code, parameters, positions, U, demands)


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 300
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 230
    failed = 0
    with tempfile.TemporaryDirectory() as folder:
        for k in range(count):
            rng = random.Random(f"{seed}/{k}")
            targets, readings, rotary = make_test(rng)
            path = f"{folder}/test.csv"
            with open(path, "wb") as file:
                file.write(write_csv(rng, targets, readings, rotary))
            command = [program, "evaluate", path, "--json", "-"]
            inputs = None
            if not rotary and rng.random() < 0.5:
                inputs = {key: round(rng.uniform(0.1, 4), 2) for key in ("range", "misalignment", "theta", "dT", "eve")}
                command += ["--device-error-range-um-per-m", str(inputs["range"]), "--misalignment-mm", str(inputs["misalignment"]),
                            "--machine-temperature-range-c", str(inputs["theta"]),
                            "--machine-temperature-difference-c", str(inputs["dT"]), "--set", "nde.applied=yes", "--environmental-variation", str(inputs["eve"])]
            demands = make_demands(rng, evaluate(targets, readings)[0])
            done = subprocess.run(command + demand_arguments(*demands), capture_output=True)
            if done.returncode not in (0, 3, 4):
                faults = [done.stderr.decode()]
            else:
                faults = list(compare(json.loads(done.stdout), targets, readings, rotary, inputs, done.returncode, demands))
            if faults:
                failed += 1
                print(f"test {k} of seed {seed}: " + "; ".join(faults[:3]))
    print(f"{count - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
