#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What the program states must hold: verdicts at, just below and just above limits, against exact fractions; verdict, p_c,
zones and interval against each other for all three methods; verdicts under growing uncertainty; effects that nobody
corrected; limits of what a test does not have.

Usage: tests/statements_oracle.py PROGRAM [COUNT] [SEED]

Shares nothing with the C++ code but the standard.
"""
import json
import pathlib
import random
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

TABLE2 = "examples/iso230-2-table2.csv"
WITHOUT_ROOT = ("E", "E_up", "E_down", "M", "B", "B_mean")
WITH_ROOT = ("A", "A_up", "A_down", "R", "R_up", "R_down")


def evaluate(program, files, *flags):
    """Results by file name."""
    done = subprocess.run([program, "evaluate", *map(str, files), "--quiet", "--json", "-", *flags], capture_output=True,
                          text=True, check=False)
    if done.returncode not in (0, 3, 4):
        sys.exit(f"exit code {done.returncode}: {done.stderr}")
    results = json.loads(done.stdout)
    results = results if isinstance(results, list) else [results]
    return {pathlib.Path(result["source"]["file"]).name: result for result in results}, done.returncode


def decimal(x):
    """A fraction that is a decimal, as text."""
    places = 0
    while (x * 10**places).denominator != 1:
        places += 1
    sign, digits = ("-" if x < 0 else ""), str(abs(x * 10**places).numerator).rjust(places + 1, "0")
    return sign + digits[:len(digits) - places] + ("." + digits[len(digits) - places:] if places else "")


def parameters(up, down, s):
    """Clause 3 of the cells' means and of one s for all, as fractions; up and down by target."""
    means = [(a + b) / 2 for a, b in zip(up, down)]
    reversals = [a - b for a, b in zip(up, down)]
    spread = lambda values: max(values) - min(values)
    B = max(abs(b) for b in reversals)
    found = {"E": spread(up + down), "E_up": spread(up), "E_down": spread(down), "M": spread(means), "B": B,
             "B_mean": sum(reversals) / len(reversals)}
    if s is not None:
        found |= {"A": found["E"] + 4 * s, "A_up": found["E_up"] + 4 * s, "A_down": found["E_down"] + 4 * s,
                  "R": max(4 * s + B, 4 * s), "R_up": 4 * s, "R_down": 4 * s}
    return found


def make_test(rng):
    """Readings in whole steps; where n is 3 they lie at −d, 0 and d about their mean, so that s is d."""
    step = Fraction(1, rng.choice((10, 100, 1000)))
    targets = [Fraction(rng.randrange(0, 10), 10) + 40 * i for i in range(rng.choice((3, 5, 8)))]
    with_s = rng.random() < 0.5
    d = step * rng.randrange(1, 30) if with_s else None
    cells = {}
    for direction in ("up", "down"):
        for i in range(len(targets)):
            middle = step * rng.randrange(-200, 200)
            if with_s:
                readings = [middle - d, middle, middle + d]
                rng.shuffle(readings)
            else:
                readings = [middle + step * rng.randrange(-20, 20) for _ in range(rng.choice((5, 5, 10)) if not cells else
                                                                                    len(cells["up", 0]))]
            cells[direction, i] = readings
    mean = lambda direction: [sum(cells[direction, i]) / len(cells[direction, i]) for i in range(len(targets))]
    return step, targets, cells, parameters(mean("up"), mean("down"), d)


def write_test(path, rng, targets, cells, limits):
    form = rng.choice(("deviation_um", "deviation_mm", "measured_mm"))
    lines = ["# axis: X"] + [f"# tolerance.{key}: {decimal(limit)}" for key, limit in limits.items()]
    lines.append(f"target_mm,direction,run,{form}")
    for (direction, i), readings in cells.items():
        for j, x in enumerate(readings):
            value = x if form == "deviation_um" else x / 1000 + (targets[i] if form == "measured_mm" else 0)
            lines.append(f"{decimal(targets[i])},{direction},{j + 1},{decimal(value)}")
    path.write_text("\n".join(lines) + "\n", encoding="utf-8")


def at_limits(program, folder, rng, count):
    """A value keeps a limit that it equals, and not one that is a hair smaller, whatever binary numbers make of them."""
    wanted = {}
    for number in range(count):
        step, targets, cells, values = make_test(rng)
        limits, verdicts = {}, {}
        for key, value in values.items():
            size = abs(value)
            denominator = size.denominator
            while denominator % 10 == 0:
                denominator //= 10
            for factor in (2, 5):
                while denominator % factor == 0:
                    denominator //= factor
            if size == 0 or denominator != 1:
                continue  # no decimal equals it
            change = rng.choice((0, 0, 1, -1)) * step / 100
            if size + change <= 0:
                continue
            limits[key] = size + change
            verdicts[key] = "conforms" if change >= 0 else "does not conform"
        name = f"at{number}.csv"
        write_test(folder / name, rng, targets, cells, limits)
        wanted[name] = verdicts
    results, _ = evaluate(program, [folder])
    compared = 0
    for name, verdicts in wanted.items():
        found = {row["parameter"]: row["verdict"] for row in results[name].get("tolerances", [])}
        assert found == verdicts, f"{name}: found {found}, expected {verdicts}\n{(folder / name).read_text()}"
        compared += len(verdicts)
    return compared


def agrees(row, record):
    """Verdict, p_c, zones and interval of one decision under ISO 14253-1."""
    verdict, p = row["verdict"], row["probability_conforming"]
    least, most = row["probability_least"], row["probability_most"]
    value, limit = record["value"], row["limit"]
    assert least <= p <= most, row
    assert (verdict == "conforms") == (p >= 0.95) == (least >= 0.95), row
    assert (verdict == "does not conform") == (p <= 0.05 + 1e-12) == (most <= 0.05 + 1e-12), row
    accepted_to, rejected_from = row["acceptance_limit"], row["rejection_limit"]
    assert (verdict == "conforms") == (accepted_to is not None and value <= accepted_to + 1e-9), (row, record)
    assert (verdict == "does not conform") == (value > rejected_from - 1e-9), (row, record)
    low, high = record["low"], record["high"]
    if row["parameter"] == "B_mean":
        low, high = -high if low < 0 < high else min(abs(low), abs(high)), max(abs(low), abs(high))
    if high <= limit:
        assert verdict == "conforms", (row, record)
    if low > limit:
        assert verdict == "does not conform", (row, record)
    if verdict == "conforms":
        assert value <= limit, (row, record)
    if verdict == "does not conform":
        assert value > limit, (row, record)


def one_distribution(program, folder, rng, count):
    """Table 2 against random limits, by each method of record."""
    compared = 0
    plain = pathlib.Path(TABLE2).read_text(encoding="utf-8")
    base, _ = evaluate(program, [TABLE2])
    values = base[pathlib.Path(TABLE2).name]["parameters"]
    for number in range(count):
        limits = {key: abs(value) * rng.uniform(0.6, 1.6) for key, value in values.items()}
        head = "".join(f"# tolerance.{key}: {limit:.4f}\n" for key, limit in limits.items())
        (folder / f"limits{number}.csv").write_text(head + plain, encoding="utf-8")
    for method in ("annex-a", "gum", "monte-carlo"):
        for kind in ("unknown", "white", "drift"):
            results, _ = evaluate(program, [folder], "--rule", "iso14253-1", "--method", method,
                                  "--uncertainty", "monte-carlo", "--trials", "2000", "--environment-kind", kind, "--environmental-variation", "1")
            for result in results.values():
                record = result["uncertainty"]["record"]
                assert record["method"] == method.replace("-", "_") and record["chosen"]
                for row in result["tolerances"]:
                    key = row["parameter"]
                    known = record["parameters"][key]
                    assert row["u_method"] == record["method"] and row["u"] == known["u"], row
                    value = abs(result["parameters"][key])
                    if row["probability_conforming"] is None:
                        assert row["verdict"] == "undecided", row  # the method states nothing of it
                        continue
                    assert known["low"] <= result["parameters"][key] <= known["high"], (row, known)
                    agrees(row, {"value": value, "low": known["low"], "high": known["high"]})
                    compared += 1
    return compared


def more_doubt(program, folder, rng):
    """What conforms with one uncertainty never fails with another, and the other way round."""
    plain = pathlib.Path(TABLE2).read_text(encoding="utf-8")
    plain = re.sub(r"# uncertainty\.environmental_variation.*\n", "", plain)
    base, _ = evaluate(program, [TABLE2])
    values = base[pathlib.Path(TABLE2).name]["parameters"]
    for number, factor in enumerate((0.7, 0.95, 0.999, 1.001, 1.05, 1.4)):
        head = "".join(f"# tolerance.{key}: {abs(value) * factor:.5f}\n" for key, value in values.items())
        (folder / f"doubt{number}.csv").write_text(head + plain, encoding="utf-8")
    compared = 0
    for method in ("annex-a", "gum", "monte-carlo"):
        seen = {}
        for variation in (0.001, 0.1, 0.5, 1.0, 1.7, 4.0, 12.0):
            results, _ = evaluate(program, [folder], "--rule", "iso14253-1", "--method", method,
                                  "--uncertainty", "monte-carlo", "--trials", "2000", "--environmental-variation",
                                  str(variation))
            for name, result in results.items():
                for row in result["tolerances"]:
                    seen.setdefault((name, row["parameter"]), set()).add(row["verdict"])
                    compared += 1
        for where, verdicts in seen.items():
            assert not {"conforms", "does not conform"} <= verdicts, (method, where, verdicts)
    return compared


def known_effects(program, folder):
    """An uncorrected expansion lets nothing be decided, under any rule, by any method; corrected, it does."""
    text = pathlib.Path(TABLE2).read_text(encoding="utf-8")
    text = text.replace("nde.applied: yes", "nde.applied: no").replace("| 20.4 | 21.0", "| 25 | 25")
    (folder / "warm.csv").write_text(text, encoding="utf-8")
    flags = ["--machine-temperature-difference-c", "5", "--tolerance", "E=20um", "--uncertainty", "monte-carlo", "--trials", "2000"]
    for method in ("annex-a", "gum", "monte-carlo"):
        for rule in ("simple", "iso14253-1", "guard-band=1um"):
            results, code = evaluate(program, [folder / "warm.csv"], *flags, "--rule", rule, "--method", method)
            row = results["warm.csv"]["tolerances"][0]
            assert code == 4 and row["verdict"] == "undecided", row
            assert row["probability_conforming"] is None and row["acceptance_limit"] is None, row
            assert "104.7" in row["withheld"] or "105.0" in row["withheld"], row
            assert "the correction for thermal expansion" in row["withheld"], row
    results, code = evaluate(program, [folder / "warm.csv"], *flags, "--rule", "iso14253-1", "--nde-correct")
    row = results["warm.csv"]["tolerances"][0]
    assert code == 3 and row["withheld"] is None and row["verdict"] == "does not conform", row
    return 10


def missing_parameters(program, folder):
    """A demand that a test cannot meet is told, wherever it comes from, and nothing conforms as a whole."""
    single = "# axis: X\ntarget_mm,direction,run,deviation_um\n" + "".join(
        f"{10 * i},{d},1,{i}.5\n" for i in range(5) for d in ("up", "down"))
    (folder / "one.csv").write_text("# tolerance.R: 5\n# tolerance.E: 50\n" + single, encoding="utf-8")
    (folder / "two.csv").write_text(single, encoding="utf-8")
    (folder / "many.csv").write_text(
        "test,target_mm,direction,run,deviation_um\n" + "".join(
            f"t{k},{10 * i},{d},1,{i}.5\n" for k in range(2) for i in range(5) for d in ("up", "down")), encoding="utf-8")
    results, code = evaluate(program, [folder], "--tolerance", "R=5um", "--tolerance", "E=50um")
    assert code == 4, code
    for result in results.values():
        assert result["verdict"] == "undecided", result["verdict"]
        assert any("R does not exist" in f["message"] for f in result["findings"]), result["findings"]
    return len(results)


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 200
    rng = random.Random(int(sys.argv[3]) if len(sys.argv) > 3 else 2302)
    with tempfile.TemporaryDirectory() as name:
        parts = {}
        for part, check in (("at limits", lambda f: at_limits(program, f, rng, count)),
                            ("one distribution", lambda f: one_distribution(program, f, rng, max(4, count // 20))),
                            ("more doubt", lambda f: more_doubt(program, f, rng)),
                            ("known effects", lambda f: known_effects(program, f)),
                            ("missing parameters", lambda f: missing_parameters(program, f))):
            folder = pathlib.Path(name, part.replace(" ", "-"))
            folder.mkdir()
            parts[part] = check(folder)
    print(", ".join(f"{part}: {n}" for part, n in parts.items()))


if __name__ == "__main__":
    main()
