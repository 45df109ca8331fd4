#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Measures simulated axes twice, by an interferometer and by probing an artefact, and holds the results together.

Usage: tests/artefact_oracle.py PROGRAM [TESTS]

The axis has a known error e(q, direction): where its scale indicates q, the functional point is at q + e. The
interferometer reads e at the targets. Probing finds the q at which q + e is the true place of a ball, which the
calibration and the temperature of the artefact tell. The parameters of both must agree, to what the error changes between
target and ball, and so must every mean deviation.
"""
import json
import math
import random
import subprocess
import sys
import tempfile

PROGRAM = sys.argv[1]
TESTS = int(sys.argv[2]) if len(sys.argv) > 2 else 40


def evaluate(head, targets, runs, quantity, *options):
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        file.write("\n".join(f"# {line}" for line in head) + f"\ntarget,direction,run,{quantity}\n")
        for (direction, j), values in runs.items():
            file.writelines(f"{t!r},{direction},{j + 1},{v!r}\n" for t, v in zip(targets, values))
        file.flush()
        done = subprocess.run([PROGRAM, "evaluate", file.name, "-q", "--json", "-", *options], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def compare(seed):
    rng = random.Random(seed)
    m = rng.randint(5, 14)
    step = rng.uniform(15, 60)
    targets = [round(rng.uniform(-300, 300) + 0.0, 3)]
    for _ in range(m - 1):
        targets.append(round(targets[-1] + step * rng.uniform(0.9, 1.1), 3))
    slope, wave, length, backlash = rng.uniform(-0.03, 0.03), rng.uniform(0, 2), rng.uniform(50, 200), rng.uniform(-3, 3)

    def error_um(q, direction):
        return (slope * (q - targets[0]) + wave * math.sin((q - targets[0]) / length)
                + (backlash if direction == "down" else 0.0))

    def indicated(place, direction, noise_um):
        q = place
        for _ in range(40):
            q = place - 1e-3 * (error_um(q, direction) + noise_um)
        return q

    alpha, temperature = rng.choice([0.0, 8.0, 11.5]), rng.uniform(18, 24)
    origin = rng.uniform(-50, 50)
    calibrated = [round(origin + t - targets[0] + rng.gauss(0, 0.003), 5) for t in targets]
    strain = 1e-6 * alpha * (temperature - 20)
    laser, probe = {}, {}
    for j in range(5):
        for direction in ("up", "down"):
            noise = [rng.gauss(0, 0.2) for _ in targets]
            laser[direction, j] = [error_um(t, direction) + e for t, e in zip(targets, noise)]
            places = [targets[0] + (c - calibrated[0]) * (1 + strain) for c in calibrated]
            probe[direction, j] = [indicated(p, direction, e) for p, e in zip(places, noise)]
    by_laser = evaluate(["unit: um", "target unit: mm"], targets, laser, "deviation")
    head = ["unit: mm", "target unit: mm", "quantity: position",
            "artefact.calibrated_positions: " + " ".join(map(repr, calibrated)),
            f"nde.equipment_expansion_um_per_m_C: {alpha!r}",
            f"sensors: equipment | artefact | {temperature!r} | {temperature!r}"]
    by_artefact = evaluate(head, targets, probe, "position")
    # Balls stand some µm off the targets (expansion, calibration): the slope there, at most 0.07 µm/mm, times that.
    tolerance = 0.07 * (0.02 + abs(strain) * (targets[-1] - targets[0])) + 1e-6
    failures = []
    for key, expected in by_laser["parameters"].items():
        if abs(by_artefact["parameters"][key] - expected) > 2 * tolerance:
            failures.append(f"test {seed}: {key} is {by_artefact['parameters'][key]} by artefact, {expected} by interferometer")
    for a, b in zip(by_artefact["positions"], by_laser["positions"]):
        for key in ("mean_up", "mean_down", "mean"):
            if abs(a[key] - b[key]) > tolerance:
                failures.append(f"test {seed}: {key} at {b['target']} is {a[key]} by artefact, {b[key]} by interferometer")
    return failures


def main():
    failures = [failure for seed in range(TESTS) for failure in compare(seed)]
    print("\n".join(failures[:20] + [f"{TESTS} axes measured twice, {len(failures)} differences"]))
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
