#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""hung.py PROGRAM: a database server that is stopped (not dead) does not hang the workbench.

Runs beside tests/store/with_postgresql. While the server and all its processes are stopped, every question, that of the
health included, is answered by 503 with a reason; two seconds are promised, the bound here leaves room for a busy machine.
When it goes on, so does the workbench. The time of the slowest answer is printed.
"""
import concurrent.futures
import contextlib
import os
import pathlib
import signal
import sys
import time

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent))
from served import Checks, Served  # noqa: E402

BOUND_S = 8.0
AT_ONCE = 24
QUESTIONS = (("GET", "/api/health", None), ("GET", "/api/tests", None), ("GET", "/api/tests/1", None),
             ("POST", "/api/machines", {"name": "Mill"}))


def processes(server):
    """The server first, so that it begins no more."""
    children = pathlib.Path(f"/proc/{server}/task/{server}/children").read_text().split()
    return [server, *map(int, children)]


def tell(those, number):
    """One that has ended meanwhile need not be told: the server begins and ends some by itself."""
    for process in those:
        with contextlib.suppress(ProcessLookupError):
            os.kill(process, number)


def timed(server, question):
    begun = time.monotonic()
    answer = server.request(*question)
    return question[1], answer, time.monotonic() - begun


def ask(server, checks):
    with concurrent.futures.ThreadPoolExecutor(AT_ONCE) as pool:
        for path, answer, seconds in pool.map(
                lambda k: timed(server, QUESTIONS[k % len(QUESTIONS)]), range(AT_ONCE)):
            checks.that(f"{path} is refused as unavailable", answer.status == 503, answer.body)
            checks.that(f"{path} says why", b"silent" in answer.body, answer.body)
            checks.that(f"{path} is answered soon", seconds < BOUND_S, seconds)
            yield seconds


def main():
    store = os.environ["AXIOMETRY_TEST_POSTGRESQL"] + "&options=-csearch_path%3Dhung"
    database = int(os.environ["AXIOMETRY_TEST_POSTGRESQL_PID"])
    checks = Checks()
    with Served(sys.argv[1], store) as server:
        checks.that("the workbench is well", server.request("GET", "/api/health").status == 200)
        stopped = processes(database)
        try:
            tell(stopped, signal.SIGSTOP)
            first = list(ask(server, checks))
            later = list(ask(server, checks))
        finally:
            tell(stopped, signal.SIGCONT)
        for path in ("/api/health", "/api/tests"):
            checks.that(f"{path} is answered again", server.request("GET", path).status == 200)
    print(f"slowest answers: {max(first):.2f} s when it was stopped, {max(later):.2f} s later")
    checks.finish()


if __name__ == "__main__":
    main()
