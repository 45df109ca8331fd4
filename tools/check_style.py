#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks the part of STYLE.md that a program can check."""
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
CODE = (".h", ".cpp")
LICENCE = "SPDX-License-Identifier: Apache-2.0"
LINE_LIMIT = 120
# A file over these is a question; the answers that were accepted stand in ACCEPTED.
HEADER_LIMIT = 200
SOURCE_LIMIT = 400
ACCEPTED = {
    "src/axiometry/report/pdf/font_metrics.cpp",  # a table
}
FORBIDDEN = [
    (re.compile(r"\bstd::(stod|strtod|atof|setlocale)\b"), "number conversion that follows the locale"),
    (re.compile(r"-ffast-math"), "-ffast-math"),
    (re.compile(r"\busing namespace std\s*;"), "using namespace std"),
    (re.compile(r"\b(TODO|FIXME|XXX)\b"), "an unfinished note"),
]

# A file of the project that a comment names, with or without its folders.
NAMED_FILE = re.compile(r"(?<![\w./<*{}-])([a-z0-9_]+(?:/[a-z0-9_]+)*\.(?:h|cpp))\b")
FOREIGN_FILES = {"cet.h", "termios.h", "version.h"}  # of the system, and made by the build


def tracked_files():
    listing = subprocess.run(["git", "ls-files", "--cached", "--others", "--exclude-standard"], cwd=ROOT,
                             capture_output=True, text=True)
    if listing.returncode == 0:
        return [ROOT / name for name in listing.stdout.splitlines()]
    return [p for p in ROOT.rglob("*") if p.is_file() and "build" not in p.relative_to(ROOT).parts[:1]]


def check_code(name, text):
    lines = text.splitlines()
    if LICENCE not in "\n".join(lines[:3]):
        yield f"{name}:1: no licence line"
    if name.endswith(".h") and "#pragma once" not in text:
        yield f"{name}:1: no #pragma once"
    limit = HEADER_LIMIT if name.endswith(".h") else SOURCE_LIMIT
    if len(lines) > limit and name not in ACCEPTED and not name.endswith("_test.cpp"):
        yield f"{name}: {len(lines)} lines, more than {limit}"
    for number, line in enumerate(lines, 1):
        if len(line) > LINE_LIMIT:
            yield f"{name}:{number}: {len(line)} characters, more than {LINE_LIMIT}"
        if "\t" in line or line != line.rstrip():
            yield f"{name}:{number}: tab or trailing blank"
        for pattern, what in FORBIDDEN:
            if pattern.search(line):
                yield f"{name}:{number}: {what}"


def check_named_files(name, text, files):
    """What a comment sends its reader to is there: after a file was moved or renamed it says where."""
    for number, line in enumerate(text.splitlines(), 1):
        _, _, comment = line.partition("//")
        for named in NAMED_FILE.findall(comment):
            if named not in FOREIGN_FILES and not any(f"/{file}".endswith(f"/{named}") for file in files):
                yield f"{name}:{number}: found {named} in a comment, expected a file that exists"


def types_defined(lines):
    """Types with linkage that lines of clang-format's shape define at namespace level: (qualified name, line number)."""
    namespaces = []
    for number, line in enumerate(lines, 1):
        if opened := re.match(r"namespace(?: ([\w:]+))? \{", line):
            namespaces.append(opened[1])
        elif line.startswith("}  // namespace"):
            namespaces.pop()
        elif (defined := re.match(r"(?:struct|class|enum class) ([\w:]+)(?=[ {])[^;()]*\{", line)) and None not in namespaces:
            yield "::".join([*namespaces, defined[1]]), number


class OneDefinition:
    """Two types of one name are no error to compiler and linker, but each file may get the functions of the other."""

    def __init__(self):
        self.places = {}

    def check(self, name, text):
        for defined, number in types_defined(text.splitlines()):
            place = self.places.setdefault(defined, f"{name}:{number}")
            if place != f"{name}:{number}":
                yield f"{name}:{number}: {defined} is another type than that of {place}"


def problems():
    one_definition = OneDefinition()
    tracked = tracked_files()
    files = [path.relative_to(ROOT).as_posix() for path in tracked if path.suffix in CODE and path.is_file()]
    for path in tracked:
        if not path.is_file():
            continue
        name = path.relative_to(ROOT).as_posix()
        if path.suffix in CODE:
            text = path.read_text(encoding="utf-8")
            yield from check_code(name, text)
            yield from one_definition.check(name, text)
            yield from check_named_files(name, text, files)
        if path.suffix in CODE and path.stem != path.stem.lower():
            yield f"{name}: file names are snake_case"


def main():
    found = list(problems())
    print("\n".join(found) if found else "style: ok")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
