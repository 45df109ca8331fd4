#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""tamper_test.py PROGRAM: both verifiers, the program's and tools/verify_archive.py, find what was done to an archive.

One archive with several tests, versions and an issued report is made by the program; each case changes a copy of it as
somebody could who has SQLite and patience: triggers are put back as they were, hashes that can be computed anew are.
"""
import contextlib
import dataclasses
import json
import pathlib
import shutil
import sqlite3
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
sys.path.insert(0, str(ROOT / "tests" / "server"))
from served import Served  # noqa: E402

VERIFIER = ROOT / "tools" / "verify_archive.py"


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
    """An archive of three files, a revised and a withdrawn test, and a report; and its seal."""
    archive, seal = folder / "good.db", folder / "good.seal"
    files = [measured_file(folder, number) for number in (1, 2, 3)]
    subprocess.run([program, "store", "add", *files, "--store", archive], check=True, stdout=subprocess.DEVNULL)
    with Served(program, archive) as server:
        for method, path, body, wanted in (
                ("POST", "/api/tests/1/reports", {"extension": "html", "language": "en"}, 201),
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
    guards = database.execute("SELECT name, sql FROM sqlite_master WHERE type = 'trigger'").fetchall()
    for name, _ in guards:
        database.execute(f"DROP TRIGGER {name}")
    yield database
    for _, sql in guards:
        database.execute(sql)
    database.close()


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
        for table in ("document", "content", "instrument_version", "instrument", "axis_version", "axis",
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


UNGUARDED = "CREATE TRIGGER audit_unchanged BEFORE UPDATE ON audit BEGIN SELECT 1; END"
CASES = [
    Case("the last test without its lines", lambda path: delete_last_test(path, with_lines=False)),
    Case("the last test with all of its lines", delete_last_test, needs_seal=True),
    Case("a byte of a file", change("UPDATE content SET bytes = CAST(replace(CAST(bytes AS text), '0', '1') AS blob)")),
    Case("the bytes of a file with their hash", change(
        "UPDATE content SET bytes = CAST('abc' AS blob), size = 3, sha256 = 'ba7816bf8f01cfea414140de5dae2223b00361a396177a9c"
        "b410ff61f20015ad' WHERE id = 3", "UPDATE test SET content = (SELECT sha256 FROM content WHERE id = 3) WHERE id = 3",
        "UPDATE test_list SET content = (SELECT sha256 FROM content WHERE id = 3) WHERE test = 3")),
    Case("who kept a file", change("UPDATE content SET actor = 'Ben' WHERE id = 1")),
    Case("a trigger dropped", schema("DROP TRIGGER figure_undeleted")),
    Case("a trigger's body", schema("DROP TRIGGER audit_unchanged", UNGUARDED)),
    Case("a trigger more", schema("CREATE TRIGGER quiet AFTER INSERT ON audit BEGIN DELETE FROM test_search; END")),
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
    Case("a document", change("UPDATE document SET name = 'other.html'")),
    Case("a document more", change("INSERT INTO document SELECT id + 1, test, version, kind, name, media_type, language, "
                                   "content, size, at, actor, reason FROM document")),
    Case("a row that refers to none", change("PRAGMA foreign_keys = OFF", "INSERT INTO list_instrument VALUES (99, 0, 1)")),
]


def program_says(program, path, *more):
    done = subprocess.run([program, "store", "verify", path, "--json", *more], capture_output=True, text=True)
    return done.returncode, json.loads(done.stdout)["problems"] if done.returncode in (0, 3) else [done.stderr]


def script_says(path, *more):
    done = subprocess.run([sys.executable, VERIFIER, path, *more], capture_output=True, text=True)
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
    for failure in failures:
        print(failure)
    if failures:
        sys.exit(1)
    print(f"{len(CASES)} ways to change an archive, each found by both verifiers")


if __name__ == "__main__":
    main()
