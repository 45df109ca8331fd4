# SPDX-License-Identifier: Apache-2.0
"""A made-up axis that walks a plan: what an instrument would send. No third-party modules."""
import json
import math
import random

PLAN = {
    "format": "axiometry-plan/1", "axis": {"name": "X", "kind": "linear"}, "cycle": "standard",
    "targets": [10, 35.5, 62, 84, 110.2], "runs": 3, "overrun": 5, "feed": 6000, "dwell_s": 0.8,
}


def deviation_mm(target, up, run):
    return 0.001 * target - (0 if up else 0.003) + 0.0005 * run


def stops(plan=PLAN):
    """Position, dwell and approach (or None) of every move of the standard cycle."""
    targets, overrun, dwell = plan["targets"], plan["overrun"], plan["dwell_s"]
    yield targets[0] - overrun, 0, None
    for run in range(plan["runs"]):
        for up in (True, False):
            numbers = range(len(targets)) if up else range(len(targets) - 1, -1, -1)
            for i in numbers:
                yield targets[i] + deviation_mm(i, up, run), dwell, (i + 1, "↑" if up else "↓", run + 1)
            yield (targets[-1] + overrun if up else targets[0] - overrun), 0, None


def samples(rate, plan=PLAN, noise=0.0001, seed=1):
    """Time and position of every sample."""
    rng = random.Random(seed)
    at, number = plan["targets"][0] + 3.0, 0

    def sample(x):
        nonlocal number
        number += 1
        return (number - 1) / rate, x + rng.gauss(0, noise)

    for _ in range(int(rate / 2)):
        yield sample(at)
    for position, dwell, _ in stops(plan):
        count = max(1, int(rate * 1.5 * abs(position - at) / (plan["feed"] / 60)))
        for k in range(count):
            u = k / count
            yield sample(at + (position - at) * u * u * (3 - 2 * u))
        for _ in range(int(rate * dwell)):
            yield sample(position)
        at = position
    for k in range(int(rate / 2)):
        yield sample(at + 10 * math.sin(k / rate))


def text(rate, **options):
    return [f"{t:.4f} {x:.5f}\n".encode() for t, x in samples(rate, **options)]


def write_plan(name):
    with open(name, "w", encoding="utf-8") as file:
        json.dump(PLAN, file)
