#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tamper_test.py PROGRAM: both verifiers, the program's and tools/verify_archive.py, find what was done to an archive.

One archive with several tests, versions and an issued report is made by the program; each case changes a copy of it as
somebody could who has SQLite and patience: triggers are put back as they were, hashes that can be computed anew are.
"""
import contextlib
import dataclasses
import importlib.util
import io
import json
import os
import pathlib
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "server"))
from served import Served  # noqa: E402

LONGEST_S = 120  # for a few rows, whatever their numbers are
VERIFIER = ROOT / "tools" / "verify_archive.py"
MEASURED = ROOT / "tests" / "transcripts" / "tracking-evaluate.files"


def heads_on_paper(archive):
    """Where the trail ended in front of each issued report, as the report itself says."""
    database = sqlite3.connect(archive)
    reports = [bytes.decode() for bytes, in database.execute(
        "SELECT c.bytes FROM document d JOIN content c ON c.sha256 = d.content WHERE d.kind = 'report' ORDER BY d.id")]
    database.close()
    return [re.search(r"Audit trail before issue.*?(\d+:[0-9a-f]{16})", report, re.DOTALL)[1] for report in reports]


PLAN = {"axis": "X", "kind": "linear", "from": 0, "to": 500, "positions": None, "targets": None, "cycle": "standard",
        "runs": 5, "feed": 1000, "dwell_s": 4, "overrun": None, "seed": 7, "further": {}}


def measured_file(folder, number):
    lines = [f"# machine.name: Mill {number % 2}", "# axis.name: X", "# axis.kind: linear",
             f"# equipment: Laser interferometer | Maker | LI-{number} | 12{number}", "target_mm,direction,run,deviation_um"]
    for run in range(1, 6):
        for direction in ("up", "down"):
            for target in range(0, 600, 100):
                lines.append(f"{target},{direction},{run},{number + run / 7 + target / 300:.4f}")
    path = folder / f"run{number}.csv"
    path.write_text("\n".join(lines) + "\n")
    return str(path)


def make_archive(program, folder):
    """An archive of three files, a withdrawn test, a withdrawn calibration, a plan and a report; and its seal."""
    archive, seal = folder / "good.db", folder / "good.seal"
    files = [measured_file(folder, number) for number in (1, 2, 3)]
    subprocess.run([program, "store", "add", *files, "--store", archive], check=True, stdout=subprocess.DEVNULL)
    instrument = ["--of-machine", "1", "--instrument", "1"]
    subprocess.run([program, "store", "calibrate", MEASURED / "lengths.csv", "--plan", MEASURED / "seven.json", *instrument,
                    "--store", archive], check=True, stdout=subprocess.DEVNULL)
    subprocess.run([program, "store", "compensate", "1", "--for", "linuxcnc", "--store", archive], check=True,
                   stdout=subprocess.DEVNULL)
    with Served(program, archive) as server:
        for method, path, body, wanted in (
                ("POST", "/api/tests/1/reports", {"extension": "html", "language": "en"}, 201),
                ("POST", "/api/plans", {"title": "X 500", "axis": None, "request": PLAN}, 201),
                ("POST", "/api/calibrations/1/withdraw", {"reason": "wrong plan"}, 200),
                ("POST", "/api/compensations/1/withdraw", {"reason": "wrong control"}, 200),
                ("POST", "/api/tests/2/withdraw", {"reason": "wrong axis"}, 200)):
            answer = server.request(method, path, body)
            if answer.status != wanted:
                sys.exit(f"{path}: found {answer.status} {answer.body}, expected {wanted}")
    subprocess.run([program, "store", "seal", seal, "--store", archive], check=True, stdout=subprocess.DEVNULL)
    return archive, seal


@contextlib.contextmanager
def past_the_guards(path):
    """A connection that may do anything; the triggers are as before afterwards."""
    database = sqlite3.connect(path, isolation_level=None)
    database.execute("PRAGMA synchronous = OFF")  # a copy that nobody needs after a power cut
    guards = database.execute("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'").fetchall()
    for name, _ in guards:
        database.execute(f"DROP TRIGGER {name}")
    yield database
    for _, sql in guards:
        database.execute(sql)
    database.close()


@dataclasses.dataclass
class Column:
    table: str
    name: str
    type: str
    nullable: bool

    def others(self, value):
        """Other values, as SQL."""
        if value is None:
            return [{"integer": "1000", "double precision": "1.5"}.get(self.type, "'x'")]
        found = {int: [f"{self.name} + 1000", f"1 - {self.name}"], float: [f"{self.name} * 2 + 1"],
                 str: [f"{self.name} || 'x'", "''"], bytes: ["x'00'"]}[type(value)]
        if value == "" or (isinstance(value, int) and value not in (0, 1)):
            found = found[:1]
        another_class = f"CAST({self.name} AS {'text' if isinstance(value, bytes) else 'blob'})"  # of the same bytes
        return [another_class, *found] + ["NULL"] * self.nullable


def columns_of(path):
    """Of all tables, as the database itself says, so that a new one is not forgotten."""
    database = sqlite3.connect(path)
    tables = [name for name, in database.execute("SELECT name FROM sqlite_master WHERE type = 'table' AND name NOT LIKE "
                                                 "'sqlite%' ORDER BY name")]
    found = [Column(table, name, kind, not required) for table in tables
             for _, name, kind, required, _, _ in database.execute(f"PRAGMA table_info({table})")]
    database.close()
    return found


def trials_of(path, column):
    """Rows and values to try: the first and the last row, which are of different kinds in most tables."""
    database = sqlite3.connect(path)
    rows = database.execute(f"SELECT rowid, {column.name} FROM {column.table} ORDER BY rowid").fetchall()
    database.close()
    return [(row, value) for row, cell in dict(rows[:1] + rows[-1:]).items() for value in column.others(cell)]


def change(*statements):
    def do(path):
        with past_the_guards(path) as database:
            for statement in statements:
                database.execute(statement)
    return do


def schema(*statements):
    def do(path):
        database = sqlite3.connect(path, isolation_level=None)
        for statement in statements:
            database.execute(statement)
        database.close()
    return do


def tell_version(version):
    """That of each test's first version in its entry, which has its place in the trail."""
    def alter(entry, detail):
        if entry["action"] == "test.received":
            detail["version"] = version
    return lambda path: tell_anew(path, alter)


def drop_all_triggers(path):
    database = sqlite3.connect(path, isolation_level=None)
    for name, in database.execute("SELECT name FROM sqlite_master WHERE type = 'trigger'").fetchall():
        database.execute(f"DROP TRIGGER {name}")
    database.close()


def delete_last_test(path, with_lines=True):
    """With all that tells of it, as far as it stands at the end."""
    with past_the_guards(path) as database:
        last, content = database.execute("SELECT id, content FROM test ORDER BY id DESC LIMIT 1").fetchone()
        first, = database.execute("SELECT min(id) FROM audit WHERE subject = (SELECT 'content ' || id FROM content WHERE "
                                  "sha256 = ?)", (content,)).fetchone()
        for table in ("list_instrument", "test_search", "test_list", "figure", "evaluation", "test_instrument",
                      "test_version"):
            database.execute(f"DELETE FROM {table} WHERE test = ?", (last,))
        database.execute("DELETE FROM test WHERE id = ?", (last,))
        if not with_lines:
            return
        gone = database.execute("SELECT subject FROM audit WHERE id >= ?", (first,)).fetchall()
        for table in ("document", "calibration_version", "calibration", "compensation_version", "compensation",
                      "plan_version", "plan", "content", "instrument_version", "instrument", "axis_version", "axis",
                      "machine_version", "machine"):
            record = table.removesuffix("_version")
            for subject, in gone:
                if subject.split(" ")[0] == record:
                    database.execute(f"DELETE FROM {table} WHERE id = ?", (int(subject.split(" ")[1]),))
        database.execute("UPDATE test SET withdrawn = 0")
        database.execute("UPDATE test_list SET withdrawn = 0")
        database.execute("UPDATE test_search SET withdrawn = 0")
        database.execute("UPDATE list_instrument SET withdrawn = 0")
        database.execute("DELETE FROM audit WHERE id >= ?", (first,))


@dataclasses.dataclass
class Case:
    what: str
    do: object
    needs_seal: bool = False


FAR = 2**63 - 1
UNGUARDED = "CREATE TRIGGER audit_unchanged BEFORE UPDATE ON audit BEGIN SELECT 1; END"
CASES = [
    Case("the last test without its lines", lambda path: delete_last_test(path, with_lines=False)),
    Case("the last test with all of its lines", delete_last_test, needs_seal=True),
    Case("a byte behind the last page", lambda path: os.truncate(path, os.path.getsize(path) + 1)),
    Case("a page behind the last one", lambda path: os.truncate(path, os.path.getsize(path) + 4096)),
    Case("a byte cut off the last page", lambda path: os.truncate(path, os.path.getsize(path) - 1)),
    Case("a byte of a file", change("UPDATE content SET bytes = CAST(replace(CAST(bytes AS text), '0', '1') AS blob)")),
    Case("the bytes of a file with their hash", change(
        "UPDATE content SET bytes = CAST('abc' AS blob), size = 3, sha256 = 'ba7816bf8f01cfea414140de5dae2223b00361a396177a9c"
        "b410ff61f20015ad' WHERE id = 3", "UPDATE test SET content = (SELECT sha256 FROM content WHERE id = 3) WHERE id = 3",
        "UPDATE test_list SET content = (SELECT sha256 FROM content WHERE id = 3) WHERE test = 3")),
    Case("who kept a file", change("UPDATE content SET actor = 'Ben' WHERE id = 1")),
    Case("a trigger dropped", schema("DROP TRIGGER figure_undeleted")),
    Case("a trigger's body", schema("DROP TRIGGER audit_unchanged", UNGUARDED)),
    Case("a trigger more", schema("CREATE TRIGGER quiet AFTER INSERT ON audit BEGIN DELETE FROM test_search; END")),
    Case("a trigger more, under a name as SQLite's statistics have them", schema(
        "PRAGMA writable_schema = ON", "INSERT INTO sqlite_master VALUES ('trigger', 'sqlite_stat_x', 'audit', 0, 'CREATE "
        "TRIGGER sqlite_stat_x AFTER INSERT ON audit BEGIN DELETE FROM test_search; END')")),
    Case("all triggers dropped", drop_all_triggers),
    Case("an entry", change("UPDATE audit SET actor = 'Ben' WHERE id = 3")),
    Case("an entry's time", change("UPDATE audit SET at = '2001' WHERE id = 1")),
    Case("an entry away", change("DELETE FROM audit WHERE id = 4")),
    Case("the tail of the trail", change("DELETE FROM audit WHERE id > 5")),
    Case("a figure", change("UPDATE figure SET value = value / 2 WHERE test = 1")),
    Case("a figure's limit", change("UPDATE figure SET tolerance = 100 WHERE test = 1")),
    Case("the result", change("UPDATE evaluation SET result = '{}' WHERE test = 2")),
    Case("the version's title", change("UPDATE test_version SET title = 'better' WHERE test = 1")),
    Case("a test that is no longer withdrawn", change("UPDATE test SET withdrawn = 0", "UPDATE test_list SET withdrawn = 0",
                                                      "UPDATE test_search SET withdrawn = 0",
                                                      "UPDATE list_instrument SET withdrawn = 0")),
    Case("a machine", change("UPDATE machine_version SET serial_number = '7'")),
    Case("a calibration's figures", change("UPDATE calibration_version SET figures = '[]' WHERE version = 1")),
    Case("the files of a calibration", change("UPDATE calibration_version SET files = replace(files, 'seven', 'eight')")),
    Case("a calibration that is no longer withdrawn", change("UPDATE calibration_version SET withdrawn = 0")),
    Case("a calibration without its last version", change("DELETE FROM calibration_version WHERE version = 2",
                                                          "UPDATE calibration SET latest = 1")),
    Case("a compensation's figures", change("UPDATE compensation_version SET figures = '[]' WHERE version = 1")),
    Case("the test of a compensation", change("UPDATE compensation_version SET test = 2 WHERE version = 1")),
    Case("a compensation that is no longer withdrawn", change("UPDATE compensation_version SET withdrawn = 0")),
    Case("a compensation without its last version", change("DELETE FROM compensation_version WHERE version = 2",
                                                           "UPDATE compensation SET latest = 1")),
    Case("a document", change("UPDATE document SET name = 'other.html'")),
    Case("a document more", change("INSERT INTO document SELECT id + 1, test, version, kind, name, media_type, language, "
                                   "content, size, at, actor, reason FROM document")),
    Case("a file's number far beyond the others", change(f"UPDATE content SET id = {FAR} WHERE id = 3")),
    Case("a test's number far beyond the others", change(f"UPDATE test SET id = {FAR} WHERE id = 3")),
    Case("a version's number far beyond the others", change(f"UPDATE test_version SET version = {FAR} WHERE test = 3")),
    Case("a document's number far beyond the others", change(f"UPDATE document SET id = {FAR}")),
    Case("an entry's number far beyond the others", change(
        f"UPDATE audit SET id = {FAR} WHERE id = (SELECT max(id) FROM audit)")),
    Case("two files' numbers, the last that there are", change(f"UPDATE content SET id = {FAR - 1} WHERE id = 2",
                                                               f"UPDATE content SET id = {FAR} WHERE id = 3")),
    Case("an entry of a version beyond all numbers of one", tell_version(1e300)),
    Case("an entry of half a version", tell_version(1.5)),
    Case("an entry's subject as bytes", change("UPDATE audit SET subject = CAST(subject AS blob)")),
    Case("the detail of an entry that no parser follows", change("UPDATE audit SET detail = replace(hex(zeroblob(100000)), "
                                                                 "'0', '[') WHERE id = 2")),
    Case("letters that a terminal obeys", change("UPDATE audit SET at = char(27) || '[2J' WHERE id = 2")),
    Case("a number that a list holds as a text", change("UPDATE test_list SET version = 'one'")),
    Case("an endless view in the place of a table", schema(
        "DROP TABLE test_search", "CREATE VIEW test_search AS WITH RECURSIVE endless(n) AS (SELECT 1 UNION ALL SELECT n FROM "
        "endless) SELECT n AS test, 0 AS withdrawn, 'x' AS words FROM endless")),
    Case("a column that is computed", schema("ALTER TABLE content ADD COLUMN more blob AS (zeroblob(900000000))")),
    Case("a row that refers to none", change("PRAGMA foreign_keys = OFF", "INSERT INTO list_instrument VALUES (99, 0, 1)")),
]


def is_changed(path, column, row, value):
    """Whether the database has such a row."""
    with past_the_guards(path) as database:
        with contextlib.suppress(sqlite3.IntegrityError):
            database.execute(f"UPDATE {column.table} SET {column.name} = {value} WHERE rowid = {row}")
            return True
    return False


def in_process():
    """The script as a function of an archive: one that is asked a thousand times."""
    spec = importlib.util.spec_from_file_location("verify_archive", VERIFIER)
    script = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(script)

    def verify(path):
        sys.argv = [str(VERIFIER), str(path)]
        with contextlib.redirect_stdout(io.StringIO()) as said:
            code = script.main()
        return code, said.getvalue().splitlines()
    return script, verify


def is_told(said, name):
    return any(line.startswith("not proved") and name in line for line in said)


def unseen_columns(program, good, folder):
    """Columns that may be changed without being found, who finds nothing, and whether it says so."""
    _, script = in_process()
    path, unseen = folder / "column.db", []

    def check(column, who, code, said):
        if code not in ((0, 3) if who == "script" else (0, 2, 3)):  # 2 of what the program does not open
            sys.exit(f"{column.table}.{column.name}: the {who} ended with {code}: {said[-3:]}")
        if code == 0:
            unseen.append((f"{column.table}.{column.name}", who, is_told(said, f"{column.table}.{column.name}")))

    columns = columns_of(good)
    for column in columns:
        shown = 0
        for row, value in trials_of(good, column):
            shutil.copy(good, path)
            if not is_changed(path, column, row, value):
                continue
            check(column, "script", *script(path))
            if shown < 2:  # of another class, and another value; store_column_test.cpp tries them all
                done = subprocess.run([program, "store", "verify", path], capture_output=True, text=True)
                check(column, "program", done.returncode, done.stdout.splitlines())
            shown += 1
        if not shown:
            unseen.append((f"{column.table}.{column.name}", "nobody", False))
    return len(columns), sorted(set(unseen))


NOT_PROVED = [("migration.at", who, True) for who in ("program", "script")]


def tell_anew(path, alter):
    """The entries with what `alter(entry, detail)` makes of their detail; the chain made anew."""
    script, _ = in_process()
    with past_the_guards(path) as database:
        database.row_factory = sqlite3.Row
        previous = ""
        for row in database.execute("SELECT * FROM audit ORDER BY id").fetchall():
            detail = json.loads(row["detail"])
            alter(row, detail)
            text = json.dumps(detail, separators=(",", ":"))
            previous = script.hash_of([previous, row["id"], row["at"], row["actor"], row["reason"], row["action"],
                                       row["subject"], text])
            database.execute("UPDATE audit SET detail = ?, sha256 = ? WHERE id = ?", (text, previous, row["id"]))


def forget_names(entry, detail):
    """As programs wrote them that did not tell file names and formats."""
    if entry["action"] in ("content.kept", "test.received"):
        detail.pop("format")
    if entry["action"] == "content.kept":
        detail.pop("file")


def check_early_entries(program, good, folder):
    """What no entry tells is said to be not proved, and nothing wrong."""
    path, (_, script) = folder / "early.db", in_process()
    shutil.copy(good, path)
    tell_anew(path, forget_names)
    done = subprocess.run([program, "store", "verify", path], capture_output=True, text=True)
    for who, code, said in (("program", done.returncode, done.stdout.splitlines()), ("script", *script(path))):
        for name in ("content.file_name", "content.format", "test.format"):
            if code != 0 or not is_told(said, name):
                yield f"{who}: of an archive whose entries do not tell {name} it says {said[-4:]}"


def check_clock(program, good, folder):
    """A clock that went back is noted by both, and no fault."""
    path, (script, verify) = folder / "clock.db", in_process()
    shutil.copy(good, path)
    database = sqlite3.connect(path, isolation_level=None)
    last, previous = database.execute("SELECT id, sha256 FROM audit ORDER BY id DESC LIMIT 1").fetchone()
    entry = (last + 1, "2001-02-03T04:05:06.007Z", "Anna", "set the clock", "clock.set", "store", "{}")
    database.execute("INSERT INTO audit VALUES (?, ?, ?, ?, ?, ?, ?, ?)", (*entry, script.hash_of([previous, *entry])))
    database.close()
    done = subprocess.run([program, "store", "verify", path], capture_output=True, text=True)
    for who, code, said in (("program", done.returncode, done.stdout.splitlines()), ("script", *verify(path))):
        if code != 0 or not any(line.startswith("noted: audit trail: the clock went back") for line in said):
            yield f"{who}: of a clock that went back it says {code}, {said}"


def check_log(program, good, folder):
    """What is altered in the log beside the file, behind which SQLite passes over finished changes, is found by both, and
    no verb destroys it."""
    path = folder / "logged.db"
    shutil.copy(good, path)
    reader, writer = (sqlite3.connect(path, isolation_level=None) for _ in range(2))
    for sql in ("BEGIN", "SELECT count(*) FROM audit"):  # for whom the log stays
        reader.execute(sql).fetchall()
    for _ in range(3):
        writer.execute("UPDATE test_list SET withdrawn = withdrawn")
    log = path.with_name(path.name + "-wal").read_bytes()
    writer.close(), reader.close()
    altered = "altered, expected it as it was written"
    for at, put in ((None, b""), (32 + 24 + 5, b"?"), (3, b"?"), (0, bytes(32))):
        left, found = folder / "left_log.db", at is not None
        shutil.copy(path, left)
        beside = left.with_name(left.name + "-wal")
        beside.write_bytes(log[:at] + put + log[at + len(put):] if found else log)
        for who, call, code in (("script", [sys.executable, VERIFIER, left], 2),
                                ("program", [program, "store", "verify", left], 3 if found else 0)):
            done = subprocess.run(call, capture_output=True, text=True)
            if done.returncode != code or found != (altered in done.stdout + done.stderr):
                yield f"{who}: of a log with the byte {at} altered it says {done.returncode}, {done.stdout}{done.stderr}"
        for verb in (("info",), ("list",), ("backup", folder / "no.db"), ("add", __file__)) if found else ():
            before = beside.read_bytes()
            done = subprocess.run([program, "store", *verb, "--store", left], capture_output=True, text=True)
            if done.returncode != 2 or altered not in done.stderr or beside.read_bytes() != before:
                yield f"{verb[0]}: of a log with the byte {at} altered it says {done.returncode}, {done.stderr}"
        beside.unlink()


def check_unfinished(program, backup, folder):
    """A change that was begun and killed: who only reads says that it is still to be taken back, and is right afterwards."""
    begun, left = folder / "begun.db", folder / "left.db"
    shutil.copy(backup, begun)
    database = sqlite3.connect(begun, isolation_level=None)
    for statement in ("PRAGMA cache_size = 1", "BEGIN IMMEDIATE", "UPDATE test_list SET title = hex(zeroblob(20000))",
                      "UPDATE test_search SET words = hex(zeroblob(20000))"):
        database.execute(statement)
    for ending in ("", "-journal"):
        shutil.copy(str(begun) + ending, str(left) + ending)
    database.close()
    for taken_back, wanted in ((False, 2), (True, 0)):
        for who, (code, said) in (("program", program_says(program, left)), ("script", script_says(left))):
            if code != wanted or (code == 2 and "-journal" not in "".join(said)):
                yield f"{who}: of a change that was begun, {taken_back=}, it says {code}, {said[:3]}"
        subprocess.run([program, "store", "info", "--store", left], check=True, stdout=subprocess.DEVNULL)


def check_sealing(program, good, folder):
    """No seal of a broken trail; none in the place of another key's but where that is asked for."""
    def seal(archive, *more):
        done = subprocess.run([program, "store", "seal", folder / "s.seal", "--store", archive, *more],
                              capture_output=True, text=True)
        return done.returncode, done.stdout + done.stderr

    archive, other = folder / "sealed.db", folder / "other.key"
    shutil.copy(good, archive)
    first, said = seal(archive)
    key = said.split("key: ")[-1].split(" ")[0]
    if first != 0 or seal(archive)[0] != 0:
        yield f"a seal is not followed: {said}"
    subprocess.run([program, "store", "seal", folder / "o.seal", "--store", archive, "--key", other], check=True,
                   stdout=subprocess.DEVNULL)
    other_key = json.loads((folder / "o.seal").read_text())["public_key"]
    code, said = seal(archive, "--key", str(other))
    if code != 2 or key not in said or other_key not in said or other_key in (folder / "s.seal").read_text():
        yield f"a seal of another key is replaced, or the keys are not named: {said}"
    code, said = seal(archive, "--key", str(folder / "none.key"))
    if code != 2 or (folder / "none.key").exists():
        yield f"a key is made that can go on from no seal: {said}"
    code, said = seal(archive, "--key", str(other), "--change-key")
    if code != 0 or other_key not in said:
        yield f"a key is not changed: {said}"
    change("UPDATE audit SET actor = 'Ben' WHERE id = 4")(archive)
    code, said = seal(archive, "--key", str(other))
    if code != 2 or "entry 4" not in said:
        yield f"a broken trail is sealed: {said}"


def program_says(program, path, *more):
    done = subprocess.run([program, "store", "verify", path, "--json", *more], capture_output=True, text=True,
                          timeout=LONGEST_S)
    return done.returncode, json.loads(done.stdout)["problems"] if done.returncode in (0, 3) else [done.stderr]


def script_says(path, *more):
    done = subprocess.run([sys.executable, VERIFIER, path, *more], capture_output=True, text=True, timeout=LONGEST_S)
    return done.returncode, (done.stdout + done.stderr).splitlines()


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    failures = []
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        good, seal = make_archive(program, folder)

        def expect(what, path, codes, *more):
            for who, (code, said) in (("program", program_says(program, path, *more)), ("script", script_says(path, *more))):
                if code not in codes:
                    failures.append(f"{what}: the {who} ended with {code}, expected {codes}: {said[:3]}")

        expect("nothing", good, [0])
        expect("nothing, with the seal", good, [0], "--seal", seal)
        heads = heads_on_paper(good)
        expect("nothing, with the head of a report", good, [0], "--head", heads[0])
        expect("a head of another trail", good, [3], "--head", heads[0][:-1] + ("1" if heads[0][-1] == "0" else "0"))
        expect("what is no head", good, [2], "--head", "17")
        backup = folder / "copy.db"
        subprocess.run([program, "store", "backup", backup, "--store", good], check=True, stdout=subprocess.DEVNULL)
        expect("a backup", backup, [0], "--seal", seal)
        for case in CASES:
            path = folder / "bad.db"
            shutil.copy(good, path)
            case.do(path)
            if case.needs_seal:
                expect(case.what + ", without the seal", path, [0])
                expect(case.what, path, [3], "--seal", seal)
            else:
                expect(case.what, path, [3])
        forged = folder / "forged.seal"
        forged.write_text(seal.read_text().replace('"entries": ', '"entries": 1'))
        expect("a forged seal", good, [2], "--seal", forged)
        expect("a seal of another key", good, [2], "--seal", seal, "--public-key", "00" * 32)
        counted, unseen = unseen_columns(program, good, folder)
        if unseen != NOT_PROVED:
            failures.append(f"columns that are changed unseen, by whom, and whether that is told: {unseen}")
        failures += [*check_early_entries(program, good, folder), *check_sealing(program, good, folder),
                     *check_clock(program, good, folder), *check_unfinished(program, backup, folder),
                     *check_log(program, good, folder)]
    for failure in failures:
        print(failure)
    if failures:
        sys.exit(1)
    print(f"{len(CASES)} ways to change an archive and each of {counted} columns, found by both verifiers")


if __name__ == "__main__":
    main()
