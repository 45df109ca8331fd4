#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""late.py PROGRAM: a capture whose test the database gets long after the program was killed becomes one test.

Runs beside tests/store/with_postgresql. The database waits for a standby that is away before it lets a COMMIT be done, so
nobody sees the test of the capture that has just ended. The program is killed, started again, and goes on with the capture;
while it waits to keep the test, the first COMMIT comes through.
"""
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

HERE = pathlib.Path(__file__).resolve().parent
sys.path[:0] = [str(HERE), str(HERE.parent / "store")]
from served import Checks, Served  # noqa: E402
from standby_test import PRIMARY, PRIMARY_FOLDER, tool  # noqa: E402

WAIT_S = 30
PLAN = {"axis": "X", "kind": "linear", "from": 0, "to": 100, "positions": None, "targets": None, "cycle": "standard",
        "runs": 2, "feed": 1000, "dwell_s": 4, "overrun": None, "seed": 7, "further": {}}


def database(sql):
    """As one statement each, which is what ALTER SYSTEM asks for."""
    command = [tool("psql"), "--quiet", "--tuples-only", "--no-align", "--host", PRIMARY_FOLDER, "--username=axiometry",
               "axiometry", "-c", sql]
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout.strip()


def wait_for_standby(name):
    database(f"ALTER SYSTEM SET synchronous_standby_names = '{name}'")
    database("SELECT pg_reload_conf()")


def wait_until(what, question):
    deadline = time.monotonic() + WAIT_S
    while not (answer := question()):
        if time.monotonic() > deadline:
            sys.exit(f"late: found no {what} within {WAIT_S} s")
        time.sleep(0.05)
    return answer


def is_waiting_for(event):
    return int(database(f"SELECT count(*) FROM pg_stat_activity WHERE wait_event = '{event}'")) > 0


def asked(server, method, path, body=None):
    answer = server.request(method, path, body)
    if answer.status >= 300:
        sys.exit(f"late: {path}: found {answer.status} {answer.body}, expected success")
    return answer.json()


def capture(server):
    return asked(server, "GET", "/api/captures")["captures"][0]


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    store = PRIMARY + "&options=-csearch_path%3Dlate"
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        os.environ["XDG_STATE_HOME"] = folder  # where captures lie until they are kept
        first = Served(program, store)
        try:
            plan = asked(first, "POST", "/api/plans", {"title": "X 100", "axis": None, "request": PLAN})["id"]
            begun = asked(first, "POST", "/api/captures", {"plan": plan, "source": "simulator", "layout": "",
                                                           "options": {"speed": "60"}})["id"]
            wait_until("reading", lambda: len(asked(first, "GET", f"/api/captures/{begun}?after=0")["readings"]) > 3)
            wait_for_standby("away")
            asked(first, "POST", f"/api/captures/{begun}/stop", {})
            wait_until("COMMIT that waits for the standby", lambda: is_waiting_for("SyncRep"))
        finally:
            first.process.send_signal(signal.SIGKILL)
            first.process.wait()
        with Served(program, store) as second:
            checks.that("the test is not seen yet", asked(second, "GET", "/api/tests")["total"] == 0)
            checks.that("the capture is interrupted", capture(second)["state"] == "interrupted")
            gone_on = asked(second, "POST", "/api/captures", {"resume": capture(second)["id"]})["id"]
            wait_until("reading", lambda: len(asked(second, "GET", f"/api/captures/{gone_on}?after=0")["readings"]) > 3)
            asked(second, "POST", f"/api/captures/{gone_on}/stop", {})
            wait_until("writer that waits for the first", lambda: is_waiting_for("advisory"))
            wait_for_standby("")
            ended = wait_until("end of the capture", lambda: capture(second) if capture(second)["state"] in (
                "complete", "stopped", "failed") else None)
            checks.that("the capture has its test", ended.get("test") == 1, ended.get("test"))
            checks.that("one capture is one test", asked(second, "GET", "/api/tests")["total"] == 1)
    checks.finish()


if __name__ == "__main__":
    main()
