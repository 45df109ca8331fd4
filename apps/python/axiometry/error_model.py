# SPDX-License-Identifier: Apache-2.0
"""The 21 errors of a machine of three linear axes, from a result of `axiometry volumetric identify` or `assemble`."""
from __future__ import annotations

import json
import os
import warnings
from collections.abc import Mapping

import numpy as np

from . import _native
from .given import numbers, path


class SeriousFinding(UserWarning):
    """The result from which something is made should not be used as it is."""


class ErrorModel:
    """The errors as curves with their covariance. Warns (SeriousFinding) where serious findings speak against them.

    result: the file, or its content as a dict. A number that the readings do not tell is NaN, never 0. Places beyond
    `ranges`, over which the curves are stated, raise Error. Without a reversal in the result, ↑, ↓ and mean are one.
    """

    def __init__(self, result: str | os.PathLike | Mapping):
        if isinstance(result, Mapping):
            self._native = _native.error_model_of_text(json.dumps(dict(result)))
        else:
            self._native = _native.error_model_of_file(path(result))
        for finding in self.findings:
            if finding["severity"] == "serious":
                warnings.warn(finding["message"], SeriousFinding, stacklevel=2)

    @property
    def findings(self) -> list[dict]:
        """What speaks against the result, or must be known of it: id, severity ("serious" or "note"), message."""
        return [{"id": id, "severity": "serious" if serious else "note", "message": message}
                for id, serious, message in self._native.findings]

    @property
    def tools(self) -> dict[str, tuple[float, float, float]]:
        """Offsets by name, mm."""
        return self._native.tools

    @property
    def ranges(self) -> dict[str, tuple[float, float]]:
        """Where the errors of each axis are known, mm."""
        return dict(zip("XYZ", self._native.ranges))

    def displacement(self, points, *, tool: str = "", approach=(0, 0, 0)) -> tuple[np.ndarray, np.ndarray]:
        """By how much the tool point is beside its place, µm (..., 3), and the covariance, µm² (..., 3, 3).

        points: where the axes stand, mm (..., 3). tool: its name, may be left out where there is one. approach: of
        each axis +1, -1 or 0 for the mean of both directions.
        """
        points = numbers(points, "points")
        if points.ndim == 0 or points.shape[-1] != 3:
            raise _native.Error(f"found points of shape {points.shape}, expected (..., 3)")
        rows = np.ascontiguousarray(points.reshape(-1, 3))
        errors, covariances = self._native.displacement(rows, tool, [_sign(a) for a in _three(approach)])
        return errors.reshape(points.shape), covariances.reshape(*points.shape, 3)

    def motion(self, error: str, positions, *, approach: int = 0) -> tuple[np.ndarray, np.ndarray]:
        """One of the 18 error motions ("EXX", "EYX", "EAX", …) at positions of its axis, and its standard uncertainty:
        µm, or µrad of a rotation.
        """
        positions = numbers(positions, "positions")
        found = self._native.motion(error, np.ascontiguousarray(positions.ravel()), _sign(approach))
        return tuple(values.reshape(positions.shape) for values in found)

    def squareness(self, which: str) -> tuple[float, float]:
        """"C0Y", "B0Z" or "A0Z" and its standard uncertainty, µrad."""
        return self._native.squareness(which)


def _three(approach):
    approach = tuple(approach)
    if len(approach) != 3:
        raise _native.Error(f"found an approach of {len(approach)} axes, expected 3")
    return approach


def _sign(approach) -> float:
    if approach not in (-1, 0, 1):
        raise _native.Error(f"found the approach {approach!r}, expected -1, 0 or 1")
    return float(approach)
