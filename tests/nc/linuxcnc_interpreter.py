#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs part programs through LinuxCNC's own interpreter and compares what it does with the plans.

Usage: linuxcnc_interpreter.py PROGRAM [--runs N]

PROGRAM is axiometry. Plans of every cycle, linear and rotary, become programs in mm and inches, looped and written out,
with and without a trigger; `rs274` (Debian package linuxcnc-uspace) interprets them without a machine or a display and
prints the canonical commands. The plans are walked here a second time, from their JSON and the meaning of the cycles.
Programs for grbl, whose words are a part of LinuxCNC's, go the same way. Then lines in space (linuxcnc_lines.py), and
rotary axes with rollover and work offsets (linuxcnc_rollover.py).
"""
import argparse
import itertools
import json
import pathlib
import random
import re
import shutil
import subprocess
import sys
import tempfile

import linuxcnc_lines
import linuxcnc_rollover

INCH = 25.4
AXES = "XYZABCUVW"
# STRAIGHT_FEED prints X Y Z A B C with four decimals; the target itself is checked in the text of the program.
PRINTED = 0.5e-4
COMMAND = re.compile(r"^\s*\d+\s+N\S+\s+([A-Z_0-9]+)\((.*)\)\s*$")


def make_plan(rng, cycle, kind):
    """A plan as people write it; numbers with three decimals at most."""
    name = rng.choice("XYZ" if kind == "linear" else "ABC")
    position = round(rng.uniform(-500, 500), 3)
    targets = []
    for _ in range(rng.randint(1, 7)):
        targets.append(round(position, 3))
        position += rng.choice([0.75, 25.4, 43.217, 0.001])
    if len(targets) > 1 and min(b - a for a, b in zip(targets, targets[1:])) < 0.0005:
        targets = sorted(set(targets))
    plan = {
        "axis": {"name": name, "kind": kind}, "machine": "Maschine (Halle 3); Nr. 5", "clause": "5.3.2", "cycle": cycle,
        "targets": targets, "runs": rng.randint(1, 6), "overrun": rng.choice([0.5, 2, 7.25]),
        "feed": rng.choice([120, 500, 1000, 8000]), "dwell_s": rng.choice([0, 0.5, 1, 3.25]),
        "warm_up_runs": rng.randint(0, 3),
    }
    if cycle == "user-defined":
        everything = [[t + 1, d, r + 1] for t in range(len(targets)) for d in ("up", "down") for r in range(plan["runs"])]
        rng.shuffle(everything)
        plan["sequence"] = everything[:rng.randint(1, len(everything))]
    return plan


def readings(plan):
    """(target, direction) in the order of the cycle."""
    up, runs = range(len(plan["targets"])), range(plan["runs"])
    down = list(reversed(up))
    if plan["cycle"] == "user-defined":
        return [(t - 1, 1 if d == "up" else -1) for t, d, _ in plan["sequence"]]
    if plan["cycle"] == "standard":
        return [r for _ in runs for r in [(i, 1) for i in up] + [(i, -1) for i in down]]
    if plan["cycle"] == "unidirectional":
        return [(i, 1) for _ in runs for i in up]
    if plan["cycle"] == "step":
        return [(i, d) for i in up for _ in runs for d in (1, -1)]
    if plan["cycle"] == "pilgrim":
        return [(i, 1) for i in up for _ in runs] + [(i, -1) for i in down for _ in runs]
    raise ValueError(plan["cycle"])


def walk(plan):
    """[position, whether a reading is taken], from the first overrun to the last."""
    targets, overrun = plan["targets"], plan["overrun"]
    low, high = targets[0] - overrun, targets[-1] + overrun
    path = [[low, False]]
    for _ in range(plan["warm_up_runs"]):
        path += [[high, False], [low, False]]
    last = None  # direction of the reading that was taken where the axis stands
    for i, direction in readings(plan):
        here = path[-1][0]
        goes_on = last == direction and (targets[i] - here) * direction > 0
        begin = targets[i] - direction * overrun
        if not goes_on and (begin - here) * direction < 0:
            path.append([begin, False])
        path.append([targets[i], True])
        last = direction
    if path[-1][0] != low:
        path.append([low, False])
    return path


def interpret(folder, program, *options):
    """Canonical commands, name and arguments; fails when the interpreter does."""
    (folder / "test.ngc").write_text(program, encoding="ascii")
    (folder / "test.var").write_text("", encoding="ascii")
    done = subprocess.run(["rs274", "-g", "-t", "tool.tbl", "-v", "test.var", *options, "test.ngc"], cwd=folder,
                          text=True, capture_output=True, stdin=subprocess.DEVNULL, timeout=120)
    if done.returncode != 0:
        raise AssertionError(f"rs274 fails:\n{done.stdout[-500:]}\n{done.stderr[-2000:]}")
    commands = [COMMAND.match(line) for line in done.stdout.splitlines()]
    return [match.groups() for match in commands if match]


def drive(commands, axis, exact):
    """What the axis does: position in mm or degrees, feed, dwell, what was put out before which dwell, stops."""
    column, visits, unit, feed, ended = AXES.index(axis), [], 1.0, 0.0, False
    exact_stop = False
    for name, text in commands:
        arguments = [a.strip() for a in text.split(",")]
        if name == "USE_LENGTH_UNITS":
            unit = INCH if text == "CANON_UNITS_INCHES" and axis in "XYZUVW" else 1.0
        elif name == "SET_MOTION_CONTROL_MODE":
            exact_stop = text == exact
        elif name == "SET_FEED_RATE":
            feed = float(text) * unit
        elif name == "STRAIGHT_FEED":
            assert exact_stop, "a move without exact stop"
            values = [float(a) for a in arguments]
            assert all(v == 0.0 for k, v in enumerate(values) if k != column), "another axis moves"
            visits.append({"at": values[column] * unit, "feed": feed, "dwells": [], "outputs": [], "stops": 0})
        elif name == "DWELL":
            visits[-1]["dwells"].append(float(text))
        elif name == "FLOOD_ON":
            visits[-1]["outputs"].append(len(visits[-1]["dwells"]))
        elif name == "PROGRAM_STOP":
            visits[-1]["stops"] += 1
        elif name == "PROGRAM_END":
            ended = True
        elif name in ("STRAIGHT_TRAVERSE", "ARC_FEED", "START_SPINDLE_CLOCKWISE", "CHANGE_TOOL", "STRAIGHT_PROBE"):
            raise AssertionError(f"{name} in a positioning test")
    assert visits and ended, "the program does not run from start to end"
    return visits, unit


def compare(plan, visits, unit, trigger, stop):
    path = walk(plan)
    assert len(visits) == len(path), f"{len(visits)} moves, expected {len(path)}"
    for number, (visit, (position, reading)) in enumerate(zip(visits, path)):
        where = f"move {number + 1} to {position}"
        # What the program may round by itself in inches: a target by 0.05 µm, an overrun by half of its fourth decimal.
        own = 0.0 if unit == 1.0 else 0.5e-4 if reading else PRINTED * unit
        assert abs(visit["at"] - position) <= PRINTED * unit + own + 1e-9, f"{where}: went to {visit['at']}"
        assert abs(visit["feed"] - plan["feed"]) <= 1e-4 * plan["feed"] + PRINTED * unit, f"{where}: feed {visit['feed']}"
        assert visit["stops"] == (1 if stop and number == 0 else 0), f"{where}: {visit['stops']} stops"
        dwell = plan["dwell_s"] if reading else 0.0
        assert abs(sum(visit["dwells"]) - dwell) <= 1e-3, f"{where}: dwells {visit['dwells']}, expected {dwell}"
        if trigger and reading:
            assert len(visit["outputs"]) == 1, f"{where}: {len(visit['outputs'])} outputs"
            before = sum(visit["dwells"][:visit["outputs"][0]])
            assert abs(before - dwell / 2) <= 1e-3, f"{where}: output after {before} s of {dwell}"
        else:
            assert not visit["outputs"], f"{where}: an output"


def targets_in_text(plan, program, inch):
    """The interpreter prints four decimals; the program may not lose what it does not print."""
    scale = INCH if inch and plan["axis"]["kind"] == "linear" else 1.0
    words = re.findall(rf"G1 {plan['axis']['name']}(-?\d*\.\d*)", program)
    assert not any(re.fullmatch(r"-0*\.0*", w) for w in words), "a negative zero"
    printed = sorted({float(w) * scale for w in words})
    for target in {plan["targets"][i] for i, _ in readings(plan)}:
        nearest = min(abs(p - target) for p in printed)
        assert nearest <= (0.5e-4 if scale != 1.0 else 1e-9), f"target {target} is not in the program (by {nearest})"


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=2, help="plans for each combination")
    arguments = parser.parse_args()
    if not shutil.which("rs274"):
        sys.exit("found no rs274, expected the Debian package linuxcnc-uspace (scripts/packages test)")
    program = arguments.program.resolve()
    rng = random.Random(2302)
    count = moves = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "tool.tbl").write_text("T1 P1 D0.125 Z0.5\n", encoding="ascii")
        cycles = ("standard", "step", "pilgrim", "unidirectional", "user-defined")
        modes = {"linuxcnc": "CANON_EXACT_STOP", "grbl": "CANON_EXACT_PATH"}  # grbl stops by its dwells
        for (dialect, exact), cycle, kind, inch, unrolled, trigger in itertools.product(
                modes.items(), cycles, ("linear", "rotary"), (False, True), (False, True), (False, True)):
            for _ in range(arguments.runs):
                plan = make_plan(rng, cycle, kind)
                stop = rng.random() < 0.5
                (folder / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
                options = ["--inch"] * inch + ["--unrolled"] * unrolled + ["--trigger", "8"] * trigger
                options += ["--stop-at-start"] * stop + ["--no-block-numbers"] * (rng.random() < 0.3)
                command = [program, "nc", folder / "plan.json", "--dialect", dialect, *options]
                done = subprocess.run(command, capture_output=True, text=True)
                try:
                    assert done.returncode == 0, done.stderr
                    visits, unit = drive(interpret(folder, done.stdout), plan["axis"]["name"], exact)
                    compare(plan, visits, unit, trigger, stop)
                    targets_in_text(plan, done.stdout, inch)
                except AssertionError as error:
                    sys.exit(f"{error}\n{dialect} {' '.join(map(str, options))}\n{json.dumps(plan)}\n{done.stdout[:3000]}")
                count += 1
                moves += len(visits)
        try:
            lines = linuxcnc_lines.check(program, folder, rng, arguments.runs, make_plan, walk, interpret)
            turns = linuxcnc_rollover.check(program, folder, rng, arguments.runs, make_plan, walk, interpret)
        except AssertionError as error:
            sys.exit(str(error))
    print(f"{lines[0]} programs of lines in space, {lines[1]} moves;")
    print(f"{turns[0]} programs with rollover, {turns[1]} moves;")
    print(f"{count} programs, {moves} moves: as LinuxCNC's interpreter drives them, so are they planned")


if __name__ == "__main__":
    main()
