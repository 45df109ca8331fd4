#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Reads the headers of the built program: what cmake/AxiometryHardening.cmake asks for must be in it.

Usage: hardening_check.py PROGRAM
"""
import pathlib
import re
import sys

from elf import PF_W, PF_X, PT_LOAD, Elf

ET_DYN = 3
PT_GNU_STACK, PT_GNU_RELRO = 0x6474e551, 0x6474e552
X86_64 = 62
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
    yield from faults_of_code(elf)


def faults_of_code(elf):
    """What the compiler has put into the functions. Of the processors only x86-64's instructions are known here."""
    names = elf.names()
    if "__stack_chk_fail" not in names:
        yield "no function asks whether its stack was written over (-fstack-protector-strong)"
    if not any(name.endswith("_chk") for name in names):
        yield "no function of the C library is told the size of what it writes to (_FORTIFY_SOURCE)"
    if elf.machine != X86_64:
        return
    code = elf.code()
    for what, instruction, least in (("compares a canary (-fstack-protector-strong)", CANARY, 1000),
                                     ("touches each page of a large frame (-fstack-clash-protection)", PROBE, 20),
                                     ("is marked as the end of an indirect jump (-fcf-protection)", MARK, 1000)):
        found = len(re.findall(instruction, code, re.DOTALL))
        if found < least:
            yield f"{what}: found {found} times, expected {least} at least"


# sub or xor of a register with %fs:0x28; or $0, (%rsp); endbr64
CANARY = rb"\x64\x48[\x2b\x33][\x04\x0c\x14\x1c\x24\x2c\x34\x3c]\x25\x28\0\0\0"
PROBE = rb"\x48\x83\x0c\x24\x00"
MARK = rb"\xf3\x0f\x1e\xfa"


def main():
    found = list(faults(Elf(pathlib.Path(sys.argv[1]).read_bytes())))
    for fault in found:
        print(f"{sys.argv[1]}: {fault}")
    sys.exit(1 if found else 0)


if __name__ == "__main__":
    main()
