#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that kernels compiled for special instructions share no function with the rest of the program.

Usage: tools/check_kernels.py LIBRARY

An inline function or template instance of a header is a weak symbol: the linker keeps one of several, perhaps the one
with instructions that the processor does not have.
"""
import re
import subprocess
import sys


def main():
    listing = subprocess.run(["nm", "-C", "-A", sys.argv[1]], capture_output=True, text=True, check=True).stdout
    kernels, shared = set(), []
    for line in listing.splitlines():
        found = re.match(r".*[:\[](\w*kernels?_(?:plain|avx2|avx512)\.cpp\.o)\]?:\s*[0-9a-f]* (\w) (.*)", line)
        if not found:
            continue
        kernels.add(found[1])
        if found[2] in "VvWwu":
            shared.append(f"{found[1]}: {found[3]}")
    print("\n".join(shared) or f"kernels: {len(kernels)} share nothing")
    return 1 if shared or not kernels else 0


if __name__ == "__main__":
    sys.exit(main())
