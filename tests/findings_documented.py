#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether docs/findings.md has every finding that the sources can make, and no other.

Reads the calls that make findings in src/axiometry and takes the first argument of each, its id. Reports an id that
stands in the sources and not in the table, or in the table and not in the sources, one that is not kebab-case, one of
the table that stands twice or out of order, and a call whose id is no literal. Exits with 1 if there is one.

    python3 tests/findings_documented.py
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
KEBAB = re.compile(r"[a-z][a-z0-9]*(-[a-z0-9]+)*")
ROW = re.compile(r"^\| `([^`]*)` \|", re.M)
LITERAL = r'"(?:[^"\\]|\\.)*"'
# An id: one literal, or one of two.
LITERAL_ID = re.compile(rf"^(?:[^\"]*\?\s*)?({LITERAL})(?:\s*:\s*({LITERAL}))?$")
# An id that was made elsewhere, handed on.
HANDED_ON = re.compile(r"^(?:std::move\()?(?:\w+\.)*id\)?$|^std::string (?:id|clause)$|^std::string_view id$")
# What stands right before an id. Helpers that are called so make findings only in the folders named.
ANYWHERE = [
    r"\b(?:findings|findings_|against)\.push_back\(\s*\{",
    r"\b(?:Named|Volumetric)?Finding\s*\{(?=\s*[^\s}])(?!\s*(?:std::string|bool)\s+\w+;)(?!\s*///)",
    rf"\{{(?=\s*{LITERAL}\s*,\s*(?:true|false)\s*,)",
    rf"\{{(?=\s*(?:{LITERAL}|std::move\(id\))\s*,\s*(?:{LITERAL}|\w+|std::move\(\w+\))\s*,\s*(?:iso230_2::)?Severity::)",
]
IN_FOLDER = {
    "standards": [r"(?<![\w.])(?:(?:iso230_2::)?rules::)?(?:note|missing|departure)\("],
    "standards/iso230_2/rules": [r'(?="environment-)'],
    "standards/rules": [r"\bexpect_approaches\(\s*(?:c|const RuleCase& c)\s*,"],
    "app/volumetric": [r"\btell\("],
}
# Calls that are named alike and make no findings.
OTHER_FILES = {"standards/iso230_2/inputs/inputs_items.cpp", "standards/iso230_2/inputs/resolved_rows.h", "standards/iso230_2/inputs/resolved_rows.cpp",
               "standards/readings/alignment.cpp", "standards/iso230_2/uncertainty/gum_environment.h"}
NOT_A_CALL = re.compile(r"^(?:double \w+|text|)$")


def sources():
    for path in sorted((ROOT / "src/axiometry").rglob("*")):
        name = path.relative_to(ROOT / "src/axiometry").as_posix()
        if path.suffix in (".cpp", ".h") and not name.endswith("_test.cpp") and name not in OTHER_FILES:
            yield name, re.sub(r"^\s*//[^\n]*|//[/ ][^\n\"]*$", "", path.read_text(encoding="utf-8"), flags=re.M)


def first_argument(text, start):
    """Up to the comma or the bracket that ends it."""
    depth, quoted, k = 0, False, start
    while k < len(text):
        c = text[k]
        if quoted and c == "\\":
            k += 1
        elif c == '"':
            quoted = not quoted
        elif not quoted:
            if c in "([{":
                depth += 1
            elif c in ")]}" or (c == "," and depth == 0) or (c == ";" and depth == 0):
                if depth == 0:
                    break
                depth -= 1
        k += 1
    return text[start:k].strip()


def made():
    """Every id that a call makes, with the file; and the calls of which none can be told."""
    found, faults = {}, []
    for name, text in sources():
        starts = ANYWHERE + [s for folder, more in IN_FOLDER.items() if name.startswith(folder + "/") for s in more]
        for match in re.finditer("|".join(starts), text):
            argument = first_argument(text, match.end())
            literal = LITERAL_ID.match(argument)
            if literal:
                for one in filter(None, literal.groups()):
                    found.setdefault(one[1:-1], name)
            elif not HANDED_ON.match(argument) and not NOT_A_CALL.match(argument):
                line = text.count("\n", 0, match.start()) + 1
                faults.append(f"{name}: near line {line}: a finding whose id is no literal: {argument[:60]}")
    return found, faults


def main():
    found, faults = made()
    rows = ROW.findall((ROOT / "docs/findings.md").read_text(encoding="utf-8"))
    faults += [f"{name}: \"{one}\" is not kebab-case" for one, name in found.items() if not KEBAB.fullmatch(one)]
    faults += [f"docs/findings.md lacks {one} ({found[one]})" for one in sorted(found.keys() - set(rows))]
    faults += [f"docs/findings.md has {one}, which no source makes" for one in sorted(set(rows) - found.keys())]
    faults += [f"docs/findings.md: {b} stands after {a}" for a, b in zip(rows, rows[1:]) if a >= b]
    print("\n".join(faults) if faults else f"findings: ok, {len(rows)} of them")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
