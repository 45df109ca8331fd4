# SPDX-License-Identifier: Apache-2.0
"""What computes for long, and how light requests fare beside it; a part of load.py."""
import json
import math
import select
import socket
import threading
import time

HEAVY_CLIENTS = 8
LIST_MS_MAX = 50.0  # of the 95th percentile
REPORT_S_MAX = 1.0  # of a small report beside Monte Carlo evaluations of some seconds each
TRIALS = 1_000_000


def large_test(example, targets, runs=5):
    """The bytes of a test of so many targets with `runs` readings in each direction."""
    test = json.loads(example)
    positions = [round(1750 * i / targets + 0.3 * math.sin(i) * 1750 / targets, 4) + 1 for i in range(targets)]
    line = lambda run, shift: [round(3 * math.sin(x / 200) + shift + 0.4 * math.sin(17 * i + 5 * run), 2)
                               for i, x in enumerate(positions)]
    test["series"]["targets"] = positions
    test["series"]["up"] = [line(run, -1) for run in range(runs)]
    test["series"]["down"] = [line(run + runs, 1) for run in range(runs)]
    return json.dumps(test).encode()


def draft(seed):
    return {"changes": {}, "options": {"methods": ["gum", "monte-carlo"], "trials": TRIALS, "seed": seed,
                                       "coverage": 0.95, "corrections": []}}


def keep_computing(server, number, test, until, faults):
    """Reports and Monte Carlo evaluations in turn."""
    turn = number
    while time.monotonic() < until:
        turn += 1
        if turn % 2:
            answer = server.request("GET", f"/api/tests/{test}/report.pdf", headers={"X-Actor": f"client{number}"})
        else:
            answer = server.request("POST", "/api/tests/1/evaluate", draft(turn), {"X-Actor": f"client{number}"})
        if answer.status != 200:
            faults.append((answer.status, answer.body[:200]))


def one_round(server, checks, test, seconds):
    """The 95th percentile of the time for a list, in ms, while all heavy clients compute."""
    faults, times = [], []
    until = time.monotonic() + seconds
    threads = [threading.Thread(target=keep_computing, args=(server, i, test, until, faults))
               for i in range(HEAVY_CLIENTS)]
    for thread in threads:
        thread.start()
    time.sleep(0.5)
    connection = server.connection()
    while time.monotonic() < until:
        begin = time.monotonic()
        answer = server.request("GET", "/api/tests?limit=20", connection=connection)
        times.append((time.monotonic() - begin) * 1000)
        if answer.status != 200:
            faults.append((answer.status, answer.body[:200]))
        time.sleep(0.02)
    connection.close()
    for thread in threads:
        thread.join()
    times.sort()
    p95 = times[int(0.95 * len(times))]
    checks.that("nothing failed beside heavy requests", not faults, faults[:3])
    print(f"{HEAVY_CLIENTS} heavy clients: list {len(times)}  p50 {times[len(times) // 2]:.1f} ms  p95 {p95:.1f} ms  "
          f"max {times[-1]:.1f} ms")
    return p95


def light_beside_heavy(server, checks, example, seconds=6.0, rounds=3):
    """Lists answer at once while reports and Monte Carlo evaluations take all that the machine has. Rounds are repeated
    where another program of the machine may have been what a list waited for."""
    answer = server.upload("/api/tests", "large.json", large_test(example, 1000))
    checks.that("a large test is taken", answer.status == 201, answer.body[:200])
    test = answer.json()["tests"][0]["id"]
    p95 = math.inf
    for _ in range(rounds):
        p95 = min(p95, one_round(server, checks, test, seconds))
        if p95 < LIST_MS_MAX:
            break
    checks.that("lists do not wait for heavy requests", p95 < LIST_MS_MAX, f"{p95:.1f} ms")


def send_heavy(server, seed, fields=""):
    body = json.dumps(draft(seed)).encode()
    client = socket.create_connection(("127.0.0.1", server.port), timeout=60)
    client.sendall(f"POST /api/tests/1/evaluate HTTP/1.1\r\nHost: {server.host}\r\nContent-Type: application/json\r\n"
                   f"X-Actor: client{seed}\r\n{fields}Content-Length: {len(body)}\r\n\r\n".encode() + body)
    return client


def report_beside_monte_carlo(server, checks, seed):
    """Seconds for a report while four evaluations take or await all processors."""
    clients = [send_heavy(server, seed + i) for i in range(4)]
    time.sleep(0.3)
    begin = time.monotonic()
    answer = server.request("GET", "/api/tests/1/report.html", headers={"X-Actor": "in a hurry"})
    seconds = time.monotonic() - begin
    checks.that("a report beside Monte Carlo evaluations is made", answer.status == 200, answer.body[:200])
    for client in clients:
        client.close()
    print(f"report beside {len(clients)} Monte Carlo evaluations: {1000 * seconds:.0f} ms")
    return seconds


def reports_beside_monte_carlo(server, checks, rounds=3):
    """Evaluations of all processors come one after another, and those that wait keep nothing that a report needs.
    Rounds are repeated as in light_beside_heavy()."""
    seconds = math.inf
    for k in range(rounds):
        seconds = min(seconds, report_beside_monte_carlo(server, checks, 2000 + 10 * k))
        if seconds < REPORT_S_MAX:
            break
    checks.that("and does not wait for them", seconds < REPORT_S_MAX, f"{seconds:.2f} s")


def answers_within(clients, seconds):
    """What those clients are told who are told anything so soon."""
    answers = {}
    until = time.monotonic() + seconds
    while (left := until - time.monotonic()) > 0:
        for client in select.select([c for c in clients if c not in answers], [], [], left)[0]:
            answers[client] = client.recv(4096)
    return list(answers.values())


def who_leaves_gives_up_the_place(server, checks):
    """A line that is filled and left by its clients is empty for the next."""
    clients = [send_heavy(server, 1000 + i) for i in range(400)]
    refused = [answer for answer in answers_within(clients, 2.0) if b" 503 " in answer]
    checks.that("a full line refuses", len(refused) > 20, len(refused))
    checks.that("and says when to come again", all(b"Retry-After: 10\r\n" in answer for answer in refused), refused[:1])
    for client in clients:
        client.close()
    time.sleep(1.5)
    begin = time.monotonic()
    answer = server.request("POST", "/api/tests/1/evaluate", draft(2))
    seconds = time.monotonic() - begin
    checks.that("the places of who has left are free", answer.status == 200, answer.body[:200])
    checks.that("and nothing is computed for them", seconds < 40, seconds)
    print(f"after {len(clients) - len(refused)} clients have left the line: {seconds:.1f} s for the next")
