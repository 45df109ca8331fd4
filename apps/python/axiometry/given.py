# SPDX-License-Identifier: Apache-2.0
"""What may be given as an argument, and how it is taken."""
from __future__ import annotations

import operator
import os

import numpy as np

from . import _native


def numbers(values, name: str) -> np.ndarray:
    """An array of float, whole in memory; what a mask hides is missing (NaN)."""
    try:
        array = np.ma.asarray(values)
        if np.iscomplexobj(array):
            raise _native.Error(f"found complex numbers in {name}, expected real ones")
        return np.ascontiguousarray(np.ma.filled(array.astype(float), np.nan))
    except (TypeError, ValueError, OverflowError) as fault:
        if isinstance(fault, _native.Error):
            raise
        raise _native.Error(f"{name}: {fault}, expected numbers") from None


def number(value, name: str) -> float:
    try:
        return float(value)
    except (TypeError, ValueError, OverflowError):
        raise _native.Error(f"found {name}={value!r}, expected a number") from None


def path(file) -> str:
    """The name of a file as the library takes it."""
    try:
        name = os.fspath(file)
        name = os.fsdecode(name)
        name.encode()
    except (TypeError, UnicodeError):
        raise _native.Error(f"found {file!r}, expected the name of a file") from None
    if "\0" in name:
        raise _native.Error(f"found the name {name!r}, expected one without a character NUL")
    return name


def whole(value, name: str, least: int, most: int) -> int:
    """A whole number, of Python or of numpy."""
    try:
        number = operator.index(value)
    except TypeError:
        raise _native.Error(f"found {name}={value!r}, expected a whole number") from None
    if not least <= number <= most:
        raise _native.Error(f"found {name}={number}, expected {least} to {most}")
    return number


SEED_MOST = 2**64 - 1
