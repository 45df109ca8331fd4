#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks that includes between the layers point down only (tools/layers.txt).

A third-party library is used where OWNERS says and nowhere else, most in one folder only.
"""
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SOURCES = ROOT / "src" / "axiometry"
INCLUDE = re.compile(r'^\s*#\s*include\s*[<"]([^>"]+)[>"]')
OWNERS = {  # prefix of an include -> the only folder that may use it; linear algebra has two
    "nlohmann/": "src/axiometry/base/",
    "Eigen/": ("src/axiometry/numeric/", "src/axiometry/uncertainty/", "src/axiometry/tracking/"),
    "muParser": "src/axiometry/app/",
    "openssl/": ("src/axiometry/digest/", "apps/server/"),
    "sqlite3": "src/axiometry/store/",
    "libpq-fe": "src/axiometry/store/",
    "boost/": ("apps/server/", "src/axiometry/verification/"),
    "cairo": "src/axiometry/report/",
    "pango/": "src/axiometry/report/",
    "CLI/": "apps/cli/",
}


def allowed_includes():
    allowed = {}
    for line in (ROOT / "tools" / "layers.txt").read_text().splitlines():
        line = line.split("#")[0].strip()
        if line:
            layer, _, below = line.partition(":")
            allowed[layer.strip()] = set(below.split()) | {layer.strip()}
    return allowed


def problems():
    allowed = allowed_includes()
    sources = [p for folder in (SOURCES, ROOT / "apps") for p in sorted(folder.rglob("*")) if p.suffix in (".h", ".cpp")]
    for path in sources:
        name = path.relative_to(ROOT).as_posix()
        layer = path.relative_to(SOURCES).parts[0] if SOURCES in path.parents else None
        is_test = path.stem.endswith(("_test", "_bench"))
        if layer is not None and layer not in allowed:
            yield f"{name}:1: layer {layer} is not in tools/layers.txt"
            continue
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            match = INCLUDE.match(line)
            if not match:
                continue
            included = match.group(1)
            if included.startswith("axiometry/") and layer is not None and not is_test:
                below = included.split("/")[1]
                if below not in allowed[layer] and included.removeprefix("axiometry/") not in allowed[layer]:
                    yield f"{name}:{number}: {layer} must not include {included}"
            for prefix, owner in OWNERS.items():
                if included.startswith(prefix) and not name.startswith(owner):
                    yield f"{name}:{number}: only {owner} may include {included}"


def main():
    found = list(problems())
    print("\n".join(found) if found else "layers: ok")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
