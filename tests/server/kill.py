#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kills `axiometry serve` while it writes and proves that nothing that it has acknowledged is lost.

Usage: kill.py PROGRAM [KILLS]

Several clients send files, edit tests and issue reports. At a random moment the server is killed (SIGKILL), then started
again on the same store: every id that was acknowledged is there with its very bytes, versions and documents, and
`axiometry store verify` finds nothing wrong.
"""
import hashlib
import http.client
import pathlib
import random
import signal
import subprocess
import sys
import tempfile
import threading
import time

from served import Checks, Served

EXAMPLE = (pathlib.Path(__file__).parents[2] / "examples" / "iso230-2-table2.json").read_bytes()
CLIENTS = 4


def different(seed):
    """The example with another title, so that each file has bytes of its own."""
    end = EXAMPLE.rstrip().rfind(b"}")
    return EXAMPLE[:end] + b" " * (1 + seed % 97) + b"\n" * (1 + seed // 97) + EXAMPLE[end:]


class Acknowledged:
    def __init__(self):
        self.lock = threading.Lock()
        self.tests = {}  # id: SHA-256 of the bytes
        self.versions = {}  # id: the latest that was acknowledged
        self.documents = {}  # id: SHA-256


def work(server, known, first_seed, stop):
    connection = server.connection(timeout=10)
    seed = first_seed
    try:
        while not stop.is_set():
            content = different(seed)
            seed += 1
            answer = server.upload("/api/tests", f"kill-{seed}.json", content, connection)
            if answer.status != 201:
                return
            test = answer.json()["id"]
            with known.lock:
                known.tests[test] = hashlib.sha256(content).hexdigest()
                known.versions[test] = 1
            revision = {"base_version": 1, "title": f"killed {seed}", "reason": "test", "changes": {},
                        "options": answer.json().get("options") or
                        {"methods": [], "trials": None, "seed": 1, "coverage": 0.95, "corrections": []}}
            answer = server.request("POST", f"/api/tests/{test}/versions", revision, connection=connection)
            if answer.status == 201:
                with known.lock:
                    known.versions[test] = 2
            answer = server.request("POST", f"/api/tests/{test}/reports", {"extension": "csv"}, connection=connection)
            if answer.status == 201:
                with known.lock:
                    known.documents[answer.json()["id"]] = answer.json()["sha256"]
    except (OSError, http.client.HTTPException, ValueError):
        return  # killed


def check_kept(server, known, checks):
    for test, digest in known.tests.items():
        answer = server.request("GET", f"/api/tests/{test}/raw")
        checks.that(f"the bytes of test {test} are there",
                    answer.status == 200 and hashlib.sha256(answer.body).hexdigest() == digest, answer.status)
        latest = server.request("GET", f"/api/tests/{test}").json()["latest"]
        checks.that(f"the versions of test {test} are there", latest >= known.versions[test], latest)
    for document, digest in known.documents.items():
        answer = server.request("GET", f"/api/documents/{document}")
        checks.that(f"document {document} is there",
                    answer.status == 200 and hashlib.sha256(answer.body).hexdigest() == digest, answer.status)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    kills = int(sys.argv[2]) if len(sys.argv) > 2 else 10
    draw = random.Random(20261122)
    checks = Checks()
    known = Acknowledged()
    with tempfile.TemporaryDirectory() as folder:
        store = pathlib.Path(folder) / "killed.db"
        for kill in range(kills):
            server = Served(program, store)
            stop = threading.Event()
            clients = [threading.Thread(target=work, args=(server, known, 100_000 * kill + 10_000 * i, stop))
                       for i in range(CLIENTS)]
            for client in clients:
                client.start()
            time.sleep(draw.uniform(0.1, 0.6))
            server.stop(signal.SIGKILL)
            stop.set()
            for client in clients:
                client.join()
            verified = subprocess.run([program, "store", "verify", str(store)], capture_output=True, text=True,
                                      timeout=60, check=False)
            checks.that(f"after kill {kill + 1} the store is sound", verified.returncode == 0,
                        verified.stdout + verified.stderr)
        with Served(program, store) as server:
            check_kept(server, known, checks)
    checks.that("something was kept", len(known.tests) >= kills, len(known.tests))
    print(f"{kills} kills: {len(known.tests)} tests, {sum(known.versions.values())} versions, "
          f"{len(known.documents)} reports were acknowledged")
    checks.finish()


if __name__ == "__main__":
    main()
