#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks what axiometry::core was built from: of foreign code fmt and Eigen, and nothing else.

Usage: core_needs.py BUILD_DIR

Every header that the compiler opened for it belongs to the project, to fmt, to Eigen or to the compiler and the C
library (Debian says to which package a file belongs); and all its names are found in fmt and the standard library.
"""
import pathlib
import re
import subprocess
import sys
import tempfile

PACKAGES = re.compile(r"libfmt-dev|libeigen3-dev|libstdc\+\+-\d+-dev|libgcc-\d+-dev|libc6-dev|linux-libc-dev|libclang-.*-dev")


def headers(build):
    """What the compiler has opened for the objects of core, its common headers among them."""
    listing = subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout
    found, objects, ours = set(), 0, False
    for line in listing.splitlines():
        if line and not line.startswith(" "):
            ours = line.startswith(("CMakeFiles/axiometry_core.dir/", "CMakeFiles/axiometry_simulation.dir/"))
            objects += ours
        elif ours and line.strip():
            found.add((build / line.strip()).resolve())
    return found, objects


def owners(paths):
    done = subprocess.run(["dpkg-query", "-S", *map(str, paths)], capture_output=True, text=True)
    found = {path: "nobody" for path in map(str, paths)}
    for line in done.stdout.splitlines():
        package, _, path = line.partition(": ")
        found[path] = package.split(":")[0]
    return found


def main():
    build = pathlib.Path(sys.argv[1]).resolve()
    opened, objects = headers(build)
    project = pathlib.Path(__file__).resolve().parent.parent.parent
    foreign = sorted(path for path in opened if project not in path.parents and build not in path.parents)
    problems = [f"core was compiled with {path} of {package}" for path, package in owners(foreign).items()
                if not PACKAGES.fullmatch(package)]
    if objects < 10 or not any("Eigen" in str(path) for path in foreign):
        problems.append(f"found {objects} objects of core and {len(foreign)} foreign headers: what was looked at?")
    with tempfile.TemporaryDirectory() as folder:
        linked = subprocess.run(["c++", "-shared", "-o", f"{folder}/core.so", "-Wl,-z,defs", "-Wl,--whole-archive",
                                 build / "libaxiometry_core.a", "-Wl,--no-whole-archive", "-lfmt"],
                                stderr=subprocess.PIPE, text=True)
    if linked.returncode:
        problems.append(linked.stderr)
    print("\n".join(problems) if problems else f"core needs: {objects} objects, fmt and Eigen, ok")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
