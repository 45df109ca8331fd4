#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""200 clients at once, and the server neither fails nor grows; and light requests beside heavy ones (heavy.py).

Usage: load.py PROGRAM [SECONDS]

Each client keeps its connection and asks for lists, tests, drafts, the page and now and then a report, or sends a file.
Every answer must be the expected one. Memory and descriptors of the last third must be those of the first. Prints what
docs/performance.md tells.
"""
import http.client
import pathlib
import random
import statistics
import sys
import tempfile
import threading
import time

from heavy import light_beside_heavy, reports_beside_monte_carlo, who_leaves_gives_up_the_place
from served import Checks, Served

EXAMPLE = (pathlib.Path(__file__).parents[2] / "examples" / "iso230-2-table2.json").read_bytes()
CLIENTS = 200
GROWTH_KIB = 24 * 1024  # of what an allocator keeps; a leak of one body for each upload would be more
KINDS = [("list", 40), ("test", 30), ("page", 12), ("health", 10), ("upload", 5), ("report", 3)]


class Tally:
    def __init__(self):
        self.lock = threading.Lock()
        self.times = {name: [] for name, _ in KINDS}
        self.faults = []

    def add(self, kind, seconds, fault):
        with self.lock:
            self.times[kind].append(seconds)
            if fault:
                self.faults.append(fault)


def ask(server, kind, connection):
    if kind == "list":
        return server.request("GET", "/api/tests?limit=20", connection=connection).status == 200
    if kind == "test":
        return server.request("GET", "/api/tests/1", connection=connection).status == 200
    if kind == "page":
        return server.request("GET", "/", connection=connection).status == 200
    if kind == "health":
        return server.request("GET", "/api/health", connection=connection).status == 200
    if kind == "upload":
        return server.upload("/api/tests", "load.json", EXAMPLE, connection).status == 201
    return server.request("GET", "/api/tests/1/report.html", connection=connection).body.startswith(b"<!")


def client(server, seed, until, tally):
    draw = random.Random(seed)
    connection = server.connection()
    names = [name for name, _ in KINDS]
    weights = [weight for _, weight in KINDS]
    while time.monotonic() < until:
        kind = draw.choices(names, weights)[0]
        begin = time.monotonic()
        try:
            fault = None if ask(server, kind, connection) else f"{kind}: another answer"
        except (OSError, http.client.HTTPException) as error:
            fault = f"{kind}: {error!r}"
            connection.close()
        tally.add(kind, time.monotonic() - begin, fault)
    connection.close()


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    seconds = float(sys.argv[2]) if len(sys.argv) > 2 else 18.0
    checks = Checks()
    tally = Tally()
    with tempfile.TemporaryDirectory() as folder, Served(program, pathlib.Path(folder) / "load.db", measured=True) as server:
        answer = server.upload("/api/tests", "first.json", EXAMPLE)
        checks.that("the first file is taken", answer.status == 201, answer.body[:200])
        begin = time.monotonic()
        threads = [threading.Thread(target=client, args=(server, i, begin + seconds, tally)) for i in range(CLIENTS)]
        for thread in threads:
            thread.start()
        memory, descriptors = [], []
        while time.monotonic() < begin + seconds:
            time.sleep(0.25)
            memory.append(server.resident_kib())
            descriptors.append(server.descriptors())
        for thread in threads:
            thread.join()
        elapsed = time.monotonic() - begin
        time.sleep(0.5)
        third = len(memory) // 3
        growth = statistics.median(memory[-third:]) - statistics.median(memory[third // 2:third])
        checks.that("no request failed", not tally.faults, tally.faults[:5])
        checks.that("memory does not grow", growth < GROWTH_KIB, f"{growth} KiB")
        checks.that("descriptors do not grow", max(descriptors[-third:]) <= max(descriptors[:third]) + 4,
                    (max(descriptors[:third]), max(descriptors[-third:])))
        checks.that("all descriptors are given back", server.descriptors() < 40, server.descriptors())
        count = sum(len(times) for times in tally.times.values())
        page = server.request("GET", "/api/tests?limit=1").json()["total"]
        checks.that("every upload is there", page == 1 + len(tally.times["upload"]), page)
        print(f"{CLIENTS} clients, {elapsed:.1f} s: {count} requests, {count / elapsed:.0f}/s; memory "
              f"{memory[-1] / 1024:.0f} MiB ({growth / 1024:+.1f}), {max(descriptors)} descriptors")
        for kind, times in tally.times.items():
            if times:
                print(f"  {kind:7} {len(times):6}  p50 {percentile(times, 0.5) * 1000:6.1f} ms  "
                      f"p99 {percentile(times, 0.99) * 1000:6.1f} ms")
    with tempfile.TemporaryDirectory() as folder, Served(program, pathlib.Path(folder) / "heavy.db", measured=True) as server:
        server.upload("/api/tests", "first.json", EXAMPLE)
        light_beside_heavy(server, checks, EXAMPLE)
        reports_beside_monte_carlo(server, checks)
        who_leaves_gives_up_the_place(server, checks)
    checks.finish()


if __name__ == "__main__":
    main()
