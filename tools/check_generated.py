#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks (or, with --update, writes) the files that the program generates about itself."""
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GENERATED = {
    "docs/man/axiometry.1": ["manual"],
    "schema/axiometry-test.schema.json": ["schema"],
    "schema/axiometry-import-profile.schema.json": ["schema", "import-profile"],
    "schema/axiometry-plan.schema.json": ["schema", "plan"],
    "schema/axiometry-station.schema.json": ["schema", "station"],
    "schema/axiometry-tracking-plan.schema.json": ["schema", "tracking-plan"],
}


def main():
    update = "--update" in sys.argv
    program = [a for a in sys.argv[1:] if a != "--update"][0]
    stale = 0
    for name, arguments in GENERATED.items():
        now = subprocess.run([program, *arguments], capture_output=True, check=True).stdout
        path = ROOT / name
        if path.exists() and path.read_bytes() == now:
            continue
        if update:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(now)
        else:
            stale += 1
            print(f"{name}: differs from 'axiometry {' '.join(arguments)}'; tools/check_generated.py PROGRAM --update writes it")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
