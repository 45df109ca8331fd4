# SPDX-License-Identifier: Apache-2.0
"""Tests of an axis: read or made of arrays, evaluated, reported."""
from __future__ import annotations

import json
import os
from collections.abc import Iterable, Iterator, Mapping

import numpy as np

from . import _native
from .given import SEED_MOST, number, numbers, path, whole


class Test:
    """One positioning test: targets, readings from both directions, and what is known of it. Never changes.

    targets: (m,), ascending, mm or °. up, down: deviations (m, runs) in µm or ″, NaN where a reading is missing; a
    test in one direction has one of them. kind: "linear" or "rotary". stating: items of the vocabulary (`axiometry
    schema`, `axiometry formats metadata`), such as {"axis.name": "X", "machine.name": "Mill 5",
    "uncertainty.device_error_range_um_per_m": 0.6}; what is stated here is told as entered.
    """

    __test__ = False  # no test of pytest

    def __init__(self, targets, up=None, down=None, *, kind: str = "linear", stating: Mapping | None = None):
        if kind not in ("linear", "rotary"):
            raise _native.Error(f"found the kind {kind!r}, expected 'linear' or 'rotary'")
        targets = _array(targets, "targets", 1)
        given = {name: _array(values, name, 2) for name, values in (("up", up), ("down", down)) if values is not None}
        if not given:
            raise _native.Error("found no readings, expected up, down or both")
        runs = max(values.shape[1] for values in given.values())
        for name, values in given.items():
            if values.shape[0] != targets.size:
                raise _native.Error(f"found {values.shape[0]} rows in {name}, expected one for each of "
                                    f"{targets.size} targets")
        rows = {name: np.full((targets.size, runs), np.nan) for name in ("up", "down")}
        for name, values in given.items():
            rows[name][:, :values.shape[1]] = values
        self._native = _native.test_of_arrays(targets, rows["up"], rows["down"], kind == "rotary")
        if stating:
            self._native = self._native.stating(_stated(stating))

    @classmethod
    def _of(cls, native: _native.Test) -> Test:
        test = cls.__new__(cls)
        test._native = native
        return test

    name = property(lambda self: self._native.name, doc="Of one test among many in its file; else empty.")
    kind = property(lambda self: self._native.kind, doc='"linear" or "rotary"')
    targets = property(lambda self: self._native.targets, doc="(m,), mm or °")
    up = property(lambda self: self._native.up, doc="(m, runs), µm or ″, NaN where missing")
    down = property(lambda self: self._native.down, doc="(m, runs), µm or ″, NaN where missing")
    remarks = property(lambda self: self._native.remarks, doc="What the reader of the file had to remark.")
    metadata = property(lambda self: json.loads(self._native.metadata), doc="In the layout of the test format.")
    source = property(lambda self: json.loads(self._native.source), doc="file, sha256, format; null of arrays")

    def stating(self, items: Mapping) -> Test:
        """The same readings with more said about them; None takes an item away."""
        return Test._of(self._native.stating(_stated(items)))

    def write(self, file: str | os.PathLike, *, format: str = "") -> list[str]:
        """Into a file that ends in .json or .csv, or of another format that can be written; whole or not at all, and
        never over the file it was read from. Gives what such a file leaves behind. Raises Error where it would lose a
        reading or an item.
        """
        return self._native.write(path(file), format)

    def __repr__(self) -> str:
        m, n = self.up.shape
        axis = self.metadata.get("axis", {}).get("name", "")
        return f"<axiometry.Test {axis + ', ' if axis else ''}{self.kind}, {m} targets, {n} runs>"


class Result(Mapping):
    """What `axiometry evaluate --json` writes of a test, as values of Python: result["parameters"]["A"],
    result["uncertainty"]["record"], result["findings"], … (docs/results.md explains every member).
    """

    def __init__(self, native: _native.Outcome):
        self._native = native
        self._values = json.loads(native.json)

    def __getitem__(self, key):
        return self._values[key]

    def __iter__(self) -> Iterator:
        return iter(self._values)

    def __len__(self) -> int:
        return len(self._values)

    def report(self, file: str | os.PathLike, *, language: str = "en", decimal: str | None = None,
               decimals: int | None = None) -> None:
        """The report, by the extension: pdf, html, svg, png, csv; whole or not at all, and never over the test's file.
        decimal: "point" or "comma", else as the language has it.
        """
        self._native.report(path(file), language, decimal, decimals)

    def __repr__(self) -> str:
        unit = "µm" if self["unit"] == "um" else "″"
        shown = [f"{key} = {value:.4g} {unit}" for key, value in self["parameters"].items() if value is not None]
        verdict = [self["verdict"]] if "verdict" in self else []
        return f"<axiometry.Result {', '.join(shown + verdict)}>"


def read(file: str | os.PathLike, *, format: str = "", profile: str | os.PathLike = "") -> Test:
    """The test in a file of any format (`axiometry formats`), recognised by its content, or read after an import
    profile. Raises Error, with line and column, on what is wrong with it, and on a file of many tests.
    """
    return Test._of(_native.test_of_file(path(file), format, path(profile)))


def read_all(file: str | os.PathLike) -> list[Test]:
    """Every test of a file, with its name where it holds many."""
    return [Test._of(test) for test in _native.tests_of_file(path(file))]


def evaluate(test: Test | str | os.PathLike, *, methods: str | Iterable[str] = ("gum",), trials: int | None = None,
             seed: int | None = None, coverage: float | None = None, corrections: str | Iterable[str] = (),
             method: str | None = None, stating: Mapping | None = None, tolerances: Mapping | None = None,
             rule: str | None = None, verify: bool = False) -> Result:
    """Parameters, uncertainty, verdicts and findings of a test or of the test in a file.

    methods: of uncertainty beside Annex A, "gum" and "monte-carlo"; with the latter trials (at most ten million; None
    until two digits are stable), seed (1) and coverage (0.95). method: whose uncertainty is that of record, "annex-a",
    "gum" or "monte-carlo". corrections: "nde", "air=ciddor", "dead-path", "drift". stating: as of Test, for this
    evaluation. tolerances: {"A": "10um", "R_up": "0.003mm"}, a bare number in µm or ″. rule: "simple", "iso14253-1" or
    "guard-band=3um". verify: computes every figure a second time on a path of its own and raises Error where one differs.
    """
    if not isinstance(test, Test):
        test = read(test)
    unit = "um" if test.kind == "linear" else "arcsec"
    limits = [f"{key}={limit}" if isinstance(limit, str) else f"{key}={number(limit, key)!r}{unit}"
              for key, limit in (tolerances or {}).items()]
    stated = dict(stating or {})
    if method is not None:
        stated["uncertainty.method"] = method
    options = {"methods": _words(methods), "corrections": _words(corrections)}
    of_trials = {"trials": trials, "seed": seed, "coverage": coverage}
    for name, value in of_trials.items():
        if value is not None and "monte-carlo" not in options["methods"]:
            raise _native.Error(f"found {name} without the method it belongs to, expected methods with 'monte-carlo'")
    if trials is not None:
        options["trials"] = whole(trials, "trials", 100, 10_000_000)
    if seed is not None:
        options["seed"] = str(whole(seed, "seed", 0, SEED_MOST))
    if coverage is not None:
        options["coverage"] = number(coverage, "coverage")
    return Result(_native.evaluate(test._native, json.dumps(options), _stated(stated), limits, rule, bool(verify)))


def _words(given: str | Iterable[str]) -> list[str]:
    return given.split(",") if isinstance(given, str) else list(given)


def _array(values, name: str, axes: int) -> np.ndarray:
    array = numbers(values, name)
    if array.ndim != axes:
        expected = "(targets,)" if axes == 1 else "(targets, runs)"
        raise _native.Error(f"found {name} of shape {array.shape}, expected {expected}")
    return array


def _stated(items: Mapping) -> str:
    """As the vocabulary takes it: texts; of a list a record per line."""
    return json.dumps({key: _text(key, value) for key, value in items.items()})


def _text(key: str, value) -> str:
    if value is None:
        return ""
    if isinstance(value, (bool, np.bool_)):
        return "yes" if value else "no"
    if isinstance(value, (float, np.floating)):
        return repr(float(value))
    if isinstance(value, (str, int, np.integer)):
        return str(value)
    if isinstance(value, (list, tuple, np.ndarray)) and not any(item is None for item in value):
        are_numbers = all(isinstance(item, (int, float, np.number)) for item in value)
        return (" " if are_numbers else "\n").join(_text(key, item) for item in value)
    raise _native.Error(f"found {value!r} as {key}, expected text, a number, yes or no as a bool, or a list of these")
