# SPDX-License-Identifier: Apache-2.0
"""Every verb of the command line, from Python."""
from __future__ import annotations

import functools
import json as _json
import os
import pathlib
import shutil
import subprocess
from collections.abc import Iterator, Mapping

from . import _native

USAGE = 1
SERIOUS, UNDECIDED, INCOMPLETE = 3, 4, 5  # the exit codes of what was done, and says something


class Done(Mapping):
    """What a verb has written as JSON, as values of Python; docs/results.md explains it. exit_code: 0, 3 where a
    parameter does not conform or a finding is serious, 4 undecided, 5 a capture that ended early. text: what it told.
    """

    def __init__(self, values, exit_code: int, text: str):
        self.values_of_json, self.exit_code, self.text = values, exit_code, text

    def __getitem__(self, key):
        return self.values_of_json[key]

    def __iter__(self) -> Iterator:
        return iter(self.values_of_json)

    def __len__(self) -> int:
        return len(self.values_of_json)

    def __repr__(self) -> str:
        return f"<axiometry.Done exit code {self.exit_code}, {', '.join(map(str, self))}>"


def run(verb: str, *arguments, json: bool | None = None, **flags) -> Done:
    """Runs a verb of the program `axiometry`: run("volumetric identify", "lengths.csv", machine="machine.json").

    flags: as `axiometry help` has them, with _ for -: True stands for the flag alone, a list for a flag given several
    times, None and False for none. Where the verb writes JSON, it is read (json=False: not). Raises Error, with the
    program's own words, where nothing was done.
    """
    words = [_program(), *verb.split(), *(_word(a) for a in arguments)]
    for name, value in flags.items():
        flag = "--" + name.strip("_").replace("_", "-")
        for item in value if isinstance(value, (list, tuple)) else [value]:
            if item is True:
                words.append(flag)
            elif item is not None and item is not False:
                words.append(f"{flag}={_word(item)}")
    reads = _writes_json(words[0], verb) if json is None else json
    done = _done([*words, "--json=-"] if reads else words)
    if json is None and done.returncode == USAGE and done.stderr.startswith("axiometry: --json:"):
        reads, done = False, _done(words)  # it writes JSON with other flags alone
    if done.returncode not in (0, SERIOUS, UNDECIDED, INCOMPLETE):
        raise _native.Error(done.stderr.strip().removeprefix("axiometry: ") or f"{verb} ended with {done.returncode}")
    values = _json.loads(done.stdout) if reads and done.stdout else {}
    return Done(values, done.returncode, done.stderr if reads else done.stdout)


def _done(words: list[str]) -> subprocess.CompletedProcess:
    return subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, text=True, encoding="utf-8")


@functools.cache
def _program() -> str:
    """AXIOMETRY_PROGRAM, the program that was installed with this package, or the one on the path."""
    named = os.environ.get("AXIOMETRY_PROGRAM")
    below = (folder / "bin" / "axiometry" for folder in pathlib.Path(__file__).parents)
    beside = next((program for program in below if program.is_file()), None)
    program = named or beside or shutil.which("axiometry")
    if not program:
        raise _native.Error("found no program axiometry, expected one on the path or named by AXIOMETRY_PROGRAM")
    try:
        told = subprocess.run([program, "--version"], capture_output=True, text=True).stdout.split()
    except OSError as fault:
        raise _native.Error(f"{program}: {fault.strerror}") from None
    if _native.version not in told:
        raise _native.Error(f"found the program {program} of another version than {_native.version}, expected the same")
    return str(program)


@functools.cache
def _writes_json(program: str, verb: str) -> bool:
    return "--json" in subprocess.run([program, *verb.split(), "--help"], capture_output=True, text=True).stdout


def _word(value) -> str:
    if isinstance(value, float):
        return repr(float(value))
    return os.fspath(value) if hasattr(value, "__fspath__") else str(value)
