# SPDX-License-Identifier: Apache-2.0
"""Every verb of the command line, from Python."""
from __future__ import annotations

import functools
import json as _json
import os
import pathlib
import re
import shutil
import subprocess
from collections.abc import Iterator, Mapping

from . import _native

USAGE, BAD_INPUT = 1, 2
SERIOUS, UNDECIDED, INCOMPLETE = 3, 4, 5  # the exit codes of what was done, and says something


class Done(Mapping):
    """What a verb has written as JSON, as values of Python; docs/results.md explains it. exit_code: 0, 3 where a
    parameter does not conform or a finding is serious, 4 undecided, 5 a capture that ended early, with keep_going=True also
    2 where an input was bad. text: what else it
    wrote, such as a part program; told: what it said of it (its standard error). json: all of the JSON, which is a list
    where it is of many tests; then nothing is found by name.
    """

    def __init__(self, json, exit_code: int, text: str, told: str):
        self.json, self.exit_code, self.text, self.told = json, exit_code, text, told
        self._members = json if isinstance(json, dict) else {}

    def __getitem__(self, key):
        return self._members[key]

    def __iter__(self) -> Iterator:
        return iter(self._members)

    def __len__(self) -> int:
        return len(self._members)

    def __repr__(self) -> str:
        return f"<axiometry.Done exit code {self.exit_code}, {', '.join(map(str, self))}>"


def run(verb: str, *arguments, json: bool | None = None, **flags) -> Done:
    """Runs a verb of the program `axiometry`: run("volumetric identify", "lengths.csv", machine="machine.json").

    flags: as `axiometry help` has them, with _ for -: True stands for the flag alone, a list for a flag given several
    times, None and False for none. Where the verb writes JSON, it is read (json=False: not). Raises Error, with the
    program's own words, where nothing was done.
    """
    if json not in (None, True, False):
        raise _native.Error(f"found json={json!r}, expected True, False or None: it is read here and goes into no file")
    program = _program(os.environ.get("AXIOMETRY_PROGRAM", ""))
    flag = "" if json is False or flags.get("help") else _json_flag(program, verb)
    if json and not flag:
        raise _native.Error(f"found json=True, and {verb} writes none")
    words = [*(_word(a) for a in arguments)]
    for name, value in flags.items():
        named = "--" + name.strip("_").replace("_", "-")
        for item in value if isinstance(value, (list, tuple)) else [value]:
            if item is True:
                words.append(named)
            elif item is not None and item is not False:
                words.append(f"{named}={_word(item)}")
    verb_words = [program, *verb.split()]
    done = _done([*verb_words, flag, *words] if flag else [*verb_words, *words])
    if json is None and done.returncode == USAGE and done.stderr.startswith(b"axiometry: --json:"):
        flag, done = "", _done([*verb_words, *words])  # it writes JSON with other flags alone
    output, told = done.stdout.decode("utf-8", "replace"), done.stderr.decode("utf-8", "replace")
    has_gone_on = flags.get("keep_going") is True and done.returncode == BAD_INPUT
    if done.returncode not in (0, SERIOUS, UNDECIDED, INCOMPLETE) and not has_gone_on:
        raise _native.Error(told.strip().removeprefix("axiometry: ") or f"{verb} ended with {done.returncode}")
    if not flag:
        return Done({}, done.returncode, output, told)
    try:
        return Done(_json.loads(output), done.returncode, "", told)
    except ValueError:
        raise _native.Error(f"found no JSON where {verb} should have written it, expected it: {output[:80]!r}") from None


def _done(words: list[str]) -> subprocess.CompletedProcess:
    english = {name: value for name, value in os.environ.items() if name != "AXIOMETRY_LANGUAGE"}
    return subprocess.run(words, stdin=subprocess.DEVNULL, capture_output=True, env=english)


@functools.cache
def _program(named: str) -> str:
    """AXIOMETRY_PROGRAM; the program of the build or the prefix that this package is of; or the one on the path."""
    here = list(pathlib.Path(__file__).parents)
    beside = (here[2] / "axiometry", *(folder / "bin" / "axiometry" for folder in here[4:5]))
    program = (named and os.path.abspath(named)) or next((p for p in beside if p.is_file()), None) or shutil.which(
        "axiometry")
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
def _json_flag(program: str, verb: str) -> str:
    """Of some verbs --json names a file, of some it says in what form the output is; "" of the others."""
    text = subprocess.run([program, *verb.split(), "--help"], capture_output=True, text=True).stdout
    flag = re.search(r"^ +--json( [A-Z]+)?", text, re.MULTILINE)
    return "" if not flag else "--json=-" if flag[1] else "--json"


def _word(value) -> str:
    if isinstance(value, float):
        return repr(float(value))
    return os.fspath(value) if hasattr(value, "__fspath__") else str(value)
