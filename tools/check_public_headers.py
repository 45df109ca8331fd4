#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks cmake/public_headers.txt, the one list of headers that somebody else's program may include.

Usage: tools/check_public_headers.py [COMPILER GENERATED]

They include each other and the C++ standard library only, name what they use of it, and no part stands in the list that
no entrance needs; what belongs to core needs nothing of the rest. With a compiler and the folder of generated headers
each of them is compiled alone.
"""
import concurrent.futures
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
LIST = ROOT / "cmake" / "public_headers.txt"
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.M)
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.S)
STANDARD_NAME = re.compile(r"\bstd::(?:ranges::)?(\w+)")
GENERATED = {"base/version.h": "#include <string_view>\n"}  # what the generated header includes
# Name of the standard library -> the header that declares it.
HEADER_OF = {name: header for header, names in {
    "algorithm": "max min max_element none_of upper_bound find", "array": "array", "bit": "bit_ceil", "cmath": "abs exp hypot isfinite isnan nearbyint",
    "cstddef": "size_t", "cstdint": "int64_t uint32_t uint64_t uintptr_t", "deque": "deque", "expected": "expected unexpected",
    "functional": "function", "initializer_list": "initializer_list", "iterator": "size", "limits": "numeric_limits",
    "map": "map", "memory": "make_unique_for_overwrite shared_ptr unique_ptr", "optional": "nullopt optional", "set": "set", "stop_token": "stop_token",
    "source_location": "source_location", "span": "span", "string": "string", "string_view": "string_view",
    "utility": "exchange move pair", "variant": "monostate variant", "vector": "vector"}.items() for name in names.split()}
# Headers that the standard says bring a name along.
ALSO = {"size": {"array", "span", "string", "string_view", "vector", "map", "set", "deque"},
        "initializer_list": {"vector", "string", "map", "set"}, "size_t": {"cstdio", "cstdlib", "cstring"},
        "abs": {"cstdlib"}}
# In the standard every container and view gives std::size_t a meaning of its own; g++ and clang declare it with each.
ALSO["size_t"] |= {"span", "string", "string_view", "vector", "array"}


def sections():
    """Section -> headers, in their order."""
    found, current = {}, None
    for line in LIST.read_text(encoding="utf-8").splitlines():
        line = line.strip()
        if not line or line.startswith("#"):
            continue
        if line.endswith(":"):
            current = found.setdefault(line[:-1], [])
        else:
            current.append(line)
    return found


def text_of(header):
    if header in GENERATED:
        return GENERATED[header]
    return (ROOT / "src" / "axiometry" / header).read_text(encoding="utf-8")


def includes_of(header):
    """Headers of ours, and those of anybody else."""
    all_of = [name for _, name in INCLUDE.findall(text_of(header))]
    ours = [name.removeprefix("axiometry/") for name in all_of if name.startswith("axiometry/")]
    return ours, [name for name in all_of if not name.startswith("axiometry/")]


def closure(headers):
    seen, waiting = set(), list(headers)
    while waiting:
        header = waiting.pop()
        if header not in seen:
            seen.add(header)
            waiting += includes_of(header)[0]
    return seen


def problems():
    found = sections()
    order = ["core entrances", "core parts", "axiometry entrances", "axiometry parts"]
    if list(found) != order:
        yield f"{LIST.name}: expected the sections {', '.join(order)}"
        return
    listed = [header for headers in found.values() for header in headers]
    for section, headers in found.items():
        if headers != sorted(headers):
            yield f"{LIST.name}: {section} are not in the order of their names"
    for header in sorted({header for header in listed if listed.count(header) > 1}):
        yield f"{LIST.name}: {header} is listed twice"
    missing = [h for h in listed if h not in GENERATED and not (ROOT / "src" / "axiometry" / h).is_file()]
    if missing:
        yield from (f"{LIST.name}: there is no {header}" for header in missing)
        return
    core = set(found["core entrances"] + found["core parts"])
    needed = closure(found["core entrances"])
    yield from (f"{LIST.name}: an entrance of core needs {header}" for header in sorted(needed - core))
    yield from (f"{LIST.name}: no entrance of core needs {header}" for header in sorted(core - needed))
    everything = closure(found["core entrances"] + found["axiometry entrances"])
    yield from (f"{LIST.name}: an entrance needs {header}" for header in sorted(everything - set(listed)))
    yield from (f"{LIST.name}: no entrance needs {header}" for header in sorted(set(listed) - everything))
    for header in listed:
        yield from problems_of(header)


def problems_of(header):
    foreign = {name for each in closure([header]) for name in includes_of(each)[1]}
    for name in includes_of(header)[1]:
        if not re.fullmatch(r"[a-z_]+|sys/types\.h", name):  # of POSIX: dev_t and ino_t
            yield f"{header}: a public header must not include {name}"
    for name in sorted(set(STANDARD_NAME.findall(COMMENT.sub("", text_of(header))))):
        if name == "ranges":
            continue
        if name not in HEADER_OF:
            yield f"{header}: which header declares std::{name}? (tools/check_public_headers.py)"
        elif not foreign & ({HEADER_OF[name]} | ALSO.get(name, set())):
            yield f"{header}: std::{name} needs <{HEADER_OF[name]}>"


def chains(headers):
    """The headers in chains, of which each includes the one before, so that what stands before a header in its chain is
    there without it too: each is compiled as if it were alone, and few times a compiler is started."""
    found = []
    includes = {header: closure([header]) for header in headers}
    for header in sorted(headers, key=lambda each: len(includes[each])):
        fitting = [chain for chain in found if chain[-1] in includes[header]]
        if fitting:
            max(fitting, key=lambda chain: len(includes[chain[-1]])).append(header)
        else:
            found.append([header])
    return found


def compile_alone(compiler, generated):
    """What the compiler says of each header. What all of them include of the standard library is compiled once, before;
    that each header names its own part of it problems_of() has seen."""
    listed = [header for headers in sections().values() for header in headers]
    standard = sorted({name for header in closure(listed) for name in includes_of(header)[1]})
    flags = ["-std=c++23", "-Wall", "-Wextra", "-Werror", f"-I{ROOT / 'src'}", f"-I{generated}"]
    with tempfile.TemporaryDirectory() as folder:
        before = pathlib.Path(folder) / "standard.h"
        before.write_text("".join(f"#include <{name}>\n" for name in standard))
        subprocess.run([compiler, *flags, "-x", "c++-header", before, "-o", f"{before}.gch"], check=True)

        def said(chain):
            done = subprocess.run([compiler, *flags, "-include", before, "-fsyntax-only", "-x", "c++", "-"], text=True,
                                  input="".join(f"#include <axiometry/{header}>\n" for header in chain),
                                  stderr=subprocess.PIPE)
            return f"{', '.join(chain)}:\n{done.stderr}" if done.returncode else ""

        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            return [text for text in pool.map(said, chains(listed)) if text]


def main():
    found = list(problems())
    if not found and len(sys.argv) == 3:
        found = compile_alone(*sys.argv[1:])
    count = sum(map(len, sections().values()))
    print("\n".join(found) if found else f"public headers: {count}, ok")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
