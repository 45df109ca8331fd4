#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""The tables and the figure of coefficients.md: Annex A's simple coefficients against simulated tests.

Usage: docs/studies/coefficients.py            prints the tables
       docs/studies/coefficients.py --check    exits 1 where the document departs from them by more than chance
       docs/studies/coefficients.py --write    puts tables and figure into the document

Needs numpy. Everything follows from one seed.
"""
import math
import pathlib
import re
import sys

import numpy as np

import clause3

SEED = 230_2
TARGETS, RUNS = 11, 5
BATCHES, TESTS = 20, 2000  # standard errors come from the scatter of the batches
RATIOS = (0.1, 0.25, 0.5, 1.0, 1.5, 2.0, 4.0)  # u/s
DOCUMENT = pathlib.Path(__file__).with_name("coefficients.md")
FIGURE = pathlib.Path(__file__).with_name("coefficients.svg")
COLUMN = {name: k for k, name in enumerate(clause3.PARAMETERS)}
FIRST = ("A", "E", "M", "R", "R_up", "B")


class Figure:
    """A number and its standard error."""

    def __init__(self, batches, axis=0):
        batches = np.asarray(batches, float)
        self.value = batches.mean(axis)
        self.error = batches.std(axis, ddof=1) / math.sqrt(batches.shape[axis])


def shape_of_axis(name):
    """Long-run means, direction × target; the reversal error and the curve are in units of s."""
    i = np.arange(TARGETS)
    up = 6 * np.sin(0.55 * i) + 0.4 * i if name == "curved" else np.zeros(TARGETS)
    down = up + {"flat": 0.0, "reversal": 2.5, "curved": 2.5 + 0.6 * np.cos(0.9 * i)}[name]
    return np.stack([up, down])


def share_tables():
    """Errors of every parameter, per shape and u/s, in units of U_EVE: 95 % quantile of their size, and mean."""
    quantiles, biases, single = {}, {}, {}
    rng = np.random.default_rng([SEED, 1])
    for _ in range(BATCHES):
        machine = rng.standard_normal((TESTS, 2, TARGETS, RUNS))
        noise = rng.standard_normal(machine.shape)
        for shape in ("flat", "reversal", "curved"):
            true_readings = shape_of_axis(shape)[None, :, :, None] + machine
            truth = clause3.evaluate(true_readings)
            for ratio in RATIOS:
                error = (clause3.evaluate(true_readings + ratio * noise) - truth) / (2 * ratio)
                quantiles.setdefault((shape, ratio), []).append(np.quantile(np.abs(error), 0.95, axis=0))
                biases.setdefault((shape, ratio), []).append(error.mean(axis=0))
        for ratio in RATIOS:  # at every position for itself
            s = [clause3.cell_statistics(x)[1] for x in (machine, machine + ratio * noise)]
            error = 4 * (s[1] - s[0]) / (2 * ratio)
            single.setdefault(ratio, []).append(np.quantile(np.abs(error), 0.95))
    return [{key: Figure(value) for key, value in table.items()} for table in (quantiles, biases, single)]


def perfect_machine():
    """s = 0: all that is seen is noise. Units of U_EVE."""
    rng = np.random.default_rng([SEED, 2])
    quantiles = []
    for _ in range(BATCHES):
        error = clause3.evaluate(rng.standard_normal((TESTS, 2, TARGETS, RUNS))) / 2
        quantiles.append(np.quantile(error, 0.95, axis=0))
    return Figure(quantiles)


def many_runs():
    """The limit u << s for other numbers of runs, at one position, from the definition: 95 % and twice the standard
    deviation."""
    rng = np.random.default_rng([SEED, 3])
    found = {}
    small = 1e-4
    for runs in (2, 3, 5, 10):
        batches = []
        for _ in range(BATCHES):
            machine = rng.standard_normal((20 * TESTS, runs))
            noise = rng.standard_normal(machine.shape)
            error = 4 * ((machine + small * noise).std(-1, ddof=1) - machine.std(-1, ddof=1)) / (2 * small)
            batches.append([2 * error.std(), np.quantile(np.abs(error), 0.95)])
        found[runs] = Figure(batches)
    return found


def long_run_bias():
    rng = np.random.default_rng([SEED, 4])
    batches = []
    for _ in range(BATCHES):
        values = clause3.evaluate(rng.standard_normal((5 * TESTS, 2, TARGETS, RUNS)))
        batches.append([values.mean(axis=0), values.std(axis=0)])
    return Figure(batches)


def linear_drift():
    """Readings of a machine without errors while the environment drifts by E_VE, evenly, from the first to the last
    reading of the standard test cycle (all targets up, all targets down, n times). No randomness. Units of U_EVE."""
    time = np.arange(2 * TARGETS * RUNS).reshape(RUNS, 2, TARGETS)
    readings = np.stack([time[:, 0, :].T, time[:, 1, ::-1].T])
    share_of_range = readings / (2 * TARGETS * RUNS - 1)
    return clause3.evaluate(share_of_range[None])[0] / 0.6  # A.9


def noise_added_again():
    """How often a reported value lies inside the 95 % interval that comes out when the noise is added once more."""
    rng = np.random.default_rng([SEED, 5])
    found = {}
    per_batch, trials = 40, 400
    for shape in ("flat", "curved"):
        batches = []
        for _ in range(BATCHES):
            inside = np.zeros(len(clause3.PARAMETERS))
            for _ in range(per_batch):
                readings = shape_of_axis(shape)[:, :, None] + rng.standard_normal((2, TARGETS, RUNS))
                reported = clause3.evaluate(readings[None])[0]
                drawn = clause3.evaluate(readings[None] + rng.standard_normal((trials, *readings.shape)))
                low, high = np.quantile(drawn, [0.025, 0.975], axis=0)
                inside += (low <= reported) & (reported <= high)
            batches.append(100 * inside / per_batch)
        found[shape] = Figure(batches)
    return found


def cell(value, error=None, digits=2):
    return f"{value:.{digits}f}" + ("" if error is None else f" ± {error:.{digits + 1}f}")


def table(header, rows):
    lines = ["| " + " | ".join(header) + " |", "|" + "---|" * len(header)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows])


def cells_of(figure, names, digits=2):
    return [cell(figure.value[COLUMN[p]], figure.error[COLUMN[p]], digits) for p in names]


def symbols(names):
    return [clause3.SYMBOLS[p] for p in names]


def all_tables(results):
    quantiles, biases, single, perfect = results
    annex = [cell(x) for x in (math.sqrt(4 + 1 / RUNS), 1 / math.sqrt(RUNS), 1 / math.sqrt(2 * RUNS), 2.2, 2.0, 0.9)]
    limits = [cell(x) for x in (2 * math.sqrt(0.6), math.sqrt(2 / RUNS), 1 / math.sqrt(RUNS), 2 * math.sqrt(0.6), 2.0,
                                math.sqrt(2 / RUNS))]
    tables = {"limits": table(["", *symbols(FIRST)], [["Annex A", *annex], ["exact for u ≪ s, k = 2", *limits]])}
    for shape in ("flat", "reversal", "curved"):
        rows = [[f"{r:g}", *cells_of(quantiles[shape, r], FIRST)] for r in RATIOS]
        if shape == "flat":
            rows.append(["∞", *cells_of(perfect, FIRST)])
        tables[shape] = table(["u/s", *symbols(FIRST)], rows)
    tables["single"] = table(["u/s", "R_i↑"], [[f"{r:g}", cell(single[r].value, single[r].error)] for r in RATIOS])
    tables["bias"] = table(["u/s", *symbols(FIRST)],
                           [[f"{r:g}", *cells_of(biases["flat", r], FIRST)] for r in RATIOS])
    tables["runs"] = table(["n", "4/√(n − 1)", "2 × standard deviation", "95 % quantile"],
                           [[str(n), cell(4 / math.sqrt(n - 1)), *(cell(*pair) for pair in zip(f.value, f.error))]
                            for n, f in many_runs().items()])
    drift = linear_drift()
    tables["drift"] = table(symbols(clause3.PARAMETERS), [[cell(x) for x in drift]])
    extremes = long_run_bias()
    names = ("A", "A_up", "E", "E_up", "M", "R", "R_up", "B")
    true_values = {"A": 4, "A_up": 4, "R": 4, "R_up": 4}
    tables["extremes"] = table(
        ["parameter", "long run", "mean of tests", "standard deviation of tests"],
        [[clause3.SYMBOLS[p], str(true_values.get(p, 0)),
          *(cell(extremes.value[k, COLUMN[p]], extremes.error[k, COLUMN[p]]) for k in (0, 1))] for p in names])
    twice = noise_added_again()
    tables["twice"] = table(["axis", *(f"{x}, %" for x in symbols(FIRST))],
                            [[shape, *cells_of(twice[shape], FIRST, 0)] for shape in twice])
    return tables


COLOURS = {"R_i↑ at one position": "#7a7a7a", "R↑": "#b4232a", "R": "#1d5fa8", "A": "#2f7d32", "B": "#8a4fae",
           "E": "#c47a00"}


def figure(results):
    """Coefficients over u/s on a logarithmic scale; dashed: Annex A."""
    quantiles, _, single, _ = results
    width, height, left, right, top, bottom = 720, 440, 64, 150, 24, 56
    most = 4.0

    def x_of(ratio):
        part = math.log(ratio / RATIOS[0]) / math.log(RATIOS[-1] / RATIOS[0])
        return left + part * (width - left - right)

    def y_of(value):
        return height - bottom - value / most * (height - top - bottom)

    curves = {"R_i↑ at one position": [single[r].value for r in RATIOS]}
    for p in ("R_up", "R", "A", "B", "E"):
        curves[clause3.SYMBOLS[p]] = [quantiles["reversal", r].value[COLUMN[p]] for r in RATIOS]
    out = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
           'font-size="13">', f'<rect width="{width}" height="{height}" fill="white"/>']
    for k in range(0, 9):
        y = y_of(k / 2)
        out.append(f'<line x1="{left}" x2="{width - right}" y1="{y:.1f}" y2="{y:.1f}" stroke="#dddddd"/>')
        out.append(f'<text x="{left - 8}" y="{y + 4:.1f}" text-anchor="end">{k / 2:g}</text>')
    for ratio in RATIOS:
        out.append(f'<line x1="{x_of(ratio):.1f}" x2="{x_of(ratio):.1f}" y1="{top}" y2="{height - bottom}" '
                   'stroke="#eeeeee"/>')
        out.append(f'<text x="{x_of(ratio):.1f}" y="{height - bottom + 18}" text-anchor="middle">{ratio:g}</text>')
    annex = {"R↑": 2.0, "R": 2.2, "B": 0.9, "E": 1 / math.sqrt(RUNS)}
    for name, values in curves.items():
        points = " ".join(f"{x_of(r):.1f},{y_of(v):.1f}" for r, v in zip(RATIOS, values))
        out.append(f'<polyline points="{points}" fill="none" stroke="{COLOURS[name]}" stroke-width="2"/>')
        if name in annex:
            y = y_of(annex[name])
            out.append(f'<line x1="{left}" x2="{width - right}" y1="{y:.1f}" y2="{y:.1f}" stroke="{COLOURS[name]}" '
                       'stroke-dasharray="5 4"/>')
            out.append(f'<text x="{left + 6}" y="{y - 4:.1f}" font-size="11" fill="{COLOURS[name]}">Annex A, {name}: '
                       f'{annex[name]:.2g}</text>')
    labels = sorted(((y_of(values[-1]), name) for name, values in curves.items()))
    lowest = -math.inf
    for y, name in labels:  # pushed apart where they would overlap
        lowest = max(y, lowest + 16)
        out.append(f'<text x="{width - right + 8}" y="{lowest + 4:.1f}" fill="{COLOURS[name]}">{name}</text>')
    out.append(f'<text x="{(left + width - right) / 2}" y="{height - 12}" text-anchor="middle">noise of the '
               'environment over scatter of the machine, u/s</text>')
    out.append(f'<text x="18" y="{(top + height - bottom) / 2}" text-anchor="middle" transform="rotate(-90 18 '
               f'{(top + height - bottom) / 2})">95 % of errors, in U_EVE</text>')
    return "\n".join(out + ["</svg>"]) + "\n"


NUMBER = re.compile(r"(-?\d+(?:\.(\d+))?)(?: ± (\d+\.\d+))?")


def departures(text, fresh):
    """Places where the document's numbers are more than chance away from fresh ones."""
    for name, wanted in fresh.items():
        block = re.search(rf"<!-- table: {name} -->\n(.*?)\n<!-- end -->", text, re.S)
        if block is None:
            yield f"{DOCUMENT.name}: found no table {name}"
            continue
        found = block.group(1)
        numbers, expected = NUMBER.findall(found), NUMBER.findall(wanted)
        if NUMBER.sub("#", found) != NUMBER.sub("#", wanted):
            yield f"{DOCUMENT.name}: table {name} is laid out otherwise"
            continue
        for (value, digits, error), (other, _, other_error) in zip(numbers, expected):
            # The errors are themselves known to 16 %; five of them, and the rounding of both.
            allowed = 5 * math.hypot(float(error or 0), float(other_error or 0)) + 1.001 * 10.0 ** -len(digits)
            if abs(float(value) - float(other)) > allowed:
                yield f"{DOCUMENT.name}: table {name}: found {value}, expected {other} ± {allowed:.3f}"


def main(arguments):
    results = (*share_tables(), perfect_machine())
    tables = all_tables(results)
    if arguments == ["--check"]:
        faults = list(departures(DOCUMENT.read_text(encoding="utf-8"), tables))
        print("\n".join(faults) or f"{len(tables)} tables agree")
        return 1 if faults else 0
    if arguments == ["--write"]:
        text = DOCUMENT.read_text(encoding="utf-8")
        for name, body in tables.items():
            text = re.sub(rf"(<!-- table: {name} -->\n).*?(<!-- end -->)", lambda m: m.group(1) + body + "\n" + m.group(2),
                          text, flags=re.S)
        DOCUMENT.write_text(text, encoding="utf-8")
        FIGURE.write_text(figure(results), encoding="utf-8")
        return 0
    if arguments:
        print(__doc__)
        return 2
    for name, body in tables.items():
        print(f"{name}\n\n{body}\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
