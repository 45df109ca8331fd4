#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Machines whose errors differ by direction, put together by the program from single measurements, and by this script.

Usage: tests/singles_directions_oracle.py PROGRAM [COUNT] [SEED]

Random machines (chains, tools, functional points, places) have errors of both directions, of which some are measured in one
direction alone, over less of the travel, at fewer positions, or not at all, in runs that scatter, with instruments of stated
uncertainty. Axes that stand still came to rest in a direction that is stated or not. Squareness is a number, or the JSON of
`axiometry squareness` whose lines were read in both directions or in one. From the readings alone singles_model.py
makes the model; coefficients, covariance and what nothing tells, the error of the tool point with its covariance at places,
and tests of positions by direction must be those of `axiometry volumetric assemble`, `field --at` and `predict`. Where all was
measured, the model must have the field of the true machine in every combination of directions, but for one motion of the whole.
"""
import itertools
import json
import subprocess
import sys
import tempfile

import numpy as np
import scipy.stats

from singles_model import LOWER, NAMES, SQUARES, UPPER, Model, axis_of, displaced, measured_place, motion_of, slope_within

CHAINS = ["FXYZ", "XFYZ", "YXFZ", "ZYXF", "ZXFY", "FZXY", "YFZX"]
ARCSEC = np.pi / 180.0 / 3600.0 * 1e6


# --- the true machine


def true_field(machine, q, tool, directions):
    e = [np.array([np.interp(q[a], machine["nodes"][a], machine["means"][a][m] + directions[a] * machine["halves"][a][m])
                   for m in range(6)]) for a in range(3)]
    return displaced(e, machine["square"], machine, q, tool)


def true_reading(machine, name, at, direction):
    a, m = axis_of(name), motion_of(name)
    directions = machine["approached"][a].copy()
    directions[a] = direction
    if m < 3:
        return true_field(machine, measured_place(machine, a, at), machine["stand_tool"][a], directions)[m]
    return np.interp(at, machine["nodes"][a], machine["means"][a][m] + direction * machine["halves"][a][m])


def random_machine(rng, chain):
    nodes = [np.linspace(LOWER[a], UPPER[a], int(rng.integers(5, 9))) for a in range(3)]
    return {"chain": chain, "nodes": nodes, "tools": {"T1": rng.uniform(-150, 150, 3), "T2": rng.uniform(-150, 150, 3)},
            "functional": rng.uniform(-200, 400, (3, 3)), "stood": [rng.uniform(LOWER, UPPER) for _ in range(3)],
            "stand_tool": [str(rng.choice(["T1", "T2"])) for _ in range(3)], "square": rng.normal(0, 30, 3),
            "approached": [rng.choice([-1.0, 1.0], 3) for _ in range(3)],
            "means": [rng.normal(0, 10, (6, len(n))) for n in nodes], "halves": [rng.normal(0, 3, (6, len(n))) for n in nodes]}


# --- measuring


def measured(machine, rng, name, directions, positions, runs, noise):
    """Readings [run][direction][position], and the text of their file. The instrument has its own zero and, of straightness,
    its own slope; some positions, and some directions, scatter more."""
    zero, askew = rng.normal(0, 50), 0.02 if motion_of(name) < 3 and name[1] != name[2] else 0.0
    wide = {d: np.where(rng.uniform(size=len(positions)) < 0.1, 20.0, rng.choice([1.0, 1.0, 5.0])) for d in directions}
    table = {d: np.array([[true_reading(machine, name, at, d) + zero + askew * at + rng.normal(0, noise * more)
                           for at, more in zip(positions, wide[d])] for _ in range(runs)]) for d in directions}
    positioning = name[1] == name[2]
    text = (f"# axis.name: {name[2]}\ntarget_mm,run,direction,deviation_um\n" if positioning else
            f"# error: {name}\nposition_mm,run,direction,{name}_{'um' if motion_of(name) < 3 else 'urad'}\n")
    for run in range(runs):
        for d in directions:
            text += "".join(f"{at!r},{run + 1},{'up' if d > 0 else 'down'},{float(y)!r}\n"
                            for at, y in zip(map(float, positions), table[d][run]))
    return table, text


def alike(squares, runs):
    """How many of the smallest s² belong together, and the mean of these: of the largest one after the other, up to half, those
    that the last one which F tells apart from all smaller ones leads."""
    ascending, count = np.sort(squares), len(squares)
    for left in range(count - 1, (count + 1) // 2 - 1, -1):
        f = ascending[left] / ascending[:left].mean()
        if scipy.stats.f.sf(f, runs - 1, left * (runs - 1)) < 0.003 / (left + 1):
            count = left
    return count, ascending[:count].mean()


def scattered(table, runs):
    """Variances of the means: s of those that scatter alike with Student's t, of both directions unless F tells these apart; of
    one that F says is unlike the others its own, without Student's t where it may be one of them."""
    own = {d: readings.var(axis=0, ddof=1) for d, readings in table.items()}

    def widened(square, degrees):
        return square * (scipy.stats.t.ppf(scipy.stats.norm.cdf(2.0), degrees) / 2.0) ** 2

    def of_means(squares, together):
        count, mean = alike(together, runs)
        largest = np.sort(together)[count - 1]
        of_all = widened(mean, count * (runs - 1))

        def one(square):
            if square > largest:
                return max(of_all, widened(square, runs - 1))
            others = (mean * count - square) / (count - 1)
            doubtful = square > mean and scipy.stats.f.sf(square / others, runs - 1, (count - 1) * (runs - 1)) < 0.01
            return max(of_all, square) if doubtful else of_all
        return np.array([one(square) for square in squares]) / runs

    everything = np.concatenate(list(own.values()))
    if everything.max() < 1e-18:  # no scatter at all but of floating point
        return {d: np.zeros_like(squares) for d, squares in own.items()}
    if len(own) == 2:
        (n1, s1), (n2, s2) = (alike(squares, runs) for squares in own.values())
        below = scipy.stats.f.cdf(s1 / s2, n1 * (runs - 1), n2 * (runs - 1))
        if min(below, 1.0 - below) < 0.005:
            return {d: of_means(squares, squares) for d, squares in own.items()}
    return {d: of_means(squares, everything) for d, squares in own.items()}


def reduced(table, positions, instrument):
    """Means, halves and their covariance, of readings of one direction or both."""
    runs, n = next(iter(table.values())).shape
    common = np.diag((0.5 * (instrument[0] + instrument[1] * (positions - positions[0]) / 1000)) ** 2)
    up, down = table.get(1.0), table.get(-1.0)

    variances = scattered(table, runs) if runs > 1 else {d: np.zeros(n) for d in table}

    def of(readings, direction):
        return readings.mean(axis=0), np.diag(variances[direction])

    if up is None or down is None:
        mean, variance = of(up, 1.0) if down is None else of(down, -1.0)
        return {"at": positions, "means": mean, "halves": None, "covariance": variance + common}
    (mean_up, var_up), (mean_down, var_down) = of(up, 1.0), of(down, -1.0)
    scatter = 0.25 * (var_up + var_down)
    of_half = scatter if runs > 1 else 0.5 * common  # of one run as of readings that have nothing in common
    cross = 0.25 * (var_up - var_down)
    return {"at": positions, "means": 0.5 * (mean_up + mean_down), "halves": 0.5 * (mean_up - mean_down),
            "covariance": np.block([[scatter + common, cross], [cross, of_half]])}


def run(program, *arguments):
    done = subprocess.run([program, *arguments], capture_output=True, text=True, timeout=120)
    if done.returncode not in (0, 3):  # 3: something is not told
        sys.exit(f"{' '.join(arguments)}: {done.returncode}: {done.stderr}")
    return done.stdout


def square_result(program, machine, rng, name, folder, noise):
    """The lines of a squareness, each with a zero of its own along one straightedge; the file of the result."""
    lines, files, error = {}, [], float(rng.normal(0, 2))
    for line in rng.permutation(SQUARES[name][:2]):
        a, kind = axis_of(line), int(rng.integers(3))
        directions = [[1.0, -1.0], [1.0], [-1.0]][kind]
        at = machine["nodes"][a]
        table = {d: np.array([[true_reading(machine, line, x, d) + rng.normal(0, noise) for x in at] for _ in range(3)])
                 for d in directions}
        if line == SQUARES[name][0]:  # the square has more than 90°
            table = {d: y + error * ARCSEC * 1e-3 * at for d, y in table.items()}
        sign = rng.choice([-1, 1])
        file = f"{folder}/line-{line}.csv"
        with open(file, "w", encoding="utf-8") as out:
            out.write(f"# error: {line}\n# positive: {'+' if sign > 0 else '-'}{line[1]}\nposition_mm,run,direction,{line}_um\n")
            for k in range(3):
                for d in directions:
                    out.writelines(f"{float(x)!r},{k + 1},{'up' if d > 0 else 'down'},{float(sign * y)!r}\n"
                                   for x, y in zip(at, table[d][k]))
        files.append(file)
        lines[line] = {"at": at, "direction": 0.0 if kind == 0 else directions[0],
                       "mean": sum(y.mean(axis=0) for y in table.values()) / len(directions)}
    reference = str(rng.choice(["least-squares", "end-points"]))
    out = f"{folder}/{name}.json"
    run(program, "squareness", *files, "--square-error", repr(error), "--square-uncertainty", "0.3", "--instrument", "0.4,0.5",
        "--reference", reference, "--json", out, "-q")
    return out, lines, reference, error


def square_measurement(file, name, lines, reference, error, ranges):
    """From the lines to what was measured over the common ranges, with what the result says of its uncertainty."""
    with open(file, encoding="utf-8") as source:
        estimate = json.load(source)["location_error"]["urad"]
    value = (-1.0 if name == "B0Z" else 1.0) * error * ARCSEC
    scatter, instrument = 1.0, 1.0
    for line, read in lines.items():
        at = read["at"]
        value += SQUARES[name][2] * slope_within(at, read["mean"], *ranges[axis_of(line)])
        w = np.array([1e-3 * slope_within(at, one, *ranges[axis_of(line)]) for one in np.eye(len(at))])
        x = at - at.mean()
        as_measured = x / (x @ x) if reference == "least-squares" else np.eye(len(at))[-1] - np.eye(len(at))[0]
        as_measured = as_measured if reference == "least-squares" else as_measured / (at[-1] - at[0])
        scatter = max(scatter, np.linalg.norm(w) / np.linalg.norm(as_measured))
        instrument = max(instrument, np.abs(w).sum() / np.abs(as_measured).sum())
    few = max(1.0, estimate["k"] / 2)
    u = few * np.linalg.norm([scatter * estimate["u_scatter"], instrument * estimate["u_instrument"], ARCSEC * 0.3 / 2])
    return {"value": value, "u": u, "lines": {n: r["direction"] for n, r in lines.items()}}


def true_square(machine, name):
    """As a number: between the mean lines of both directions over the travel."""
    return SQUARES[name][2] * sum(
        slope_within(q := machine["nodes"][axis_of(line)], [sum(true_reading(machine, line, x, d) for d in (1.0, -1.0)) / 2
                                                            for x in q], q[0], q[-1]) for line in SQUARES[name][:2])


# --- against the program


def written_machine(machine, folder):
    file = folder + "/machine.json"
    with open(file, "w", encoding="utf-8") as out:
        json.dump({"chain": machine["chain"], "travel_mm": {a: [LOWER[k], UPPER[k]] for k, a in enumerate("XYZ")},
                   "tools_mm": {n: list(t) for n, t in machine["tools"].items()},
                   "functional_point_mm": {a: list(machine["functional"][k]) for k, a in enumerate("XYZ")}}, out)
    return file


def stand(machine, a, stated):
    words = {1.0: ":up", -1.0: ":down", 0.0: ""}
    places = ",".join(f"{float(x)!r}{words[stated[a][b]]}" for b, x in enumerate(machine["stood"][a]))
    return f"--at={'XYZ'[a]}={places}@{machine['stand_tool'][a]}"


def assembled(program, machine, rng, folder, whole):
    """The program's result and this script's model. `whole`: all errors in both directions over the whole travel, no noise."""
    noise = 0.0 if whole else 0.3
    stated = np.array([[0.0 if a == b or (not whole and rng.random() < 0.5) else machine["approached"][a][b] for b in range(3)]
                       for a in range(3)])
    read, items, instruments = {}, [], []
    for name in NAMES:
        if not whole and rng.random() < 0.12:
            continue
        own = machine["nodes"][axis_of(name)]
        positions, directions, runs = own, [1.0, -1.0], 2
        if not whole:
            shape = rng.integers(6)
            if shape == 0:
                positions = np.linspace(own[0], own[-1], len(own) + int(rng.integers(0, 4)))
            if shape == 1:
                positions = own[(0 if rng.random() < 0.5 else 1):(len(own) if rng.random() < 0.5 else -1)]
            directions = [[1.0, -1.0], [1.0], [-1.0]][int(rng.choice(3, p=[0.8, 0.1, 0.1]))]
            runs = int(rng.choice([1, 2, 3], p=[0.1, 0.4, 0.5]))
        instrument = (float(rng.uniform(0.2, 1.0)), float(rng.uniform(0.0, 1.0)))
        table, text = measured(machine, rng, name, directions, positions, runs, noise)
        read[name] = reduced(table, positions, instrument)
        with open(f"{folder}/{name}.csv", "w", encoding="utf-8") as out:
            out.write(text)
        items.append(f"{name}={folder}/{name}.csv")
        instruments.append(f"--instrument={name}={instrument[0]!r},{instrument[1]!r}")
    ranges = Model(machine, read, {}, stated).ranges
    squares = {}
    for name in SQUARES:
        if not whole and rng.random() < 0.15:
            continue
        if rng.random() < 0.4:
            squares[name] = {"value": true_square(machine, name), "u": 0.6, "lines": None}
            items.append(f"{name}={float(squares[name]['value'])!r},1.2")
        else:
            result = square_result(program, machine, rng, name, folder, noise)
            squares[name] = square_measurement(result[0], name, *result[1:], ranges)
            items.append(f"{name}={result[0]}")
    keeps = whole or rng.random() < 0.8
    run(program, "volumetric", "assemble", *items, "--machine", written_machine(machine, folder), *instruments,
        *[stand(machine, a, stated) for a in range(3)], *([] if keeps else ["--reversal", "none"]), "--out",
        folder + "/result.json", "-q")
    with open(folder + "/result.json", encoding="utf-8") as source:
        result = json.load(source)
    return result["model"], Model(machine, read, squares, stated, keeps)


def projector(directions, size):
    if not len(directions):
        return np.zeros((size, size))
    u, s, _ = np.linalg.svd(np.array(directions).T, full_matrices=False)
    u = u[:, s > 1e-9]
    return u @ u.T


def close(got, expected, scale, what):
    apart = np.abs(np.asarray(got) - expected).max() if np.size(expected) else 0.0
    assert apart <= 1e-9 * scale, (what, apart, scale)


def compare_model(model, mine):
    """Every coefficient, every covariance, and what nothing tells."""
    for a, axis in enumerate("XYZ"):
        curve = model["curves"][axis]
        assert curve["kind"] == "nodes" and curve["size"] + 1 == len(mine.nodes[a]), (axis, curve)
        close(curve["range_mm"], np.array(mine.ranges[a]), 1e3, "range")
    assert model["reversal"] == ("curves" if mine.keeps else "none")
    covariance = np.zeros((mine.size, mine.size))
    covariance[np.tril_indices(mine.size)] = model["covariance"]
    covariance += np.tril(covariance, -1).T
    told = np.eye(mine.size) - projector(mine.untold, mine.size)
    close(projector(model["unseen"], mine.size), np.eye(mine.size) - told, 10.0, "untold")
    # A share in what nothing tells is no number, whatever stands there.
    close(told @ np.array(model["coefficients"]), told @ mine.values, 1e3, "coefficients")
    close(told @ covariance @ told, told @ mine.covariance @ told, 1e4, "covariance")


def compare_field(program, machine, mine, rng, folder):
    places = [(str(rng.choice(["T1", "T2"])), np.array([rng.uniform(*mine.ranges[a]) for a in range(3)])) for _ in range(12)]
    with open(folder + "/points.csv", "w", encoding="utf-8") as out:
        out.write("tool,x_mm,y_mm,z_mm\n" + "".join(f"{t},{','.join(repr(float(x)) for x in q)}\n" for t, q in places))
    answer = json.loads(run(program, "volumetric", "field", folder + "/result.json", "--at", folder + "/points.csv", "--json",
                            "-"))
    numbers = 0
    middle = np.array([sum(r) / 2 for r in mine.ranges])
    for (tool, q), point in zip(places, answer["points"], strict=True):
        rows, beside = mine.rows(q, tool), mine.rows(middle, tool)
        given = np.array([x is not None for x in point["error_um"]])
        expected = [mine.is_told(row) or mine.is_told(row, off) for row, off in zip(rows, beside)]
        assert list(given) == expected, (tool, q, given, expected)
        numbers += given.sum()
        if not given.any():
            continue
        close(np.array(point["error_um"], dtype=object)[given].astype(float), (rows @ mine.values)[given], 1e3, "field")
        covariance = np.array(point["covariance_um2"], dtype=object).reshape(3, 3)[np.ix_(given, given)].astype(float)
        close(covariance, (rows @ mine.covariance @ rows.T)[np.ix_(given, given)], 1e4, "covariance of the field")
    return numbers


def compare_tests(program, machine, mine, folder):
    """Positions of each axis through where it was measured, in each direction, less the mean of all."""
    compared = 0
    for a, axis in enumerate("XYZ"):
        place = machine["stood"][a]
        if any(not mine.ranges[b][0] <= place[b] <= mine.ranges[b][1] for b in range(3) if b != a):
            continue
        at = ",".join(f"{'xyz'[b]}={float(place[b])!r}" for b in range(3) if b != a)
        targets = np.linspace(*mine.ranges[a], 11)
        rows = {d: np.array([mine.rows(measured_place(machine, a, x), machine["stand_tool"][a],
                                       [d if b == a else 0 for b in range(3)])[a] for x in targets]) for d in (1, -1, 0)}
        of_means = rows[0] - rows[0].mean(axis=0)
        if not all(mine.is_told(row) for row in of_means):
            continue
        predicted = json.loads(run(program, "volumetric", "predict", folder + "/result.json", "--axis", axis, "--at", at,
                                   "--tool", machine["stand_tool"][a], "--json", "-", "-q"))["prediction"]
        both = np.concatenate([rows[1], rows[-1]])
        is_directed = mine.keeps and all(mine.is_told(row) for row in both - both.mean(axis=0))
        assert (predicted["reversal_um"] is not None) == is_directed, (axis, predicted["reversal_um"], is_directed)
        expected = both - both.mean(axis=0) if is_directed else np.concatenate([of_means, of_means])
        got = np.array([[t["up_um"], t["up_u_um"]] for t in predicted["targets"]] +
                       [[t["down_um"], t["down_u_um"]] for t in predicted["targets"]], dtype=float)
        close(got[:, 0], expected @ mine.values, 1e3, "predicted")
        close(got[:, 1] ** 2, np.sum((expected @ mine.covariance) * expected, axis=1), 1e4, "u of predicted")
        compared += is_directed
    return compared


def compare_truth(machine, mine, rng):
    """One motion of the whole, and a place of each tool, is left over, whatever the directions are."""
    rows, left = [], []
    for directions in itertools.product((1, -1), repeat=3):
        for k, tool in itertools.product(range(6), ("T1", "T2")):
            q = rng.uniform(LOWER, UPPER)
            left.append(mine.rows(q, tool, directions) @ mine.values - true_field(machine, q, tool, directions))
            turn = np.array([[0, q[2], -q[1]], [-q[2], 0, q[0]], [q[1], -q[0], 0]])
            rows.append(np.c_[turn, np.eye(3) * (tool == "T1"), np.eye(3) * (tool == "T2")])
    rows, left = np.concatenate(rows), np.concatenate(left)
    rest = left - rows @ np.linalg.lstsq(rows, left, rcond=None)[0]
    assert np.abs(rest).max() < 1e-6, (machine["chain"], "truth", np.abs(rest).max())


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 2 * len(CHAINS)
    seed = int(sys.argv[3]) if len(sys.argv) > 3 else 20261126
    numbers = tests = 0
    for k in range(count):
        rng = np.random.default_rng([seed, k])
        machine = random_machine(rng, CHAINS[k % len(CHAINS)])
        whole = k < len(CHAINS)
        with tempfile.TemporaryDirectory() as folder:
            model, mine = assembled(program, machine, rng, folder, whole)
            try:
                compare_model(model, mine)
                numbers += compare_field(program, machine, mine, rng, folder)
                tests += compare_tests(program, machine, mine, folder)
                if whole:
                    compare_truth(machine, mine, rng)
            except AssertionError as apart:
                sys.exit(f"machine {k} of seed {seed}, {machine['chain']}: {apart}")
    assert count < len(CHAINS) or (numbers > 200 and tests > 20), (numbers, tests)
    print(f"{count} machines agree by direction: {numbers} numbers of the field, {tests} tests of positions")


if __name__ == "__main__":
    main()
