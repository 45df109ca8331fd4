# SPDX-License-Identifier: Apache-2.0
"""Tests how truly a machine tool's axes move: ISO 230-2 and what belongs to it, from Python.

Arrays in, numbers out, by the library that the program `axiometry` is made of:

- parameters(up, down): clause 3 of one test or of a million, as numpy arrays
- Test, read, read_all, evaluate: a test, its uncertainty by three methods, verdicts, findings, reports
- propagate: the uncertainty of any measurement model of Python, after the GUM and by Monte Carlo
- ErrorModel: the 21 errors of a machine, at any place
- run: every verb of the command line, its JSON as Python values

Deviations are in µm (″ of a rotary axis), positions in mm (°). What cannot be done raises Error, which says what was
found and what was expected. Nothing measured is ever changed.
"""
from ._native import Error, version as __version__
from .arrays import parameters
from .error_model import ErrorModel, SeriousFinding
from .program import Done, run
from .tests import Result, Test, evaluate, read, read_all
from .uncertainty import Propagated, propagate

Error.__module__ = __name__  # where one catches it

__all__ = ["Done", "Error", "ErrorModel", "Propagated", "Result", "SeriousFinding", "Test", "evaluate", "parameters",
           "propagate", "read", "read_all", "run"]
