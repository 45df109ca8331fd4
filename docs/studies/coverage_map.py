#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Where the 95 % intervals hold the truth: a map over what the environment may do.

  coverage_map.py PROGRAM                    counts every cell of the map, writes coverage_map.csv
  coverage_map.py PROGRAM --draw             draws coverage_map.svg and the tables of coverage_map.md from it
  coverage_map.py PROGRAM --check            a small part of the map; fails where too few intervals hold
      --tests N        simulated tests of each cell (100)
      --kinds A,B      counts the cells of these kinds again and keeps the others
      --trials N       Monte Carlo trials in each (400)

Simulates tests whose truth is known, has the program evaluate them with the kind of E_VE unknown, as it is when nothing
is stated, and counts how often the truth lies in the interval. The truth is computed here, in numpy, not by the
program. Needs numpy.
"""
import argparse
import csv
import dataclasses
import itertools
import pathlib
import re
import subprocess
import sys
import tempfile
import zlib

import numpy as np

import clause3

FOLDER = pathlib.Path(__file__).parent
RESULTS, PICTURE, DOCUMENT = (FOLDER / f"coverage_map.{end}" for end in ("csv", "svg", "md"))
SEED = 14
TARGETS, RANGE = 9, 1.7  # µm: E_VE as it truly is
KINDS = ("white", "sine", "trend", "random walk", "mixture")
RATIOS = (0.25, 0.5, 1.0, 2.0, 4.0)  # E_VE as stated over E_VE as it truly is
OUTLIERS = (0.0, 0.01, 0.05)
RUNS = (3, 5, 10)
MEASURANDS = ("this-test", "this-machine")
MACHINES = {"steady": (0.55, 0.0), "shifting": (0.2, 1.0)}  # scatter s, and of shifts of whole runs, µm
LEAST = 93.0
REFUSED = 50.0  # % of tests, from which on a cell says that no interval is stated


@dataclasses.dataclass(frozen=True)
class Setting:
    kind: str
    ratio: float
    outliers: float
    runs: int
    machine: str = "steady"


def times(runs):
    """Share of the time of each reading: direction, target, run; bidirectional cycle, equal steps."""
    order = [(d, i if d == 0 else TARGETS - 1 - i, j) for j in range(runs) for d in (0, 1) for i in range(TARGETS)]
    share = np.zeros((2, TARGETS, runs))
    for k, place in enumerate(order):
        share[place] = k / (len(order) - 1)
    return share


def environment(kind, tests, runs, rng):
    """What the environment does to each reading; its range over a test is about RANGE."""
    share = times(runs)
    if kind == "white":
        return RANGE / np.sqrt(12) * rng.standard_normal((tests, *share.shape))
    if kind == "sine":
        phase = rng.uniform(0, 2 * np.pi, (tests, 1, 1, 1))
        return RANGE / 2 * np.sin(2 * np.pi * share + phase)
    if kind == "trend":
        return RANGE * rng.choice([-1.0, 1.0], (tests, 1, 1, 1)) * (share - 0.5)
    if kind == "random walk":
        steps = rng.standard_normal((tests, share.size)) / np.sqrt(share.size)
        walk = np.cumsum(steps, axis=1) * RANGE / np.sqrt(8 / np.pi)
        order = np.argsort(share.ravel())
        found = np.empty_like(walk)
        found[:, order] = walk
        return found.reshape(tests, *share.shape)
    return 0.7 * environment("sine", tests, runs, rng) + 0.7 * environment("white", tests, runs, rng)


def simulate(setting, tests):
    """Readings, and what is true of this test and of this machine."""
    rng = np.random.default_rng([SEED, zlib.crc32(f"{setting.kind} {setting.outliers} {setting.runs}".encode())])
    scatter, shift = MACHINES[setting.machine]
    i = np.linspace(0, 10, TARGETS)
    up = 6 * np.sin(0.55 * i) + 0.4 * i
    means = np.stack([up, up + 2.5 + 0.6 * np.cos(0.9 * i)])
    did = means[None, :, :, None] + scatter * rng.standard_normal((tests, 2, TARGETS, setting.runs))
    did = did + shift * rng.standard_normal((tests, 1, 1, setting.runs))
    read = did + environment(setting.kind, tests, setting.runs, rng)
    gross = rng.random(read.shape) < setting.outliers  # of the measurement, 5 to 15 times the machine's scatter
    read = read + gross * rng.choice([-1.0, 1.0], read.shape) * rng.uniform(5, 15, read.shape) * scatter
    cells = (tests, 2, TARGETS)
    long_run = clause3.evaluate_cells(np.broadcast_to(means, cells), np.full(cells, np.hypot(scatter, shift)))
    return read, {"this-test": clause3.evaluate(did), "this-machine": long_run}


def intervals(options, readings, setting, measurand):
    """Interval of every parameter of every test: test, parameter, (low, high); NaN where the program states none."""
    with tempfile.TemporaryDirectory() as folder:
        file, table = pathlib.Path(folder, "tests.csv"), pathlib.Path(folder, "all.csv")
        with open(file, "w", encoding="utf-8") as out:
            out.write("# axis: X\ntest,target_mm,direction,run,deviation_um\n")
            for t, (d, i, j) in itertools.product(range(len(readings)), np.ndindex(readings.shape[1:])):
                out.write(f"t{t},{100 * i},{('up', 'down')[d]},{j + 1},{readings[t, d, i, j]!r}\n")
        subprocess.run([options.program, "evaluate", str(file), "--quiet", "--report", str(table), "--uncertainty",
                        "monte-carlo", "--trials", str(options.trials), "--seed", "1", "--measurand", measurand,
                        "--environmental-variation", repr(RANGE * setting.ratio)], check=True)
        with open(table, encoding="utf-8", newline="") as text:
            return np.array([[[float(row[f"mc_{end}_{p}"] or "nan") for end in ("low", "high")]
                              for p in clause3.PARAMETERS] for row in csv.DictReader(text)])


def count(options, setting, measurand):
    """Of every parameter: tests with an interval, and those of them that hold the truth."""
    readings, truth = simulate(setting, options.tests)
    ends = intervals(options, readings, setting, measurand)
    stated = ~np.isnan(ends[..., 0])
    slack = 1e-9  # of the text of the readings
    held = stated & (truth[measurand] >= ends[..., 0] - slack) & (truth[measurand] <= ends[..., 1] + slack)
    return stated.sum(axis=0), held.sum(axis=0)


def all_settings():
    steady = [Setting(*x) for x in itertools.product(KINDS, RATIOS, OUTLIERS, RUNS)]
    return steady + [Setting(kind, ratio, 0.0, runs, "shifting") for kind, ratio, runs in
                     itertools.product(KINDS, RATIOS, RUNS)]


def study(options):
    chosen = options.kinds.split(",") if options.kinds else KINDS
    kept = []
    if options.kinds:
        with open(RESULTS, encoding="utf-8", newline="") as text:
            kept = [row for row in list(csv.reader(text))[1:] if row[0] not in chosen]
    with open(RESULTS, "w", encoding="utf-8", newline="") as out:
        table = csv.writer(out, lineterminator="\n")
        table.writerow(["kind", "stated_over_true", "outliers", "runs", "machine", "measurand", "parameter", "tests",
                        "stated", "held"])
        table.writerows(kept)
        for setting, measurand in itertools.product([s for s in all_settings() if s.kind in chosen], MEASURANDS):
            stated, held = count(options, setting, measurand)
            for p, s, h in zip(clause3.PARAMETERS, stated, held):
                table.writerow([*dataclasses.astuple(setting), measurand, p, options.tests, s, h])
            out.flush()
            print(setting, measurand, held.sum(), "of", stated.sum(), flush=True)
    return 0


def check(options):
    """Cells that each failed before E_VE had a kind, with room for the binomial error of so few tests."""
    faults = 0
    chosen = [("this-test", Setting("sine", 1.0, 0.0, 5)), ("this-test", Setting("random walk", 1.0, 0.0, 5)),
              ("this-test", Setting("white", 4.0, 0.0, 5)), ("this-test", Setting("white", 1.0, 0.0, 5)),
              ("this-test", Setting("trend", 0.25, 0.0, 3)), ("this-test", Setting("mixture", 1.0, 0.01, 5)),
              ("this-machine", Setting("white", 1.0, 0.0, 5)), ("this-test", Setting("white", 1.0, 0.05, 10)),
              ("this-test", Setting("random walk", 1.0, 0.0, 5, "shifting")),
              ("this-test", Setting("trend", 1.0, 0.0, 3, "shifting")), ("this-test", Setting("trend", 0.25, 0.0, 5, "shifting")),
              ("this-test", Setting("white", 0.25, 0.0, 5))]
    for measurand, setting in chosen:
        stated, held = count(options, setting, measurand)
        for p, s, h in zip(clause3.PARAMETERS, stated, held):
            wrong, allowed = int(s - h), options.tests * 0.07 + 3 * np.sqrt(options.tests * 0.07 * 0.93)
            if wrong > allowed:
                print(f"{setting} {measurand} {p}: {wrong} of {s} intervals without the truth, at most {allowed:.0f}")
                faults += 1
        if setting.outliers == 0.05 and stated.max() > 0.2 * options.tests:
            print(f"{setting}: {stated.max()} of {options.tests} tests with outliers got an interval")
            faults += 1
    return 1 if faults else 0


def read_results():
    found = {}
    with open(RESULTS, encoding="utf-8", newline="") as text:
        for row in csv.DictReader(text):
            setting = Setting(row["kind"], float(row["stated_over_true"]), float(row["outliers"]), int(row["runs"]),
                              row["machine"])
            found.setdefault((row["measurand"], setting), {})[row["parameter"]] = tuple(
                int(row[name]) for name in ("tests", "stated", "held"))
    return found


def state_of(tests, stated, held):
    """What a cell of the map is: one of the keys of FILLS."""
    if 100 * (tests - stated) / tests >= REFUSED:
        return "refused"
    share = 100 * held / stated
    error = 100 * np.sqrt(LEAST / 100 * (1 - LEAST / 100) / stated)
    return "held" if share >= LEAST else "near" if share >= LEAST - 2 * error else "short"


FILLS = {"held": "#5b9bd5", "near": "#cfe2f3", "short": "#c0392b", "refused": "#d9d9d9"}
WORDS = {"held": "93 % or more hold the truth", "near": "less, but within the binomial error (k = 2) of 93 %",
         "short": "less", "refused": "most tests refused: outliers"}


def draw(found):
    """A strip of twelve fields, A to B̄, for every setting."""
    wide, high, gap, left, top = 5.2, 15, 6, 118, 74
    blocks = [("steady", o) for o in OUTLIERS] + [("shifting", 0.0)]
    across = [(m, o, r) for m, o in blocks for r in RATIOS]
    down = [(k, n) for k in KINDS for n in RUNS]
    strip = 12 * wide + gap
    width = left + len(across) * strip + 3 * 14 + 10
    panel = len(down) * (high + 3) + len(KINDS) * 5 + 62
    height = top + len(MEASURANDS) * panel + 46
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height:.0f}" font-family="sans-serif" '
           'font-size="10">', f'<rect width="{width:.0f}" height="{height:.0f}" fill="#ffffff"/>',
           f'<text x="{left}" y="20" font-size="14">Tests whose 95 % interval holds the truth</text>']
    x = left
    for key in FILLS:
        out.append(f'<rect x="{x}" y="30" width="12" height="10" fill="{FILLS[key]}" stroke="#555" stroke-width=".6"/>')
        out.append(f'<text x="{x + 16}" y="39">{WORDS[key]}</text>')
        x += 30 + 5.4 * len(WORDS[key])
    out.append(f'<text x="{left}" y="58">each strip: A A↑ A↓ E E↑ E↓ M R R↑ R↓ B B̄; columns: E_VE as stated over E_VE '
               'as it truly is; rows: kind of E_VE and approaches n</text>')
    for m, measurand in enumerate(MEASURANDS):
        y0 = top + m * panel + 40
        out.append(f'<text x="8" y="{y0 - 28}" font-size="12">{measurand.replace("-", " ")}</text>')
        for c, (machine, outliers, ratio) in enumerate(across):
            x = left + c * strip + 14 * (c // len(RATIOS))
            if c % len(RATIOS) == 0:
                words = f"outliers {100 * outliers:g} %" if machine == "steady" else "runs that shift"
                out.append(f'<text x="{x}" y="{y0 - 18}">{words}</text>')
            out.append(f'<text x="{x + 6 * wide}" y="{y0 - 5}" text-anchor="middle">{ratio:g}</text>')
        for r, (kind, runs) in enumerate(down):
            y = y0 + r * (high + 3) + 5 * (r // len(RUNS))
            if r % len(RUNS) == 0:
                out.append(f'<text x="8" y="{y + 11}">{kind}</text>')
            out.append(f'<text x="{left - 8}" y="{y + 11}" text-anchor="end">n = {runs}</text>')
            for c, (machine, outliers, ratio) in enumerate(across):
                setting = Setting(kind, ratio, outliers, runs, machine)
                x = left + c * strip + 14 * (c // len(RATIOS))
                states = [state_of(*found[measurand, setting][p]) for p in clause3.PARAMETERS]
                k = 0
                for state, alike in itertools.groupby(states):
                    fields = len(list(alike))
                    out.append(f'<rect x="{x + k * wide:.1f}" y="{y}" width="{fields * wide:.1f}" height="{high}" '
                               f'fill="{FILLS[state]}"/>')
                    k += fields
                out.append(f'<rect x="{x:.1f}" y="{y}" width="{12 * wide:.1f}" height="{high}" fill="none" '
                           'stroke="#555" stroke-width=".6"/>')
    out.append("</svg>")
    PICTURE.write_text("\n".join(out) + "\n", encoding="utf-8")


def table_of(found, measurand):
    """The worst parameter of every setting: share of intervals that hold, and what share of tests was refused."""
    lines = ["| kind | n | outliers | " + " | ".join(f"{r:g}" for r in RATIOS) + " |", "|---" * (3 + len(RATIOS)) + "|"]
    rows = [(kind, runs, "steady", outliers) for kind, runs, outliers in itertools.product(KINDS, RUNS, OUTLIERS)]
    rows += [(kind, runs, "shifting", 0.0) for kind, runs in itertools.product(KINDS, RUNS)]
    for kind, runs, machine, outliers in rows:
        shown = []
        for ratio in RATIOS:
            setting = Setting(kind, ratio, outliers, runs, machine)
            cell = found[measurand, setting]
            tests = next(iter(cell.values()))[0]
            refused = 100 * max((t - s) / t for t, s, _ in cell.values())
            stated = [(h / s, h, s, p) for p, (_, s, h) in cell.items() if s > 0]
            text = "–"
            if stated:
                share, held, count, p = min(stated)
                few = refused >= REFUSED
                text = f"{held} of {count} {clause3.SYMBOLS[p]}" if few else f"{100 * share:.0f} {clause3.SYMBOLS[p]}"
            shown.append(text + (f", {refused:.0f} refused" if refused >= 2.5 or not stated else ""))
        case = f"{100 * outliers:g} %" if machine == "steady" else "runs shift"
        lines.append(f"| {kind} | {runs} | {case} | " + " | ".join(shown) + " |")
    return "\n".join(lines) + "\n"


def write_document(found):
    text = DOCUMENT.read_text(encoding="utf-8")
    for measurand in MEASURANDS:
        marks = rf"(<!-- results: {measurand} -->\n).*?(<!-- end -->)"
        table = table_of(found, measurand)
        text, replaced = re.subn(marks, lambda m: m.group(1) + table + m.group(2), text, flags=re.S)
        assert replaced == 1, measurand
    DOCUMENT.write_text(text, encoding="utf-8")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--tests", type=int, default=100)
    parser.add_argument("--trials", type=int, default=400)
    parser.add_argument("--kinds", default="")
    parser.add_argument("--draw", action="store_true")
    parser.add_argument("--check", action="store_true")
    options = parser.parse_args()
    if options.check:
        return check(options)
    if options.draw:
        found = read_results()
        draw(found)
        write_document(found)
        return 0
    return study(options)


if __name__ == "__main__":
    sys.exit(main())
