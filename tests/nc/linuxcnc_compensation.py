#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""A joint with a bad screw, corrected for real: LinuxCNC's motion controller drives it, without a table and with one.

Usage: linuxcnc_compensation.py PROGRAM

PROGRAM is axiometry. The screw is known (lead, period, bow, lost motion); where it puts the slide is read from the motor
through HAL. The test of the bare axis becomes a table, the controller is started anew with it, and the same test must
then show what was predicted. With a table of the wrong sign the re-test must be called just that.
"""
import json
import math
import pathlib
import shutil
import subprocess
import sys
import tempfile

import linuxcnc_machine

TARGETS = [7.5 + 31.25 * k + 2.4 * math.sin(1.7 * k) for k in range(9)]  # nothing round about them
RUNS, OVERRUN = 2, 6.0
LOST_MOTION = 9.0  # µm, that the slide stays behind when it comes from above


def screw(motor, direction, run):
    """Deviation of the slide in µm where the motor stands; a little different in every run."""
    error = 0.11 * motor + 6 * math.sin(2 * math.pi * motor / 83.0) - 4e-4 * (motor - 120) ** 2
    return error + (LOST_MOTION if direction < 0 else 0.0) + 0.4 * math.sin(12.9 * run + motor)


def stops():
    """(position, direction, run of a reading or None) of the standard bidirectional cycle."""
    for run in range(RUNS):
        yield TARGETS[0] - OVERRUN, -1, None
        for target in TARGETS:
            yield target, 1, run
        yield TARGETS[-1] + OVERRUN, 1, None
        for target in reversed(TARGETS):
            yield target, -1, run


def measured(folder, file, comp=None, comp_type=0):
    """Runs the test on the controller, after a way over the whole table, and writes it down as an instrument would.

    Without that way the controller adds nothing until the joint has passed a position of the table.
    """
    plan = list(stops())
    warm_up = [TARGETS[-1] + OVERRUN]
    motors = linuxcnc_machine.drive(folder, warm_up + [p for p, _, _ in plan], comp, comp_type)[len(warm_up):]
    lines = ["target_mm,direction,run,deviation_um"]
    for (position, direction, run), motor in zip(plan, motors):
        if run is not None:
            actual = motor + screw(motor, direction, run) * 1e-3
            lines.append(f"{position:.6f},{'+' if direction > 0 else '-'},{run + 1},{(actual - position) * 1e3:.4f}")
    file.write_text("\n".join(lines) + "\n")


def axiometry(program, *words, expected=(0, 3)):
    done = subprocess.run([program, *map(str, words)], capture_output=True, text=True)
    if done.returncode not in expected:
        raise SystemExit(f"axiometry {' '.join(map(str, words))}: {done.returncode}\n{done.stdout}{done.stderr}")
    return json.loads(done.stdout)


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    if not shutil.which("linuxcnc"):
        raise SystemExit("found no linuxcnc, expected the Debian package linuxcnc-uspace")
    faults = []

    def check(what, holds):
        if not holds:
            faults.append(what)

    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        folder.chmod(0o755)
        measured(folder, folder / "before.csv")
        for control, comp_type in (("linuxcnc", 0), ("linuxcnc-type1", 1)):
            comp = folder / f"{control}.comp"
            made = axiometry(program, "compensate", folder / "before.csv", "--for", control, "--out", comp, "--json", "-")
            measured(folder, folder / "after.csv", comp.name, comp_type)
            held = axiometry(program, "compensate", folder / "before.csv", "--for", control, "--retest",
                             folder / "after.csv", "--json", "-")
            before, predicted, after = made["before"], made["predicted"], held["retest"]["parameters"]
            print(f"{control}: E {before['E']:.2f}, predicted {predicted['E']:.3f}, measured {after['E']:.3f} µm")
            check(f"{control}: E of the bare screw is {before['E']}", before["E"] > 30)
            for parameter in ("A", "E", "R", "B", "M"):
                # The scatter is a function of where the motor stands, which the table moves by some 30 µm.
                check(f"{control}: {parameter} predicted {predicted[parameter]}, measured {after[parameter]}",
                      abs(predicted[parameter] - after[parameter]) < 0.15)
            check(f"{control}: {held['findings']}", "retest-as-predicted" in [f["id"] for f in held["findings"]])
        # Forward and reverse as LinuxCNC's documentation tells type 1: the opposite of what the program does.
        wrong = [line.split() for line in (folder / "linuxcnc-type1.comp").read_text().splitlines()]
        (folder / "wrong.comp").write_text("".join(f"{p} {-float(f):.6f} {-float(r):.6f}\n" for p, f, r in wrong))
        measured(folder, folder / "doubled.csv", "wrong.comp", 1)
        held = axiometry(program, "compensate", folder / "before.csv", "--for", "linuxcnc-type1", "--retest",
                         folder / "doubled.csv", "--json", "-")
        print(f"wrong sign: E {held['retest']['parameters']['E']:.2f} µm, {[f['id'] for f in held['findings']]}")
        check(f"wrong sign: {held['findings']}", "retest-sign" in [f["id"] for f in held["findings"]])
    for fault in faults:
        print("FAILED ", fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
