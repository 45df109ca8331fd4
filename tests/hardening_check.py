#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads the headers of the built program: what cmake/AxiometryHardening.cmake asks for must be in it.

Usage: hardening_check.py PROGRAM
"""
import pathlib
import sys

from elf import PT_LOAD, Elf

ET_DYN = 3
PT_GNU_STACK, PT_GNU_RELRO = 0x6474e551, 0x6474e552
PF_X, PF_W = 1, 2
DT_BIND_NOW, DT_FLAGS, DT_FLAGS_1, DT_TEXTREL = 24, 30, 0x6ffffffb, 22
DF_BIND_NOW, DF_1_NOW, DF_1_PIE = 8, 1, 0x08000000


def faults(elf):
    dynamic = elf.dynamic()
    if elf.type != ET_DYN or not dynamic.get(DT_FLAGS_1, 0) & DF_1_PIE:
        yield "it is not position-independent (PIE)"
    if not elf.of_type(PT_GNU_RELRO):
        yield "it has no segment that becomes read-only (RELRO)"
    now = DT_BIND_NOW in dynamic or dynamic.get(DT_FLAGS, 0) & DF_BIND_NOW or dynamic.get(DT_FLAGS_1, 0) & DF_1_NOW
    if not now:
        yield "its symbols are bound late: RELRO is not full"
    if DT_TEXTREL in dynamic:
        yield "its code is written to when it starts"
    stacks = elf.of_type(PT_GNU_STACK)
    if not stacks or stacks[0]["flags"] & PF_X:
        yield "its stack can be executed"
    if any(s["flags"] & PF_W and s["flags"] & PF_X for s in elf.of_type(PT_LOAD)):
        yield "memory can be both written and executed"


def main():
    found = list(faults(Elf(pathlib.Path(sys.argv[1]).read_bytes())))
    for fault in found:
        print(f"{sys.argv[1]}: {fault}")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
