#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Do the 95 % intervals of the Monte Carlo method hold the truth? The tables of coverage.md.

Usage: docs/studies/coverage.py PROGRAM [options]

  --setting NAME    one setting (may be repeated); all but the population when not given
  --measurand WORD  this-test, this-machine; both when not given
  --tests N         simulated tests in each (10000)
  --trials N        of each Monte Carlo run (2000)
  --methods         the other methods instead
  --check           exits 1 where the mean coverage is off by more than chance and the width of --within (0.015)
  --write           puts the tables into coverage.md
  --list            names of the settings

Simulates tests of machines whose truth is known, writes their readings to a file, has the program evaluate it as a
user would, and counts how often the truth lies in the interval. The truth is computed here, in numpy, not by the
program. Needs numpy.
"""
import argparse
import csv
import dataclasses
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import zlib

import numpy as np

import clause3

DOCUMENT = pathlib.Path(__file__).with_name("coverage.md")
SEED = 230_2
TRAVEL = (50.0, 950.0)  # mm


@dataclasses.dataclass(frozen=True)
class Noise:
    """Standard uncertainties of what is known about the measurement, in µm (scale: µm/m)."""
    reading: float = 0.0
    run: float = 0.0
    target: float = 0.0
    scale: float = 0.0
    uniform: bool = False  # the noise of the readings: uniform, stated as a range (A.9)

    def arguments(self):
        found = []
        for effect in ("run", "target", "scale"):
            if getattr(self, effect) > 0:
                found += ["--distributions", f"{effect}:study | normal 0 {getattr(self, effect)!r}"]
        if self.uniform:
            found += ["--environmental-variation", repr(self.reading * math.sqrt(12))]
        elif self.reading > 0:
            found += ["--distributions", f"reading:study | normal 0 {self.reading!r}"]
        return found


@dataclasses.dataclass(frozen=True)
class Machine:
    """An axis and how it is tested; µm."""
    shape: str = "curved"
    s: float = 0.7          # scatter of a cell, their geometric mean
    unlike: float = 0.0     # standard deviation of ln s from cell to cell
    run: float = 0.0        # own shift from run to run
    targets: int = 11
    runs: int = 5
    directions: tuple = (0, 1)
    missing: float = 0.0    # share of readings


def curve(machine, rng):
    """Long-run means of both directions: 2 × m."""
    place = np.linspace(0, 1, machine.targets)
    if machine.shape == "curved":
        i = 10 * place
        up = 6 * np.sin(0.55 * i) + 0.4 * i
        return np.stack([up, up + 2.5 + 0.6 * np.cos(0.9 * i)])
    if machine.shape == "straight":
        return np.stack([18 * place, 18 * place + 2.5])
    if machine.shape == "flat":
        return np.zeros((2, machine.targets))
    if machine.shape == "rough":
        up = 3 * rng.standard_normal(machine.targets)
        return np.stack([up, up + 2 + 0.3 * rng.standard_normal(machine.targets)])
    assert machine.shape == "any"
    up = machine.s * 6 * rng.standard_normal() * place
    for k in range(1, rng.integers(2, 6)):
        size = machine.s * 10 ** rng.uniform(-0.5, 1) / k
        up = up + size * np.sin(math.pi * k * place * rng.uniform(0.6, 1.4) + rng.uniform(0, 2 * math.pi))
    if rng.random() < 0.5:
        up = up + machine.s * 10 ** rng.uniform(-1, 0.5) * rng.standard_normal(machine.targets)
    reversal = machine.s * (3 * rng.standard_normal() + rng.standard_normal() * (place - 0.5))
    reversal = reversal + machine.s * 10 ** rng.uniform(-1, 0.3) * np.sin(rng.uniform(1, 6) * place + rng.uniform(0, 6))
    return np.stack([up, up + reversal])


@dataclasses.dataclass
class Tests:
    """Simulated tests of one form: what was read, and what is true."""
    noise: Noise
    positions: np.ndarray
    readings: np.ndarray      # test, direction, target, run; NaN is missing
    this_test: np.ndarray     # test, parameter
    this_machine: np.ndarray

    def truth(self, measurand):
        return self.this_test if measurand == "this-test" else self.this_machine


def simulate(machine, noise, tests, rng):
    m, n = machine.targets, machine.runs
    positions = np.linspace(*TRAVEL, m)
    fixed = machine.shape in ("curved", "straight", "flat")
    means = np.stack([curve(machine, rng)] * tests if fixed else [curve(machine, rng) for _ in range(tests)])
    s = machine.s * np.exp(machine.unlike * rng.standard_normal((tests, 2, m)))
    did = means[..., None] + s[..., None] * rng.standard_normal((tests, 2, m, n))
    did += machine.run * rng.standard_normal((tests, 1, 1, n))
    absent = rng.random(did.shape) < machine.missing
    absent[..., 0] = False  # a reading everywhere
    absent[:, [d for d in (0, 1) if d not in machine.directions]] = True
    did[absent] = np.nan
    means = np.where(absent.all(-1), np.nan, means)
    own = rng.uniform(-1, 1, did.shape) * math.sqrt(3) if noise.uniform else rng.standard_normal(did.shape)
    read = did + noise.reading * own + noise.run * rng.standard_normal((tests, 1, 1, n))
    read += noise.target * rng.standard_normal((tests, 1, m, 1))
    read += noise.scale * rng.standard_normal((tests, 1, 1, 1)) * positions[:, None] / 1000
    long_run = clause3.evaluate_cells(means, np.hypot(s, machine.run)) if n > 1 else np.full((tests, 12), np.nan)
    return Tests(noise, positions, read, clause3.evaluate(did), long_run)


def population(tests, rng):
    """Machines and measurements of every kind: the noise is 1 µm, all else is drawn for every test."""
    groups = []
    for _ in range(tests):
        noise = Noise(reading=1.0, run=float(rng.choice([0, 0, 0.5, 1])), target=float(rng.choice([0, 0, 0, 0.5])),
                      scale=float(rng.choice([0, 2])))
        s = math.exp(rng.uniform(math.log(0.5), math.log(4)))
        machine = Machine("any", s, float(rng.choice([0, 0, rng.uniform(0.1, 0.4)])),
                          float(rng.choice([0, 0, s * rng.uniform(0.2, 1)])), int(rng.choice([5, 11, 11, 21])),
                          int(rng.choice([3, 5, 5, 10])), missing=float(rng.choice([0, 0, 0, 0.05])))
        groups.append(simulate(machine, noise, 1, rng))
    return groups


def settings():
    """Name → machine and noise; the population has neither."""
    found = {f"s/u = {r:g}": (Machine(), Noise(0.7 / r)) for r in (0.5, 1, 2, 4)}
    one = Noise(0.7)
    found |= {
        "drift from run to run, measured": (Machine(), Noise(0.7, run=0.7)),
        "drift from run to run, machine's": (Machine(run=0.7), one),
        "drift from run to run, both": (Machine(run=0.5), Noise(0.7, run=0.5)),
        "error of each target": (Machine(), Noise(0.7, target=0.35)),
        "error of scale": (Machine(), Noise(0.7, scale=3.0)),
        "uniform noise": (Machine(), Noise(0.7, uniform=True)),
        "straight axis": (Machine("straight"), one),
        "rough axis": (Machine("rough"), one),
        "cells unlike by 15 %": (Machine(unlike=0.15), one),
        "cells unlike by 30 %": (Machine(unlike=0.3), one),
        "m = 5": (Machine(targets=5), one),
        "m = 21": (Machine(targets=21), one),
        "n = 3": (Machine(runs=3), one),
        "n = 10": (Machine(runs=10), one),
        "one direction": (Machine(directions=(0,)), one),
        "one direction, m = 5": (Machine(targets=5, directions=(0,)), one),
        "missing readings": (Machine(missing=0.05), one),
        "missing readings and drift": (Machine(missing=0.05, run=0.7), Noise(0.7, run=0.7)),
        "n = 1": (Machine(runs=1), one),
        "population": None,
        "flat axis": (Machine("flat"), one),
    }
    return found


def groups_of(name, tests):
    rng = np.random.default_rng([SEED, zlib.crc32(name.encode())])
    chosen = settings()[name]
    return population(tests, rng) if chosen is None else [simulate(*chosen, tests, rng)]


def write_tests(path, groups):
    """One file of many tests, each with its own targets."""
    number = 0
    with open(path, "w", encoding="utf-8") as out:
        out.write("# axis: X\ntest,target_mm,direction,run,deviation_um\n")
        for group in groups:
            for readings in group.readings:
                name = f"t{number}"
                number += 1
                for d, i, j in np.argwhere(~np.isnan(readings)):
                    out.write(f"{name},{group.positions[i]!r},{('up', 'down')[d]},{j + 1},{readings[d, i, j]!r}\n")


def intervals(program, groups, measurand, trials, more=()):
    """Interval of every parameter of every test, as the program finds it: test, parameter, (low, high)."""
    with tempfile.TemporaryDirectory() as folder:
        file, table = pathlib.Path(folder, "tests.csv"), pathlib.Path(folder, "all.csv")
        write_tests(file, groups)
        subprocess.run([program, "evaluate", str(file), "--quiet", "--report", str(table), "--uncertainty",
                        "monte-carlo", "--trials", str(trials), "--seed", "1", "--measurand", measurand,
                        *groups[0].noise.arguments(), *more], check=True)
        rows = []
        with open(table, encoding="utf-8", newline="") as text:
            for row in csv.DictReader(text):
                rows.append([[float(row[f"mc_{end}_{p}"] or "nan") for end in ("low", "high")]
                             for p in clause3.PARAMETERS])
    return np.array(rows)


def coverage_of(program, groups, measurand, trials, more=()):
    """Where the truth lies: tests × parameters of −1 below, 0 inside, 1 above the interval; NaN without."""
    by_noise = {}
    for group in groups:  # a file's tests share what is known about the measurement
        by_noise.setdefault(group.noise, []).append(group)
    found = []
    for alike in by_noise.values():
        truth = np.concatenate([group.truth(measurand) for group in alike])
        ends = intervals(program, alike, measurand, trials, more)
        side = np.where(truth < ends[..., 0], -1.0, np.where(truth > ends[..., 1], 1.0, 0.0))
        side[np.isnan(truth) | np.isnan(ends[..., 0])] = np.nan  # not there, or refused because of an outlier
        found.append(side)
    return np.concatenate(found)


def percentages(side):
    """Tests with the truth inside the interval, in % of those with an interval, of each parameter."""
    return [None if np.isnan(column).all() else 100 * float((column[~np.isnan(column)] == 0).mean())
            for column in side.T]


def naive(groups, rng, trials=400):
    """Adds the noise once more around the readings."""
    found = []
    for group in groups:
        for readings, truth in zip(group.readings, group.this_test):
            drawn = clause3.evaluate(readings + group.noise.reading * rng.standard_normal((trials, *readings.shape)))
            low, high = np.quantile(drawn, [0.025, 0.975], axis=0)
            found.append(np.where(truth < low, -1.0, np.where(truth > high, 1.0, 0.0)))
    return np.array(found)


def annex_a(groups, measurand):
    """The reported value ± U of Annex A with U_EVE = 2 u, n = 5."""
    found = []
    for group in groups:
        value = clause3.evaluate(group.readings)
        U_eve, n = 2 * group.noise.reading, group.readings.shape[-1]
        E, M = U_eve / math.sqrt(n), U_eve / math.sqrt(2 * n)
        A, B = math.hypot(E, 2 * U_eve), 0.9 * U_eve
        U = np.array([A, A, A, E, E, E, M, 2.2 * U_eve, 2 * U_eve, 2 * U_eve, B, B])
        error = group.truth(measurand) - value
        found.append(np.where(error < -U, -1.0, np.where(error > U, 1.0, 0.0)))
    return np.concatenate(found)


def row(name, shown):
    return "| " + " | ".join([name, *("–" if p is None else f"{p:.1f}" for p in shown)]) + " |"


def header(first):
    names = [first, *(clause3.SYMBOLS[p] for p in clause3.PARAMETERS)]
    return "| " + " | ".join(names) + " |\n" + "|---" * len(names) + "|"


class Table:
    """Printed row by row, since a row may take a minute; then put into the document where asked for."""

    def __init__(self, name, first):
        self.name = name
        self.lines = [header(first)]
        print(f"\n{name}\n\n{self.lines[0]}", flush=True)

    def add(self, line):
        self.lines.append(line)
        print(line, flush=True)

    def write(self):
        marks = rf"(<!-- results: {self.name} -->\n).*?(<!-- end -->)"
        body = "\n".join(self.lines) + "\n"
        text, count = re.subn(marks, lambda m: m.group(1) + body + m.group(2), DOCUMENT.read_text(encoding="utf-8"),
                              flags=re.S)
        assert count == 1, self.name
        DOCUMENT.write_text(text, encoding="utf-8")


def compare_methods(options):
    for measurand in options.measurand:
        table = Table(f"methods {measurand}", "method")
        for ratio in (0.5, 1, 2, 4):
            groups = groups_of(f"s/u = {ratio:g}", options.tests)
            methods = {"Annex A": lambda: annex_a(groups, measurand)}
            if measurand == "this-test":
                methods["noise added again"] = lambda: naive(groups, np.random.default_rng(SEED))
            else:
                for key in ("t-scaled", "resampled"):
                    methods[key] = lambda key=key: coverage_of(options.program, groups, measurand, options.trials,
                                                               ["--type-a", key])
            methods["this program"] = lambda: coverage_of(options.program, groups, measurand, options.trials)
            for name, method in methods.items():
                table.add(row(f"{name}, s/u = {ratio:g}", percentages(method())))
        if options.write:
            table.write()


def study(options):
    names = options.setting or [name for name in settings() if name != "population"]
    faults = 0
    for measurand in options.measurand:
        table = Table(f"population {measurand}" if names == ["population"] else measurand, "setting")
        for name in names:
            groups = groups_of(name, options.tests)
            if measurand == "this-machine" and groups[0].readings.shape[-1] == 1:
                continue  # the scatter of a machine cannot be known from one approach
            shown = percentages(coverage_of(options.program, groups, measurand, options.trials))
            table.add(row(name, shown))
            known = [p for p in shown if p is not None]
            allowed = 100 * (options.within + 4 * math.sqrt(0.95 * 0.05 / options.tests))
            faults += any(95 - p > allowed for p in known)  # the envelope of several hypotheses may hold more
        if options.write:
            table.write()
    return 1 if options.check and faults else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--setting", action="append", choices=list(settings()), metavar="NAME")
    parser.add_argument("--measurand", action="append", choices=("this-test", "this-machine"))
    parser.add_argument("--tests", type=int, default=10_000)
    parser.add_argument("--trials", type=int, default=2000)
    parser.add_argument("--within", type=float, default=0.015)
    parser.add_argument("--methods", action="store_true")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--write", action="store_true")
    parser.add_argument("--list", action="store_true")
    options = parser.parse_args()
    options.measurand = options.measurand or ["this-test", "this-machine"]
    if options.list:
        print("\n".join(settings()))
        return 0
    if options.methods:
        compare_methods(options)
        return 0
    return study(options)


if __name__ == "__main__":
    sys.exit(main())
