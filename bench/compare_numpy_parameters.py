#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The twelve parameters of 100 000 tests, by axiometry.parameters() and by numpy.

Usage: PYTHONPATH=build/release/python compare_numpy_parameters.py [TESTS]
"""
import os
import pathlib
import sys
import time

import numpy as np

import axiometry

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "tests/python"))
from clause_3 import by_numpy  # noqa: E402


def main():
    os.sched_setaffinity(0, {0})
    tests = int(sys.argv[1]) if len(sys.argv) > 1 else 100_000
    up, down = np.random.default_rng(1).normal(size=(2, tests, 11, 5))
    seconds = {axiometry.parameters: [], by_numpy: []}
    for _ in range(5):
        found = {}
        for way, times in seconds.items():
            begun = time.perf_counter()
            found[way] = way(up, down)
            times.append(time.perf_counter() - begun)
    ours, theirs = found.values()
    print(f"largest difference {max(abs(ours[key] - theirs[key]).max() for key in theirs):.1e}")
    for way, times in seconds.items():
        print(f"{way.__module__}.{way.__name__}: {min(times):.3f} s")
    print(f"ratio {min(seconds[by_numpy]) / min(seconds[axiometry.parameters]):.1f}")


if __name__ == "__main__":
    main()
