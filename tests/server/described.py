# SPDX-License-Identifier: Apache-2.0
"""Holds what is asked and answered against apps/server/openapi.json. Needs python3-jsonschema."""
import functools
import json
import pathlib
import re

import jsonschema

ROOT = pathlib.Path(__file__).resolve().parents[2]
OPENAPI = json.loads((ROOT / "apps" / "server" / "openapi.json").read_text(encoding="utf-8"))
PATTERNS = [(re.compile("[^/]+".join(re.escape(part) for part in re.split(r"\{[a-z]+\}", pattern))), pattern)
            for pattern in OPENAPI["paths"]]
FAILURE = OPENAPI["components"]["responses"]["Failure"]


def resolved(part):
    if "$ref" not in part:
        return part
    return OPENAPI["components"]["responses"][part["$ref"].rsplit("/", 1)[1]]


def innermost(fault):
    """Of alternatives, what is wrong with the one that goes deepest."""
    while fault.context:
        fault = max(fault.context, key=lambda inner: len(inner.absolute_path) + len(inner.context or []))
    return f"/{'/'.join(map(str, fault.absolute_path))}: {fault.message[:200]}"


class Description:
    """Of the API; keeps in mind what it has seen, as tests ask for the same many times."""

    def __init__(self):
        self.validators = {}
        self.seen = set()
        self.answered = set()  # (method, pattern, status)

    @staticmethod
    def pattern(method, path):
        """That fits with the fewest braces, one that has the method before others."""
        found = [(method not in OPENAPI["paths"][pattern], pattern.count("{"), pattern)
                 for expression, pattern in PATTERNS if expression.fullmatch(path)]
        return min(found)[2] if found else None

    def faults(self, method, target, sent, answer, bodies=True):
        """What is not as described; `bodies`: whether also within one of the kind that was seen before."""
        path = target.split("?")[0]
        if not path.startswith("/api/"):
            return []
        named = "get" if method == "HEAD" else method.lower()
        pattern = self.pattern(named, path)
        operation = OPENAPI["paths"].get(pattern, {}).get(named)
        befalls_any = answer.status in FAILURE["x-statuses"]
        if operation is None:
            expected = 404 if pattern is None else 405
            faults = [] if answer.status == expected or befalls_any else ["this is not described"]
            return faults + self.of_content((method, pattern, answer.status), FAILURE, answer, bodies)
        response = operation["responses"].get(str(answer.status), FAILURE if befalls_any else None)
        if response is None:
            return ["a status that is not described"]
        self.answered.add((method, pattern, answer.status))
        faults = self.of_content((method, pattern, answer.status), resolved(response), answer, bodies)
        if answer.status < 300:
            faults += self.of_request((method, pattern), operation, sent, bodies)
        return faults

    def of_content(self, operation, response, answer, bodies):
        described = response.get("content", {})
        if not described or operation[0] == "HEAD":
            return [] if answer.body == b"" else ["a body, expected none"]
        kind = answer.headers.get("content-type", "").split(";")[0]
        if kind not in described:
            return [f"content of the type {kind}, which is not described"]
        if kind != "application/json":
            return []
        return self.of_json(operation, described[kind]["schema"], answer.body, bodies)

    def of_request(self, operation, described, sent, bodies):
        """What was taken must be described as it was sent."""
        body = described.get("requestBody", {"required": False})
        if not sent:
            return ["a request without a body, expected one"] if body["required"] else []
        if "content" not in body:
            return ["a request with a body, expected none"]
        if "application/json" not in body["content"]:
            return []
        return self.of_json(operation, body["content"]["application/json"]["schema"], sent, bodies)

    def of_json(self, operation, schema, body, bodies):
        what = (operation, hash(body) if bodies else None)
        if what in self.seen:
            return []
        self.seen.add(what)
        try:
            value = json.loads(body)
        except ValueError as error:
            return [str(error)]
        whole = {**schema, "components": OPENAPI["components"]}
        validator = self.validators.setdefault(operation, jsonschema.Draft202012Validator(whole))
        return [innermost(fault) for fault in list(validator.iter_errors(value))[:4]]


def open_objects():
    """Objects of answers that may have members which nothing describes: what is in them is held against nothing."""
    schemas, answers = OPENAPI["components"]["schemas"], OPENAPI["components"]["responses"]
    seen, found = set(), []

    def walk(part, path, closed):
        if not isinstance(part, dict):
            return
        closed = closed or "additionalProperties" in part or part.get("unevaluatedProperties") is False
        if "$ref" in part:
            name = part["$ref"].removeprefix("#/components/schemas/")
            if (name, closed) not in seen:
                seen.add((name, closed))
                walk(functools.reduce(lambda found, step: found[step], name.split("/"), schemas), name, closed)
        kinds = part.get("type", [])
        if "object" in ([kinds] if isinstance(kinds, str) else kinds) and not closed:
            found.append(path)
        for word in ("allOf", "oneOf", "anyOf"):
            for alternative in part.get(word, []):
                walk(alternative, path, closed)
        for name, member in part.get("properties", {}).items():
            walk(member, f"{path}.{name}", False)
        for word in ("items", "additionalProperties"):
            walk(part.get(word), f"{path}[]", False)

    for path, operations in OPENAPI["paths"].items():
        for method, operation in operations.items():
            for response in operation["responses"].values():
                response = answers[response["$ref"].rsplit("/", 1)[1]] if "$ref" in response else response
                walk(response.get("content", {}).get("application/json", {}).get("schema"), f"{method} {path}", False)
    return found
