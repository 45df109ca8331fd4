#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Validates every JSON test of the project against the published schema, and that the schema refuses faults.

Usage: tests/schema_check.py
"""
import copy
import json
import pathlib
import sys

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parent.parent


def faulty(test):
    """The same test with one fault each, and what the fault is."""
    for what, change in {
        "no series": lambda t: t.pop("series"),
        "an unknown member": lambda t: t.update(colour="red"),
        "a wrong format name": lambda t: t.update(format="axiometry-test/0"),
        "a text as target": lambda t: t["series"]["targets"].__setitem__(0, "first"),
        "an unknown unit": lambda t: t["series"].update(unit="inch²"),
        "a negative dwell time": lambda t: t.setdefault("test", {}).update(dwell_s=-1),
    }.items():
        changed = copy.deepcopy(test)
        change(changed)
        yield what, changed


def station_faults():
    """A station as people write it, and as 'axiometry tracking locate' does in short; and what is none."""
    schema = json.loads((ROOT / "schema" / "axiometry-station.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    place, covariance = [650, -30, 260.5], [[4e-6, 0, 0], [0, 4e-6, 0], [0, 0, 9e-6]]
    refined = {"station": place, "L0": 1.5, "covariance": covariance}
    finding = {"id": "station-misclosure", "severity": "note", "message": "all is well"}
    finding_of_old = {"severity": "note", "message": "written before findings had ids"}
    good = [{"station": place}, {"station": place, "covariance": None}, {"station": place, "covariance": covariance},
            {"refined": refined, "linear": None, "findings": [finding, finding_of_old]},
            {"refined": refined, "linear": {"station": None, "rank": 4, "condition": 1e15}, "misclosure": None}]
    bad = [{}, {"station": place[:2]}, {"station": ["1", 2, 3]}, {"station": place, "covariance": covariance[:2]},
           {"refined": {"covariance": covariance}}, {"refined": refined, "findings": [{"message": "none"}]}]
    return ([f"the schema of stations refuses {s}" for s in good if not validator.is_valid(s)] +
            [f"the schema of stations allows {s}" for s in bad if validator.is_valid(s)])


def main():
    schema = json.loads((ROOT / "schema" / "axiometry-test.schema.json").read_text(encoding="utf-8"))
    jsonschema.Draft202012Validator.check_schema(schema)
    validator = jsonschema.Draft202012Validator(schema)
    faults = []
    for path in sorted((ROOT / "examples").glob("*.json")):
        test = json.loads(path.read_text(encoding="utf-8"))
        faults += [f"{path.name}: {error.json_path}: {error.message}" for error in validator.iter_errors(test)]
        faults += [f"{path.name}: the schema allows {what}" for what, changed in faulty(test) if validator.is_valid(changed)]
    faults += station_faults()
    print("\n".join(faults) if faults else "schema: ok")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
