#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The same work twice in one run: a CSV of many tests evaluated by axiometry and by pandas/numpy.

Usage: bench/compare_pandas.py PROGRAM BIG.csv [RUNS]

Work: read the file, evaluate the twelve parameters of every test, write one CSV row per test.
Prints seconds, MB/s, peak memory and the ratio of each pair of runs, and checks that both agree.
The pandas side is vectorised over all tests of one shape; it may hold the whole file in memory.
"""
import os
import statistics
import subprocess
import sys
import tempfile
import time


def evaluate_with_pandas(source, target):
    import numpy as np
    import pandas as pd

    frame = pd.read_csv(source, dtype={"test": "category", "direction": "category"})
    frame = frame.sort_values(["test", "direction", "target_mm", "run"], kind="stable")
    tests = frame["test"].cat.categories
    n = int(frame["run"].max())
    m = len(frame) // (len(tests) * 2 * n)
    directions = list(frame["direction"].cat.categories)
    x = frame["deviation_um"].to_numpy().reshape(len(tests), 2, m, n)
    up, down = x[:, directions.index("up")], x[:, directions.index("down")]
    mean_up, mean_down = up.mean(-1), down.mean(-1)
    s_up, s_down = up.std(-1, ddof=1), down.std(-1, ddof=1)
    mean, reversal = (mean_up + mean_down) / 2, mean_up - mean_down
    R_i = np.maximum(2 * s_up + 2 * s_down + abs(reversal), np.maximum(4 * s_up, 4 * s_down))
    high_up, low_up = (mean_up + 2 * s_up).max(-1), (mean_up - 2 * s_up).min(-1)
    high_down, low_down = (mean_down + 2 * s_down).max(-1), (mean_down - 2 * s_down).min(-1)
    result = pd.DataFrame({
        "A": np.maximum(high_up, high_down) - np.minimum(low_up, low_down),
        "A_up": high_up - low_up,
        "A_down": high_down - low_down,
        "E": np.maximum(mean_up.max(-1), mean_down.max(-1)) - np.minimum(mean_up.min(-1), mean_down.min(-1)),
        "E_up": np.ptp(mean_up, -1),
        "E_down": np.ptp(mean_down, -1),
        "M": np.ptp(mean, -1),
        "R": R_i.max(-1),
        "R_up": 4 * s_up.max(-1),
        "R_down": 4 * s_down.max(-1),
        "B": abs(reversal).max(-1),
        "B_mean": reversal.mean(-1),
    }, index=tests)
    result.to_csv(target, index_label="test")


def timed(command):
    before = time.monotonic()
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status:
        sys.exit(f"{command} failed")
    return time.monotonic() - before, usage.ru_maxrss / 1024


def check_agreement(ours, theirs):
    import pandas as pd

    a = pd.read_csv(ours).set_index("test")
    b = pd.read_csv(theirs).set_index("test")
    worst = max((a.loc[b.index, key] - b[key]).abs().max() for key in b.columns)
    print(f"largest difference of any parameter of any of {len(b)} tests: {worst:.1e} um")
    if not worst < 1e-9:
        sys.exit("the results differ")


def main():
    if sys.argv[1] == "--pandas":
        return evaluate_with_pandas(sys.argv[2], sys.argv[3])
    program, source = sys.argv[1:3]
    runs = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    megabytes = os.path.getsize(source) / 1e6
    with tempfile.TemporaryDirectory() as folder:
        ours, theirs = f"{folder}/ours.csv", f"{folder}/theirs.csv"
        one_core = ["taskset", "-c", "0"]
        us = one_core + [program, "evaluate", source, "--quiet", "--report", ours]
        them = one_core + [sys.executable, __file__, "--pandas", source, theirs]
        pairs = [(timed(us), timed(them)) for _ in range(runs)]
        check_agreement(ours, theirs)
    for name, side in (("axiometry", 0), ("pandas", 1)):
        seconds = statistics.median(pair[side][0] for pair in pairs)
        memory = max(pair[side][1] for pair in pairs)
        print(f"{name:10} {seconds:8.2f} s  {megabytes / seconds:8.1f} MB/s  {memory:8.1f} MiB peak")
    print(f"ratio      {statistics.median(p[1][0] / p[0][0] for p in pairs):8.1f} (median of {runs} pairs, one core)")


if __name__ == "__main__":
    main()
