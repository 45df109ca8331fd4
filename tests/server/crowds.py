#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Crowds of clients that take room and give nothing, and one honest one beside them.

Usage: crowds.py PROGRAM

All come from one address, so that nobody is told apart by it.
"""
import json
import pathlib
import resource
import select
import socket
import ssl
import sys
import tempfile
import threading
import time
import urllib.parse

from doors import made_certificate
from heavy import draft, send_heavy
from served import Checks, Served

EXAMPLE = (pathlib.Path(__file__).parents[2] / "examples" / "iso230-2-table2.json").read_bytes()
TOKEN = "fedcba9876543210-secret"
LIST_MS_MAX = 100.0
HELD_MIB_MAX = 700  # 256 of answers, and what makes, keeps and frees them
EVALUATIONS_BEFORE = 60  # one at a time
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


def bodies_that_wait(server, checks):
    """More uploads of the largest size than there is memory for, all of which wait for evaluations before them: more of
    these than are made meanwhile."""
    size = (64 << 20) - (16 << 10)
    computing = [send_heavy(server, 3000 + k) for k in range(EVALUATIONS_BEFORE)]
    path = "/api/evaluations?draft=" + urllib.parse.quote(json.dumps(draft(1)))
    head = f"POST {path} HTTP/1.1\r\nHost: {server.host}\r\nContent-Length: {size}\r\n\r\n".encode()
    clients, refused = [], []
    for _ in range(6):
        client = socket.create_connection(("127.0.0.1", server.port), timeout=60)
        try:
            client.sendall(head + bytes(size))
            client.settimeout(0.2)
            refused.append(client.recv(4096))
        except TimeoutError:
            clients.append(client)  # waits
        except (BrokenPipeError, ConnectionResetError):
            refused.append(client.recv(4096))
    checks.that("some wait", clients, refused)
    checks.that("more than half of the memory is refused to one",
                len(clients) <= 2 and all(b" 503 " in answer for answer in refused), (len(clients), refused))
    checks.that("with the reason, and when to come again",
                all(b"more uploads" in answer and b"Retry-After" in answer for answer in refused), refused)
    answer = server.request("GET", "/api/tests/1/report.html")
    checks.that("large answers are given beside them", answer.status == 200 and len(answer.body) > 100_000,
                (answer.status, answer.body[:200]))
    answer = server.upload("/api/preview", "again.json", EXAMPLE)
    checks.that("and small bodies are taken", answer.status == 200, (answer.status, answer.body[:200]))
    held = server.resident_kib()
    print(f"six uploads of {size / 1e6:.0f} MB that wait behind evaluations: {held / 1024:.0f} MiB")
    checks.that("bodies that wait take no more memory than they may", held < HELD_MIB_MAX * 1024, held)
    checks.that("they wait to the end", not select.select([computing[-1], *clients], [], [], 0)[0])
    for client in computing + clients:
        client.close()


def what_leavers_asked_to_keep(server, checks):
    """Is kept, though they leave while it waits for evaluations before it: an edit with trials, a report, a file."""
    before = server.request("GET", "/api/health").json()["store"]["counts"]
    version = server.request("GET", "/api/tests/1").json()["latest"]
    edit = {**draft(1), "base_version": version, "title": "edited", "reason": "left"}
    edit["options"]["trials"] = 10_000
    report = {"extension": "html", "reason": "left"}
    computing = [send_heavy(server, 4000 + k) for k in range(3)]
    time.sleep(0.3)
    for path, kind, body in (("/api/tests/1/versions", "application/json", json.dumps(edit).encode()),
                             ("/api/tests/1/reports", "application/json", json.dumps(report).encode()),
                             ("/api/tests", "application/octet-stream", EXAMPLE + b"\n" * 100_000)):
        with socket.create_connection(("127.0.0.1", server.port), timeout=60) as client:
            client.sendall(f"POST {path} HTTP/1.1\r\nHost: {server.host}\r\nContent-Type: {kind}\r\nX-File-Name: a.json"
                           f"\r\nContent-Length: {len(body)}\r\n\r\n".encode() + body)
            time.sleep(0.1)
    time.sleep(1)  # until it is seen that they have left
    for client in computing:
        client.close()
    until = time.monotonic() + 60
    while time.monotonic() < until:
        after = server.request("GET", "/api/health").json()["store"]["counts"]
        found = (server.request("GET", "/api/tests/1").json()["latest"] - version,
                 after["documents"] - before["documents"], after["tests"] - before["tests"])
        if found == (1, 1, 1):
            break
        time.sleep(0.2)
    checks.that("an edit, a report and a file of those who left are kept", found == (1, 1, 1), found)


def names_are_no_askers(program, folder, checks):
    """Who fills the line under many names is one all the same, and another finds a place."""
    with Served(program, folder / "names.db", token=TOKEN, measured=True) as server:
        signed = {"Authorization": "Bearer " + TOKEN}
        server.request("POST", "/api/tests", EXAMPLE, {**signed, "X-File-Name": "first.json"})
        clients = [send_heavy(server, 5000 + k, f"Authorization: Bearer {TOKEN}\r\n") for k in range(400)]
        time.sleep(1)
        cookie = server.request("POST", "/api/login", {"token": TOKEN}).headers["set-cookie"].split(";")[0]
        answer = server.request("GET", "/api/tests/1/report.html", headers={"Cookie": cookie})
        checks.that("another finds a place in the line", answer.status == 200, (answer.status, answer.body[:200]))
        for client in clients:
            client.close()


def greeting():
    """How a client begins to speak TLS."""
    answers, said = ssl.MemoryBIO(), ssl.MemoryBIO()
    try:
        ssl.create_default_context().wrap_bio(answers, said, server_hostname="localhost").do_handshake()
    except ssl.SSLWantReadError:
        return said.read()


def handshakes(program, folder, checks):
    """Clients that all begin to speak TLS at once, and say no more, beside one who goes on; also after all have said a
    part of it."""
    hello = greeting()
    with Served(program, folder / "tls.db", tls=made_certificate(folder, "crowd"), measured=True) as server:
        for before in (0, 1, 5, len(hello) - 1):
            slowest = min(lists_beside_handshakes(server, hello, before) for _ in range(ROUNDS))
            print(f"lists beside 300 handshakes, {before} bytes of each sent before: max {slowest:.1f} ms")
            checks.that(f"lists do not wait for handshakes of which {before} bytes came before", slowest < LIST_MS_MAX,
                        slowest)


def lists_beside_handshakes(server, hello, before):
    """The slowest of them, in ms."""
    connection = server.connection()
    list_times(server, 3, connection)
    crowd = [connect(server) for _ in range(300)]
    for client in crowd:
        client.send(hello[:before])
    list_times(server, 3, connection)
    time.sleep(0.2)
    for client in crowd:
        client.send(hello[before:])
    slowest = list_times(server, 40, connection)[-1]
    for client in crowd:
        client.close()
    connection.close()
    return slowest


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    checks = Checks()
    with tempfile.TemporaryDirectory() as name, Served(program, pathlib.Path(name) / "crowd.db", measured=True) as server:
        _, hard = resource.getrlimit(resource.RLIMIT_NOFILE)
        resource.setrlimit(resource.RLIMIT_NOFILE, (min(hard, 4096), hard))
        server.upload("/api/tests", "first.json", EXAMPLE)
        for crowd in (silent, dripping, without_reading, bodies_that_wait,
                      what_leavers_asked_to_keep, full_files):
            crowd(server, checks)
            checks.that(f"after {crowd.__name__} it lives", server.process.poll() is None)
        names_are_no_askers(program, pathlib.Path(name), checks)
        handshakes(program, pathlib.Path(name), checks)
    checks.finish()


if __name__ == "__main__":
    main()
