#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether sentences of the library leave flags to the command line, whose own table tells them.

Of apps/cli/text/flags_of_words.cpp the words must stand in a sentence of the program, and the flags must be flags that
a verb of it adds. No sentence with a flag in it may come from src/axiometry: the API and the page say it too. Exits with
1 where one of it is not so.

    python3 tests/flags_of_words.py
"""
import pathlib
import re
import sys

import language_pairs

ROOT = pathlib.Path(__file__).resolve().parent.parent
TABLE = ROOT / "apps/cli/text/flags_of_words.cpp"
ROW = re.compile(r'Row\{"((?:[^"\\]|\\.)*)", "((?:[^"\\]|\\.)*)"\}')
FLAG = re.compile(r"--[a-z][a-z-]*")
ADDED = re.compile(r'"(--[a-z][a-z-]*)(?:,-\w)?"')
LITERALS_APART = re.compile(r'"\s*\n\s*"')


def sentences():
    for _, pairs in language_pairs.subjects("de"):
        yield from pairs


def literals(folder, *endings):
    """All sources of a folder, literals that stand in several lines as one."""
    return "\n".join(LITERALS_APART.sub("", path.read_text(encoding="utf-8"))
                     for path in sorted((ROOT / folder).rglob("*")) if path.suffix in endings)


def from_edges(sentence, edges):
    """Whether the words around each flag of it are those of the command line, the server or the page."""
    return all(piece in edges for piece in re.split(r"\{\d+[=#?]?\}", sentence) if FLAG.search(piece))


def main():
    problems = []
    known = {flag for folder in ("apps/cli/verbs", "apps/cli/flags", "src/axiometry/app") for flag in ADDED.findall(literals(folder, ".cpp", ".h"))}
    told = list(sentences())
    rows = ROW.findall(TABLE.read_text(encoding="utf-8"))
    if len(rows) < 10 or len(known) < 100:
        problems.append(f"{len(rows)} rows and {len(known)} flags were found, expected more: this test reads them no longer")
    for words, flags in rows:
        if not any(words in sentence for sentence in told):
            problems.append(f"{TABLE.name}: no sentence has the words {words!r}")
        for flag in FLAG.findall(flags):
            if flag not in known:
                problems.append(f"{TABLE.name}: no verb has {flag}")
    edges = literals("apps", ".cpp", ".h") + literals("web/src", ".ts", ".tsx")
    problems += [f"src/axiometry names a flag, expected words, and the flag in {TABLE.name}: {sentence}"
                 for sentence in told if FLAG.search(sentence) and not from_edges(sentence, edges)]
    print("\n".join(problems) or f"{len(rows)} rows, {len(told)} sentences: flags are told by the command line alone")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
