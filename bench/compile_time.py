#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""compile_time.py BUILD_DIR PATTERN...: what it takes to compile the sources whose paths match one of the patterns.

Each is compiled alone, one after the other, by the command of the build's compile_commands.json, past ccache, to nowhere.
Prints seconds of processor time, memory at most, and the sum. The headers that are compiled once must be there: build
first, or ask for `cmake_pch`, which is what they are called, and is written.
"""
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys


def compiled(entry):
    """(seconds, MiB) of one source."""
    command = shlex.split(entry["command"])
    if "cmake_pch" not in entry["file"]:
        command[command.index("-o") + 1] = os.devnull
    running = subprocess.Popen(command, cwd=entry["directory"])
    _, status, used = os.wait4(running.pid, 0)
    if status != 0:
        sys.exit(f"{entry['file']} does not compile")
    return used.ru_utime + used.ru_stime, used.ru_maxrss / 1024


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    total = 0.0
    for entry in json.loads((build / "compile_commands.json").read_text()):
        if not any(re.search(pattern, entry["file"]) for pattern in sys.argv[2:]):
            continue
        seconds, memory = compiled(entry)
        total += seconds
        print(f"{seconds:6.1f} s {memory:5.0f} MiB  {os.path.relpath(entry['file'], build)}", flush=True)
    print(f"{total:6.1f} s")


if __name__ == "__main__":
    main()
