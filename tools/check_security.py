#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks docs/security.md: every test that it names as `FILE: NAME` is in that file, every file that it names is there,
every row of what is met has a proof, and each requirement of ASVS 4.0.3 up to level 2 stands in one table, once.

A FILE is the end of one path. A NAME is `Suite.test` in C++, a function in Python, a test of the page in JavaScript.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
FOLDERS = ("apps", "cmake", "docs", "scripts", "src", "tests", "tools", "web/tests")
# Section:last requirement, or section:requirements where 4.0.3 calls some deleted or asks some of level 3 alone.
ASVS = """
1.1:7 1.2:4 1.4:1,4,5 1.5:4 1.6:4 1.7:2 1.8:2 1.9:2 1.10:1 1.11:2 1.12:2, 1.14:6 2.1:12 2.2:3 2.3:3 2.4:5 2.5:7 2.6:3
2.7:6 2.8:7 2.9:3 2.10:4 3.1:1 3.2:4 3.3:4 3.4:5 3.5:3 3.7:1 4.1:1,2,3,5 4.2:2 4.3:3 5.1:5 5.2:8 5.3:10 5.4:3 5.5:4
6.1:3 6.2:6 6.3:2 6.4:2 7.1:4 7.2:2 7.3:1,3,4 7.4:3 8.1:4 8.2:3 8.3:8 9.1:3 9.2:4 10.2:2 10.3:3 11.1:8 12.1:3 12.2:1
12.3:6 12.4:2 12.5:2 12.6:1 13.1:1,3,4,5 13.2:1,2,3,5,6 13.3:2 13.4:2 14.1:4 14.2:6 14.3:2,3 14.4:7 14.5:4"""


def level_2():
    for section, _, numbers in (entry.partition(":") for entry in ASVS.split()):
        listed = filter(None, numbers.split(",")) if "," in numbers else range(1, int(numbers) + 1)
        yield from (f"{section}.{k}" for k in listed)


def files_ending(end):
    if (ROOT / end).is_file():
        return {ROOT / end}
    found = (path for folder in FOLDERS for path in (ROOT / folder).rglob(pathlib.PurePath(end).name))
    return {path for path in found if f"/{path.relative_to(ROOT).as_posix()}".endswith(f"/{end}")}


def holds(path, name):
    text = path.read_text(encoding="utf-8")
    suite, _, test = map(re.escape, name.partition("."))
    patterns = {".cpp": rf"^TEST(_F|_P)?\({suite}, {test}\)", ".py": rf"^def {suite}\(", ".mjs": f"'{re.escape(name)}'"}
    return re.search(patterns[path.suffix], text, re.MULTILINE)


def wrong_names(line):
    for span in re.findall(r"`([^`]+)`", line):
        named = re.fullmatch(r"([\w./-]+\.(?:cpp|mjs|py)): (.+)", span)
        if not named and not re.fullmatch(r"[\w./-]+\.(?:cpp|h|json|md|mjs|py|sql|txt)", span):
            continue
        found = files_ending(named[1] if named else span)
        if len(found) != 1:
            yield f"found {len(found)} files for {span}, expected one"
        elif named and not holds(*found, named[2]):
            yield f"found no test {named[2]} in {named[1]}"


def requirements(cell):
    """"5.2.1, 5.2.7–5.2.8" as single numbers."""
    for first, _, last in (part.strip().partition("–") for part in cell.split(",")):
        section, _, low = first.rpartition(".")
        yield from (f"{section}.{k}" for k in range(int(low), int(last.rpartition(".")[2] or low) + 1))


def problems(text):
    expected, seen = set(level_2()), set()
    for number, line in enumerate(text.splitlines(), 1):
        yield from (f"{number}: {fault}" for fault in wrong_names(line))
        row = re.match(r"\| (\d+\.\d[\d., –]*) \|", line)
        for one in requirements(row[1]) if row else ():
            if one not in expected or one in seen:
                yield f"{number}: found {one}, expected what level 2 asks, once"
            seen.add(one)
        if row and line.count("|") == 5 and "`" not in line.split("|")[4]:
            yield f"{number}: found {row[1]} without a proof"
    yield from (f"found no row for {one}" for one in sorted(expected - seen))


if __name__ == "__main__":
    faults = list(problems((ROOT / "docs" / "security.md").read_text(encoding="utf-8")))
    print("\n".join(f"docs/security.md:{fault}" for fault in faults) or "security: ok")
    sys.exit(1 if faults else 0)
