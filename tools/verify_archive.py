#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""verify_archive.py ARCHIVE [--seal FILE]... [--public-key KEY]: proves an archive of Axiometry without Axiometry.

ARCHIVE is a SQLite archive or a backup (of a PostgreSQL archive, too). Written from docs/theory/archive.md, which says how
every hash is made, with nothing but Python's standard library, so that whoever doubts the program can read all of this.

Checked: the bytes of every file, the audit trail entry by entry, that every record has its entry and every entry its
record, numbers without gaps, the triggers that keep rows as they are, and seals with their signatures.
Exit code: 0 nothing is wrong, 3 something is, 2 the archive or a seal cannot be read.
"""
import argparse
import hashlib
import json
import pathlib
import re
import sqlite3
import sys
from decimal import Decimal

APPLICATION_ID = 0x4178696F  # "Axio"

VERSIONED = {  # what is known by versions: its columns in the order in which they are hashed
    "machine": ("name", "manufacturer", "type", "serial_number", "controller", "location", "notes"),
    "axis": ("machine", "name", "kind", "limits", "notes"),
    "instrument": ("role", "manufacturer", "type", "serial_number", "certificate", "calibrated_on", "calibration_due",
                   "inputs", "notes"),
    "plan": ("title", "axis", "content"),
}
TEST_VERSION = ("test", "version", "at", "actor", "reason", "title", "machine", "axis", "axis_name", "axis_kind", "plan",
                "measured_on", "changes")
EVALUATION = ("program", "standard", "options", "seed", "unit", "conforming", "verdict", "label", "result")
FIGURE = ("parameter", "value", "expanded_uncertainty", "tolerance", "verdict")
FIGURE_OF_RECORD = ("low", "high", "method")
DOCUMENT = ("id", "test", "version", "kind", "name", "media_type", "language", "content", "size", "at", "actor", "reason")

KEPT = {  # tables whose rows never change: what tells two rows apart
    "content": ("id", "sha256"), "machine_version": ("id", "version"), "axis_version": ("id", "version"),
    "instrument_version": ("id", "version"), "plan_version": ("id", "version"), "test_version": ("test", "version"),
    "test_instrument": ("test", "version", "place"), "evaluation": ("test", "version"),
    "figure": ("test", "version", "place"), "document": ("id",), "audit": ("id",), "migration": ("number",),
}
GROWING = ("machine", "axis", "instrument", "plan", "test")  # only `latest` grows, by one


def real_text(value):
    """The shortest decimals that read back the same; of two spellings the shorter, the one without exponent on a tie."""
    sign, digits, exponent = Decimal(repr(value)).as_tuple()
    text = "".join(map(str, digits)).lstrip("0") or "0"
    exponent += len(text) - len(text.rstrip("0")) if text != "0" else -exponent
    text = text.rstrip("0") or "0"
    power = len(text) - 1 + exponent
    scientific = text[0] + ("." + text[1:] if len(text) > 1 else "") + f"e{'-' if power < 0 else '+'}{abs(power):02d}"
    if exponent >= 0:
        fixed = str(int(abs(value)))
    elif power >= 0:
        fixed = text[:power + 1] + "." + text[power + 1:]
    else:
        fixed = "0." + "0" * (-power - 1) + text
    return ("-" if sign else "") + (fixed if len(fixed) <= len(scientific) else scientific)


def field(value):
    """A field goes into a hash with its type and its length, so that it lends no letter to its neighbour."""
    if value is None:
        kind, data = b"n", b""
    elif isinstance(value, int):
        kind, data = b"i", str(value).encode()
    elif isinstance(value, float):
        kind, data = b"r", real_text(value).encode()
    elif isinstance(value, str):
        kind, data = b"t", value.encode()
    else:
        kind, data = b"b", bytes(value)
    return kind + str(len(data)).encode() + b":" + data


def hash_of(values):
    return hashlib.sha256(b"".join(map(field, values))).hexdigest()


def expected_triggers():
    """Name -> definition, as the program's first schema wrote them."""
    def trigger(name, when, refusal):
        return name, f"CREATE TRIGGER {name} BEFORE {when} BEGIN SELECT RAISE(ABORT, 'found {refusal}'); END"

    made = []
    for table, keys in {**KEPT, **{table: ("id",) for table in GROWING}}.items():
        columns = {"test": " OF id, content, file_name, format, name_in_file, at, actor, reason"}.get(table, " OF id")
        changed = f"UPDATE{columns if table in GROWING else ''} ON {table}"
        same = " OR " if table == "content" else " AND "
        there = same.join(f"{key} = NEW.{key}" for key in keys)
        made.append(trigger(f"{table}_unchanged", changed, f"an update of {table}, whose rows are never changed"))
        made.append(trigger(f"{table}_undeleted", f"DELETE ON {table}",
                            f"a deletion from {table}, whose rows are never taken away"))
        made.append(trigger(f"{table}_unreplaced", f"INSERT ON {table} WHEN EXISTS (SELECT 1 FROM {table} WHERE {there})",
                            f"a row for {table} that is there already"))
        if table in GROWING:
            made.append(trigger(f"{table}_grows", f"UPDATE OF latest ON {table} WHEN NEW.latest <> OLD.latest + 1",
                                f"a version of {table} that does not follow the latest one"))
    return dict(made)


# Ed25519, RFC 8032, 5.1: enough of it to check a signature. Points are (X, Y, Z, T) with x = X/Z, y = Y/Z, x·y = T/Z.
PRIME = 2**255 - 19
ORDER = 2**252 + 27742317777372353535851937790883648493
CURVE_D = -121665 * pow(121666, -1, PRIME) % PRIME


def added(p, q):
    a = (p[1] - p[0]) * (q[1] - q[0]) % PRIME
    b = (p[1] + p[0]) * (q[1] + q[0]) % PRIME
    c = 2 * p[3] * q[3] * CURVE_D % PRIME
    d = 2 * p[2] * q[2] % PRIME
    e, f, g, h = b - a, d - c, d + c, b + a
    return e * f % PRIME, g * h % PRIME, f * g % PRIME, e * h % PRIME


def times(number, point):
    total = (0, 1, 1, 0)
    while number:
        if number & 1:
            total = added(total, point)
        point = added(point, point)
        number >>= 1
    return total


def point_of(data):
    """From its 32 bytes, or None: y, and the lowest bit of x in the highest one."""
    y = int.from_bytes(data, "little")
    odd, y = y >> 255, y & (2**255 - 1)
    if y >= PRIME:
        return None
    square = (y * y - 1) * pow(CURVE_D * y * y + 1, -1, PRIME) % PRIME
    x = pow(square, (PRIME + 3) // 8, PRIME)
    if (x * x - square) % PRIME:
        x = x * pow(2, (PRIME - 1) // 4, PRIME) % PRIME
    if (x * x - square) % PRIME or (x == 0 and odd):
        return None
    if x & 1 != odd:
        x = PRIME - x
    return x, y, 1, x * y % PRIME


BASE = point_of((4 * pow(5, -1, PRIME) % PRIME).to_bytes(32, "little"))


def is_signed(message, signature, public_key):
    a, r = point_of(public_key), point_of(signature[:32])
    s = int.from_bytes(signature[32:], "little")
    if len(public_key) != 32 or len(signature) != 64 or a is None or r is None or s >= ORDER:
        return False
    k = int.from_bytes(hashlib.sha512(signature[:32] + public_key + message).digest(), "little") % ORDER
    left, right = times(s, BASE), added(r, times(k, a))
    return not any((left[i] * right[2] - right[i] * left[2]) % PRIME for i in (0, 1))


class Archive:
    def __init__(self, path):
        # Of the file as it is, so that nothing is written beside it; a log beside it would have to be merged first.
        path = pathlib.Path(path).resolve(strict=True)
        log = path.with_name(path.name + "-wal")
        if log.exists() and log.stat().st_size:
            raise ValueError(f"found changes in {log.name} that are not merged, expected the program ended, or a backup")
        self.database = sqlite3.connect(path.as_uri() + "?immutable=1", uri=True)
        self.database.row_factory = sqlite3.Row
        if self.database.execute("PRAGMA application_id").fetchone()[0] != APPLICATION_ID:
            raise ValueError("found a database of another program, expected an archive of Axiometry")
        self.problems = []
        self.attested = {}  # (subject, version) -> hash that the trail tells of; version 0 of what has none
        self.counts = {}
        self.received = {}
        self.kept = {}
        self.withdrawn = {}
        self.hashes = {}    # number of an entry -> its hash
        self.versions = {}

    def problem(self, text):
        self.problems.append(text)

    def rows(self, sql, *parameters):
        return self.database.execute(sql, parameters)

    def check_file(self):
        for row in self.rows("PRAGMA integrity_check"):
            if row[0] != "ok":
                self.problem(f"file: {row[0]}")
        for row in self.rows("PRAGMA foreign_key_check"):
            self.problem(f"{row[0]}: a row refers to one of {row[2]} that does not exist")

    def check_triggers(self):
        expected = expected_triggers()
        found = {row["name"]: re.sub(r"\s+", " ", row["sql"]).strip()
                 for row in self.rows("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'")}
        for name, definition in expected.items():
            if name not in found:
                self.problem(f"trigger {name}: missing")
            elif found[name] != definition:
                self.problem(f"trigger {name}: altered: {found[name]}")
        for name in found.keys() - expected.keys():
            self.problem(f"trigger {name}: no archive has one of this name")
        return len(expected)

    def check_trail(self):
        previous, last = "", 0
        for row in self.rows("SELECT * FROM audit ORDER BY id"):
            if row["id"] != last + 1:
                self.problem(f"audit trail: entry {row['id']} comes after {last}")
            made = hash_of([previous, *(row[name] for name in ("id", "at", "actor", "reason", "action", "subject",
                                                               "detail"))])
            if made != row["sha256"]:
                self.problem(f"audit trail: entry {row['id']} or one in front of it was changed")
            previous, last = row["sha256"], row["id"]
            self.hashes[last] = previous
            self.learn(row)
        return last

    def learn(self, entry):
        subject, detail = entry["subject"], json.loads(entry["detail"])
        if entry["action"] in ("test.withdrawn", "test.reinstated"):
            self.withdrawn[subject] = entry["action"] == "test.withdrawn"
        change = (entry["at"], entry["actor"], entry["reason"])
        if entry["action"] == "test.received":
            self.received[subject] = (detail["content"], detail["file"], detail.get("name_in_file", ""), *change)
        if entry["action"] == "content.kept":
            self.kept[subject] = change
        if "sha256" in detail:
            self.attested[subject, int(detail.get("version", 0))] = detail["sha256"]
            table = subject.split(" ")[0]
            self.counts[table] = self.counts.get(table, 0) + 1

    def attest(self, subject, version, made, stored=None):
        if self.attested.get((subject, version)) != made or (stored is not None and stored != made):
            self.problem(f"{subject}: version {version} is not what the audit trail tells of" if version else
                         f"{subject}: not what the audit trail tells of")

    def check_count(self, table, found):
        if found != self.counts.get(table, 0):
            self.problem(f"{table}: {found} are there, the audit trail tells of {self.counts.get(table, 0)}")

    def without_gaps(self, table, ids):
        for expected, number in enumerate(ids, 1):
            if number != expected:
                self.problem(f"{table} {expected}: missing")
                return

    def check_contents(self):
        ids = []
        for row in self.rows("SELECT * FROM content ORDER BY id"):
            ids.append(row["id"])
            subject = f"content {row['id']}"
            data = row["bytes"] if isinstance(row["bytes"], bytes) else str(row["bytes"]).encode()
            made = hashlib.sha256(data).hexdigest()
            if made != row["sha256"] or len(data) != row["size"]:
                self.problem(f"{subject}: its bytes were changed")
            self.attest(subject, 0, made)
            if self.kept.get(subject) != (row["at"], row["actor"], row["reason"]):
                self.problem(f"{subject}: kept by another, at another time or for another reason than the trail tells")
        self.without_gaps("content", ids)
        self.check_count("content", len(ids))
        return len(ids)

    def check_versions(self, table, key):
        """That versions of each record are 1, 2, … up to its latest one; gives the records' numbers."""
        latest = dict(self.rows(f"SELECT id, latest FROM {table}").fetchall())
        self.without_gaps(table, sorted(latest))
        counted = {}
        for row in self.rows(f"SELECT {key} AS id, version FROM {table}_version ORDER BY 1, 2"):
            counted[row["id"]] = counted.get(row["id"], 0) + 1
            if row["version"] != counted[row["id"]]:
                self.problem(f"{table} {row['id']}: version {counted[row['id']]} is missing")
        for number in latest.keys() | counted.keys():
            if latest.get(number) != counted.get(number):
                self.problem(f"{table} {number}: {counted.get(number, 0)} versions, expected {latest.get(number)}")
        self.check_count(table, sum(counted.values()))
        return latest

    def check_things(self):
        for table, columns in VERSIONED.items():
            self.check_versions(table, "id")
            for row in self.rows(f"SELECT * FROM {table}_version"):
                made = hash_of([row["id"], row["version"], row["at"], row["actor"], row["reason"],
                                *(row[name] for name in columns)])
                self.attest(f"{table} {row['id']}", row["version"], made, row["sha256"])

    def test_fields(self, row):
        which = (row["test"], row["version"])
        fields = [row[name] for name in TEST_VERSION]
        evaluation = self.rows("SELECT * FROM evaluation WHERE test = ? AND version = ?", *which).fetchone()
        fields += [evaluation[name] for name in EVALUATION] if evaluation else []
        for use in self.rows("SELECT * FROM test_instrument WHERE test = ? AND version = ? ORDER BY place", *which):
            fields += [use["instrument"], use["instrument_version"]]
        for figure in self.rows("SELECT * FROM figure WHERE test = ? AND version = ? ORDER BY place", *which):
            fields += [figure[name] for name in FIGURE]
            if figure["method"]:  # versions from before it was kept were hashed without
                fields += [figure[name] for name in FIGURE_OF_RECORD]
        return fields

    def check_tests(self):
        tests = self.check_versions("test", "test")
        for row in self.rows("SELECT * FROM test"):
            subject = f"test {row['id']}"
            told = (row["content"], row["file_name"], row["name_in_file"], row["at"], row["actor"], row["reason"])
            if self.received.get(subject) != told:
                self.problem(f"{subject}: another file, name or receipt than the audit trail tells of")
            if bool(row["withdrawn"]) != self.withdrawn.get(subject, False):
                self.problem(f"{subject}: withdrawn or not, against the audit trail")
        for row in self.rows("SELECT * FROM test_version"):
            self.attest(f"test {row['test']}", row["version"], hash_of(self.test_fields(row)), row["sha256"])
        return len(tests)

    def check_documents(self):
        ids = []
        for row in self.rows("SELECT * FROM document ORDER BY id"):
            ids.append(row["id"])
            self.attest(f"document {row['id']}", 0, hash_of(row[name] for name in DOCUMENT))
        self.without_gaps("document", ids)
        self.check_count("document", len(ids))

    def check_seal(self, seal):
        sealed = f"sealed at {seal['sealed_at']}"
        if seal["entries"] not in self.hashes:
            self.problem(f"audit trail: it ends in front of entry {seal['entries']}, which was {sealed}")
        elif self.hashes[seal["entries"]] != seal["sha256"]:
            self.problem(f"audit trail: entry {seal['entries']} is another than was {sealed}")


def read_seal(path, public_key):
    seal = json.loads(pathlib.Path(path).read_text(encoding="utf-8"))
    if seal["format"] != "axiometry-seal-1":
        raise ValueError(f"{path}: found no seal of a known format")
    if public_key and seal["public_key"] != public_key:
        raise ValueError(f"{path}: found a seal of the key {seal['public_key']}, expected {public_key}")
    message = "".join(f"{part}\n" for part in ("axiometry-seal-1", seal["entries"], seal["sha256"], seal["entry_at"],
                                               seal["sealed_at"]))
    if not is_signed(message.encode(), bytes.fromhex(seal["signature"]), bytes.fromhex(seal["public_key"])):
        raise ValueError(f"{path}: found a seal that its key has not signed")
    return seal


def main():
    parser = argparse.ArgumentParser(description="Proves an archive of Axiometry without Axiometry.")
    parser.add_argument("archive", help="a SQLite archive or a backup")
    parser.add_argument("--seal", action="append", default=[], help="the audit trail must go on from it")
    parser.add_argument("--public-key", help="of whom the seals must be")
    arguments = parser.parse_args()
    try:
        seals = [read_seal(path, arguments.public_key) for path in arguments.seal]
        archive = Archive(arguments.archive)
    except (OSError, ValueError, KeyError, TypeError, sqlite3.Error) as error:
        print(f"verify_archive: {error}", file=sys.stderr)
        return 2
    try:
        archive.check_file()
        triggers, entries = archive.check_triggers(), archive.check_trail()
        for seal in seals:
            archive.check_seal(seal)
        contents = archive.check_contents()
        archive.check_things()
        tests = archive.check_tests()
        archive.check_documents()
    except (sqlite3.Error, ValueError, KeyError, TypeError, IndexError) as error:
        archive.problem(f"the rest cannot be read: {error!r}")
    for problem in archive.problems:
        print(problem)
    if archive.problems:
        print(f"{len(archive.problems)} problems")
        return 3
    print(f"{contents} files, {tests} tests, {entries} entries, {triggers} triggers: all that is there is as it was written")
    if not seals:
        print("not proved without a seal: that nothing is missing at the end")
    return 0


if __name__ == "__main__":
    sys.exit(main())
