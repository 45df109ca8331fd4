#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that includes between the layers point down only (tools/layers.txt).

A third-party library is used where OWNERS says and nowhere else, most in one folder only.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ROOT / "src" / "axiometry"
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
OWNERS = {  # prefix of an include -> the only folder that may use it; linear algebra has two
    "nlohmann/": "src/axiometry/base/",
    "Eigen/": ("src/axiometry/numeric/", "src/axiometry/uncertainty/", "src/axiometry/tracking/",
               "src/axiometry/volumetric/"),
    # What decomposes matrices is compiled once, by numeric/dense/dense.h.
    **{f"Eigen/{header}": "src/axiometry/numeric/dense/"
       for header in ("Dense", "QR", "SVD", "LU", "Cholesky", "Eigenvalues", "Householder", "Geometry")},
    "muParser": "src/axiometry/app/",
    "openssl/": ("src/axiometry/digest/", "apps/server/"),
    "sqlite3": "src/axiometry/store/",
    "libpq-fe": "src/axiometry/store/",
    "boost/": ("apps/server/", "src/axiometry/verification/"),
    "cairo": "src/axiometry/report/",
    "pango/": "src/axiometry/report/",
    "pybind11/": "apps/python/",
    "CLI/": ("apps/cli/main.cpp", "apps/cli/flags/verb.cpp", "apps/cli/verbs/completion.cpp",
             "apps/cli/verbs/manual.cpp"),
}


def allowed_includes():
    """Room -> what it may include, in the order of the file; and what is wrong with that order."""
    allowed, wrong = {}, []
    for number, line in enumerate((ROOT / "tools" / "layers.txt").read_text().splitlines(), 1):
        line = line.split("#")[0].strip()
        if not line:
            continue
        room, _, below = line.partition(":")
        above = set(allowed) | {known.split("/")[0] for known in allowed}
        wrong += [f"tools/layers.txt:{number}: {room} names {name}, which does not stand above it"
                  for name in below.split() if "." not in name and name not in above]
        allowed[room.strip()] = set(below.split())
    return allowed, wrong


def room_of(path, rooms):
    """The folder with a line of its own that is nearest above a file; nothing where there is none."""
    parts = path.split("/")[:-1]
    return next((name for n in range(len(parts), 0, -1) if (name := "/".join(parts[:n])) in rooms), None)


def may_include(room, included, allowed):
    other = room_of(included, allowed) or included.split("/")[0]
    layer = other.split("/")[0]
    below = allowed[room]
    return other == room or other in below or included in below or (layer != room.split("/")[0] and layer in below)


def problems():
    allowed, wrong = allowed_includes()
    yield from wrong
    sources = [p for folder in (SOURCES, ROOT / "apps") for p in sorted(folder.rglob("*")) if p.suffix in (".h", ".cpp")]
    for path in sources:
        name = path.relative_to(ROOT).as_posix()
        inside = SOURCES in path.parents
        room = room_of(path.relative_to(SOURCES).as_posix(), allowed) if inside else None
        is_test = path.stem.endswith(("_test", "_bench"))
        if inside and room is None:
            yield f"{name}:1: its folder is not in tools/layers.txt"
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            included = match.group(1)
            if included.startswith("axiometry/") and inside and not is_test:
                below = included.removeprefix("axiometry/")
                if not may_include(room, below, allowed):
                    yield f"{name}:{number}: {room} must not include {included}"
            for prefix, owner in OWNERS.items():
                if included.startswith(prefix) and not name.startswith(owner):
                    yield f"{name}:{number}: only {owner} may include {included}"


def main():
    found = list(problems())
    print("\n".join(found) if found else "layers: ok")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
