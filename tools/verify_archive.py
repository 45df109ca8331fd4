#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""verify_archive.py ARCHIVE [--seal FILE]... [--head N:HEX]... [--public-key KEY]: proves an archive of Axiometry without Axiometry.

ARCHIVE is a SQLite archive or a backup (of a PostgreSQL archive, too). Written from docs/theory/archive.md, which says how
every hash is made, with nothing but Python's standard library, so that whoever doubts the program can read all of this.

Checked: how each cell is stored, the bytes of every file, the audit trail entry by entry, that every record has its entry
and every entry its record, numbers without gaps, the lists, the triggers that keep rows as they are, and seals with their
signatures.
Exit code: 0 nothing is wrong, 3 something is, 2 the archive or a seal cannot be read.
"""
import argparse
import hashlib
import json
import pathlib
import re
import sqlite3
import struct
import sys
from decimal import Decimal

APPLICATION_ID = 0x4178696F  # "Axio"

VERSIONED = {  # what is known by versions: its columns in the order in which they are hashed
    "machine": ("name", "manufacturer", "type", "serial_number", "controller", "location", "notes"),
    "axis": ("machine", "name", "kind", "limits", "notes"),
    "instrument": ("role", "manufacturer", "type", "serial_number", "certificate", "calibrated_on", "calibration_due",
                   "inputs", "notes"),
    "plan": ("title", "axis", "content"),
    "calibration": ("kind", "title", "machine", "instrument", "instrument_version", "measured_on", "notes", "withdrawn",
                    "files", "program", "options", "result", "verdict", "serious", "figures"),
    "compensation": ("test", "test_version", "retest", "retest_version", "axis", "control", "notes", "withdrawn", "files",
                     "program", "options", "result", "serious", "figures"),
}
TEST_VERSION = ("test", "version", "at", "actor", "reason", "title", "machine", "axis", "axis_name", "axis_kind", "plan",
                "measured_on", "changes")
EVALUATION = ("program", "standard", "options", "seed", "unit", "conforming", "verdict", "label", "result")
FIGURE = ("parameter", "value", "expanded_uncertainty", "tolerance", "verdict")
FIGURE_OF_RECORD = ("low", "high", "method")
LIST = ("test", "version", "withdrawn", "conforming", "machine", "axis", "value_a", "value_e", "value_r", "value_b", "unit",
        "verdict", "measured_on", "received_at", "title_key", "file_key", "machine_key", "axis_key", "title", "file_name",
        "machine_name", "axis_name", "axis_kind", "label", "content")
LONGEST_KEY = 400  # bytes
MIGRATIONS = {  # number -> name and SHA-256 of what SQLite was given
    1: ("archive", "8eee08e77cde153cc9807c8bafb156f6dd15181a01ce61b6eae68a4b5a8eea95"),
    2: ("record", "d2fd50a321a0525264dc8f72f6d5bee5c3afe3972ec3ad1607f1aff92c8f1b66"),
    3: ("calibration", "4cb5397a9a5e25892d07c67374453665c1de16da4f3daf0721dcb5b29b466b38"),
    4: ("compensation", "205e1a10956b09d60bb51dc36587089296562ae165285608ccaf977fe025f6df"),
}
DOCUMENT = ("id", "test", "version", "kind", "name", "media_type", "language", "content", "size", "at", "actor", "reason")

KEPT = {  # tables whose rows never change: what tells two rows apart
    "content": ("id", "sha256"), "machine_version": ("id", "version"), "axis_version": ("id", "version"),
    "instrument_version": ("id", "version"), "plan_version": ("id", "version"),
    "calibration_version": ("id", "version"), "compensation_version": ("id", "version"),
    "test_version": ("test", "version"),
    "test_instrument": ("test", "version", "place"), "evaluation": ("test", "version"),
    "figure": ("test", "version", "place"), "document": ("id",), "audit": ("id",), "migration": ("number",),
}
GROWING = ("machine", "axis", "instrument", "plan", "calibration", "compensation", "test")  # only `latest` grows, by one
LISTS = ("test_list", "test_search", "list_instrument")
STORED_AS = {  # what SQLite calls the values of a column that is declared so
    "integer": "integer", "bigint": "integer", "double precision": "real", "plain_text": "text", "text": "text",
    "blob": "blob",
}


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


def small(letter):
    """Of the Latin, Greek and Cyrillic letters that are two bytes in UTF-8, and of ASCII."""
    code = ord(letter)
    if 0x41 <= code <= 0x5A or (0xC0 <= code <= 0xDE and code != 0xD7) or 0x391 <= code <= 0x3A9 or 0x410 <= code <= 0x42F:
        return chr(code + 32)
    if 0x400 <= code <= 0x40F:
        return chr(code + 80)
    if code == 0x178:
        return chr(0xFF)
    if 0x100 <= code <= 0x17E and code not in (0x130, 0x131, 0x138, 0x149):
        odd_capital = 0x139 <= code <= 0x148 or 0x179 <= code
        return chr(code + (code & 1) if odd_capital else code | 1)
    return letter


def folded(text):
    """As it is looked for and ordered."""
    key, room = [], LONGEST_KEY
    for letter in text:
        room -= len(letter.encode())
        if room < 0:
            break
        key.append(small(letter))
    return "".join(key)


def identifier(name):
    return '"' + name.replace('"', '""') + '"'


def say(text, to=None):
    """A cell may hold what no terminal shows, or what one obeys."""
    to = to or sys.stdout
    plain = "".join(letter if letter.isprintable() else ascii(letter)[1:-1] for letter in text)
    encoding = to.encoding or "utf-8"
    print(plain.encode(encoding, "backslashreplace").decode(encoding), file=to)


def hash_of(values):
    return hashlib.sha256(b"".join(map(field, values))).hexdigest()


def expected_triggers():
    """Name -> definition, as the program's schemas wrote them."""
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


def sum_on(total, data, order):
    """The sum of SQLite's log (sqlite.org/fileformat2.html, 4.2) over these bytes too."""
    a, b = total
    words = struct.unpack(f"{order}{len(data) // 4}I", data)
    for k in range(0, len(words), 2):
        a = (a + words[k] + b) & 0xFFFFFFFF
        b = (b + words[k + 1] + a) & 0xFFFFFFFF
    return a, b


def lost_its_size(before, stated, page, order):
    """Whether the last page of a change lost no more than what says so, the size behind its number: the sums in front of
    the page and behind what follows in it tell the size that was written."""
    a, b = stated
    words = struct.unpack(f"{order}{(len(page) - 24) // 4}I", page[24:])
    for k in range(len(words), 0, -2):
        b = (b - words[k - 1] - a) & 0xFFFFFFFF
        a = (a - words[k - 2] - b) & 0xFFFFFFFF
    number, = struct.unpack(f"{order}I", page[:4])
    return a == (before[0] + number + before[1]) & 0xFFFFFFFF and b != (before[1] + a) & 0xFFFFFFFF


def check_log(path):
    """SQLite passes over what stands in a log behind a page that is not as it was written, and says nothing. A page that
    is the last of a change has a size; a change is begun when the one in front of it is on the disk, so that one alone,
    the last, may be half written. Pages with other salts are those of an earlier log."""
    log = path.read_bytes()
    head = log[:32]
    if len(log) < 32 + 24 + 512 or not any(log):  # no page, or all that a file system has kept of it is its size
        return
    magic, _, size, _, *salts_and_sum = struct.unpack(">8I", head)
    salts, total = tuple(salts_and_sum[:2]), tuple(salts_and_sum[2:])
    order = "<" if magic == 0x377f0682 else ">"
    if magic not in (0x377f0682, 0x377f0683) or sum_on((0, 0), head[:24], order) != total:
        raise ValueError(f"found the head of {path.name} altered, expected it as it was written: the changes in it are "
                         "passed over")
    altered, is_surely, kept, finished = None, False, 0, 0
    for number, at in enumerate(range(32, len(log) - 24 - size + 1, 24 + size), 1):
        _, end, *stated = struct.unpack(">6I", log[at:at + 24])
        is_ours = tuple(stated[:2]) == salts
        if altered is None:
            end = end or lost_its_size(total, stated[2:], log[at:at + 24 + size], order)
            total = sum_on(sum_on(total, log[at:at + 8], order), log[at + 24:at + 24 + size], order)
            fits = total == tuple(stated[2:])
            if fits and is_ours:
                kept = number if end else kept
                continue
            altered, is_surely = number, fits
            is_ours = is_ours or fits
        finished += is_ours and bool(end)
    behind = max(finished - 1, 0)  # the first is the change of the altered page itself
    if is_surely or behind:
        more = f", and {behind} finished change{'s' * (behind > 1)} behind it" if behind else ""
        raise ValueError(f"found page {altered} of {path.name} altered, expected it as it was written: the change that "
                         f"begins with page {kept + 1} is passed over{more}")


class Archive:
    def __init__(self, path):
        # Of the file as it is, so that nothing is written beside it; a log beside it would have to be merged first, and
        # what a journal beside it knows to have been there before put back.
        path = pathlib.Path(path).resolve(strict=True)
        for ending, said in (("-wal", "found changes in {} that are not merged, expected the program ended, or a backup"),
                             ("-journal", "found a change that {} is to take back, expected that the program has done so")):
            beside = path.with_name(path.name + ending)
            if beside.exists() and beside.stat().st_size:
                if ending == "-wal":
                    check_log(beside)
                raise ValueError(said.format(beside.name))
        self.bytes = path.stat().st_size
        self.database = sqlite3.connect(path.as_uri() + "?immutable=1", uri=True)
        self.database.row_factory = sqlite3.Row
        if self.database.execute("PRAGMA application_id").fetchone()[0] != APPLICATION_ID:
            raise ValueError("found a database of another program, expected an archive of Axiometry")
        self.problems = []
        self.notes = []
        self.not_told = {}  # what no entry tells -> of how many
        self.attested = {}  # (subject, version) -> hash that the trail tells of; version 0 of what has none
        self.counts = {}
        self.received = {}
        self.kept = {}
        self.withdrawn = {}
        self.hashes = {}    # number of an entry -> its hash
        self.versions = {}

    def untold(self, what):
        self.not_told[what] = self.not_told.get(what, 0) + 1

    def problem(self, text):
        self.problems.append(text)

    def rows(self, sql, *parameters):
        return self.database.execute(sql, parameters)

    def check_tables(self):
        """What stands in the place of a table, an endless view it may be, is not read."""
        tables = {row["name"]: row["sql"] for row in self.rows("SELECT name, sql FROM sqlite_master WHERE type = 'table'")}
        for table in (*KEPT, *GROWING, *LISTS):
            if not tables.get(table, "").startswith("CREATE TABLE "):
                raise ValueError(f"found no table {table}, expected it")
            for column in self.rows(f"PRAGMA table_xinfo({table})"):
                if column["hidden"]:
                    raise ValueError(f"found a column {column['name']} of {table} that is computed, expected values")

    def check_file(self):
        for row in self.rows("PRAGMA integrity_check"):
            if row[0] != "ok":
                self.problem(f"file: {row[0]}")
        for row in self.rows("PRAGMA foreign_key_check"):
            self.problem(f"{row[0]}: a row refers to one of {row[2]} that does not exist")
        # SQLite reads zeros for what was cut off the last page, and passes over what stands behind it.
        pages, each = (self.database.execute(f"PRAGMA {what}").fetchone()[0] for what in ("page_count", "page_size"))
        if self.bytes != pages * each:
            self.problem(f"file: {self.bytes} bytes, not {pages} pages of {each} bytes")

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

    def check_migrations(self):
        found = {row["number"]: (row["name"], row["sha256"]) for row in self.rows("SELECT * FROM migration")}
        for number in sorted(found.keys() | MIGRATIONS.keys()):
            if found.get(number) != MIGRATIONS.get(number):
                self.problem(f"migration {number}: found {found.get(number)}, expected {MIGRATIONS.get(number)}")

    def check_classes(self):
        """SQLite keeps any value in any column: a text as bytes has the hash of the text, and no search finds it."""
        for table in (*KEPT, *GROWING, *LISTS):
            columns = [(row["name"], STORED_AS.get(row["type"].lower(), row["type"]), not row["notnull"] and not row["pk"])
                       for row in self.rows(f"PRAGMA table_info({table})")]
            shown = ", ".join(f'typeof({identifier(name)})' for name, _, _ in columns)
            for number, *found in self.rows(f"SELECT rowid, {shown} FROM {table} NOT INDEXED"):
                for (name, kind, nullable), stored in zip(columns, found):
                    if stored != kind and not (nullable and stored == "null"):
                        self.problem(f"{table}: row {number} has {name} stored as {stored}, expected {kind}"
                                     f"{' or null' if nullable else ''}")

    def check_trail(self):
        previous, last, before = "", 0, ""
        for row in self.rows("SELECT * FROM audit ORDER BY id"):
            if row["id"] != last + 1:
                self.problem(f"audit trail: entry {row['id']} comes after {last}")
            made = hash_of([previous, *(row[name] for name in ("id", "at", "actor", "reason", "action", "subject",
                                                               "detail"))])
            if made != row["sha256"]:
                self.problem(f"audit trail: entry {row['id']} or one in front of it was changed")
            if row["at"] < before:
                self.notes.append(f"audit trail: the clock went back in front of entry {row['id']}, from {before} to "
                                  f"{row['at']}")
            previous, last, before = row["sha256"], row["id"], row["at"]
            self.hashes[last] = previous
            self.learn(row)
        return last

    def learn(self, entry):
        subject, detail = entry["subject"], json.loads(entry["detail"])
        if entry["action"] in ("test.withdrawn", "test.reinstated"):
            self.withdrawn[subject] = entry["action"] == "test.withdrawn"
        change = (entry["at"], entry["actor"], entry["reason"])
        if entry["action"] == "test.received":
            self.received[subject] = (detail["content"], detail["file"], detail.get("name_in_file", ""),
                                      detail.get("format"), *change)
        if entry["action"] == "content.kept":
            self.kept[subject] = (detail.get("file"), detail.get("format"), *change)
        version = detail.get("version", 0)
        if "sha256" in detail and version == int(version):
            self.attested[subject, int(version)] = detail["sha256"]
            table = subject.split(" ")[0]
            self.counts[table] = self.counts.get(table, 0) + 1

    def attest(self, subject, version, made, stored=None):
        if self.attested.get((subject, version)) != made or (stored is not None and stored != made):
            self.problem(f"{subject}: version {version} is not what the audit trail tells of" if version else
                         f"{subject}: not what the audit trail tells of")

    def check_count(self, table, found):
        if found != self.counts.get(table, 0):
            self.problem(f"{table}: {found} are there, the audit trail tells of {self.counts.get(table, 0)}")

    def told(self, entry, stored, *columns):
        """What an entry tells of these columns, or what is stored where it tells nothing."""
        for value, column in zip(entry, columns):
            if value is None:
                self.untold(column)
        return tuple(there if value is None else value for value, there in zip(entry, stored))

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
            kept = self.kept.get(subject, (None,) * 5)
            told = self.told(kept, (row["file_name"], row["format"]), "content.file_name", "content.format")
            if told + kept[2:] != (row["file_name"], row["format"], row["at"], row["actor"], row["reason"]):
                self.problem(f"{subject}: kept by another, at another time, for another reason or under another name or "
                             "format than the trail tells")
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
            received = self.received.get(subject, (None,) * 7)
            format_told = self.told(received[3:4], (row["format"],), "test.format")
            if received[:3] + format_told + received[4:] != (
                    row["content"], row["file_name"], row["name_in_file"], row["format"], row["at"], row["actor"],
                    row["reason"]):
                self.problem(f"{subject}: another file, name, format or receipt than the audit trail tells of")
            if row["withdrawn"] != int(self.withdrawn.get(subject, False)):
                self.problem(f"{subject}: withdrawn or not, against the audit trail")
        for row in self.rows("SELECT * FROM test_version"):
            self.attest(f"test {row['test']}", row["version"], hash_of(self.test_fields(row)), row["sha256"])
        for table in ("test_instrument", "figure"):
            for row in self.rows(f"SELECT test, version FROM {table} GROUP BY test, version HAVING min(place) <> 1 OR "
                                 "max(place) <> count(*)"):
                self.problem(f"{table}: places of version {row[1]} of test {row[0]} do not count from 1")
        for row in self.rows("SELECT test, version FROM figure WHERE method = '' AND (low IS NOT NULL OR high IS NOT NULL)"):
            self.problem(f"figure: an interval in version {row[1]} of test {row[0]} that no method has stated")
        return len(tests)

    def latest(self, table):
        return {row["id"]: row for row in self.rows(f"SELECT v.* FROM {table}_version v JOIN {table} t ON t.id = v.id AND "
                                                    "t.latest = v.version")}

    def check_lists(self):
        """That they repeat the latest versions."""
        machines, axes = self.latest("machine"), self.latest("axis")
        lines = {row["test"]: tuple(row[name] for name in LIST) for row in self.rows("SELECT * FROM test_list")}
        words = {row["test"]: (row["withdrawn"], row["words"]) for row in self.rows("SELECT * FROM test_search")}
        instruments = {}
        for row in self.rows("SELECT * FROM list_instrument"):
            instruments.setdefault(row["test"], set()).add((row["instrument"], row["withdrawn"]))
        for row in self.rows("SELECT t.content, t.file_name, t.at AS received_at, t.withdrawn, v.* FROM test t JOIN "
                             "test_version v ON v.test = t.id AND v.version = t.latest"):
            test = row["test"]
            line = self.line(row, machines, axes)
            if lines.pop(test, None) != line:
                self.problem(f"test {test}: another line in the list than its latest version gives")
            keys = line[LIST.index("title_key"):LIST.index("title")]
            if words.pop(test, None) != (row["withdrawn"], " ".join(keys)):
                self.problem(f"test {test}: other words to be searched than its latest version gives")
            used = {(use["instrument"], row["withdrawn"]) for use in self.rows(
                "SELECT instrument FROM test_instrument WHERE test = ? AND version = ?", test, row["version"])}
            if instruments.pop(test, set()) != used:
                self.problem(f"test {test}: other instruments in the list than its latest version gives")
        for test in sorted(lines.keys() | words.keys() | instruments.keys()):
            self.problem(f"test {test}: in the lists, and there is none")

    def line(self, row, machines, axes):
        evaluation = self.rows("SELECT * FROM evaluation WHERE test = ? AND version = ?", row["test"],
                               row["version"]).fetchone()
        figures = {}
        for figure in self.rows("SELECT parameter, value FROM figure WHERE test = ? AND version = ? ORDER BY place",
                                row["test"], row["version"]):
            figures.setdefault(figure["parameter"], figure["value"])
        machine, axis = machines.get(row["machine"]), axes.get(row["axis"])
        names = {"machine_name": machine["name"] if machine else "", "axis_name": (axis or {"name": row["axis_name"]})["name"],
                 "axis_kind": (axis or {"kind": row["axis_kind"]})["kind"]}
        made = {
            **{name: row[name] for name in ("test", "version", "withdrawn", "machine", "axis", "measured_on", "received_at",
                                            "title", "file_name", "content")},
            **{name: evaluation[name] for name in ("conforming", "unit", "verdict", "label")},
            **{f"value_{parameter.lower()}": figures.get(parameter) for parameter in "AERB"}, **names,
            "title_key": folded(row["title"]), "file_key": folded(row["file_name"]),
            "machine_key": folded(names["machine_name"]), "axis_key": folded(names["axis_name"])}
        return tuple(made[name] for name in LIST)

    def check_documents(self):
        ids = []
        for row in self.rows("SELECT * FROM document ORDER BY id"):
            ids.append(row["id"])
            self.attest(f"document {row['id']}", 0, hash_of(row[name] for name in DOCUMENT))
        self.without_gaps("document", ids)
        self.check_count("document", len(ids))

    def check_head(self, number, digits):
        if number not in self.hashes:
            self.problem(f"audit trail: it ends in front of entry {number}, of which a report tells")
        elif not self.hashes[number].startswith(digits):
            self.problem(f"audit trail: entry {number} is another than that of which a report tells")

    def check_seal(self, seal):
        sealed = f"sealed at {seal['sealed_at']}"
        if seal["entries"] not in self.hashes:
            self.problem(f"audit trail: it ends in front of entry {seal['entries']}, which was {sealed}")
        elif self.hashes[seal["entries"]] != seal["sha256"]:
            self.problem(f"audit trail: entry {seal['entries']} is another than was {sealed}")


def read_head(text):
    """"17:3f2a9c0b1d2e4f56" of an issued report: number of an entry, and how its hash begins."""
    found = re.fullmatch(r"([1-9]\d*):([0-9a-fA-F]{16,64})", text.strip())
    if not found:
        raise ValueError(f"found {text} as the head of an audit trail, expected one like 17:3f2a9c0b1d2e4f56")
    return int(found[1]), found[2].lower()


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
    parser.add_argument("--head", action="append", default=[], help="likewise, as an issued report says it: N:HEX")
    parser.add_argument("--public-key", help="of whom the seals must be")
    arguments = parser.parse_args()
    try:
        seals = [read_seal(path, arguments.public_key) for path in arguments.seal]
        heads = [read_head(text) for text in arguments.head]
        archive = Archive(arguments.archive)
    except (OSError, ValueError, KeyError, TypeError, RecursionError, sqlite3.Error) as error:
        say(f"verify_archive: {error}", sys.stderr)
        return 2
    try:
        archive.check_tables()
        archive.check_file()
        archive.check_classes()
        triggers, entries = archive.check_triggers(), archive.check_trail()
        archive.check_migrations()
        for seal in seals:
            archive.check_seal(seal)
        for number, digits in heads:
            archive.check_head(number, digits)
        contents = archive.check_contents()
        archive.check_things()
        tests = archive.check_tests()
        archive.check_documents()
        archive.check_lists()
    except Exception as error:  # whatever somebody put into a cell, which is what this looks for
        archive.problem(f"the rest cannot be read: {error!r}")
    for problem in archive.problems:
        say(problem)
    for note in archive.notes:
        say(f"noted: {note}")
    for column, number in archive.not_told.items():
        print(f"not proved: {column} of {number}, from before entries told it")
    print("not proved: when the archive was given its tables (migration.at)")
    if archive.problems:
        print(f"{len(archive.problems)} problems")
        return 3
    print(f"{contents} files, {tests} tests, {entries} entries, {triggers} triggers: all that is there is as it was written")
    if not seals and not heads:
        print("not proved without a seal: that nothing is missing at the end, and that nobody made all of it anew")
    return 0


if __name__ == "__main__":
    sys.exit(main())
