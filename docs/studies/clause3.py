# SPDX-License-Identifier: Apache-2.0
"""Clause 3 of ISO 230-2:2014 for many tests at once, in numpy: shared by the studies of this folder.

Written from the definitions, not from the program's code, so that the studies are a second opinion. Axes of the
arrays: test, direction (up, down), target, run; NaN is a missing reading.
"""
import warnings

import numpy as np

PARAMETERS = ("A", "A_up", "A_down", "E", "E_up", "E_down", "M", "R", "R_up", "R_down", "B", "B_mean")
SYMBOLS = dict(zip(PARAMETERS, ("A", "A↑", "A↓", "E", "E↑", "E↓", "M", "R", "R↑", "R↓", "B", "B̄")))


def cell_statistics(readings):
    """Mean and estimator s of every cell; NaN where there are too few readings."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", RuntimeWarning)  # of empty cells, which stay NaN
        return np.nanmean(readings, axis=-1), np.nanstd(readings, axis=-1, ddof=1)


def spread(values, axes):
    return np.nanmax(values, axis=axes) - np.nanmin(values, axis=axes)


def evaluate_cells(mean, s):
    """All twelve parameters from means and estimators: a row for each test, NaN where not applicable."""
    tests = len(mean)
    found = {name: np.full(tests, np.nan) for name in PARAMETERS}
    low, high = mean - 2 * s, mean + 2 * s
    scattered = bool(np.isfinite(s).any())
    present = [bool(np.isfinite(mean[:, d]).any()) for d in (0, 1)]
    for d, name in enumerate(("up", "down")):
        if not present[d]:
            continue
        found["E_" + name] = spread(mean[:, d], -1)
        if scattered:
            found["A_" + name] = np.nanmax(high[:, d], -1) - np.nanmin(low[:, d], -1)
            found["R_" + name] = 4 * np.nanmax(s[:, d], -1)
    if all(present):
        reversal = mean[:, 0] - mean[:, 1]
        found["B"] = np.nanmax(np.abs(reversal), -1)
        found["B_mean"] = np.nanmean(reversal, -1)
        found["M"] = spread(0.5 * (mean[:, 0] + mean[:, 1]), -1)
        found["E"] = spread(mean, (-2, -1))
        if scattered:
            found["A"] = np.nanmax(high, (-2, -1)) - np.nanmin(low, (-2, -1))
            both = 2 * s.sum(axis=1) + np.abs(reversal)
            found["R"] = np.nanmax(np.fmax(both, 4 * np.fmax(s[:, 0], s[:, 1])), -1)
    return np.stack([found[name] for name in PARAMETERS], axis=-1)


def evaluate(readings):
    return evaluate_cells(*cell_statistics(readings))
