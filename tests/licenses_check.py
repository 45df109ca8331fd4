#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Everything that others wrote and the program holds or needs must be in its list, and in the bill of materials.

Usage: licenses_check.py PROGRAM SPDX_FILE 1|0 (whether the Python package is built)

licenses/components.json is held against what the build looks for, what the sources include, what the page depends on and
what the program is linked with; `axiometry licenses` and the bill of materials against it.
"""
import json
import pathlib
import re
import subprocess
import sys

from elf import Elf

ROOT = pathlib.Path(__file__).resolve().parent.parent
OF_THE_BUILD = {"PkgConfig", "Python3", "GTest", "benchmark", "rapidcheck", "OpenMP", "Doxygen"}  # tools and tests
OF_THE_SYSTEM = re.compile(r"^(sys|arpa|netinet|net|asm|linux)$")


def demand(condition, message):
    if not condition:
        sys.exit(f"failed: {message}")


def looked_for():
    """What CMake finds, tests and benchmarks aside."""
    names = set()
    files = [ROOT / "CMakeLists.txt", *ROOT.glob("cmake/*.cmake"), *ROOT.glob("apps/*/CMakeLists.txt")]
    for path in files:
        text = path.read_text(encoding="utf-8")
        names |= set(re.findall(r"find_package\((\w+)", text)) | set(re.findall(r"pkg_check_modules\((\w+)", text))
    return names - OF_THE_BUILD


def included():
    """The first part of <...> of what is neither of the language nor of the system."""
    names = set()
    for folder in ("src", "apps"):
        for path in (ROOT / folder).rglob("*"):
            if path.suffix not in (".h", ".cpp") or path.stem.endswith(("_test", "_bench", "_test_support")):
                continue
            for header in re.findall(r"^#include <([\w./-]+)>", path.read_text(encoding="utf-8"), re.M):
                first = header.split("/")[0]
                if "/" in header and not OF_THE_SYSTEM.match(first):
                    names.add(first)
                elif header in ("libpq-fe.h", "sqlite3.h", "muParser.h", "cairo.h", "cairo-pdf.h", "glib.h"):
                    names.add(header[:-2])
    return names


def linked(program):
    """Names of the shared libraries that the program itself asks for, without versions."""
    return {name.split(".so")[0] for name in Elf(pathlib.Path(program).read_bytes()).libraries()}


def main():
    program, spdx_file, has_python = sys.argv[1:4]
    rows = json.loads((ROOT / "licenses/components.json").read_text(encoding="utf-8"))
    known = {key: {x for row in rows for x in row[key]} for key in ("found", "headers", "libraries")}
    for what, names, key in (("CMake looks for", looked_for(), "found"), ("sources include", included(), "headers"),
                             ("the program is linked with", linked(program), "libraries")):
        demand(names, f"nothing that {what} was found")
        demand(names <= known[key], f"{what} {sorted(names - known[key])}, which licenses/components.json does not name")
    page = json.loads((ROOT / "web/package.json").read_text(encoding="utf-8"))["dependencies"]
    packages = {row.get("package") for row in rows}
    demand(set(page) <= packages, f"the page depends on {sorted(set(page) - packages)}, which is not in the list")

    shown = subprocess.run([program, "licenses"], capture_output=True, text=True, check=True).stdout
    spdx = json.loads(pathlib.Path(spdx_file).read_text(encoding="utf-8"))
    demand(spdx["spdxVersion"] == "SPDX-2.3" and spdx["dataLicense"] == "CC0-1.0", "the bill of materials is none")
    of_spdx = {p["name"]: p for p in spdx["packages"]}
    rows = [row for row in rows if "with" not in row or has_python == "1"]
    demand(set(of_spdx) == {row["name"] for row in rows} | {"axiometry"}, "the bill of materials has another list")
    ids = {p["SPDXID"] for p in spdx["packages"]}
    demand(len(ids) == len(of_spdx), "two packages have one SPDXID")
    demand({r["relatedSpdxElement"] for r in spdx["relationships"]} == ids, "a relationship is missing")
    for row in rows:
        package = of_spdx[row["name"]]
        version = package["versionInfo"]
        demand(re.match(r"\d+\.", version), f"{row['name']} has the version {version!r}")
        demand(package["licenseDeclared"] == row["license"], f"{row['name']} has another licence")
        line = next((x for x in shown.splitlines() if x.startswith(row["name"] + " ")), "")
        demand(version in line and line.endswith(row["license"]), f"'axiometry licenses' tells of {row['name']}: {line!r}")
        text = subprocess.run([program, "licenses", row["name"]], capture_output=True, text=True, check=True).stdout
        in_it = row["use"] != "shared"
        demand(bool(row["text"]) == in_it, f"{row['name']} is {row['use']} and its text is {row['text']!r}")
        demand(len(text) > 500 if in_it else "shared library" in text, f"the licence of {row['name']} is {text[:200]!r}")
    print(f"{len(rows)} components, in the program and in the bill of materials")


if __name__ == "__main__":
    main()
