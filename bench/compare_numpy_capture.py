#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The same work twice in one run: the readings of a plan out of a long recording, by axiometry and by numpy.

Usage: bench/compare_numpy_capture.py PROGRAM [SAMPLES [RUNS]]

Work: read a .npy of time and position, find where the axis rests, average there, give every reading to its approach.
The numpy side is what one would write: windows of fixed length, their ranges against a threshold, runs of quiet windows,
their means. It takes no care of outliers, gaps, directions or a threshold, and holds the whole file in memory (mapped).
Prints seconds of the processor, samples per second, peak memory and the ratio of each pair of runs, and checks that both agree.
"""
import json
import os
import statistics
import subprocess
import sys
import tempfile

RATE = 20_000.0
TARGETS = [10, 160.5, 322, 484, 650.2, 801, 967.3, 1120, 1301.7, 1450, 1602.4]
OVERRUN, FEED, RUNS = 5.0, 6000.0, 5


def make_run(name, samples):
    """A run of the standard cycle whose dwell makes it so many samples long."""
    import numpy as np

    stops = [(TARGETS[0] - OVERRUN, False)]
    for run in range(RUNS):
        for up in (True, False):
            order = TARGETS if up else TARGETS[::-1]
            stops += [(p + 1e-3 * run - (0 if up else 3e-3), True) for p in order]
            stops.append((TARGETS[-1] + OVERRUN if up else TARGETS[0] - OVERRUN, False))
    moving, at = 0.0, TARGETS[0]
    for p, _ in stops:
        moving += 1.5 * abs(p - at) / (FEED / 60)
        at = p
    dwell = max(0.5, (samples / RATE - moving - 1) / sum(d for _, d in stops))
    array = np.lib.format.open_memmap(name, mode="w+", dtype="<f8", shape=(samples, 2))
    rng = np.random.default_rng(1)
    k, at = 0, TARGETS[0]
    for p, dwells in stops:
        n = max(1, int(1.5 * abs(p - at) / (FEED / 60) * RATE))
        u = np.arange(n) / n
        for part in (at + (p - at) * u * u * (3 - 2 * u), np.full(int(dwell * RATE) if dwells else 0, p)):
            part = part[:samples - k]
            array[k:k + len(part), 1] = part + rng.normal(0, 1e-4, len(part))
            k += len(part)
        at = p
    array[k:, 1] = at + 0.01 * np.arange(samples - k)
    array[:, 0] = np.arange(samples) / RATE
    array.flush()
    return dwell


def capture_with_numpy(source, target, dwell):
    import numpy as np

    data = np.load(source, mmap_mode="r")
    window = int(min(max(dwell / 4, 0.1), 1.0) / 4 * RATE)
    count = len(data) // window
    blocks = data[:count * window].reshape(count, window, 2)
    positions = blocks[:, :, 1]
    low, high = positions.min(axis=1), positions.max(axis=1)
    quiet = (high - low) < 0.005
    edges = np.flatnonzero(np.diff(np.concatenate([[0], quiet.astype(np.int8), [0]])))
    readings = []
    for begin, end in zip(edges[::2], edges[1::2]):
        if end - begin < 8:
            continue
        used = positions[begin + 4:end - 1]
        mean = used.mean()
        nearest = min(TARGETS, key=lambda p: abs(p - mean))
        if abs(nearest - mean) < 2:
            readings.append([nearest, (mean - nearest) * 1000, used.std(ddof=1) * 1000])
    with open(target, "w", encoding="utf-8") as file:
        json.dump(readings, file)


def timed(command):
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL)
    _, status, usage = os.wait4(child.pid, 0)
    if status:
        sys.exit(f"{command} failed")
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024


def check_agreement(ours, theirs):
    with open(ours, encoding="utf-8") as file:
        series = json.load(file)["series"]
    up = [x for run in series["up"] for x in run]
    down = [x for run in series["down"] for x in run]
    with open(theirs, encoding="utf-8") as file:
        readings = json.load(file)
    pairs = len(TARGETS)
    expected_up, expected_down = [], []
    for run in range(RUNS):
        part = readings[2 * pairs * run:2 * pairs * (run + 1)]
        expected_up += [r[1] for r in part[:pairs]]
        expected_down += [r[1] for r in part[pairs:]][::-1]
    if len(up) + len(down) != len(readings):
        sys.exit(f"{len(up) + len(down)} readings against {len(readings)}")
    worst = max(abs(a - b) for a, b in zip(up + down, expected_up + expected_down))
    print(f"largest difference of any of {len(readings)} readings: {worst:.1e} um")
    if not worst < 0.02:
        sys.exit("the readings differ")


def main():
    if sys.argv[1] == "--make":
        return print(make_run(sys.argv[2], int(sys.argv[3])))
    if sys.argv[1] == "--numpy":
        return capture_with_numpy(sys.argv[2], sys.argv[3], float(sys.argv[4]))
    program = sys.argv[1]
    samples = int(float(sys.argv[2])) if len(sys.argv) > 2 else 20_000_000
    runs = int(sys.argv[3]) if len(sys.argv) > 3 else 3
    with tempfile.TemporaryDirectory(dir=os.environ.get("TMPDIR", "/var/tmp")) as folder:
        source, plan, ours, theirs = (f"{folder}/{name}" for name in ("run.npy", "plan.json", "ours.json", "theirs.json"))
        dwell = float(subprocess.check_output([sys.executable, __file__, "--make", source, str(samples)]))
        with open(plan, "w", encoding="utf-8") as file:
            json.dump({"format": "axiometry-plan/1", "axis": {"name": "X", "kind": "linear"}, "cycle": "standard",
                       "targets": TARGETS, "runs": RUNS, "overrun": OVERRUN, "feed": FEED, "dwell_s": dwell}, file)
        us = ["taskset", "-c", "0", program, "capture", "--plan", plan, "--from", source, "--out", ours, "--quiet"]
        them = ["taskset", "-c", "0", sys.executable, __file__, "--numpy", source, theirs, str(dwell)]
        pairs = [(timed(us), timed(them)) for _ in range(runs)]
        check_agreement(ours, theirs)
    for name, side in (("axiometry", 0), ("numpy", 1)):
        seconds = statistics.median(pair[side][0] for pair in pairs)
        memory = max(pair[side][1] for pair in pairs)
        print(f"{name:10} {seconds:8.2f} s  {samples / seconds / 1e6:8.1f} M samples/s  {memory:8.1f} MiB peak")
    print(f"ratio      {statistics.median(p[1][0] / p[0][0] for p in pairs):8.1f} (median of {runs} pairs, one core, processor time)")


if __name__ == "__main__":
    main()
