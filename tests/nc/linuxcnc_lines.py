# SPDX-License-Identifier: Apache-2.0
"""Lines in space, driven by several axes in one program: the part of linuxcnc_interpreter.py for tracking plans.

Tracking plans of one to six lines, with ways between them, become programs; LinuxCNC's interpreter says where the axes
go. The plans are walked here a second time, from their JSON alone.
"""
import itertools
import json
import math
import re
import subprocess

INCH = 25.4
PRINTED = 0.5e-4  # STRAIGHT_FEED prints four decimals
DIRECTIONS = {"x": (1, 0, 0), "y": (0, -1, 0), "z": (0, 0, 1), "xy": (1, 1, 0), "xz": (1, 0, -1), "yz": (0, 1, 1),
              "xyz": (1, -1, 1), "PPP-NNN": (-1000, -600, -500), "steep": (0.003, 0.02, -1)}


def point(rng):
    return [round(rng.uniform(-700, 700), 3) for _ in range(3)]


def make_tracking_plan(rng, make_plan):
    lines = []
    for name in rng.sample(sorted(DIRECTIONS), rng.randint(1, 6)):
        plan = make_plan(rng, rng.choice(["standard", "standard", "step", "pilgrim", "unidirectional"]), "linear")
        plan["axis"] = {"name": name.upper(), "kind": "linear", "line_origin_mm": point(rng),
                        "line_direction": list(DIRECTIONS[name])}
        # Along a slope 1 µm is less than the four decimals of each coordinate tell.
        for low, high in zip(range(len(plan["targets"]) - 1), range(1, len(plan["targets"]))):
            plan["targets"][high] = max(plan["targets"][high], round(plan["targets"][low] + 0.01, 3))
        plan["way_in_mm"] = [point(rng) for _ in range(rng.randint(0, 3))]
        plan["way_out_mm"] = [point(rng) for _ in range(rng.randint(0, 2))]
        lines.append({"id": name, "plan": plan})
    return {"format": "axiometry-tracking-plan/1", "title": "Seven (lines); of 1", "machine": "Maschine (Halle 3)",
            "setup": {"travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 500, 0]},
                      "station": {"position_mm": [400, 250, -450]}},
            "lines": lines, "lost": [{"id": "q", "reason": "there is no such line"}]}


def path_of(plan, walk):
    """[point, axes that must be named, whether a reading is taken there, direction in which it must be reached]."""
    origin, direction = plan["axis"]["line_origin_mm"], plan["axis"]["line_direction"]
    length = math.sqrt(sum(d * d for d in direction))
    unit = [d / length for d in direction]
    moving = "".join(axis for axis, u in zip("XYZ", unit) if abs(u) > 1e-9)
    path = [[p, "XYZ", False] for p in plan["way_in_mm"]]
    for k, (position, reading) in enumerate(walk(plan)):
        path.append([[o + position * u for o, u in zip(origin, unit)], "XYZ" if k == 0 else moving, reading])
    return path + [[p, "XYZ", False] for p in plan["way_out_mm"]]


def drive(commands, exact):
    """What the axes do: point in mm, feed, dwells, number of dwells before each output, stops."""
    visits, unit, feed, ended, exact_stop = [], 1.0, 0.0, False, False
    for name, text in commands:
        if name == "USE_LENGTH_UNITS":
            unit = INCH if text == "CANON_UNITS_INCHES" else 1.0
        elif name == "SET_MOTION_CONTROL_MODE":
            exact_stop = text == exact
        elif name == "SET_FEED_RATE":
            feed = float(text) * unit
        elif name == "SET_FEED_MODE":
            assert text.split(",")[-1].strip() == "0", "feed that is not per minute"
        elif name == "STRAIGHT_FEED":
            assert exact_stop, "a move without exact stop"
            values = [float(a) for a in text.split(",")]
            assert not any(values[3:]), "another axis moves"
            visits.append({"at": [v * unit for v in values[:3]], "feed": feed, "dwells": [], "outputs": [], "stops": 0})
        elif name == "DWELL":
            visits[-1]["dwells"].append(float(text))
        elif name == "FLOOD_ON":
            visits[-1]["outputs"].append(len(visits[-1]["dwells"]))
        elif name == "PROGRAM_STOP":
            visits[-1]["stops"] += 1
        elif name == "PROGRAM_END":
            ended = True
        elif name in ("STRAIGHT_TRAVERSE", "ARC_FEED", "START_SPINDLE_CLOCKWISE", "CHANGE_TOOL", "STRAIGHT_PROBE"):
            raise AssertionError(f"{name} between lines")
    assert visits and ended, "the program does not run from start to end"
    return visits, unit


def alone(plan, visits, unit, walk):
    """A line driven without the others: from above and back, or as it was planned where no such way is safe."""
    moves = len(walk(plan))
    around = len(visits) - moves - len(plan["way_in_mm"]) - len(plan["way_out_mm"])
    line = path_of({**plan, "way_in_mm": [], "way_out_mm": []}, walk)
    begin, within = line[0][0], 2 * PRINTED * unit + 1e-9
    own = plan["way_in_mm"] + [begin]
    if around == 0 and all(abs(a - b) <= within for v, p in zip(visits, own) for a, b in zip(v["at"], p)):
        return plan
    steps, odd = divmod(len(visits) - moves, 2)
    assert not odd, "there and back by different ways"
    way = [visit["at"] for visit in visits[:steps]]
    assert not way or all(abs(a - b) <= within for a, b in zip(way[0], [*begin[:2], 0.0])), f"begins at {way[0]}"
    assert all(low <= x <= high for p in way for x, low, high in zip(p, (0, 0, -500), (800, 500, 0))), f"{way}"
    return {**plan, "way_in_mm": way, "way_out_mm": way[::-1]}


def compare(plans, visits, unit, trigger, stop, walk):
    """`stop`: "start", "lines" or nothing, at the first move on the first line or on each."""
    path = [(plan, *step) for plan in plans for step in path_of(plan, walk)]
    stopping, begin = set(), 0
    for plan in plans:
        if stop == "lines" or (stop == "start" and plan is plans[0]):
            stopping.add(begin + len(plan["way_in_mm"]))
        begin += len(path_of(plan, walk))
    assert len(visits) == len(path), f"{len(visits)} moves, expected {len(path)}"
    for number, (visit, (plan, at, _, reading)) in enumerate(zip(visits, path)):
        where = f"move {number + 1} to {at}"
        # Rounded by the program to four decimals at least, and by the interpreter's print.
        within = 2 * PRINTED * unit + 1e-9
        assert all(abs(a - b) <= within for a, b in zip(visit["at"], at)), f"{where}: went to {visit['at']}"
        assert abs(visit["feed"] - plan["feed"]) <= 1e-4 * plan["feed"] + PRINTED * unit, f"{where}: {visit['feed']}"
        stops = 1 if number in stopping else 0
        assert visit["stops"] == stops, f"{where}: {visit['stops']} stops"
        dwell = plan["dwell_s"] if reading else 0.0
        assert abs(sum(visit["dwells"]) - dwell) <= 1e-3, f"{where}: dwells {visit['dwells']}, expected {dwell}"
        assert len(visit["outputs"]) == (1 if trigger and reading else 0), f"{where}: outputs {visit['outputs']}"
        if visit["outputs"]:
            before = sum(visit["dwells"][:visit["outputs"][0]])
            assert abs(before - dwell / 2) <= 1e-3, f"{where}: output after {before} s of {dwell}"


def words_in_text(plans, program, unit, walk):
    """Every target within 0.05 µm, every axis that must be named: read from the text, which the interpreter rounds."""
    moves = []
    for block in re.findall(r"^(?:N\d+ )?G1 ([XYZ0-9. -]+) F", program, re.M):
        words = dict((w[0], float(w[1:]) * unit) for w in block.split())
        assert not re.search(r"-0*\.0*(?![0-9])", block), f"a negative zero in {block}"
        moves.append(words)
    for plan in plans:
        for at, named, reading in path_of(plan, walk):
            of_line = dict(zip("XYZ", at))
            near = 0.5e-4 + 1e-8 if reading else PRINTED * unit + 1e-8
            assert any("".join(words) == named and all(abs(words[a] - of_line[a]) <= near for a in named)
                       for words in moves), f"no block of {named} to {at}"


def check(program, folder, rng, runs, make_plan, walk, interpret):
    """(number of programs, number of moves); raises AssertionError with the case."""
    count = moves = 0
    modes = {"linuxcnc": "CANON_EXACT_STOP", "grbl": "CANON_EXACT_PATH"}  # grbl stops by its dwells
    for (dialect, exact), inch, unrolled, trigger, _ in itertools.product(
            modes.items(), (False, True), (False, True), (False, True), range(3 * runs)):
        tracking = make_tracking_plan(rng, make_plan)
        plans = [line["plan"] for line in tracking["lines"]]
        stop = rng.choice(["start", "lines", ""])
        options = ["--inch"] * inch + ["--unrolled"] * unrolled + ["--trigger", "8"] * trigger
        options += [f"--stop-at-{stop}"] * bool(stop) + ["--no-block-numbers"] * (rng.random() < 0.3)
        options += ["--decimals", str(rng.randint(4, 6))]
        if rng.random() < 0.3:
            only = rng.choice(tracking["lines"])
            plans = [only["plan"]]
            options += ["--line", only["id"]]
        (folder / "tracking.json").write_text(json.dumps(tracking), encoding="utf-8")
        command = [program, "nc", folder / "tracking.json", "--dialect", dialect, *options]
        done = subprocess.run(command, capture_output=True, text=True)
        try:
            assert done.returncode == 0, done.stderr
            visits, unit = drive(interpret(folder, done.stdout), exact)
            if "--line" in options:
                plans = [alone(plans[0], visits, unit, walk)]
            compare(plans, visits, unit, trigger, stop, walk)
            words_in_text(plans, done.stdout, unit, walk)
        except AssertionError as error:
            raise AssertionError(f"{error}\n{dialect} {' '.join(map(str, options))}\n{json.dumps(tracking)}\n"
                                 f"{done.stdout[:3000]}") from None
        count += 1
        moves += len(visits)
    return count, moves
