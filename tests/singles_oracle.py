#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Machines with random errors, measured one error after the other, put together by the program.

Usage: tests/singles_oracle.py PROGRAM [COUNT] [SEED]

The script has the first-order kinematics of its own: δ = Σ E_a + ω_a × r_a and squareness. From random errors it makes what
instruments would read along one line for each axis, rotations with an unknown zero, straightness with an unknown zero and
slope, and squareness as the angle between the lines' best straight directions. `axiometry volumetric assemble` and `field --at`
must give the error of the tool point anywhere, but for a motion of the whole machine; and standard uncertainties that agree
with the scatter of the same chain under noise. The same once more from the JSON of `axiometry straightness`, `angles` and
`squareness`, to which the instruments' signs are told.
"""
import json
import subprocess
import sys
import tempfile

import numpy as np

CHAINS = ["FXYZ", "XFYZ", "YXFZ", "ZYXF", "XYFZ", "YFZX", "FZYX"]
NODES = 6
LOWER, UPPER = np.array([0.0, -100.0, -500.0]), np.array([900.0, 500.0, -80.0])
TOOL = np.array([30.0, -20.0, -150.0])
ERRORS = [f"E{m}{a}" for a in "XYZ" for m in "XYZABC"]


def levers(chain, q, t):
    order = [c for c in chain if c != "F"]
    workpiece = chain.split("F")[0]
    r = np.zeros((3, 3))
    for k, a in enumerate(order):
        i = "XYZ".index(a)
        r[i] = t
        for b in order[k + 1:]:
            r[i]["XYZ".index(b)] += q["XYZ".index(b)]
        if a in workpiece:
            r[i][i] += q[i]
    return r


def field(machine, q):
    r = levers(machine["chain"], q, TOOL)
    d = np.zeros(3)
    for a in range(3):
        e = [np.interp(q[a], machine["nodes"][a], machine["curves"][a][m]) for m in range(6)]
        d += np.array(e[:3]) + 1e-3 * np.cross(e[3:], r[a])
    c, b, a = machine["square"]
    return d + 1e-3 * np.array([-c * q[1] + b * q[2], -a * q[2], 0.0])


def slope(q, y):
    """µrad, of the straight line that is best over the travel for the curve of straight lines between the nodes."""
    x = np.linspace(q[0], q[-1], 20001)
    return 1e3 * np.polyfit(x, np.interp(x, q, y), 1)[0]


def measure(machine, rng, noise):
    readings, slopes = {}, {}
    for a, axis in enumerate("XYZ"):
        for m, letter in enumerate("XYZABC"):
            values = []
            for n, at in enumerate(machine["nodes"][a]):
                q = machine["stood"][a].copy()
                q[a] = at
                values.append(field(machine, q)[m] if m < 3 else machine["curves"][a][m][n] + 55.0)
            values = np.array(values)
            if m < 3 and m != a:
                slopes[letter + axis] = slope(machine["nodes"][a], values)
                values = values + 3.0 + 0.02 * machine["nodes"][a]  # the straightedge lies as it lies
            readings[f"E{letter}{axis}"] = values + rng.normal(0, noise, NODES)
    square = {"C0Y": -slopes["XY"] - slopes["YX"], "B0Z": slopes["XZ"] + slopes["ZX"], "A0Z": -slopes["YZ"] - slopes["ZY"]}
    return readings, {k: v + rng.normal(0, noise) for k, v in square.items()}


def program_field(program, machine, readings, square, places, folder, noise, results=None):
    with open(folder + "/machine.json", "w", encoding="utf-8") as out:
        json.dump({"chain": machine["chain"], "travel_mm": {a: [LOWER[k], UPPER[k]] for k, a in enumerate("XYZ")},
                   "tools_mm": {"T": list(TOOL)},
                   "functional_point_mm": {a: [0, 0, 0] for a in "XYZ"}}, out)
    items = [f"{k}={v!r},{2 * noise!r}".replace("np.float64(", "").replace(")", "") for k, v in square.items()]
    instruments = []
    for name, values in readings.items():
        a = "XYZ".index(name[2])
        file = f"{folder}/{name}.csv"
        with open(file, "w", encoding="utf-8") as out:
            if name[1] == name[2]:
                out.write("# axis.name: " + name[2] + "\ntarget_mm,run,direction,deviation_um\n")
                out.writelines(f"{q:.17g},1,up,{v:.17g}\n" for q, v in zip(machine["nodes"][a], values))
            else:
                out.write(f"position_mm,{name}_{'um' if name[1] in 'XYZ' else 'urad'},direction\n")
                out.writelines(f"{q:.17g},{v:.17g},up\n" for q, v in zip(machine["nodes"][a], values))
        items.append(f"{name}={file}")
        instruments += ["--instrument", f"{name}={2 * noise:.17g}"]
    if results is not None:  # positions stay as they are
        kept = [item for item in items if item[0] == "E" and item[1] == item[2]]
        items, instruments = kept + results, [f"--instrument={item[:3]}=1" for item in kept]
    stood = [f"--at={a}={','.join(f'{x:.17g}' for x in machine['stood'][k])}@T" for k, a in enumerate("XYZ")]
    with open(folder + "/points.csv", "w", encoding="utf-8") as out:
        out.write("tool,x_mm,y_mm,z_mm\n")
        out.writelines(f"T,{q[0]:.17g},{q[1]:.17g},{q[2]:.17g}\n" for q in places)
    made = subprocess.run([program, "volumetric", "assemble", *items, "--machine", folder + "/machine.json", *instruments,
                           *stood, "--out", folder + "/result.json", "-q"], capture_output=True, text=True, timeout=120)
    if made.returncode != 0:
        sys.exit(f"assemble: {made.returncode}: {made.stderr}")
    done = subprocess.run([program, "volumetric", "field", folder + "/result.json", "--at", folder + "/points.csv", "--json",
                           "-"], capture_output=True, text=True, timeout=120)
    if done.returncode != 0:
        sys.exit(f"field: {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def results_of(program, machine, readings, rng, folder):
    """The errors as JSON of their own verbs, out of readings by sensors that are positive either way."""
    def run(verb, files, senses, out, *more):
        done = subprocess.run([program, verb, *files, f"--positive={','.join(senses)}", "--json", out, "-q", *more],
                              capture_output=True, text=True, timeout=120)
        if done.returncode != 0:
            sys.exit(f"{verb}: {done.returncode}: {done.stderr}")
        return out

    def read(name):
        sign = rng.choice([-1, 1])
        file = f"{folder}/sensor-{name}.csv"
        with open(file, "w", encoding="utf-8") as out:
            out.write(f"position_mm,run,direction,{name}_{'um' if name[1] in 'XYZ' else 'urad'}\n")
            # Runs that agree in all say nothing of how good they are: these turn by next to nothing, about their mean.
            out.writelines(f"{q:.17g},{run},up,{sign * v + turned * k:.17g}\n" for run, turned in ((1, 1e-6), (2, -1e-6))
                           for k, (q, v) in enumerate(zip(machine["nodes"]["XYZ".index(name[2])], readings[name])))
        return file, ("+" if sign > 0 else "-") + name[1]

    items = []
    for name in readings:
        if name[1] != name[2]:
            file, sense = read(name)
            verb = "straightness" if name[1] in "XYZ" else "angles"
            items.append(f"{name}={run(verb, [file], [sense], f'{folder}/{name}.json')}")
    for name, pair in (("C0Y", ("EYX", "EXY")), ("B0Z", ("EXZ", "EZX")), ("A0Z", ("EYZ", "EZY"))):
        lines = [read(line) for line in (pair if rng.random() < 0.5 else pair[::-1])]
        reference = str(rng.choice(["least-squares", "end-points"]))
        items.append(f"{name}=" + run("squareness", [f for f, _ in lines], [s for _, s in lines], f"{folder}/{name}.json",
                                      "--reference", reference))
    return items


def without_motion(places, d):
    rows = np.concatenate([np.c_[np.eye(3), [[0, q[2], -q[1]], [-q[2], 0, q[0]], [q[1], -q[0], 0]]] for q in places])
    motion = np.linalg.lstsq(rows, d.ravel(), rcond=None)[0]
    return (d.ravel() - rows @ motion).reshape(-1, 3)


def main():
    program = sys.argv[1]
    count = int(sys.argv[2]) if len(sys.argv) > 2 else len(CHAINS)
    rng = np.random.default_rng(int(sys.argv[3]) if len(sys.argv) > 3 else 20260119)
    for k in range(count):
        machine = {"chain": CHAINS[k % len(CHAINS)], "nodes": [np.linspace(LOWER[a], UPPER[a], NODES) for a in range(3)],
                   "curves": rng.normal(0, 10, (3, 6, NODES)), "square": rng.normal(0, 30, 3),
                   "stood": [rng.uniform(LOWER, UPPER) for _ in range(3)]}
        places = rng.uniform(LOWER, UPPER, (25, 3))
        with tempfile.TemporaryDirectory() as folder:
            readings, square = measure(machine, rng, 0.0)
            answer = program_field(program, machine, readings, square, places, folder, 0.5)
            points = answer["points"] if isinstance(answer, dict) else answer
            got = np.array([p["error_um"] for p in points], dtype=float)
            true = np.array([field(machine, q) for q in places])
            rest = without_motion(places, got - true)
            assert np.abs(rest).max() < 2e-3, (machine["chain"], np.abs(rest).max())  # slopes of a fine grid
            # Without a slope of the straightedge: each line of the squareness is read against the same one.
            level = {name: values - (3.0 + 0.02 * machine["nodes"]["XYZ".index(name[2])]
                                     if name[1] in "XYZ" and name[1] != name[2] else 0.0)
                     for name, values in readings.items()}
            told = program_field(program, machine, level, square, places, folder, 0.5,
                                 results_of(program, machine, level, np.random.default_rng(k), folder))
            told = told["points"] if isinstance(told, dict) else told
            rest = without_motion(places, np.array([p["error_um"] for p in told], dtype=float) - true)
            assert np.abs(rest).max() < 1e-6, (machine["chain"], "from results", np.abs(rest).max())
            if k < 2:
                u = np.array([np.sqrt(np.diag(np.reshape(p["covariance_um2"], (3, 3)))) for p in points])
                trials = []
                for _ in range(60):
                    noisy, noisy_square = measure(machine, rng, 0.5)
                    again = program_field(program, machine, noisy, noisy_square, places, folder, 0.5)
                    again = again["points"] if isinstance(again, dict) else again
                    trials.append([p["error_um"] for p in again])
                ratio = np.sqrt((np.std(np.array(trials, dtype=float), axis=0) ** 2).mean() / (u ** 2).mean())
                assert 0.85 < ratio < 1.15, (machine["chain"], ratio)
    print(f"{count} machines put together from single measurements agree")


if __name__ == "__main__":
    main()
