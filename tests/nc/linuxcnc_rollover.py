# SPDX-License-Identifier: Apache-2.0
"""Programs with rollover, and work offsets, in LinuxCNC's own interpreter; linuxcnc_interpreter.py runs it.

A rotary axis is configured as wrapped (WRAPPED_ROTARY), or not, and stands anywhere: the interpreter's positions, which
count turns, must go the plan's ways. The absolute angles of a program without rollover must not, or be refused: else
this would prove nothing.
"""
import json
import subprocess

INI = """[EMC]
VERSION = 1.1
[TRAJ]
COORDINATES = X Y Z A B C
LINEAR_UNITS = mm
ANGULAR_UNITS = degree
"""
COLUMNS = "XYZABC"
PRINTED = 1e-4  # two positions of four decimals, rounded


def written(program, folder, plan, *options):
    (folder / "plan.json").write_text(json.dumps(plan), encoding="utf-8")
    done = subprocess.run([program, "nc", folder / "plan.json", "--dialect", "linuxcnc", *options], capture_output=True,
                          text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def positions(commands, axis):
    """Where the axis is driven, and whether it dwells there."""
    column, visits = COLUMNS.index(axis), []
    for name, text in commands:
        if name == "STRAIGHT_FEED":
            values = [float(value) for value in text.split(",")]
            assert all(value == 0 for k, value in enumerate(values[:6]) if k != column), "another axis moves"
            visits.append([values[column], False])
        elif name == "DWELL":
            visits[-1][1] = True
    return visits


def drive(interpret, folder, program, axis, wrapped, start):
    ini = folder / "machine.ini"
    ini.write_text(INI + "".join(f"[AXIS_{name}]\nWRAPPED_ROTARY = {int(wrapped)}\n" for name in "ABC"))
    # The axis is brought to its start in an increment, which no rule of a wrapped one changes.
    there = f"G21 G91 G0 {axis}{start:.4f}\nG90\n" if start else ""
    commands = interpret(folder, there + program, "-i", str(ini))
    return positions(commands, axis)


def compare(plan, path, visits, start):
    where = json.dumps(plan)
    assert len(visits) == len(path), f"{len(visits)} moves, expected {len(path)}: {where}"
    zero = visits[0][0] - path[0][0]
    turns = zero / 360
    assert abs(turns - round(turns)) * 360 <= PRINTED, f"the first move goes to {visits[0][0]}: {where}"
    assert abs(visits[0][0] - start) < 360, f"the first move turns from {start} to {visits[0][0]}: {where}"
    for number, ((at, dwells), (position, reading)) in enumerate(zip(visits, path)):
        assert abs(at - zero - position) <= PRINTED, f"move {number + 1} goes to {at - zero}, expected {position}: {where}"
        assert dwells == (reading and plan["dwell_s"] > 0), f"move {number + 1}: {where}"


def turning_plan(rng, make_plan, cycle):
    """Of less than a turn, of one, or of several."""
    plan = make_plan(rng, cycle, "rotary")
    targets = {"part": [0, 30, 90], "turn": [0, 90, 180, 270, 306.4577], "turns": [0, 360, 725.5, 1800],
               "below": [-400.25, -180, 0, 359]}[rng.choice(["part", "turn", "turns", "below"])]
    plan["targets"] = targets
    if cycle == "user-defined":
        everything = [[t + 1, d, r + 1] for t in range(len(targets)) for d in ("up", "down") for r in range(plan["runs"])]
        rng.shuffle(everything)
        plan["sequence"] = everything
    return plan


def check(program, folder, rng, runs, make_plan, walk, interpret):
    """(programs, moves) that were compared; AssertionError names what differs."""
    count = moves = strayed = 0
    for cycle in ("standard", "step", "pilgrim", "unidirectional", "user-defined"):
        for _ in range(3 * runs):
            plan = turning_plan(rng, make_plan, cycle)
            axis, path = plan["axis"]["name"], walk(plan)
            options = ["--unrolled"] * (rng.random() < 0.3) + ["--frame", "machine"] * (rng.random() < 0.3)
            text = written(program, folder, plan, "--rollover", "on", *options)
            for wrapped in (True, False):
                start = rng.choice([0, 123.4567, 359.9]) if wrapped else 0
                visits = drive(interpret, folder, text, axis, wrapped, start)
                compare(plan, path, visits, start)
                count, moves = count + 1, moves + len(visits)
            try:
                compare(plan, path, drive(interpret, folder, written(program, folder, plan), axis, True, 0), 0)
            except AssertionError:
                strayed += 1
    assert strayed > count // 4, "a wrapped axis goes the planned ways by absolute angles: this proves nothing"
    offsets(program, folder, rng, make_plan, interpret)
    return count, moves


def offsets(program, folder, rng, make_plan, interpret):
    """Another offset is active before the program, and G92 shifts."""
    plan = make_plan(rng, "standard", "linear")
    axis, low = plan["axis"]["name"], plan["targets"][0] - plan["overrun"]
    before = (f"G21\nG10 L2 P2 {axis}7\nG10 L2 P4 {axis}20\nG55\n", f"G92 {axis}3\n")
    for frame, shift, seen in (("active", "", low), ("G57", "", low), ("machine", "", low - 7), ("machine", before[1], None)):
        commands = interpret(folder, before[0] + shift + written(program, folder, plan, "--frame", frame))
        systems = [int(text.split(",")[0]) for name, text in commands if name == "SET_G5X_OFFSET"]
        ends = next(k for k, (name, _) in enumerate(commands) if name == "STRAIGHT_FEED")
        at = float(commands[ends][1].split(",")["XYZ".index(axis)])
        active = [int(text.split(",")[0]) for name, text in commands[:ends] if name == "SET_G5X_OFFSET"][-1]
        assert active == {"active": 2, "G57": 4, "machine": 2}[frame], f"{frame}: offset {active} of {systems}"
        if seen is None:  # positions are told in the active offset, shifted by G92 as the interpreter says
            shifted = [text for name, text in commands if name == "SET_G92_OFFSET"][-1]
            seen = low - 7 - float(shifted.split(",")["XYZ".index(axis)])
        assert abs(at - seen) <= 2e-4, f"{frame}: the first move goes to {at}, expected {seen} in the active offset"
