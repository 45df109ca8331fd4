#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""kill_test.py PROGRAM [ROUNDS]: programs that put tests into one archive are killed at random moments.

Every test that a program said it had kept must be there afterwards, and the archive must verify. With
AXIOMETRY_TEST_POSTGRESQL (tests/store/with_postgresql) the archive is in that server, else in a file.
"""
import json
import os
import pathlib
import random
import re
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
FILES_EACH = 200
WRITERS = 2


def measured_file(folder, number):
    """A small test of its own, so that its bytes are new."""
    lines = ["# machine.name: Mill", "# axis.name: X", "# axis.kind: linear", "target_mm,direction,run,deviation_um"]
    for cycle in range(1, 6):
        for direction in ("up", "down"):
            for target in range(0, 600, 100):
                lines.append(f"{target},{direction},{cycle},{random.uniform(-3, 3) + number * 1e-6:.6f}")
    path = folder / f"run{number}.csv"
    path.write_text("\n".join(lines) + "\n")
    return path


def address(folder):
    server = os.environ.get("AXIOMETRY_TEST_POSTGRESQL")
    if server is None:
        return str(folder / "archive.db")
    return f"{server}{'&' if '?' in server else '?'}options=-csearch_path%3Dkilled_{os.getpid()}"


def run(program, *arguments):
    return subprocess.run([program, "store", *arguments], capture_output=True, text=True, encoding="utf-8")


def kill_writers(program, store, files):
    """Starts writers, kills each at its moment, and gives the numbers that they said."""
    writers = []
    for _ in range(WRITERS):
        writers.append(subprocess.Popen([program, "store", "add", *random.sample(files, len(files)), "--store", store],
                                        stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True, encoding="utf-8"))
    said = []
    for writer in writers:
        time.sleep(random.uniform(0.05, 1.0))
        writer.kill()
        output, errors = writer.communicate()
        if errors:
            sys.exit(f"a writer said: {errors}")
        said += [int(number) for number in re.findall(r"^test (\d+): .*\n", output, re.MULTILINE)]
    return said


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    rounds = int(sys.argv[2]) if len(sys.argv) > 2 else 12
    random.seed(230)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        store = address(folder)
        files = [str(measured_file(folder, number)) for number in range(FILES_EACH)]
        acknowledged = []
        for _ in range(rounds):
            acknowledged += kill_writers(program, store, files)
        verified = run(program, "verify", "--json", "--store", store)
        if verified.returncode != 0:
            sys.exit(f"verify ended with {verified.returncode}: {verified.stdout}{verified.stderr}")
        kept = json.loads(verified.stdout)["tests"]
    if not acknowledged:
        sys.exit("no writer kept a test before it was killed: nothing was tried")
    if len(set(acknowledged)) != len(acknowledged):
        sys.exit("a number was given twice")
    if max(acknowledged) > kept:  # numbers have no gaps, which verify has just proved
        sys.exit(f"test {max(acknowledged)} was acknowledged, {kept} are there")
    print(f"{rounds * WRITERS} writers killed, {len(acknowledged)} tests acknowledged, {kept} there, all verified")


if __name__ == "__main__":
    main()
