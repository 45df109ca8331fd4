#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Attacks `axiometry serve` and proves that it refuses, cuts off, keeps nothing half, and still answers afterwards.

Usage: attack.py PROGRAM
"""
import pathlib
import socket
import subprocess
import sys
import tempfile
import threading
import time

from served import Checks, Served, read_all

EXAMPLE = pathlib.Path(__file__).parents[2] / "examples" / "iso230-2-table2.json"
TOKEN = "0123456789abcdef-secret"
SECURITY = {
    "x-content-type-options": "nosniff",
    "referrer-policy": "no-referrer",
    "cross-origin-opener-policy": "same-origin",
    "cross-origin-resource-policy": "same-origin",
    "x-frame-options": "SAMEORIGIN",
}


def head(server, line, *fields, host=None, end="\r\n"):
    return end.join([line, f"Host: {host or server.host}", *fields, "", ""]).encode("latin-1")


def status_of(answer):
    """0 when the connection was closed without an answer."""
    return int(answer.split(b" ", 2)[1]) if answer.startswith(b"HTTP/1.") else 0


def statuses(answer):
    return [int(part[2:5]) for part in answer.split(b"HTTP/1.")[1:]]


def foreign(server, checks):
    """Names and pages of others."""
    for host in ("evil.example", f"evil.example:{server.port}", "127.0.0.1", "127.0.0.1:1", "localhost", "",
                 f"127.0.0.1:{server.port}.evil.example", f"user@127.0.0.1:{server.port}"):
        answer = server.raw(f"GET /api/health HTTP/1.1\r\nHost: {host}\r\nConnection: close\r\n\r\n".encode())
        checks.that(f"host {host!r} is refused", status_of(answer) == 421, answer[:80])
    answer = server.raw(b"GET /api/health HTTP/1.1\r\nConnection: close\r\n\r\n")
    checks.that("no host is refused", status_of(answer) == 400, answer[:80])
    answer = server.raw(head(server, "GET /api/health HTTP/1.1", "Host: evil.example", "Connection: close"))
    checks.that("two hosts are refused", status_of(answer) == 400, answer[:80])
    for name in ("localhost", "LOCALHOST", "[::1]"):
        answer = server.raw(head(server, "GET /api/health HTTP/1.1", "Connection: close", host=f"{name}:{server.port}"))
        checks.that(f"host {name} is ours", status_of(answer) == 200, answer[:80])

    before = server.request("GET", "/api/health").json()["store"]["counts"]
    content = EXAMPLE.read_bytes()
    for fields in ({"Origin": "http://evil.example"}, {"Origin": "null"}, {"Origin": f"https://{server.host}"},
                   {"Origin": f"http://localhost:{server.port}"}, {"Origin": f"http://{server.host}.evil.example"},
                   {"Sec-Fetch-Site": "cross-site"}, {"Sec-Fetch-Site": "same-site"},
                   {"Origin": f"http://{server.host}", "Sec-Fetch-Site": "cross-site"}):
        for method, path in (("POST", "/api/tests"), ("PUT", "/api/machines/1"), ("DELETE", "/api/tests/1")):
            answer = server.request(method, path, content, fields)
            checks.that(f"{method} with {fields} is refused", answer.status == 403, answer.body)
        checks.that("nothing grants another origin", "access-control-allow-origin" not in answer.headers)
    answer = server.request("GET", "/api/tests", headers={"Sec-Fetch-Site": "cross-site", "Sec-Fetch-Mode": "no-cors"})
    checks.that("what another page embeds is refused", answer.status == 403, answer.body)
    for method in ("TRACE", "CONNECT", "OPTIONS", "PATCH", "PROPFIND", "get", "BREW"):
        target = f"127.0.0.1:{server.port}" if method == "CONNECT" else "/api/health"
        answer = server.raw(head(server, f"{method} {target} HTTP/1.1", "Connection: close"))
        checks.that(f"{method} is refused", status_of(answer) in (400, 405), answer[:80])
    after = server.request("GET", "/api/health").json()["store"]["counts"]
    checks.that("nothing of it was kept", before == after, after)


def paths(server, checks):
    """Ways out of the tree. There is no tree: nothing but 400, 404 or the page may come."""
    for path in ("/../../../../etc/passwd", "/%2e%2e/%2e%2e/etc/passwd", "/..%2f..%2fetc/passwd", "/%00", "/a%00.html",
                 "//etc/passwd", "/etc//passwd", "/./index.html", "/\\..\\..\\etc\\passwd", "/%5c..%5cetc", "/%",
                 "/%zz", "/%2", "/%c0%ae%c0%ae/", "/%ff", "/api/tests/%2e%2e/x", "/api/tests/1/report.%2fetc",
                 "http://evil.example/api/health", f"http://{server.host}/api/health", "*", "etc/passwd", "/a#b",
                 "/%0d%0aSet-Cookie:x", "/%7f", "/api/tests?text=%", "/api/tests?text=%00", "/api/tests?%zz=1"):
        answer = server.raw(head(server, f"GET {path} HTTP/1.1", "Connection: close"))
        checks.that(f"{path} is refused", status_of(answer) == 400, answer[:80])
        checks.that(f"{path} gives no file", b"root:" not in answer, answer[:80])
    for path in ("/etc/passwd", "/proc/self/environ", "/machines/3", "/.git/config", "/%25%32%65", "/index.html.bak"):
        answer = server.raw(head(server, f"GET {path} HTTP/1.1", "Connection: close"))
        checks.that(f"{path} is the page or nothing", status_of(answer) in (200, 404), answer[:80])
        checks.that(f"{path} gives no file", b"root:" not in answer and b"PATH=" not in answer, answer[:80])
    for path in ("/api", "/api/", "/api/nothing", "/api/tests/0", "/api/tests/-1", "/api/tests/1e9", "/api/tests/abc",
                 "/api/tests/99999999999999999999", "/api/documents/0", "/api/tests/1/report.exe", "/api//tests",
                 "/api/tests/", "/api/tests/1'%20OR%201=1"):
        answer = server.raw(head(server, f"GET {path} HTTP/1.1", "Connection: close"))
        checks.that(f"{path} is not there", status_of(answer) in (400, 404, 422), answer[:80])


def smuggling(server, checks):
    """Requests that two readers could part differently."""
    chunked = b"4\r\nabcd\r\n0\r\n\r\n"
    for what, fields, body in (
            ("length and chunks", ["Content-Length: 4", "Transfer-Encoding: chunked"], chunked),
            ("chunks and length", ["Transfer-Encoding: chunked", "Content-Length: 4"], chunked),
            ("two lengths", ["Content-Length: 4", "Content-Length: 5"], b"abcde"),
            ("the length twice", ["Content-Length: 4", "Content-Length: 4"], b"abcd"),
            ("a list of lengths", ["Content-Length: 4, 4"], b"abcd"),
            ("a negative length", ["Content-Length: -4"], b"abcd"),
            ("a signed length", ["Content-Length: +4"], b"abcd"),
            ("a hexadecimal length", ["Content-Length: 0x4"], b"abcd"),
            ("a length that overflows", ["Content-Length: 99999999999999999999999"], b"abcd"),
            ("an unknown coding", ["Transfer-Encoding: gzip, chunked"], chunked),
            ("a body that is packed", ["Content-Encoding: gzip", "Content-Length: 4"], b"abcd"),
            ("a coding that is nearly one", ["Transfer-Encoding: xchunked"], chunked),
            ("two codings", ["Transfer-Encoding: chunked", "Transfer-Encoding: identity"], chunked),
            ("a blank before the colon", ["Content-Length : 4"], b"abcd"),
            ("a chunk of negative size", ["Transfer-Encoding: chunked"], b"-1\r\nabcd\r\n0\r\n\r\n"),
            ("a chunk of absurd size", ["Transfer-Encoding: chunked"], b"ffffffffffffffff1\r\nabcd\r\n0\r\n\r\n"),
            ("a chunk without end", ["Transfer-Encoding: chunked"], b"4\r\nabcdXX0\r\n\r\n")):
        data = head(server, "POST /api/preview HTTP/1.1", *fields) + body + head(server, "GET /api/health HTTP/1.1")
        answer = server.raw(data)
        checks.that(f"{what}: refused and closed", statuses(answer) in ([400], [501], [413], [415]), answer[:200])
    for what, data in (("bare line feeds", head(server, "GET /api/health HTTP/1.1", end="\n")),
                       ("a null byte in a field", head(server, "GET /api/health HTTP/1.1", "X-A: a\0b")),
                       ("a folded field", head(server, "GET /api/health HTTP/1.1", "X-A: a\r\n b", "Connection: close")),
                       ("no version", b"GET /api/health\r\n\r\n"), ("version 0.9", b"GET /\r\n"),
                       ("version 2", b"PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"),
                       ("version 1.2", head(server, "GET /api/health HTTP/1.2")),
                       ("another protocol", b"\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03" + bytes(64)),
                       ("an empty line of noise", bytes(range(256)) * 16)):
        answer = server.raw(data, timeout=13)
        checks.that(f"{what}: no success", statuses(answer) in ([400], [408], [505], [200]) and
                    (what == "a folded field" or statuses(answer) != [200]), answer[:200])
    answer = server.raw(head(server, "GET /api/health HTTP/1.1") * 3 +
                        head(server, "GET /api/health HTTP/1.1", "Connection: close"))
    checks.that("four requests at once have four answers", statuses(answer) == [200] * 4, answer[:200])


def too_much(server, checks):
    """More than anybody needs."""
    answer = server.raw(head(server, "GET /api/health HTTP/1.1", *[f"X-{i}: {i}" for i in range(10_000)]))
    checks.that("10 000 fields are refused", status_of(answer) == 431, answer[:80])
    answer = server.raw(head(server, "GET /api/health HTTP/1.1", "X-A: " + "a" * 70_000))
    checks.that("a huge field is refused", status_of(answer) == 431, answer[:80])
    answer = server.raw(head(server, "GET /" + "a" * 70_000 + " HTTP/1.1"))
    checks.that("a huge target is refused", status_of(answer) == 431, answer[:80])
    answer = server.raw(head(server, "POST /api/tests HTTP/1.1", "Content-Length: 99999999999"))
    checks.that("a huge body is refused before it is read", status_of(answer) == 413, answer[:80])
    answer = server.raw(head(server, "POST /api/tests HTTP/1.1", "Content-Length: 99999999999", "Expect: 100-continue"))
    checks.that("and is not asked for", statuses(answer) == [413], answer[:80])
    answer = server.raw(head(server, "POST /api/tests HTTP/1.1", "Content-Length: 4", "Expect: miracles"))
    checks.that("other expectations are refused", status_of(answer) == 417, answer[:80])
    with socket.create_connection(("127.0.0.1", server.port), timeout=30) as client:
        client.sendall(head(server, "POST /api/tests HTTP/1.1", "Transfer-Encoding: chunked"))
        try:
            for _ in range(80):
                client.sendall(b"100000\r\n" + bytes(0x100000) + b"\r\n")
        except (BrokenPipeError, ConnectionResetError):
            pass
        answer = read_all(client)
    checks.that("chunks without end are cut off", status_of(answer) in (413, 0), answer[:80])
    with socket.create_connection(("127.0.0.1", server.port), timeout=30) as client:
        client.sendall(head(server, "POST /api/tests HTTP/1.1", "Transfer-Encoding: chunked") + b"1000000000000000\r\n")
        answer = read_all(client)
    checks.that("a huge chunk is refused before it comes", status_of(answer) == 413, answer[:80])
    deep = b'{"changes":' + b"[" * 100_000
    answer = server.request("POST", "/api/plans/draft", deep, {"Content-Type": "application/json"})
    checks.that("deep JSON is refused", answer.status in (400, 404, 405, 422), answer.body[:200])


def slow(server, checks):
    """Clients that take their time; all at once, since each takes as long as it is let."""
    results = {}

    def drip(name, opening, piece, pause, longest):
        begin = time.monotonic()
        answer = b""
        with socket.create_connection(("127.0.0.1", server.port)) as client:
            client.sendall(opening)
            client.settimeout(pause)
            while time.monotonic() - begin < longest:
                try:
                    if piece:
                        client.sendall(piece)
                    received = client.recv(65536)
                    answer += received
                    if not received:
                        break
                except TimeoutError:
                    continue
                except (BrokenPipeError, ConnectionResetError):
                    break
        results[name] = (time.monotonic() - begin, answer)

    def dripping(name, opening, piece, longest):
        return threading.Thread(target=drip, args=(name, opening, piece, 0.5, longest))

    body = head(server, "POST /api/tests HTTP/1.1", "Content-Length: 100000")
    chunked = head(server, "POST /api/tests HTTP/1.1", "Transfer-Encoding: chunked")
    threads = [dripping("silence", b"", b"", 20), dripping("slow head", b"GET / HTTP/1.1\r\n", b"X-A: a\r\n", 20),
               dripping("slow body", body, b"a", 50), dripping("slow chunks", chunked, b"1\r\na\r\n", 50),
               dripping("half a body", body + bytes(50_000), b"", 50),
               dripping("idle", head(server, "GET /api/health HTTP/1.1"), b"", 50)]
    threads += [dripping(f"slow head {i}", b"GET / HTTP/1.1\r\n", b"X-A: a\r\n", 20) for i in range(150)]
    for thread in threads:
        thread.start()
    time.sleep(2)
    answer = server.request("GET", "/api/health")
    checks.that("others are answered meanwhile", answer.status == 200, answer.status)
    for thread in threads:
        thread.join()
    for name, longest, expected in (("silence", 20, 0), ("slow head", 20, 408), ("slow body", 36, 408),
                                    ("slow chunks", 36, 408), ("half a body", 36, 408), ("idle", 36, 200)):
        seconds, answer = results[name]
        checks.that(f"{name} is cut off", seconds < longest, seconds)
        checks.that(f"{name} is told", status_of(answer) == expected, answer[:80])


def half_uploads(server, checks):
    before = server.request("GET", "/api/health").json()["store"]["counts"]
    content = EXAMPLE.read_bytes()
    for length in (0, 1, len(content) // 2, len(content) - 1):
        with socket.create_connection(("127.0.0.1", server.port)) as client:
            client.sendall(head(server, "POST /api/tests HTTP/1.1", f"Content-Length: {len(content)}") +
                           content[:length])
    time.sleep(0.5)
    after = server.request("GET", "/api/health").json()["store"]["counts"]
    checks.that("half uploads leave nothing", before == after, after)


def markup(server, checks):
    """Programs in names: kept as they are, never run."""
    evil = "<script>alert(1)</script>\"'><img src=x onerror=alert(1)>"
    answer = server.upload("/api/tests", evil + ".json", EXAMPLE.read_bytes())
    checks.that("a file of any name is taken", answer.status == 201, answer.body[:200])
    if answer.status != 201:
        return
    test = answer.json()["id"]
    revision = {"base_version": 1, "title": evil, "reason": evil, "changes": {"machine.name": evil, "axis.name": evil},
                "options": {"methods": [], "trials": None, "seed": 1, "coverage": 0.95, "corrections": []}}
    answer = server.request("POST", f"/api/tests/{test}/versions", revision,
                            {"X-Actor": "%3Cscript%3Ealert(1)%3C/script%3E"})
    checks.that("markup is taken as text", answer.status in (201, 422), answer.body[:200])
    for path in (f"/api/tests/{test}", "/api/tests", "/api/machines", "/api/audit", f"/api/tests/{test}/report.html",
                 f"/api/tests/{test}/report.svg", f"/api/tests/{test}/figures/1.svg", f"/api/tests/{test}/raw"):
        answer = server.request("GET", path)
        kind = answer.headers.get("content-type", "")
        for name, value in SECURITY.items():
            checks.that(f"{path} has {name}", answer.headers.get(name) == value, answer.headers)
        policy = answer.headers.get("content-security-policy", "")
        checks.that(f"{path} has a policy", "default-src 'none'" in policy and "unsafe-eval" not in policy, policy)
        if "html" in kind or "svg" in kind:
            checks.that(f"{path} holds no program", b"<script" not in answer.body and b"<img src=x" not in answer.body)
            checks.that(f"{path} runs none", "'unsafe-inline'" not in policy.split("script-src")[-1].split(";")[0] or
                        "script-src" not in policy, policy)
    answer = server.raw(head(server, "GET /api/health HTTP/1.1", "X-Actor: %0d%0aSet-Cookie:x=1", "Connection: close"))
    checks.that("line ends in names are refused", status_of(answer) == 400 and b"\nSet-Cookie" not in answer,
                answer)
    answer = server.request("GET", f"/api/tests/{test}/report.html?download=1")
    checks.that("a download has a safe name", "<" not in answer.headers.get("content-disposition", "<"), answer.headers)


def tokens(program, folder, checks):
    with Served(program, folder / "token.db", token=TOKEN) as server:
        answer = server.request("GET", "/api/health")
        checks.that("health tells strangers nothing", answer.json() == {"status": "ok"}, answer.body)
        for fields in ({}, {"Cookie": f"axiometry-{server.port}={TOKEN}"}, {"Authorization": "Basic " + TOKEN},
                       {"Cookie": f"axiometry-{server.port}="}):
            answer = server.request("GET", "/api/vocabulary", headers=fields)
            checks.that(f"{list(fields)} is not enough", answer.status == 401, answer.status)
        begin = time.monotonic()
        for wrong in ("", "x", TOKEN[:-1], TOKEN + "x"):
            answer = server.request("GET", "/api/vocabulary", headers={"Authorization": "Bearer " + wrong})
            checks.that("a wrong token is refused", answer.status == 401, answer.status)
        checks.that("and slowly", time.monotonic() - begin > 3, time.monotonic() - begin)
        answer = server.request("GET", "/api/vocabulary", headers={"Authorization": "Bearer " + TOKEN})
        checks.that("the token opens", answer.status == 200, answer.status)
        answer = server.request("POST", "/api/login", {"token": TOKEN + "x"})
        checks.that("a wrong token does not sign in", answer.status == 401 and "set-cookie" not in answer.headers)
        answer = server.request("POST", "/api/login", {"token": TOKEN, "more": "x" * 5000})
        checks.that("a large body does not sign in", answer.status == 413, (answer.status, answer.body[:200]))
        answer = server.request("GET", "/api/health", headers={"Authorization": "Bearer " + TOKEN + "x"})
        checks.that("a wrong token is refused at health too", answer.status == 401, answer.body[:200])
        answer = server.request("POST", "/api/login", {"token": TOKEN}, {"Origin": "http://evil.example"})
        checks.that("another page does not sign in", answer.status == 403, answer.status)
        answer = server.request("POST", "/api/login", {"token": TOKEN})
        cookie = answer.headers.get("set-cookie", "")
        checks.that("the cookie is the browser's alone", "HttpOnly" in cookie and "SameSite=Strict" in cookie, cookie)
        checks.that("the cookie does not tell the token", TOKEN not in cookie, cookie)
        answer = server.request("GET", "/api/vocabulary", headers={"Cookie": cookie.split(";")[0]})
        checks.that("the cookie opens", answer.status == 200, answer.status)
        other = server.request("POST", "/api/login", {"token": TOKEN}).headers["set-cookie"].split(";")[0]
        checks.that("each sign-in has a session of its own", other != cookie.split(";")[0], other)
        server.request("POST", "/api/logout", headers={"Cookie": cookie.split(";")[0]})
        answer = server.request("GET", "/api/vocabulary", headers={"Cookie": cookie.split(";")[0]})
        checks.that("who has signed out is out", answer.status == 401, answer.status)
        answer = server.request("GET", "/api/vocabulary", headers={"Cookie": other})
        checks.that("and nobody else", answer.status == 200, answer.status)
        checks.that("the page needs no token", server.request("GET", "/").status == 200)


def behind_a_proxy(program, folder, checks):
    """A proxy that ends TLS: its address is known by what the user said at the start, by nothing else."""
    ours = "https://calibration.example"
    content = EXAMPLE.read_bytes()
    with Served(program, folder / "proxy.db", "--public-address", ours, token=TOKEN) as server:
        signed = {"Authorization": "Bearer " + TOKEN}
        for fields in ({"Origin": ours}, {"Origin": ours, "Host": "calibration.example"},
                       {"Origin": ours, "Host": "calibration.example:443", "Sec-Fetch-Site": "same-origin"},
                       {"Origin": f"http://{server.host}"}, {}):
            answer = server.request("POST", "/api/preview", content, {**signed, **fields})
            checks.that(f"{fields} through the proxy is ours", answer.status == 200, answer.body[:200])
        before = server.request("GET", "/api/health", headers=signed).json()["store"]["counts"]
        trusting = {"Forwarded": "host=calibration.example;proto=https", "X-Forwarded-Host": "calibration.example",
                    "X-Forwarded-Proto": "https", "X-Forwarded-For": "127.0.0.1"}
        for fields in ({"Origin": "https://evil.example"}, {"Origin": "null"}, {"Origin": "http://calibration.example"},
                       {"Origin": f"https://{server.host}"}, {"Origin": ours + ".evil.example"},
                       {"Origin": ours + ":8443"}, {"Origin": ours, "Sec-Fetch-Site": "cross-site"},
                       {"Origin": "http://calibration.example", "Host": "calibration.example"},
                       {"Origin": "https://evil.example", "Host": "calibration.example"}):
            for more in ({}, trusting):
                answer = server.request("POST", "/api/tests", content, {**signed, **fields, **more})
                checks.that(f"POST with {fields} is refused", answer.status == 403, answer.body[:200])
        for host in ("evil.example", "calibration.example:80", "calibration.example.evil.example"):
            answer = server.request("GET", "/api/tests", headers={**signed, **trusting, "Host": host})
            checks.that(f"the host {host} is refused", answer.status == 421, answer.body[:200])
        after = server.request("GET", "/api/health", headers=signed).json()["store"]["counts"]
        checks.that("nothing of it was kept", before == after, after)
        answer = server.request("POST", "/api/login", {"token": TOKEN}, {"Origin": ours})
        cookie = answer.headers.get("set-cookie", "")
        checks.that("the proxy's page has a cookie for TLS alone", "; Secure" in cookie and "HttpOnly" in cookie, cookie)
        checks.that("of this host alone", cookie.startswith("__Host-"), cookie)
        answer = server.request("GET", "/api/tests", headers={"Cookie": cookie.split(";")[0]})
        checks.that("which opens", answer.status == 200, answer.status)
        answer = server.request("GET", "/api/tests", headers=trusting)
        checks.that("nobody else", answer.status == 401, answer.status)


def exposure(program, folder, checks):
    def refused(*more):
        done = subprocess.run([program, "serve", "--store", str(folder / "never.db"), "--port", "0", *more],
                              capture_output=True, text=True, timeout=20, check=False)
        return done.returncode == 2 and done.stdout == "" and not (folder / "never.db").exists(), done.stderr

    certificate, key = folder / "cert.pem", folder / "key.pem"
    subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost",
                    "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1", "-keyout", str(key), "-out",
                    str(certificate)], check=True, capture_output=True)
    (folder / "short.txt").write_text("short")
    pair = ["--certificate", str(certificate), "--key", str(key)]
    for more in (["--listen", "0.0.0.0"], ["--listen", "::"], ["--listen", "0.0.0.0", *pair], ["--listen", "nonsense"],
                 ["--certificate", str(certificate)], ["--certificate", str(key), "--key", str(certificate)],
                 ["--token-file", str(folder / "short.txt")], ["--token-file", str(folder / "none.txt")],
                 ["--listen", "0.0.0.0", *pair, "--token-file", str(folder / "short.txt")],
                 ["--public-address", "https://calibration.example"], ["--public-address", "http://127.0.0.1.example"],
                 ["--public-address", "https://calibration.example/axes"], ["--public-address", "*"]):
        holds, message = refused(*more)
        checks.that(f"{more} does not start", holds, message)
        checks.that(f"{more} says why", message.startswith("axiometry: ") and "expected" in message or
                    "cannot" in message or "No such" in message, message)
    with Served(program, folder / "tls.db", token=TOKEN, tls=(certificate, key)) as server:
        answer = server.request("POST", "/api/login", {"token": TOKEN}, {"Origin": f"https://{server.host}"})
        cookie = answer.headers.get("set-cookie", "")
        checks.that("over TLS the cookie is for TLS alone", "Secure" in cookie and cookie.startswith("__Host-"), cookie)
        checks.that("TLS is asked to stay", "strict-transport-security" in answer.headers, answer.headers)
        plain = server.raw(b"GET / HTTP/1.1\r\nHost: " + server.host.encode() + b"\r\n\r\n")
        checks.that("plain HTTP is not answered", b"HTTP" not in plain, plain[:80])
        for offer, taken in ((["-tls1_1", "-cipher", "ALL:@SECLEVEL=0"], False), (["-tls1_3"], True),
                             (["-tls1_2"], True), (["-tls1_2", "-cipher", "ECDHE-RSA-AES128-GCM-SHA256"], True),
                             (["-tls1_2", "-cipher", "ECDHE-RSA-AES256-SHA384:ECDHE-RSA-AES128-SHA"], False),
                             (["-tls1_2", "-cipher", "DHE-RSA-AES256-GCM-SHA384"], False),
                             (["-tls1_2", "-cipher", "AES256-GCM-SHA384:AES128-GCM-SHA256:AES256-SHA"], False)):
            done = subprocess.run(["openssl", "s_client", "-connect", server.host, *offer], input="", text=True,
                                  capture_output=True, timeout=20, check=False)
            shaken = "Cipher is (NONE)" not in done.stdout and "Cipher is" in done.stdout
            checks.that(f"the handshake {' '.join(offer)} is {'made' if taken else 'refused'}", shaken == taken,
                        done.stdout[-300:] + done.stderr[-300:])


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    checks = Checks()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        with Served(program, folder / "attacked.db") as server:
            descriptors = server.descriptors()
            for attack in (foreign, paths, smuggling, too_much, half_uploads, markup, slow):
                begin = time.monotonic()
                attack(server, checks)
                answer = server.request("GET", "/api/health")
                checks.that(f"after {attack.__name__} it answers", answer.status == 200, answer.status)
                print(f"{attack.__name__}: {time.monotonic() - begin:.1f} s", flush=True)
            time.sleep(4)
            checks.that("no descriptor is left", server.descriptors() <= descriptors + 8, server.descriptors())
            checks.that("the server lives", server.process.poll() is None)
        tokens(program, folder, checks)
        behind_a_proxy(program, folder, checks)
        exposure(program, folder, checks)
    checks.finish()


if __name__ == "__main__":
    main()
