#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Diagonals by an aligned interferometer: planned without a station, measured on machines whose truth the program does not
see, evaluated; the squareness of each face from its two diagonals by the law of cosines.

Usage: tests/diagonals_oracle.py PROGRAM [COUNT] [SEED]

Shares nothing with the C++ code: places, lengths, deviations, E, R, B, slopes, their uncertainties and angles are computed
here, the angles from the lengths of the sides themselves.
"""
import csv
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

FACES = {"XY": (0, 1, "NN0-PP0", "NP0-PN0", "C0Y", 1.0), "XZ": (0, 2, "N0N-P0P", "N0P-P0N", "B0Z", -1.0),
         "YZ": (1, 2, "0NN-0PP", "0NP-0PN", "A0Z", 1.0)}
ALL = {"NNN-PPP", "NNP-PPN", "NPN-PNP", "NPP-PNN"} | {d for f in FACES.values() for d in f[2:4]}


def run(program, *arguments, codes=(0,)):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True)
    if done.returncode not in codes:
        raise SystemExit(f"{' '.join(map(str, arguments))}\nexit {done.returncode}: {done.stderr}")
    return done


def close(what, found, expected, within):
    if not abs(found - expected) <= within:
        raise SystemExit(f"{what}: found {found}, expected {expected} within {within}")


class Machine:
    def __init__(self, rng):
        self.low = np.round(rng.uniform(-700, -100, 3), 1)
        self.high = self.low + np.round(rng.uniform(300, 1100, 3), 1)
        self.tool = np.array([0.0, 0.0, -100.0])
        e = rng.normal(0, 20e-6, 3)
        self.c, self.b, self.a = rng.normal(0, 30e-6, 3)
        self.D = np.array([[e[0], -self.c, self.b], [0, e[1], -self.a], [0, 0, e[2]]])
        self.play = rng.uniform(0, 0.004)
        self.instrument = rng.normal(0, 5e-6)

    def reflector(self, axes):
        return axes + self.tool + self.D @ axes


def measure(machine, plan, rng, folder):
    """Rows of the table; and deviations by line, direction, run and target in µm, zero at the first target's mean."""
    rows, deviations = [], {}
    for line in plan["lines"]:
        p, axis = line["plan"], line["plan"]["axis"]
        origin, u = np.array(axis["line_origin_mm"]), np.array(axis["line_direction"])
        u = u / np.linalg.norm(u)
        zero = machine.reflector(origin) - 3000.0 * u  # where the beam comes from
        dead = rng.uniform(-500, 500)
        found = np.empty((2, p["runs"], len(p["targets"])))
        for k in range(p["runs"]):
            for d in (0, 1):
                order = range(len(p["targets"]))
                for i in order if d == 0 else reversed(order):
                    place = machine.reflector(origin + p["targets"][i] * u) + (0 if d == 0 else machine.play) * u
                    along = (place - zero) @ u * (1 + machine.instrument) + rng.normal(0, 2e-4)
                    rows.append([line["id"], i + 1, "up" if d == 0 else "down", k + 1, repr(float(along + dead))])
                    found[d, k, i] = 1000.0 * (along - p["targets"][i])
        found -= np.mean([found[0, :, 0].mean(), found[1, :, 0].mean()])
        deviations[line["id"]] = (np.array(p["targets"]), u, found)
    table = folder / "lengths.csv"
    with table.open("w", newline="") as file:
        writer = csv.writer(file)
        writer.writerow(["line", "target", "direction", "run", "length_difference_mm"])
        writer.writerows(rows)
    return table, deviations


def slope_of(targets, means):
    x, y = targets - targets.mean(), means - means.mean()
    return 1000.0 * (x @ y) / (x @ x)


def check(program, rng, folder):
    machine = Machine(rng)
    travel = ",".join(f"{n}={float(a)}:{float(b)}" for n, a, b in zip("XYZ", machine.low, machine.high))
    plan_file = folder / "d.json"
    done = run(program, "tracking", "plan", "--travel", travel, "--tool", "0,0,-100", "--diagonals", "body,face",
               "--runs", 3, "--seed", int(rng.integers(1, 1000)), "--out", plan_file, "--sheet", folder / "d.html")
    assert "Station" not in done.stdout, done.stdout
    assert "From station" not in (folder / "d.html").read_text() and "nan" not in done.stdout
    plan = json.loads(plan_file.read_text())
    assert "station" not in plan["setup"] and "limits" not in plan["setup"]
    assert {line["id"] for line in plan["lines"]} == ALL and not plan["lost"]
    for line in plan["lines"]:
        axis = line["plan"]["axis"]
        for end in (axis["travel_begin"], axis["travel_end"]):
            place = np.array(axis["line_origin_mm"]) + end * np.array(axis["line_direction"])
            middle = (machine.low + machine.high) / 2
            for k in range(3):
                assert min(abs(place[k] - v) for v in (machine.low[k], machine.high[k], middle[k])) < 2e-3, line["id"]
    table, deviations = measure(machine, plan, rng, folder)
    result = json.loads(run(program, "tracking", "evaluate", table, "--plan", plan_file, "--json", "-",
                            codes=(0, 3)).stdout)
    assert "NaN" not in json.dumps(result)
    slopes = {}
    for line in result["lines"]:
        targets, u, found = deviations[line["id"]]
        up, down = found[0].mean(0), found[1].mean(0)
        slopes[line["id"]] = slope_of(targets, (up + down) / 2)
        close(line["id"] + " slope", line["slope"]["um_per_m"], slopes[line["id"]], 1e-6)
        parameters = line["test"]["parameters"]
        close("E", parameters["E"], max(up.max(), down.max()) - min(up.min(), down.min()), 1e-6)
        close("B", parameters["B"], np.abs(up - down).max(), 1e-6)
    for pair in result["iso230_6"]["face_pairs"]:
        i, k, first, second, term, sign = FACES[pair["face"]]
        assert pair["lines"] == [first, second] and pair["squareness"] == term
        a, b = machine.high[i] - machine.low[i], machine.high[k] - machine.low[k]
        diagonal = np.hypot(a, b)
        d1, d2 = (diagonal * (1 + 1e-6 * slopes[s]) for s in (first, second))
        angle = sign * 1e6 * np.arcsin((d2 ** 2 - d1 ** 2) / (4 * a * b))
        close(term, pair["um_per_m"], angle, 0.02)  # second order of 1e-4
        true = 1e6 * {"C0Y": machine.c, "B0Z": machine.b, "A0Z": machine.a}[term]
        close(term + " of the machine", pair["um_per_m"], true, 4 * pair["u_um_per_m"] + 0.05)
        u = [line["slope"]["u_um_per_m"] for line in result["lines"] if line["id"] in (first, second)]
        close("u of " + term, pair["u_um_per_m"], np.hypot(*u) * diagonal ** 2 / (2 * a * b), 1e-6)
    assert len(result["iso230_6"]["face_pairs"]) == 3
    for term in result["squareness"]["terms"]:
        if term["id"] == "C0Y":
            close("C0Y of all lines", term["um_per_m"], 1e6 * machine.c, 1.0)
    # --reversed: an instrument at the other end counts the other way
    rows = list(csv.reader(table.open()))
    with table.open("w", newline="") as file:
        csv.writer(file).writerows([rows[0]] + [r[:4] + [repr(-float(r[4]))] for r in rows[1:]])
    run(program, "tracking", "evaluate", table, "--plan", plan_file, "-q", codes=(2,))
    turned = json.loads(run(program, "tracking", "evaluate", table, "--plan", plan_file, "--reversed", "--json", "-",
                            codes=(0, 3)).stdout)
    close("reversed", turned["lines"][0]["slope"]["um_per_m"], result["lines"][0]["slope"]["um_per_m"], 1e-6)


def recorded(program, rng, folder):
    """The same out of a continuous recording, in which the interferometer is set up anew between two diagonals."""
    machine = Machine(rng)
    machine.play = 0.002
    travel = ",".join(f"{n}={float(a)}:{float(b)}" for n, a, b in zip("XYZ", machine.low, machine.high))
    plan_file = folder / "r.json"
    run(program, "tracking", "plan", "--travel", travel, "--tool", "0,0,-100", "--diagonals", "NN0-PP0,NP0-PN0",
        "--targets", 4, "--runs", 2, "--warm-up", 0, "--feed", 6000, "--dwell", 2, "--seed", 5, "--out", plan_file, "-q")
    plan, rate = json.loads(plan_file.read_text()), 20.0
    lengths, slopes = [], {}
    for line in plan["lines"]:
        p, axis = line["plan"], line["plan"]["axis"]
        origin, u = np.array(axis["line_origin_mm"]), np.array(axis["line_direction"])
        u = u / np.linalg.norm(u)
        zero, dead = machine.reflector(origin) - 3000.0 * u, rng.uniform(-500, 500)
        shown = lambda position, down: (machine.reflector(origin + position * u) + down * machine.play * u - zero) @ u + dead
        at = p["targets"][0] - p["overrun"]
        lengths += [shown(at, 0)] * int(5 * rate)

        def go(to, down, rest_s):
            nonlocal at
            steps = max(2, int(abs(to - at) / (p["feed"] / 60) * rate) + int(rate))
            lengths.extend(shown(at + (to - at) * k / steps, down) for k in range(1, steps))
            lengths.extend([shown(to, down)] * int(rest_s * rate))
            at = to

        for _ in range(p["runs"]):
            for target in p["targets"]:
                go(target, 0, p["dwell_s"])
            go(p["targets"][-1] + p["overrun"], 0, 0)
            for target in reversed(p["targets"]):
                go(target, 1, p["dwell_s"])
            go(p["targets"][0] - p["overrun"], 1, 0)
        lengths += [shown(at, 1)] * int(5 * rate)
        deviation = [1000.0 * (shown(x, 0) - x) for x in p["targets"]]
        slopes[line["id"]] = slope_of(np.array(p["targets"]), np.array(deviation))
    lengths = np.array(lengths) + rng.normal(0, 1e-4, len(lengths))
    recording = folder / "run.csv"
    recording.write_text("time_s,length_mm\n" + "".join(f"{k / rate:.3f},{x:.7f}\n" for k, x in enumerate(lengths)))
    result = json.loads(run(program, "tracking", "evaluate", recording, "--plan", plan_file, "--json", "-",
                            codes=(0, 3)).stdout)
    assert result["source"]["format"] == "time-position"
    for line in result["lines"]:
        assert line["test"]["parameters"]["B"] is not None
        close(line["id"] + " recorded", line["slope"]["um_per_m"], slopes[line["id"]], 0.5)
    assert {line["id"] for line in result["lines"]} == set(slopes)


def refusals(program, folder):
    travel = ["tracking", "plan", "--travel", "X=0:800,Y=0:600,Z=-500:0"]
    for more, words in [(["--lines", "x", "--diagonals", "body"], "found no station"),
                        ([], "found no station"), (["--diagonals", "body", "--range", "0.2m:15m"], "without a station"),
                        (["--diagonals", "body", "--suggest"], "without a station"),
                        (["--diagonals", "body", "--incidence", "30"], "without a station"),
                        (["--diagonals", "body", "--locate", "6", "--points", folder / "p.csv"], "found")]:
        done = run(program, *travel, *more, "--out", folder / "none.json", codes=(1, 2))
        assert words in done.stderr, (more, done.stderr)


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    count = int(sys.argv[2]) if len(sys.argv) > 2 else 5
    rng = np.random.default_rng(int(sys.argv[3]) if len(sys.argv) > 3 else 19)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for _ in range(count):
            check(program, rng, folder)
        recorded(program, rng, folder)
        refusals(program, folder)
    print(f"{count} machines: diagonals without a station, their slopes and the squareness of their faces agree")


if __name__ == "__main__":
    main()
