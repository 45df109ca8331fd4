# SPDX-License-Identifier: Apache-2.0
"""Clause 3 of ISO 230-2 for arrays of readings."""
from __future__ import annotations

import numpy as np

from . import _native
from .given import numbers


def parameters(up, down=None, *, missing: str = "refuse") -> dict:
    """The parameters of one test or of many: A, A_up, A_down, E, E_up, E_down, M, R, R_up, R_down, B, B_mean.

    up, down: deviations of shape (..., targets, runs), in the order of the targets; everything before the last two
    axes counts tests. `down` may be left out: a test in one direction has no A, E, M, R and B.

    Gives numbers for one test and arrays of shape (...) for many, by key, in the unit of the readings. What does not
    exist for this shape has no key: with a single run per direction there is no R and no A (6.2).

    missing="refuse": a NaN raises Error. missing="omit": what is there is evaluated as clause 3 has it, NaN where a test
    has nothing of it. That is no result after the standard: means of fewer readings are others, and where some s exist
    and another does not, 0 stands for it.
    """
    up = _readings(up, "up")
    down = None if down is None else _readings(down, "down")
    if down is not None and down.shape != up.shape:
        raise _native.Error(f"found readings of shape {up.shape} up and {down.shape} down, expected the same")
    if missing not in ("refuse", "omit"):
        raise _native.Error(f"found missing={missing!r}, expected 'refuse' or 'omit'")
    found = _native.parameters(up, down, missing == "omit")
    return {key: values if values.ndim else float(values) for key, values in found.items()}


def _readings(values, name: str) -> np.ndarray:
    readings = numbers(values, name)
    if readings.ndim < 2:
        raise _native.Error(f"found readings of shape {readings.shape} {name}, expected (..., targets, runs)")
    return readings
