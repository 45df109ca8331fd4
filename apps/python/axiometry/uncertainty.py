# SPDX-License-Identifier: Apache-2.0
"""The uncertainty of any measurement model."""
from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from . import _native
from .given import SEED_MOST, number, whole


@dataclass(frozen=True)
class Propagated:
    """What is known of one output.

    gum: value, u, k, U, nu_eff (None where it is not defined, inf where nothing limits it), interval; by input
    sensitivities c_i, sensitivity_errors (of the differences they are taken from) and contributions (c_i u_i). monte_carlo: value, u, symmetric and shortest coverage interval, tolerance
    (JCGM 101, 7.9.2), stable. trials: how many.
    """

    gum: dict
    monte_carlo: dict
    trials: int


def propagate(model: Callable, inputs: Mapping, *, correlation: Mapping | None = None, trials: int | None = None,
              seed: int = 1, coverage: float = 0.95) -> Propagated | list[Propagated]:
    """Propagates the inputs through a model of Python: by the law of propagation of uncertainty (GUM, clause 5) and by
    Monte Carlo (JCGM 101).

    model: takes one array per input, in their order, and gives one array, or a tuple of arrays for several outputs;
    numpy's functions do so of themselves. It is called from other threads too, one at a time. inputs: by name a distribution of JCGM 101 as text ("normal 5 0.01", "uniform
    -0.5 0.5", "t 8 0 0.4", "trapezoidal …", "arcsine …", "ctrap …", "constant 3"), or (value, u) of a normal one.
    correlation: {("a", "b"): 0.3, …}, by a Gaussian copula where they are not normal. trials: None until two digits are
    stable, twenty million at most. The same seed gives the same bits.

    >>> import axiometry
    >>> ohm = axiometry.propagate(lambda V, I: V / I, {"V": (5, 0.01), "I": (0.02, 0.0001)}, trials=100_000)
    >>> round(ohm.gum["value"], 3), round(ohm.gum["U"], 2)
    (250.0, 2.64)
    """
    names = list(inputs)
    if not names:
        raise _native.Error("found no inputs, expected at least one")
    matrix = np.eye(len(names))
    given = set()
    for (a, b), r in (correlation or {}).items():
        if frozenset((a, b)) in given:
            raise _native.Error(f"found two correlations of {a!r} and {b!r}, expected one")
        given.add(frozenset((a, b)))
        for name in (a, b):
            if name not in names:
                raise _native.Error(f"found a correlation of {name!r}, expected one of {', '.join(names)}")
        if a == b:
            raise _native.Error(f"found a correlation of {a!r} with itself, expected one of two inputs")
        matrix[names.index(a), names.index(b)] = matrix[names.index(b), names.index(a)] = r
    count, several = _outputs_of(model, inputs)
    trials = None if trials is None else whole(trials, "trials", 100, 4_000_000_000)
    call = _native.PropagationCall(names, [_distribution(name, inputs[name]) for name in names], matrix.ravel().tolist(),
                                   count, trials, whole(seed, "seed", 0, SEED_MOST), number(coverage, "coverage"))
    law, draws, done = _native.propagate(lambda rows: _rows_of(model(*rows), rows[0].size, count), call)
    for found in law:
        for key in ("sensitivities", "sensitivity_errors", "contributions"):
            found[key] = dict(zip(names, found[key]))
    outputs = [Propagated(*both, done) for both in zip(law, draws)]
    return outputs if several else outputs[0]


def _distribution(name: str, given) -> str:
    if isinstance(given, str):
        return given
    try:
        value, u = (float(x) for x in given)
    except (TypeError, ValueError, OverflowError):
        raise _native.Error(f"found {given!r} as {name}, expected (value, u) or a distribution as text") from None
    return f"normal {value!r} {u!r}"


def _outputs_of(model: Callable, inputs: Mapping) -> tuple[int, bool]:
    """How many there are, asked of the model itself at values of the inputs."""
    probe = _native.estimates(list(inputs), [_distribution(name, given) for name, given in inputs.items()])
    found = model(*[np.array([x]) for x in probe])
    several = isinstance(found, (tuple, list))
    if several and not found:
        raise _native.Error("found no output of the model, expected at least one")
    return (len(found) if several else 1), several


def _rows_of(found, size: int, count: int) -> list[np.ndarray]:
    outputs = found if isinstance(found, (tuple, list)) else [found]
    if len(outputs) != count:
        raise _native.Error(f"found {len(outputs)} outputs of the model, expected {count} as before")
    rows = [np.asarray(output, dtype=float) for output in outputs]
    for row in rows:
        if row.shape not in ((), (size,)):
            raise _native.Error(f"found an output of shape {row.shape} of inputs of shape ({size},), expected the same")
    return [np.ascontiguousarray(np.broadcast_to(row, (size,))) for row in rows]
