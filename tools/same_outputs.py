#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""same_outputs.py OLD NEW FOLDER... [--word OLD=NEW]...: whether two builds of the program give the same bytes.

Every file in and below the folders goes through the verbs that read it: what they print, how they end and what they
write is compared. For a change that is to change nothing. --word names an expression that is meant to have changed.
Exit code: 0 all the same, 1 something differs, which is named.
"""
import argparse
import concurrent.futures
import pathlib
import subprocess
import sys
import tempfile

LONGEST_S = 120
VERBS = [  # @ is the file, = a file that is written
    ["evaluate", "@", "--json", "-"],
    ["evaluate", "@", "--language", "de", "--report", "=.html", "--tolerance", "A=10um"],
    ["evaluate", "@", "--report", "=.svg", "--report", "=.csv", "--quiet"],
    ["uncertainty", "@", "--trials", "20000", "--seed", "7"],
    ["convert", "@", "=.csv"],
    ["convert", "@", "=.json"],
    ["periodic", "@", "--json", "-"],
    ["compare-rules", "@", "--json", "-"],
    ["check", "@"],
    ["tracking", "locate", "@", "--json", "-"],
    ["nc", "@", "--dialect", "linuxcnc"],
]


def outcome(program, verb, file, folder):
    folder.mkdir()
    words = [str(file) if word == "@" else word.replace("=.", "out.") if word.startswith("=.") else word for word in verb]
    done = subprocess.run([program, *words], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True, timeout=LONGEST_S)
    written = {path.name: path.read_bytes() for path in sorted(folder.iterdir())}
    return {"exit code": str(done.returncode).encode(), "standard output": done.stdout, "standard error": done.stderr, **written}


def differences(programs, verb, file, words):
    with tempfile.TemporaryDirectory() as folder:
        old, new = (outcome(program, verb, file, pathlib.Path(folder) / name)
                    for program, name in zip(programs, ("old", "new")))
    for was, is_now in words:
        old = {what: data.replace(was, is_now) for what, data in old.items()}
    return [f"{file}: {' '.join(verb)}: {what} differs" for what in sorted(old.keys() | new.keys())
            if old.get(what) != new.get(what)]


def main():
    parser = argparse.ArgumentParser(description="Compares the outputs of two builds of the program, byte by byte.")
    parser.add_argument("programs", nargs=2, metavar="PROGRAM")
    parser.add_argument("folders", nargs="+", metavar="FOLDER")
    parser.add_argument("--word", action="append", default=[], metavar="OLD=NEW")
    arguments = parser.parse_args()
    words = [tuple(part.encode() for part in word.split("=", 1)) for word in arguments.word]
    programs = [str(pathlib.Path(program).resolve()) for program in arguments.programs]
    files = sorted(path.resolve() for folder in arguments.folders for path in pathlib.Path(folder).rglob("*") if path.is_file())
    runs = [(verb, file) for file in files for verb in VERBS]
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        found = [line for lines in pool.map(lambda run: differences(programs, run[0], run[1], words), runs) for line in lines]
    print("\n".join(found))
    print(f"{len(runs)} runs over {len(files)} files: {len(found)} differences")
    return 1 if found or not runs else 0


if __name__ == "__main__":
    sys.exit(main())
