#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Crowds of clients that take room and give nothing, and one honest one beside them.

Usage: crowds.py PROGRAM

All come from one address, so that nobody is told apart by it.
"""
import pathlib
import resource
import socket
import sys
import tempfile
import threading
import time

from served import Checks, Served

EXAMPLE = (pathlib.Path(__file__).parents[2] / "examples" / "iso230-2-table2.json").read_bytes()
LIST_MS_MAX = 100.0
HELD_MIB_MAX = 700  # 256 of answers, and what makes, keeps and frees them
ROUNDS = 3  # where another program of the machine may have been what a list waited for


def list_times(server, count, connection=None):
    """Milliseconds of lists, each over a connection of its own unless one is given."""
    times = []
    for _ in range(count):
        begin = time.monotonic()
        answer = server.request("GET", "/api/tests?limit=20", connection=connection)
        times.append((time.monotonic() - begin) * 1000 if answer.status == 200 else float("inf"))
    return sorted(times)


def connect(server):
    client = socket.create_connection(("127.0.0.1", server.port), timeout=10)
    client.setblocking(False)
    return client


def silent(server, checks):
    """More clients that say nothing than there are places. Whoever comes anew is served at once, and so is who was
    there before."""
    slowest = float("inf")
    for _ in range(ROUNDS):
        before = server.connection()
        list_times(server, 1, before)
        crowd = [connect(server) for _ in range(1100)]
        ours = list_times(server, 40)
        kept = list_times(server, 40, before)
        for client in crowd:
            client.close()
        before.close()
        slowest = min(slowest, max(ours[int(0.95 * len(ours))], kept[int(0.95 * len(kept))]))
        if slowest < LIST_MS_MAX:
            break
    print(f"lists beside 1100 silent clients: p95 {slowest:.1f} ms")
    checks.that("a newcomer beside silent clients is answered at once", slowest < LIST_MS_MAX, slowest)


def dripping(server, checks):
    """The same with heads and bodies that never end, and with clients that come again whenever they are closed."""
    until = time.monotonic() + 4

    def keep_coming(opening):
        clients = []
        while time.monotonic() < until:
            try:
                clients.append(connect(server))
                clients[-1].send(opening)
            except OSError:
                time.sleep(0.01)
            if len(clients) > 400:
                clients.pop(0).close()
        for client in clients:
            client.close()

    host = f"Host: {server.host}\r\n".encode()
    threads = [threading.Thread(target=keep_coming, args=(opening,)) for opening in
               (b"", b"GET / HTTP/1.1\r\n", b"POST /api/tests HTTP/1.1\r\n" + host + b"Content-Length: 1000\r\n\r\nx")]
    for thread in threads:
        thread.start()
    time.sleep(1)
    times = list_times(server, 30)
    for thread in threads:
        thread.join()
    print(f"lists beside clients that keep coming: p50 {times[len(times) // 2]:.1f} ms, max {times[-1]:.1f} ms")
    checks.that("an honest client among those who keep coming is answered", times[-1] < float("inf"), times[-3:])


def without_reading(server, checks):
    """Clients that ask for large answers and do not read them."""
    size = 12 << 20
    answer = server.upload("/api/tests/1/attachments", "large.bin", bytes(size))
    checks.that("a large attachment is taken", answer.status == 201, answer.body[:200])
    path = f"/api/documents/{answer.json()['id']}"
    head = f"GET {path} HTTP/1.1\r\nHost: {server.host}\r\n\r\n".encode()
    crowd, most = [], 0
    for _ in range(300):
        client = connect(server)
        client.send(head)
        crowd.append(client)
        most = max(most, server.resident_kib())
    for _ in range(30):
        server.request("GET", "/api/health")
        most = max(most, server.resident_kib())
        time.sleep(0.1)
    answer = server.request("GET", path)
    checks.that("who reads is answered beside those who do not", answer.status == 200 and len(answer.body) == size,
                (answer.status, answer.body[:200]))
    print(f"300 clients that do not read {size / 1e6:.1f} MB: {most / 1024:.0f} MiB")
    checks.that("answers that nobody reads take no more memory than they may", most < HELD_MIB_MAX * 1024, most)
    for client in crowd:
        client.close()


def full_files(server, checks):
    """A file that may grow no more fails the write, not the program."""
    pid = server.process.pid
    _, hard = resource.prlimit(pid, resource.RLIMIT_FSIZE)
    resource.prlimit(pid, resource.RLIMIT_FSIZE, (64 << 20, hard))
    statuses = []
    for k in range(40):
        answer = server.upload("/api/tests/1/attachments", f"{k}.bin", bytes([k]) * (4 << 20))
        statuses.append(answer.status)
        if answer.status != 201:
            break
    checks.that("a write beyond the limit is refused", statuses[-1] >= 500, statuses)
    checks.that("and says why", b'"message":"' in answer.body, answer.body[:200])
    checks.that("lists are answered all the same", server.request("GET", "/api/tests").status == 200)
    resource.prlimit(pid, resource.RLIMIT_FSIZE, (hard, hard))
    answer = server.upload("/api/tests/1/attachments", "again.bin", b"again")
    checks.that("and what fits again is kept", answer.status == 201, answer.body[:200])


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    checks = Checks()
    with tempfile.TemporaryDirectory() as name, Served(program, pathlib.Path(name) / "crowd.db") as server:
        _, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, 4096), hard))
        server.upload("/api/tests", "first.json", EXAMPLE)
        for crowd in (silent, dripping, without_reading, full_files):
            crowd(server, checks)
            checks.that(f"after {crowd.__name__} it lives", server.process.poll() is None)
    checks.finish()


if __name__ == "__main__":
    main()
