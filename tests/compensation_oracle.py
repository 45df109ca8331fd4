#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads every table that the program writes for a control a second time, by that control's rule, and applies it.

Usage: compensation_oracle.py PROGRAM

An axis is made here: its errors, its backlash and its readings are known. For every control that the program lists, the
table is written from the readings, read here by the rule of the control (no code is shared), held against the "table"
of the program's JSON, and added to the readings: what is left must be what the program predicts, and less than before.
Then a re-test with that table active, of an axis that has changed since, gives the next table: new less old must take the
rest away. The same for a rotary axis over a whole turn, in degrees and seconds of arc, and for controls in inches.
"""
import csv
import json
import math
import pathlib
import random
import re
import subprocess
import sys
import tempfile

NUMBER = r"[-+]?\d+(?:\.\d+)?"


# ---------------------------------------------------------------- rules of the controls: text → {position: (up, down)}, µm

def even(first, step, up, down=None):
    down = up if down is None else down
    assert len(up) == len(down)
    return {round(first + step * k, 6): (u, d) for k, (u, d) in enumerate(zip(up, down))}


def numbers(line):
    return [float(x) for x in re.findall(NUMBER, line)]


def linuxcnc(text, is_trims):
    table = {}
    for line in text.splitlines():
        nominal, forward, reverse = (float(x) for x in line.split())
        trims = (forward, reverse) if is_trims else (nominal - forward, nominal - reverse)
        table[nominal] = tuple(1e3 * x for x in trims)
    return table


def siemens_values(text, name, table):
    """Values by N, and what stands beside them, of `name[…table…]`: a positive value is taken off."""
    values = {int(n): -1e3 * float(v) for n, v in re.findall(rf"\${name}\[{table},(\d+)(?:,\w+)?\]=({NUMBER})", text)}
    beside = {key: float(v) for key, v in re.findall(rf"\${name}_([A-Z_]+)\[{table}(?:,\w+)?\]=({NUMBER})", text)}
    count = round((beside["MAX"] - beside["MIN"]) / beside["STEP"]) + 1
    assert sorted(values) == list(range(count)), "a gap"
    return beside, [values[n] for n in range(count)]


def siemens_lec(text):
    beside, values = siemens_values(text, "AA_ENC_COMP", 0)
    return even(beside["MIN"], beside["STEP"], values)


def siemens_lec_with_backlash(text):
    """Beside the curve MD32450 is driven more at each reversal into the negative direction; positive where it lags."""
    number = re.search(r"^; MD32450 = its value while the axis was measured \+ (-?[\d.]+)$", text, re.M)
    return {p: (up, down - 1000.0 * float(number.group(1))) for p, (up, down) in siemens_lec(text).items()}


def turned(rule):
    """Of a control whose sign is the other one."""
    return lambda text: {p: (-up, -down) for p, (up, down) in rule(text).items()}


def siemens_cec(text):
    curves = {}
    for table in sorted(set(re.findall(r"\$AN_CEC\[(\d+),", text))):
        beside, values = siemens_values(text, "AN_CEC", table)
        for direction in (1, -1):
            if beside["DIRECTION"] in (0, direction):
                curves[direction] = values
    return even(beside["MIN"], beside["STEP"], curves[1], curves[-1])


def fanuc(text, detection_unit):
    tape, settings = text.split("%")[1:3]
    points = {int(n) - 10000: int(p) for n, p in re.findall(r"N(\d+)P(-?\d+)", tape)}
    parameter = {int(n): float(v) for n, v in re.findall(rf"^(36\d\d)(?:#0)? = ({NUMBER})", settings, re.M)}
    count = detection_unit * parameter[3623]

    def walked(first, at_reference):
        """From the reference point up and down: each number is added on the way to its own point, taken off on the way back."""
        found = {parameter[3620]: at_reference}
        for n in range(int(parameter[3620]) + 1, int(parameter[3622]) + 1):
            found[n] = found[n - 1] + count * points[first + n - int(parameter[3621])]
        for n in range(int(parameter[3620]), int(parameter[3621]) - 1, -1):
            found[n - 1] = found[n] - count * points[first + n - int(parameter[3621])]
        return found

    up = walked(int(parameter[3621]), 0.0)
    down = walked(int(parameter[3626]), detection_unit * parameter[3627]) if parameter[3605] else up
    if 3625 in parameter:  # a whole turn: its first point is its last again, one section before the reference point
        for first in {parameter[3621], parameter[3626] if parameter[3605] else parameter[3621]}:
            assert points[int(first)] == points[int(first + parameter[3622] - parameter[3621])]
        del up[parameter[3620] - 1]
    return {round((n - parameter[3620]) * parameter[3624], 6): (up[n], down[n]) for n in sorted(up)}


def mitsubishi(text, output_unit):
    entry = {int(n): float(v) for n, v in re.findall(rf"#(\d+) ({NUMBER})$", text, re.M)}
    reference, spacing = int(entry[4003]), entry[4007]
    moved = {reference: 0.0}  # the actual move of the axis alone is spacing − v/2 upward, −(spacing − v/2) downward
    for n in range(reference + 1, int(entry[4005]) + 1):
        moved[n] = moved[n - 1] + output_unit * entry[4006] * entry[n] / 2
    for n in range(reference, int(entry[4004]) - 1, -1):
        moved[n - 1] = moved[n] - output_unit * entry[4006] * entry[n] / 2
    return {round((n - reference) * spacing, 6): (x, x) for n, x in sorted(moved.items())}


def heidenhain(text):
    rows = [numbers(line) for line in text.splitlines() if line[:1].isdigit()]
    return {position: (-1e3 * up, -1e3 * down) for _, position, down, up in rows}


def twincat_cnc(text):
    columns = {}
    for k, name, value in re.findall(r"kw\.ssfk\.table\[(\d+)\]\.(\w+) (-?\d+)", text):
        columns.setdefault(name, {})[int(k)] = int(value)
    return {columns["setpoint"][k] / 1e4: (-0.1 * columns["pos"][k], -0.1 * columns["neg"][k]) for k in columns["setpoint"]}


def twincat_ptp(text):
    pairs = re.findall(rf"Position := ({NUMBER}), Compensation := ({NUMBER})", text)
    return {float(p): (1e3 * float(c),) * 2 for p, c in pairs}


def acs(text):
    values = [1e3 * float(v) for _, v in sorted((int(k), v) for k, v in re.findall(rf"^\w+\((\d+)\)=({NUMBER})$", text, re.M))]
    start, step = re.search(rf"MAP\(APOS\(0\),\w+,({NUMBER}),({NUMBER})\)", text).groups()
    return even(float(start), float(step), values)


def aerotech(text):
    head = re.search(rf"^:START \w+ .*SAMPDIST=({NUMBER}) OFFSET=({NUMBER})$", text, re.M)
    values = [float(x) for x in text[head.end():text.index(":END")].split()]
    return even(float(head[2]), float(head[1]), values)


def pmac(text, count_um, per_position=1e3):
    low, high = numbers(re.search(r"^; range (.*)$", text, re.M)[1])
    curves = {}
    for kind, entries, length, body in re.findall(r"DEFINE (COMP|BLCOMP) (\d+),(\d+)\n((?:-?\d+\n)+)", text):
        values = [int(x) for x in body.split()]
        assert len(values) == int(entries)
        curves[kind] = values
        step = int(length) * count_um / per_position / int(entries)
    at_home = int(constant[1]) / 16 * count_um if (constant := re.search(r"^I\d+86=(\d+)$", text, re.M)) else 0.0
    assert curves.get("BLCOMP", [0])[-1] == 0  # at home it is 0 by definition
    table = {}
    for k in range(round(low / step), round(high / step) + 1):
        up, less = (curves.get(kind, [0] * 10 ** 5)[k % len(curves["COMP"]) - 1] / 16 * count_um for kind in ("COMP", "BLCOMP"))
        table[round(k * step, 6)] = (up, up - less - at_home)
    return table


def fagor(text):
    rows = [numbers(line)[1:] for line in text.splitlines() if line.startswith("P")]
    is_one = all(row[2] == 0 for row in rows)
    return {p: (-1e3 * up, -1e3 * (up if is_one else down)) for p, up, down in rows}


def haas(text):
    rows = [line.split() for line in text.splitlines() if not line.startswith(";")]
    return dict(sorted((round(-12.7 * (int(k) - 1), 6), (2.54 * int(v),) * 2) for k, v in rows))


def kflop(text):
    count, spacing, offset, *rows = text.split()
    assert len(rows) == int(count)
    places = [(float(offset) + float(spacing) * int(row.split(",")[0]), float(row.split(",")[1])) for row in rows]
    return {round(p, 6): (1e3 * (command - p),) * 2 for p, command in places}


def mach4(text):
    start, length, count = (float(re.search(rf"^{key} = ({NUMBER})$", text, re.M)[1]) for key in ("Start", "Length", "Points"))
    maps = [[1e3 * float(line.split()[1]) for line in part.splitlines()[1:]] for part in text.split("Map = ")[1:]]
    assert all(len(m) == count for m in maps)
    return even(start, length / (count - 1), *maps)


def axeserr(text):
    rows = [numbers(line) for line in text.splitlines()[2:]]
    return {p: (-1e3 * up, -1e3 * down) for p, up, down in rows}


def stepped(text, steps_key, backlash_key, steps_before):
    low, high = numbers(re.search(r"range (.*)$", text, re.M)[1])
    steps = float(re.search(rf"^{re.escape(steps_key)}({NUMBER})$", text, re.M)[1])
    backlash = 1e3 * float(re.search(rf"^{re.escape(backlash_key)}({NUMBER})$", text, re.M)[1])
    line = {p: 1e3 * p * (steps / steps_before - 1) for p in (low, high)}
    return {p: (up, up - backlash) for p, up in line.items()}


# id: (rule, further options of the command)
CONTROLS = {
    "acs": (acs, []),
    "aerotech": (aerotech, []),
    "axeserr": (axeserr, []),
    "fagor": (fagor, []),
    "fanuc": (lambda t: fanuc(t, 1.0), ["--magnification", "3", "--number", "40"]),
    "fanuc-bidirectional": (lambda t: fanuc(t, 0.5), ["--magnification", "6", "--resolution", "0.5"]),
    "grblhal": (lambda t: stepped(t, "$100=", "$160=", 200.0), ["--steps-per-unit", "200"]),
    "haas": (haas, []),
    "heidenhain": (heidenhain, []),
    "kflop": (kflop, []),
    "linuxcnc": (lambda t: linuxcnc(t, False), []),
    "linuxcnc-type1": (lambda t: linuxcnc(t, True), []),
    "mach4": (mach4, []),
    "marlin": (lambda t: stepped(t, "M92 X", "M425 F1 X", 200.0), ["--steps-per-unit", "200"]),
    "mitsubishi": (lambda t: mitsubishi(t, 1.0), []),
    "pmac": (lambda t: pmac(t, 0.5), ["--resolution", "0.5"]),
    "siemens-cec": (siemens_cec, []),
    "siemens-lec": (siemens_lec, []),
    "smoothie": (lambda t: stepped(t, "alpha_steps_per_mm ", "alpha_backlash_mm ", 200.0), ["--steps-per-unit", "200"]),
    "twincat-cnc": (twincat_cnc, []),
    "twincat-ptp": (twincat_ptp, []),
}


def in_degrees(rule):
    """Rules above give 1000 for a thousandth of the unit of positions: of degrees, 3.6 seconds of arc."""
    return lambda text: {p: (3.6 * up, 3.6 * down) for p, (up, down) in rule(text).items()}


def in_inches(rule):
    return lambda text: {round(25.4 * p, 6): (25.4 * up, 25.4 * down) for p, (up, down) in rule(text).items()}


# Of a rotary axis. Detection units, output units and counts are in seconds of arc: 0.001 degrees is 3.6 of them.
ROTARY = {
    **{control: (in_degrees(CONTROLS[control][0]), []) for control in
       ("acs", "aerotech", "fagor", "heidenhain", "kflop", "linuxcnc", "linuxcnc-type1", "mach4", "siemens-cec", "siemens-lec",
        "twincat-cnc", "twincat-ptp")},
    "fanuc": (lambda t: fanuc(t, 3.6), ["--resolution", "3.6"]),
    "fanuc-bidirectional": (lambda t: fanuc(t, 0.36), ["--resolution", "0.36", "--largest", "127"]),
    "mitsubishi": (lambda t: mitsubishi(t, 3.6), ["--resolution", "3.6"]),
    "pmac": (lambda t: pmac(t, 0.36, 3600.0), ["--resolution", "0.36"]),
}
NO_TURN = ("grblhal", "marlin")  # one slope and one backlash: nothing that a turn could close with
INCHES = {control: (in_inches(CONTROLS[control][0]), ["--inch"]) for control in
          ("acs", "aerotech", "fagor", "heidenhain", "kflop", "linuxcnc", "linuxcnc-type1", "mach4", "siemens-cec", "siemens-lec",
           "twincat-ptp")}
INCHES["mitsubishi"] = (  # positions in inches; output units are told in µm
    lambda t: {round(25.4 * p, 6): value for p, value in mitsubishi(t, 2.54).items()}, ["--inch", "--resolution", "2.54"])


# ---------------------------------------------------------------- the axis, and the parameters of ISO 230-2, 3.

def measured(seed):
    """{target: ([deviations upward], [downward])}, µm, of an axis with a pitch error, a wave and a backlash."""
    draw = random.Random(seed)
    readings = {}
    for k in range(21):
        target = -254.0 + 12.7 * k
        true = 0.06 * target + 5.0 * math.sin(target / 40.0)
        backlash = 9.0 + 2.0 * math.cos(target / 60.0)
        readings[round(target, 4)] = tuple([true + side * backlash / 2 + draw.gauss(0.0, 0.4) for _ in range(5)] for side in (-1, 1))
    return readings


def turned_round(seed, size=1.0):
    """The same in seconds of arc, every 30 degrees of a whole turn."""
    draw = random.Random(seed)
    readings = {}
    for k in range(13):
        angle = math.radians(30 * k)
        true = size * (18.0 * math.sin(angle) + 6.0 * math.cos(2 * angle))
        backlash = size * (9.0 + 2.0 * math.cos(angle))
        readings[30.0 * k] = tuple([true + side * backlash / 2 + draw.gauss(0.0, 0.3) for _ in range(5)] for side in (-1, 1))
    return readings


def added(table, position, side):
    """Linear between the positions of the table, constant beyond its ends."""
    places = sorted(table)
    if position <= places[0] or position >= places[-1]:
        return table[places[0] if position <= places[0] else places[-1]][side]
    k = max(i for i, p in enumerate(places) if p <= position)
    share = (position - places[k]) / (places[k + 1] - places[k])
    return table[places[k]][side] + share * (table[places[k + 1]][side] - table[places[k]][side])


def parameters(readings):
    """A, E, R, B, M of both directions, µm."""
    mean = lambda x: sum(x) / len(x)
    scatter = lambda x: math.sqrt(sum((v - mean(x)) ** 2 for v in x) / (len(x) - 1))
    means, ends, R, B, M = [], [], [], [], []
    for up, down in readings.values():
        (a, b), (s, t) = (mean(up), mean(down)), (scatter(up), scatter(down))
        means += [a, b]
        ends += [a - 2 * s, a + 2 * s, b - 2 * t, b + 2 * t]
        R.append(max(2 * s + 2 * t + abs(a - b), 4 * s, 4 * t))
        B.append(abs(a - b))
        M.append((a + b) / 2)
    return {"A": max(ends) - min(ends), "E": max(means) - min(means), "R": max(R), "B": max(B), "M": max(M) - min(M)}


LINEAR_AXIS, ROTARY_AXIS = ("X", "linear", "target_mm", "deviation_um"), ("C", "rotary", "target_deg", "deviation_arcsec")


def written_test(name, readings, axis):
    letter, kind, target_column, deviation_column = axis
    with open(name, "w", newline="", encoding="utf-8") as file:
        file.write(f"# axis.name: {letter}\n# axis.kind: {kind}\n")
        rows = csv.writer(file)
        rows.writerow(["run", "direction", target_column, deviation_column])
        for target, sides in readings.items():
            for side, values in zip(("up", "down"), sides):
                rows.writerows([run + 1, side, target, f"{value:.9f}"] for run, value in enumerate(values))
    return str(name)


def made_table(program, control, options, test, out, axis):
    command = [program, "compensate", test, "--for", control, "--axis", axis[0], "--out", str(out), "--json", "-", *options]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    if done.returncode not in (0, 3):
        raise AssertionError(f"{' '.join(command[1:])} ends with {done.returncode}: {done.stderr.strip()}")
    return json.loads(done.stdout)


def faults_of_table(told, table, readings, existing=None):
    """What is told of a table, and of readings with it in place of `existing`, against the table as its control reads it."""
    faults = []
    nodes = {round(node["position"], 6): (node["up"], node["down"]) for node in told["table"]}
    if len(nodes) != len(table):
        faults.append(f"{len(table)} positions by the rule, {len(nodes)} told")
    for position, values in table.items():
        near = min(nodes, key=lambda p: abs(p - position))
        if abs(near - position) > 1e-4 or any(abs(a - b) > 6e-3 for a, b in zip(nodes[near], values)):
            faults.append(f"{values} at {position} by the rule, {nodes[near]} at {near} told")
    change = lambda target, side: added(table, target, side) - (added(existing, target, side) if existing else 0.0)
    after = {target: tuple([v + change(target, side) for v in values] for side, values in enumerate(sides))
             for target, sides in readings.items()}
    before, predicted = parameters(readings), parameters(after)
    for key, value in predicted.items():
        if abs(told["before"][key] - before[key]) > 1e-3 or abs(told["predicted"][key] - value) > 1e-2:
            faults.append(f"{key} {before[key]:.4f} → {value:.4f}, told {told['before'][key]} → {told['predicted'][key]}")
    if not predicted["E"] < before["E"]:
        faults.append(f"E becomes {predicted['E']:.3f} from {before['E']:.3f}")
    return faults


def check(program, control, rule, options, folder, axis=LINEAR_AXIS, make=measured, again=None):
    """Faults of a table, and where readings were taken `again` with it active, of the one that follows it."""
    name = " ".join([control, axis[1], *options])
    out, next_out = folder / f"{control}.table", folder / f"{control}.next"
    try:
        readings = make(7)
        told = made_table(program, control, options, written_test(folder / "axis.csv", readings, axis), out, axis)
        table = rule(out.read_text(encoding="utf-8"))
        faults = faults_of_table(told, table, readings)
        if told["unit"] != ("um" if axis[1] == "linear" else "arcsec"):
            faults.append(f"the unit {told['unit']} is told")
        if again:
            later = [*options, "--existing", str(out), "--hold-ends"]
            told = made_table(program, control, later, written_test(folder / "later.csv", again, axis), next_out, axis)
            faults += ["next: " + fault for fault in faults_of_table(told, rule(next_out.read_text(encoding="utf-8")), again, table)]
    except AssertionError as error:
        faults = [str(error)]
    return [f"{name}: {fault}" for fault in faults]


def main():
    program = sys.argv[1]
    listed = subprocess.run([program, "compensate", "--list", "--json", "-"], capture_output=True, text=True, check=True).stdout
    controls = [c for c in json.loads(listed) if c["limits"]["linear"] or c["limits"]["rotary"]]  # not of cross tables alone
    ids = [control["id"] for control in controls]
    faults = [f"{control}: no rule is known here" for control in ids if control not in CONTROLS]
    faults += [f"{control}: is not listed by the program" for control in CONTROLS if control not in ids]
    with tempfile.TemporaryDirectory() as folder:
        for control in controls:
            if control["id"] not in CONTROLS:
                continue
            rule, options = CONTROLS[control["id"]]
            smaller = {target: tuple([0.3 * v for v in values] for values in sides) for target, sides in measured(8).items()}
            faults += check(program, control["id"], rule, options, pathlib.Path(folder), again=smaller)
            if control["turned_sign"]:
                faults += check(program, control["id"], turned(rule), [*options, "--turned-sign"], pathlib.Path(folder))
        turns = [control["id"] for control in controls if control["limits"]["rotary"] and control["id"] not in NO_TURN]
        faults += [f"{control}: no rule of a rotary axis is known here" for control in turns if control not in ROTARY]
        faults += [f"{control}: has no rotary axis" for control in ROTARY if control not in turns]
        for control, (rule, options) in ROTARY.items():
            faults += check(program, control, rule, options, pathlib.Path(folder), ROTARY_AXIS, turned_round, turned_round(8, 0.4))
        for control, (rule, options) in INCHES.items():
            faults += check(program, control, rule, options, pathlib.Path(folder))
        faults += check(program, "siemens-lec", siemens_lec_with_backlash, ["--curves", "with-backlash"], pathlib.Path(folder))
    print("\n".join(faults) if faults else f"{len(ids)} controls: ok")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
