#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Holds the uncertainty of the station of a tracking interferometer against draws of its own.

Usage: tests/station_uncertainty_oracle.py PROGRAM [TESTS]   (needs numpy)

A made-up line is read by an instrument at an exactly drawn place beside it: distances are those of points in space, no
formula of the program is used. For the budget of Annex A, the range of the length difference must stay below U_STATION in
95 % of the draws; for the Monte Carlo method, mean, u and interval of every parameter must agree with the drawn ones; for the
law of propagation, u must be the root of mean square of the error, to what linearity leaves. Then coverage: of many
tests whose truth is known the intervals must hold it as often as they claim.
"""
import json
import subprocess
import sys
import tempfile

import numpy as np

PROGRAM = sys.argv[1]
TESTS = int(sys.argv[2]) if len(sys.argv) > 2 else 6
DRAWS = 400_000


def evaluate(targets, up, down, at, u, *options):
    head = ["unit: um", "target unit: mm", f"tracking.station_position: {at!r}",
            f"tracking.station_uncertainty_mm: {u[0]!r} {u[1]!r}"]
    with tempfile.NamedTemporaryFile("w", suffix=".csv") as file:
        file.write("\n".join(f"# {line}" for line in head) + "\ntarget,direction,run,deviation\n")
        for direction, runs in (("up", up), ("down", down)):
            for j, run in enumerate(runs):
                file.writelines(f"{t!r},{direction},{j + 1},{float(x)!r}\n" for t, x in zip(targets, run))
        file.flush()
        done = subprocess.run([PROGRAM, "evaluate", file.name, "-q", "--json", "-", *options], capture_output=True, text=True)
    if done.returncode:
        raise SystemExit(f"exit {done.returncode}: {done.stderr}")
    return json.loads(done.stdout)


def errors_um(targets, at, offsets):
    """What the readings are wrong by for each offset (rows): lengths from a point in space, against the farthest target."""
    along = np.asarray(targets) - at
    # np.longdouble: the difference of two lengths of a metre would lose what counts.
    lengths = np.sqrt(along.astype(np.longdouble) ** 2 + np.sum(offsets.astype(np.longdouble) ** 2, axis=1)[:, None])
    shown = np.sign(along) * (lengths - np.abs(along))
    far = np.argmax(np.abs(along))
    return (1000 * (shown - np.sign(along) * np.abs(shown[:, [far]]))).astype(float)


def parameters(up, down):
    """E, E↑, E↓, M of mean deviations (rows)."""
    both = np.concatenate([up, down], axis=1)
    middle = (up + down) / 2
    return {"E": np.ptp(both, axis=1), "E_up": np.ptp(up, axis=1), "E_down": np.ptp(down, axis=1), "M": np.ptp(middle, axis=1)}


def a_line(rng):
    m = int(rng.integers(5, 12))
    near, far = rng.uniform(150, 400), rng.uniform(900, 2000)
    at = float(np.round(rng.uniform(-500, 500), 3))
    side = rng.choice([-1, 1])
    targets = np.sort(np.round(at + side * np.linspace(near, far, m) + rng.uniform(-5, 5, m), 3)).tolist()
    slope, backlash = rng.uniform(-8, 8), rng.uniform(-3, 3)
    up = slope * (np.array(targets) - targets[0]) / 1000 + rng.normal(0, 1, m)
    return targets, at, up, up + backlash + rng.normal(0, 0.2, m)


def compare(seed):
    rng = np.random.default_rng(seed)
    targets, at, up, down = a_line(rng)
    u = sorted(np.round(rng.uniform(0.05, 2.5, 2), 3).tolist(), reverse=True)
    if seed % 3 == 0:
        u[1] = 0.0
    offsets = rng.normal(size=(DRAWS, 2)) * u
    errors = errors_um(targets, at, offsets)
    failures = []

    def expect(what, found, expected, tolerance):
        if not abs(found - expected) <= tolerance:
            failures.append(f"test {seed}: {what} is {found}, by draws {expected} ± {tolerance}")

    annex = evaluate(targets, [up, up], [down, down], at, u)
    U = annex["uncertainty"]["annex_a"]["E"]
    below = np.mean(np.ptp(np.concatenate([errors, 0 * errors[:, :1]], axis=1), axis=1) <= U)
    expect("share of draws below U_STATION", below, 0.95, 0.002)

    measured = {key: value[0] for key, value in parameters(up[None, :], down[None, :]).items()}
    drawn = parameters(up - errors, down - errors)
    result = evaluate(targets, [up, up], [down, down], at, u, "--uncertainty", "gum,monte-carlo", "--trials", "200000")
    for key, values in drawn.items():
        found = result["uncertainty"]["monte_carlo"][key]
        sd = np.std(values)
        expect(f"{key}: mean", found["mean"], np.mean(values), 0.012 * sd + 1e-9)
        expect(f"{key}: u", found["u"], sd, 0.03 * sd + 1e-9)
        low, high = np.quantile(values, [0.025, 0.975])
        expect(f"{key}: low", found["symmetric"][0], low, 0.05 * sd + 1e-9)
        expect(f"{key}: high", found["symmetric"][1], high, 0.05 * sd + 1e-9)
        expect(f"{key}: measured", found["value"], measured[key], 1e-9)

    # To first order the error of E is that at the targets where it is measured to be, its mean not corrected.
    means, wrong = np.concatenate([up, down]), np.concatenate([errors, errors], axis=1)
    linear = wrong[:, np.argmax(means)] - wrong[:, np.argmin(means)]
    found = result["uncertainty"]["gum"]["E"]
    if found is None:
        expect("E of the law of propagation", 0.0, np.sqrt(np.mean(linear**2)), 1e-9)
    else:
        expect("E of the law of propagation: u", found["u"], np.sqrt(np.mean(linear**2)), 0.02 * found["u"])
    return failures


def coverage(tests):
    """How often the intervals of E hold the truth that a wrong station has hidden, by method."""
    rng = np.random.default_rng(1)
    held = {"annex_a": 0, "gum": 0, "monte_carlo": 0}
    u = [0.9, 0.9]
    for _ in range(tests):
        targets, at, up, down = a_line(rng)
        # A steep line: E is that between its ends, whatever the station.
        slope = np.sign(up[-1] - up[0]) * 60 * (np.array(targets) - targets[0]) / 1000
        up, down = up + slope, down + slope
        truth = parameters(up[None, :], down[None, :])["E"][0]
        error = errors_um(targets, at, rng.normal(size=(1, 2)) * u)[0]
        result = evaluate(targets, [up + error] * 2, [down + error] * 2, at, u, "--uncertainty", "gum,monte-carlo",
                          "--trials", "10000")
        value, stated = result["parameters"]["E"], result["uncertainty"]
        held["annex_a"] += abs(value - truth) <= stated["annex_a"]["E"]
        held["gum"] += abs(value - truth) <= stated["gum"]["E"]["U"]
        low, high = stated["monte_carlo"]["E"]["symmetric"]
        held["monte_carlo"] += low <= truth <= high
    print({key: f"{100 * count / tests:.1f} %" for key, count in held.items()})
    # Exact shares: 95, 94.1 and 95 %; four standard deviations of a count are allowed.
    return [f"{key} holds {held[key]} of {tests}" for key, share in (("annex_a", 0.95), ("gum", 0.941), ("monte_carlo", 0.95))
            if abs(held[key] / tests - share) > 4 * np.sqrt(share * (1 - share) / tests)]


def main():
    failures = [line for seed in range(1, TESTS + 1) for line in compare(seed)] + coverage(40 * TESTS)
    print("\n".join(failures) or f"{TESTS} lines agree with {DRAWS} draws each")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
