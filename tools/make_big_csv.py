#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Writes a CSV file of many tests for benchmarks: columns test,target_mm,direction,run,deviation_um;
11 targets, both directions, 5 runs, so 110 rows per test. The same seed gives the same bytes.

    tools/make_big_csv.py --tests 100000 big.csv      # about 300 MB
"""
import argparse
import random
import sys

TARGETS = ["6.711", "175.077", "353.834", "525.668", "704.175", "881.868", "1055.890", "1234.304", "1408.462",
           "1580.269", "1750.920"]
RUNS = 5


def approaches():
    """Target, direction and run of every row of a test, in the order of the standard test cycle."""
    for run in range(1, RUNS + 1):
        for i in range(len(TARGETS)):
            yield i, "up", run
        for i in reversed(range(len(TARGETS))):
            yield i, "down", run


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("file", help="where to write; - for the standard output")
    parser.add_argument("--tests", type=int, default=100_000)
    parser.add_argument("--seed", type=int, default=230)
    arguments = parser.parse_args()

    generator = random.Random(arguments.seed)
    # A thousand different tests, repeated: making random numbers would take longer than evaluating them.
    heads = [f",{TARGETS[i]},{direction},{run}," for i, direction, run in approaches()]
    bodies = []
    for _ in range(1000):
        slope, reversal = generator.uniform(-3, 3), generator.uniform(0, 4)
        rows = []
        for head, (i, direction, _run) in zip(heads, approaches()):
            mean = slope * i / 10 + (reversal if direction == "down" else 0)
            rows.append(f"{head}{generator.gauss(mean, 0.4):.1f}\n")
        bodies.append(rows)

    out = sys.stdout if arguments.file == "-" else open(arguments.file, "w", encoding="ascii", newline="\n")
    out.write("test,target_mm,direction,run,deviation_um\n")
    for test in range(arguments.tests):
        name = f"T{test + 1:06d}"
        out.write(name + name.join(bodies[test % len(bodies)]))
    if out is not sys.stdout:
        out.close()


if __name__ == "__main__":
    main()
