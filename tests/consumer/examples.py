#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Compiles and runs every C++ fragment of the documents against an installed Axiometry, with pkg-config alone.

Usage: examples.py PREFIX [--update]

Each fragment is a whole program, and what it prints stands in the block of text behind it. One that includes headers of
core only is linked with core only. --update writes what was printed into the documents.
"""
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DOCUMENTS = ["README.md", "docs/howto/use-as-a-library.md"]
FRAGMENT = re.compile(r"^```cpp\n(.*?)^```\n(?:\n^```text\n(.*?)^```\n)?", re.M | re.S)
INCLUDE = re.compile(r"#include <axiometry/([^>]+)>")


def core_headers():
    text = (ROOT / "cmake" / "public_headers.txt").read_text(encoding="utf-8")
    return set(text.split("core entrances:")[1].split("axiometry entrances:")[0].split())


def run(program, prefix, folder):
    """What the program prints; fails with what the compiler or the program has to say."""
    package = "axiometry-core" if set(INCLUDE.findall(program)) <= core_headers() else "axiometry"
    found = [str(p) for p in pathlib.Path(prefix).rglob("pkgconfig")]
    environment = dict(os.environ, PKG_CONFIG_PATH=":".join(found))
    flags = subprocess.run(["pkg-config", "--cflags", "--libs", package], env=environment, capture_output=True,
                           text=True, check=True).stdout.split()
    binary = folder / "example"
    built = subprocess.run([os.environ.get("CXX", "c++"), "-std=c++23", "-Wall", "-Wextra", "-Werror", "-x", "c++", "-",
                            "-x", "none", "-o", binary, *flags], input=program, text=True, stderr=subprocess.PIPE)
    if built.returncode:
        return None, built.stderr
    libraries = next((flag[2:] for flag in flags if flag.startswith("-L" + str(prefix))), "")
    done = subprocess.run([binary], cwd=ROOT, env=dict(os.environ, LD_LIBRARY_PATH=libraries), capture_output=True, text=True)
    if done.returncode:
        return None, f"it ended with {done.returncode}\n{done.stdout}{done.stderr}"
    return done.stdout, ""


def main():
    prefix, update = sys.argv[1], "--update" in sys.argv[2:]
    problems, count = [], 0
    with tempfile.TemporaryDirectory() as folder:
        for name in DOCUMENTS:
            text = (ROOT / name).read_text(encoding="utf-8")
            fragments = list(FRAGMENT.finditer(text))
            if not fragments:
                problems.append(f"{name}: found no fragment of C++")
            for fragment in reversed(fragments):
                place = f"{name}:{text[:fragment.start()].count(chr(10)) + 1}"
                count += 1
                if fragment[2] is None:
                    problems.append(f"{place}: found no block of text behind the program, expected what it prints")
                    continue
                printed, error = run(fragment[1], prefix, pathlib.Path(folder))
                if printed is None:
                    problems.append(f"{place}: {error}")
                elif printed != fragment[2] and update:
                    text = text[:fragment.start(2)] + printed + text[fragment.end(2):]
                elif printed != fragment[2]:
                    problems.append(f"{place}: it prints\n{printed}")
            if update:
                (ROOT / name).write_text(text, encoding="utf-8")
    print("\n".join(problems) if problems else f"examples of the documents: {count}, ok")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
