#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Checks (or, with --update, writes) the files that the program generates about itself, and what the description of the
API says of the contents of such files."""
import json
import pathlib
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
GENERATED = {
    "docs/man/axiometry.1": ["manual"],
    "schema/axiometry-test.schema.json": ["schema"],
    "schema/axiometry-import-profile.schema.json": ["schema", "import-profile"],
    "schema/axiometry-plan.schema.json": ["schema", "plan"],
    "schema/axiometry-station.schema.json": ["schema", "station"],
    "schema/axiometry-tracking-plan.schema.json": ["schema", "tracking-plan"],
    "schema/axiometry-machine.schema.json": ["schema", "machine"],
    "schema/axiometry-volumetric-result.schema.json": ["schema", "volumetric-result"],
    "schema/axiometry-volumetric-plan.schema.json": ["schema", "volumetric-plan"],
}
API = ROOT / "apps" / "server" / "openapi.json"
LINE_LIMIT = 120


OF_THE_API = {
    "ImportProfile": {"schema": ["import-profile"], "whole": True},  # answers leave nothing out
    "Metadata": {"schema": [], "left_out": ["format", "source", "series", "times_s"]},
    "PlanFile": {"schema": ["plan"]},
    "TrackingPlanFile": {"schema": ["tracking-plan"]},
    "VolumetricPlanFile": {"schema": ["volumetric-plan"]},
}


def component(name, schema, part):
    """A published schema, or what is wanted of it, as one of the description's."""
    text = json.dumps(schema).replace('"$ref": "#"', f'"$ref": "#/components/schemas/{name}"')
    text = text.replace('"urn:axiometry:schema:axiometry-plan:1"', '"#/components/schemas/PlanFile"')
    left_out = ["$schema", *part.get("left_out", [])]
    properties = {key: value for key, value in json.loads(text)["properties"].items() if key not in left_out}
    required = [key for key in (properties if part.get("whole") else schema["required"]) if key in properties]
    return {"type": "object", "description": schema["description"], "properties": properties,
            **({"required": required} if required else {}), "additionalProperties": False}


def spelled(value, indent=0, before=0, after=0):
    """JSON in lines that are as full as may be."""
    flat = json.dumps(value, ensure_ascii=False)
    if not isinstance(value, (dict, list)) or not value or before + len(flat) + after <= LINE_LIMIT:
        return flat
    is_object = isinstance(value, dict)
    names = [f"{json.dumps(name, ensure_ascii=False)}: " for name in value] if is_object else [""] * len(value)
    members = list(value.values()) if is_object else value
    blank = " " * (indent + 2)
    lines = [blank + name + spelled(member, indent + 2, len(blank + name), k + 1 < len(members))
             for k, (name, member) in enumerate(zip(names, members))]
    opened, closed = "{}" if is_object else "[]"
    return opened + "\n" + ",\n".join(lines) + "\n" + " " * indent + closed


def output_of(program, *arguments):
    return subprocess.run([program, *arguments], capture_output=True, check=True).stdout


def description(program):
    """The API's description as it is to be, with the parts that the program knows."""
    whole = json.loads(API.read_text(encoding="utf-8"))
    for name, part in OF_THE_API.items():
        schema = json.loads(output_of(program, "schema", *part["schema"]))
        whole["components"]["schemas"][name] = component(name, schema, part)
    return (spelled(whole) + "\n").encode()


def main():
    update = "--update" in sys.argv
    program = [a for a in sys.argv[1:] if a != "--update"][0]
    wanted = {ROOT / name: (output_of(program, *arguments), f"'axiometry {' '.join(arguments)}'")
              for name, arguments in GENERATED.items()}
    wanted[API] = (description(program), f"'axiometry schema' in {', '.join(OF_THE_API)}, or in its layout")
    stale = 0
    for path, (now, source) in wanted.items():
        if path.exists() and path.read_bytes() == now:
            continue
        if update:
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(now)
        else:
            stale += 1
            print(f"{path.relative_to(ROOT)}: differs from {source}; tools/check_generated.py PROGRAM --update writes it")
    return 1 if stale else 0


if __name__ == "__main__":
    sys.exit(main())
