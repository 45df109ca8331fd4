#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""The Monte Carlo of a whole evaluation twice in one run: by axiometry and by numpy.

Usage: bench/compare_numpy_monte_carlo.py PROGRAM [TRIALS [ROUNDS]]

Work: the model of src/axiometry/app/studies/bench_monte_carlo.h, every reading made and all twelve parameters evaluated, with
mean, standard deviation and the 2.5 % and 97.5 % quantiles of each. Sides take turns, each pinned to its cores; only
the work is timed, not the start of a process or an import. Rates are by the clock and by the processor time that was
used, which other programs disturb less. The figures of every run must agree with those of numpy
and with those below within Monte Carlo error. numpy is vectorised over trials, in double precision, in chunks that
fit the cache; its chunk is chosen first, the fastest of some. A second row shows numpy as it is usually written: the
default generator, chunks of 20 000, std(). Prints rates, ratios and the largest disagreement.
"""
import json
import math
import os
import resource
import subprocess
import sys
import time

import numpy as np

KEYS = ("A", "A_up", "A_down", "E", "E_up", "E_down", "M", "R", "R_up", "R_down", "B", "B_mean")
TARGETS, RUNS = 11, 5

# Computed once with another numpy program and 2e6 trials or more: mean, sd, q025, q975.
REFERENCE = {
    "A": (15.804, 1.169, 13.657, 18.224), "A_up": (13.776, 1.169, 11.630, 16.194),
    "A_down": (13.175, 1.202, 10.945, 15.650), "E": (11.801, 0.834, 10.231, 13.479),
    "E_up": (9.822, 0.829, 8.260, 11.489), "E_down": (9.179, 0.884, 7.501, 10.958),
    "M": (9.390, 0.799, 7.873, 10.999), "R": (7.900, 0.779, 6.569, 9.612),
    "R_up": (5.658, 0.938, 4.053, 7.715), "R_down": (5.658, 0.938, 4.053, 7.717),
    "B": (3.591, 0.335, 2.997, 4.309), "B_mean": (-2.526, 0.154, -2.827, -2.224),
}
REFERENCE_ERROR = 0.003  # its Monte Carlo error and its digits


def evaluate(x, usual):
    """Parameters of readings x[direction, target, run, trial], one row each, in the order of KEYS."""
    mean = x.mean(axis=2)
    if usual:
        s = x.std(axis=2, ddof=1)
    else:
        x -= mean[:, :, None]
        s = np.sqrt(np.einsum("dirt,dirt->dit", x, x) / (RUNS - 1))  # no array of squares in between
    band = 2 * s
    high, low = (mean + band).max(axis=1), (mean - band).min(axis=1)
    top, bottom = mean.max(axis=1), mean.min(axis=1)
    reversal = mean[0] - mean[1]
    middle = (mean[0] + mean[1]) / 2
    spread = 4 * s.max(axis=1)
    size = np.abs(reversal)
    both = (band[0] + band[1] + size).max(axis=0)
    return np.stack([
        np.maximum(high[0], high[1]) - np.minimum(low[0], low[1]), high[0] - low[0], high[1] - low[1],
        np.maximum(top[0], top[1]) - np.minimum(bottom[0], bottom[1]), top[0] - bottom[0], top[1] - bottom[1],
        np.ptp(middle, axis=0), np.maximum(both, np.maximum(spread[0], spread[1])), spread[0], spread[1],
        size.max(axis=0), reversal.mean(axis=0)])


def with_numpy(trials, chunk, seed, usual):
    # SFC64 is the fastest of numpy's generators.
    generator = np.random.default_rng(seed) if usual else np.random.Generator(np.random.SFC64(seed))
    i = np.arange(TARGETS)
    position = 0.05 + 0.09 * i
    up = 6 * np.sin(0.55 * i) + 0.4 * i
    base = np.stack([up, up + 2.5 + 0.6 * np.cos(0.9 * i)])[:, :, None, None]
    scatter = math.sqrt(0.7 ** 2 + 0.4 ** 2)
    result = np.empty((len(KEYS), trials))
    buffer = np.empty(2 * TARGETS * RUNS * chunk)
    for begin in range(0, trials, chunk):
        count = min(chunk, trials - begin)
        x = buffer[:2 * TARGETS * RUNS * count]
        generator.standard_normal(out=x)
        x = x.reshape(2, TARGETS, RUNS, count)
        x *= scatter
        common = base + (1.5 * position)[:, None, None] * generator.standard_normal(count)
        x += common
        x += 0.5 * generator.standard_normal((RUNS, count))
        result[:, begin:begin + count] = evaluate(x, usual)
    quantiles = np.quantile(result, [0.025, 0.975], axis=1, overwrite_input=True)
    return np.column_stack([result.mean(axis=1), result.std(axis=1, ddof=1), quantiles.T])


def time_numpy(trials, chunk, seed, usual=False):
    clock, processor = time.perf_counter(), time.process_time()
    figures = with_numpy(trials, chunk, seed, usual)
    return np.array([trials / (time.perf_counter() - clock), trials / (time.process_time() - processor)]), figures


def processor_time(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    output = subprocess.run(command, capture_output=True, check=True).stdout
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, output


def run_program(program, trials, threads, precision, seed):
    command = ["taskset", "-c", "0" if threads == 1 else "0,1", program, "bench", "monte-carlo", "--trials", str(trials),
               "--threads", str(threads), "--seed", str(seed), "--precision", precision]
    start, _ = processor_time(command[:4] + ["--version"])
    seconds, output = processor_time(command)
    result = json.loads(output)
    figures = np.array([[result[key][name] for name in ("mean", "sd", "q025", "q975")] for key in KEYS])
    rates = np.array([result["trials_per_second"], trials * threads / (seconds - start)])
    return rates, figures, result["instructions"]


def standard_errors(figures, trials):
    """Of mean, sd and quantiles; generous for skew distributions."""
    return figures[:, 1:2] / math.sqrt(trials) * np.array([1.0, 1.0, 4.0, 4.0])


def check(name, figures, expected, errors):
    """Differences in units of the tolerance, 5 standard errors: above 1 the program and numpy differ."""
    worst = float(np.max(np.abs(figures - expected) / errors))
    if not worst < 1:
        sys.exit(f"{name}: the figures differ, {worst:.2f} of what is allowed")
    return worst


def main():
    program = sys.argv[1]
    trials = int(sys.argv[2]) if len(sys.argv) > 2 else 1_000_000
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 7
    os.sched_setaffinity(0, {0})
    chunk = max((250, 500, 1000, 2000, 4000), key=lambda size: time_numpy(200_000, size, 1)[0][1])
    kinds = [(1, "double"), (2, "double"), (1, "single"), (2, "single")]
    rates = {kind: [] for kind in kinds}
    numpy_rates, usual_rates, worst, instructions = [], [], 0.0, ""
    reference = np.array([REFERENCE[key] for key in KEYS])
    for seed in range(1, rounds + 1):
        rate, theirs = time_numpy(trials, chunk, seed)
        numpy_rates.append(rate)
        usual_rates.append(time_numpy(trials, 20_000, seed, usual=True)[0])
        error = standard_errors(reference, trials)
        worst = max(worst, check("numpy and the reference", theirs, reference, 5 * error + REFERENCE_ERROR))
        for kind in kinds:
            rate, ours, instructions = run_program(program, trials, *kind, seed)
            rates[kind].append(rate)
            worst = max(worst, check(f"{kind} and numpy", ours, theirs, 5 * math.sqrt(2) * error),
                        check(f"{kind} and the reference", ours, reference, 5 * error + REFERENCE_ERROR))
    print(f"{trials} trials, {rounds} rounds, {instructions}, numpy {np.__version__} in chunks of {chunk}; medians")
    print(f"{'million trials a second, ratio':32}{'by the clock':>20}{'by processor time':>20}")
    numpy_rates = np.array(numpy_rates)
    for name, of in (("numpy, 1 core, double", numpy_rates), ("the same as usually written", np.array(usual_rates))):
        million, ratio = np.median(of, axis=0) / 1e6, np.median(of / numpy_rates, axis=0)
        print(f"{name:32}{million[0]:12.3f}{ratio[0]:8.1f}{million[1]:12.3f}{ratio[1]:8.1f}")
    for threads, precision in kinds:
        ours = np.array(rates[(threads, precision)])
        million = np.median(ours, axis=0) / 1e6
        ratio = np.median(ours / numpy_rates, axis=0)
        name = f"axiometry, {threads} core{'s' if threads > 1 else ''}, {precision}"
        print(f"{name:32}{million[0]:12.3f}{ratio[0]:8.1f}{million[1]:12.3f}{ratio[1]:8.1f}")
    print(f"figures agree: largest difference {worst:.2f} of 5 standard errors")


if __name__ == "__main__":
    main()
