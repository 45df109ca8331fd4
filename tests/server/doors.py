#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Proves what docs/security.md says of `axiometry serve` and attack.py does not try: one door for everything, nothing
told to strangers, nothing secret written down.

Usage: doors.py PROGRAM
"""
import json
import os
import pathlib
import re
import socket
import ssl
import subprocess
import sys
import tempfile
import threading
import time

from attack import SECURITY, head, status_of
from served import Checks, Served

ROOT = pathlib.Path(__file__).parents[2]
EXAMPLE = (ROOT / "examples" / "iso230-2-table2.json").read_bytes()
OPERATIONS = json.loads((ROOT / "apps" / "server" / "openapi.json").read_text(encoding="utf-8"))["paths"]
TOKEN = "fedcba9876543210-secret"
ENDS_WITHIN_S = 2.0  # the shutdown takes 5, a connection that lingers 3
OPEN_TO_ALL = {("GET", "/api/health"), ("POST", "/api/login")}
PLAN = {"axis": "X", "kind": "linear", "from": 0, "to": 500, "positions": None, "targets": None, "cycle": "standard",
        "runs": 5, "feed": 1000, "dwell_s": 4, "overrun": None, "seed": 7, "further": {}}


def operations():
    """(method, path) of all that openapi.json describes, which a test of the program holds against its routes."""
    for pattern, methods in OPERATIONS.items():
        for method in methods:
            yield method.upper(), re.sub(r"\{[a-z]+\}", "1", pattern)


def every_operation_asks(server, checks):
    """For the token, whatever the path, before anything else is looked at; and no other page changes anything."""
    signed = {"Authorization": "Bearer " + TOKEN}
    ours = {"Origin": f"http://{server.host}", "Sec-Fetch-Site": "same-origin"}
    for method, path in [*operations(), ("GET", "/api"), ("GET", "/api/nothing"), ("DELETE", "/api/tests/1")]:
        if (method, path) in OPEN_TO_ALL:
            continue
        for fields in ({}, ours, {"X-Actor": "admin"}, {"X-Forwarded-For": "127.0.0.1"}):
            answer = server.request(method, path, b"{}" if method != "GET" else None, fields)
            checks.that(f"{method} {path} with {list(fields)} asks for the token", answer.status == 401, answer.status)
        answer = server.request(method, f"{path}?token={TOKEN}&access_token={TOKEN}", b"" if method != "GET" else None)
        checks.that(f"{method} {path} takes no token of an address", answer.status == 401, answer.status)
        if method != "GET":
            answer = server.request(method, path, b"{}", {**signed, "Origin": "https://evil.example"})
            checks.that(f"{method} {path} is for our page alone", answer.status == 403, answer.status)
    answer = server.request("GET", "/api/tests", headers=signed)
    checks.that("with the token it opens", answer.status == 200, answer.status)


def strangers_are_told_nothing(server, checks):
    """Of every answer, also of one made before a route is found: what it is, how it may be used, no more."""
    server.upload("/api/tests", "kept.json", EXAMPLE)
    asked = ["/", "/licenses.txt", "/api/openapi.json", "/api/tests", "/api/tests/1", "/api/tests/1/raw",
             "/api/tests/1/report.csv", "/api/tests/1/figures/1.svg", "/nothing.js", "/api/nothing", "/%zz",
             "/api/tests?limit=x"]
    for line, *fields in [[f"GET {path} HTTP/1.1"] for path in asked] + [
            ["TRACE / HTTP/1.1"], ["PUT /api/health HTTP/1.1"], ["GET / HTTP/1.2"], ["nonsense"],
            ["GET /api/tests HTTP/1.1", "Sec-Fetch-Site: cross-site"],
            ["GET / HTTP/1.1", "X-A: " + "a" * 70_000], ["POST /api/tests HTTP/1.1", "Content-Length: 99999999999"],
            ["POST /api/tests HTTP/1.1", "Content-Length: x"]]:
        answer = server.raw(head(server, line, *fields, "Connection: close"))
        above, _, body = answer.partition(b"\r\n\r\n")
        names = [field.partition(": ") for field in above.decode().split("\r\n")[1:]]
        found = {name.lower(): value for name, _, value in names}
        checks.that(f"{line} is answered", status_of(answer) >= 200, answer[:80])
        checks.that(f"{line} names no program", not {"server", "x-powered-by", "via"} & found.keys(), found)
        told = re.search(r"(?i)boost|beast|openssl|sqlite|\d+\.\d+\.\d+", str(found))
        checks.that(f"{line} tells no version", not told, told)
        checks.that(f"{line} carries what browsers must know", SECURITY.items() <= found.items(), found)
        checks.that(f"{line} has a policy", "default-src 'none'" in found.get("content-security-policy", ""), found)
        kind = found.get("content-type", "")
        checks.that(f"{line} says what its body is", not body or kind, found)
        is_understood = " /api/" in line and status_of(answer) != 400
        is_api_json = is_understood and "openapi" not in line and kind == "application/json"
        name = found.get("content-disposition", "")
        is_download = "/raw" in line
        checks.that(f"{line} is a file where it is the API's JSON",
                    name.startswith("attachment;") == (is_api_json or is_download), (kind, name))
        has_letters = kind.startswith("text/") or "+xml" in kind
        checks.that(f"{line} says its letters", not has_letters or "charset=utf-8" in kind, kind)
        is_archive = status_of(answer) != 200 or "/api/tests" in line
        checks.that(f"{line} is kept by nobody", not is_archive or found.get("cache-control") == "no-store", found)


def nothing_is_said_twice(server, checks):
    """What two readers could take for two things."""
    for name, value in (("Origin", f"http://{server.host}"), ("Authorization", "Bearer x"), ("X-Actor", "a"),
                        ("Content-Type", "text/csv"), ("X-File-Name", "a"), ("Sec-Fetch-Site", "none"),
                        ("Accept-Language", "en"), ("If-None-Match", '"x"')):
        field = f"{name}: {value}"
        answer = server.raw(head(server, "GET /api/health HTTP/1.1", field, field, "Connection: close"))
        checks.that(f"two headers {name} are refused", status_of(answer) == 400, answer[:80])
    answer = server.request("POST", "/api/machines", b'{"name": "a", "name": "b", "serial_number": ""}',
                            {"Content-Type": "application/json"})
    checks.that("a member that stands twice is refused", answer.status == 422, answer.body[:200])
    answer = server.request("GET", "/api/tests?limit=0&limit=5")
    checks.that("a parameter that stands twice is refused", answer.status == 422, answer.body[:200])
    before = server.request("GET", "/api/machines").body
    answer = server.request("POST", "/api/machines?name=b", {"name": "a", "serial_number": ""})
    checks.that("a parameter replaces no member", answer.status == 422, answer.body[:200])
    checks.that("and nothing is kept", server.request("GET", "/api/machines").body == before, before[:200])


def what_was_not_asked_for_is_not_set(server, checks):
    revision = {"base_version": 1, "title": "t", "reason": "r", "changes": {}, "options": {
        "methods": [], "trials": None, "seed": 1, "coverage": 0.95, "corrections": []}}
    for member in ("id", "version", "latest", "actor", "at", "sha256", "verdict", "received"):
        answer = server.request("POST", "/api/tests/1/versions", {**revision, member: 1})
        checks.that(f"{member} cannot be set", answer.status == 422, answer.body[:200])
    for key in ("raw", "deviation", "targets", "provenance.sha256"):
        answer = server.request("POST", "/api/tests/1/versions", {**revision, "changes": {key: "1"}})
        checks.that(f"{key} cannot be edited", answer.status == 422, answer.body[:200])
    kept = server.request("GET", "/api/tests/1").json()
    checks.that("nothing of it was kept", kept["latest"] == 1, kept["latest"])


def statements_stay_text(server, checks):
    """SQL in texts, names and numbers."""
    evil = "x'; DROP TABLE test; --"
    made = server.request("POST", "/api/machines", {"name": evil, "serial_number": evil + "\\"}).json()
    kept = server.request("GET", f"/api/machines/{made['id']}").json()
    checks.that("it is kept as it is", evil in json.dumps(kept), kept)
    for query, expected in (("text=%27%20OR%201%3D1%20--", 200), ("text=%25", 200), ("text=_", 200),
                            ("sha256=%27", 422), ("verdict=%27%20OR%20%271%27%3D%271", 422), ("from=%27", 422),
                            ("order=title%3B%20DROP%20TABLE%20test", 422), ("machine=1%20OR%201%3D1", 422),
                            ("limit=1%3B", 422)):
        answer = server.request("GET", f"/api/tests?{query}")
        checks.that(f"{query} answers {expected}", answer.status == expected, answer.body[:200])
        checks.that(f"{query} finds nothing", expected != 200 or answer.json()["total"] == 0, answer.body[:200])
    answer = server.request("GET", "/api/audit?subject=%27%20OR%201%3D1&limit=5")
    checks.that("the trail is not opened by it", answer.status == 422, answer.body[:200])
    checks.that("the tests are there", server.request("GET", "/api/tests").json()["total"] == 1)


def files_are_the_owners(server, store, checks):
    plan = server.request("POST", "/api/plans", {"title": "X", "axis": None, "request": PLAN}).json()["id"]
    wish = {"plan": plan, "source": "simulator", "layout": "", "options": {"speed": "1"}}
    begun = server.request("POST", "/api/captures", wish)
    checks.that("a capture runs", begun.status == 201, begun.body[:200])
    for path in sorted(store.parent.glob(store.name + "*")):
        checks.that(f"{path.name} is its owner's alone", path.stat().st_mode & 0o077 == 0, oct(path.stat().st_mode))
    checks.that("a folder of captures is there", (store.parent / (store.name + ".captures")).is_dir())
    server.request("POST", f"/api/captures/{begun.json()['id']}/stop", {})


def nobody_is_called(server):
    """Yields every socket of the process that did not come to it: none may be there, at no moment."""
    sockets = set()
    for descriptor in pathlib.Path(f"/proc/{server.process.pid}/fd").iterdir():
        try:
            sockets.add(os.readlink(descriptor))
        except OSError:
            pass  # closed meanwhile
    for table in ("tcp", "tcp6", "udp", "udp6"):
        for line in pathlib.Path(f"/proc/net/{table}").read_text(encoding="ascii").splitlines()[1:]:
            fields = line.split()
            own = table == "tcp" and fields[1] == f"0100007F:{server.port:04X}"
            if f"socket:[{fields[9]}]" in sockets and not own:
                yield line


class Watched:
    """Looks at the sockets of a server all the while that it is used: a call need not last."""

    def __init__(self, server):
        self.server, self.over, self.looks, self.strange = server, threading.Event(), 0, []
        self.thread = threading.Thread(target=self.watch)

    def watch(self):
        while not self.over.wait(0.002):
            self.look()

    def look(self):
        self.strange += nobody_is_called(self.server)
        self.looks += 1

    def __enter__(self):
        self.thread.start()
        return self

    def __exit__(self, *_):
        self.over.set()
        self.thread.join()
        self.look()


def log_holds_no_secret(program, folder, checks):
    with open(folder / "log.txt", "w+", encoding="utf-8") as log:
        with Served(program, folder / "logged.db", "--log", token=TOKEN, errors=log) as server:
            cookie = server.request("POST", "/api/login", {"token": TOKEN}).headers["set-cookie"].split(";")[0]
            known = {"Cookie": cookie, "X-Actor": "Anna%20Beispiel"}
            server.request("GET", f"/api/tests?token={TOKEN}&text=private", headers=known)
            server.request("GET", "/api/vocabulary", headers={"Authorization": "Bearer " + TOKEN})
            server.request("GET", "/api/vocabulary", headers={"Authorization": "Bearer wrong-token"})
            for line in ("GET /%1b[2Jx HTTP/1.1", "GET /a%0d%0a127.0.0.1%20GET%20/forged%20200 HTTP/1.1",
                         "GET /api/%E2%80%AEgnp.x%20200%205 HTTP/1.1", "TRACE / HTTP/1.1", "GET /a\x1b[2J HTTP/1.1",
                         "\x1b[2J / HTTP/1.1"):
                server.raw(head(server, line, "Connection: close"))
        log.seek(0)
        text = log.read()
    for secret in (TOKEN, cookie.split("=", 1)[1], "wrong-token", "private", "Anna"):
        checks.that("the log holds no secret and no name", secret not in text, secret)
    lines = [line for line in text.split("\n") if line and not line.startswith("axiometry: ")]
    checks.that("every request has one line", len(lines) == 10, lines)
    checks.that("none can be forged", not any("forged" in line for line in lines), lines)
    steering = [c for line in lines for c in line if not " " <= c <= "~"]
    checks.that("no control character reaches a terminal, and none that turns the direction", not steering, lines)
    checks.that("nor a blank of others", sum("/api/%E2%80%AEgnp.x%20200%205 401 " in line for line in lines) == 1, lines)
    counts = [sum(f" {status} " in line for line in lines) for status in (401, 405, 400)]
    checks.that("what was refused is there", counts == [2, 1, 4], lines)
    checks.that("with the address of who asked", all(line.startswith("127.0.0.1 ") for line in lines), lines)


def security_events_are_told(program, folder, checks):
    """Also without --log: a line for each in one format, without secrets; of a flood some, and how many were left out."""
    certificate, key = made_certificate(folder, "events")
    with open(folder / "events.txt", "w+", encoding="ascii") as log:
        with Served(program, folder / "events.db", token=TOKEN, tls=(certificate, key), errors=log) as server:
            server.request("POST", "/api/login", {"token": "wrong-token-of-a-guess"})
            cookie = server.request("POST", "/api/login", {"token": TOKEN}).headers["set-cookie"].split(";")[0]
            known = {"Cookie": cookie, "X-Actor": "Anna%20Beispiel"}
            server.request("GET", f"/api/tests?token={TOKEN}", headers=known)
            server.request("POST", "/api/logout", {}, known)
            server.request("GET", "/api/tests?text=private", headers=known)
            server.request("GET", "/api/vocabulary", headers={"Authorization": "Bearer wrong-token-of-a-guess"})
            server.request("POST", "/api/machines", {}, {"Origin": "https://evil.example"})
            server.request("GET", "/", headers={"Host": "evil.example"})
            server.request("TRACE", "/")
            server.request("GET", "/", headers={"X-Long": "a" * 70_000})
            for _ in range(100):
                server.request("GET", "/api/tests/%c3%a9%20a")
        log.seek(0)
        text = log.read()
    for secret in (TOKEN, cookie.split("=", 1)[1], "wrong-token", "private", "Anna"):
        checks.that("security events hold no secret and no name", secret not in text, secret)
    told = [line for line in text.split("\n") if line.startswith("axiometry: security ")]
    form = re.compile(r"axiometry: security \d{4}-\d\d-\d\dT\d\d:\d\d:\d\dZ (left-out event=\S+ count=(\d+)|"
                      r"(\S+) peer=127\.0\.0\.1 method=\S+ path=\S+ status=(\d{3}))")
    lines = [form.fullmatch(line) for line in told]
    checks.that("all in one format", all(lines), told)
    events = [(line[3], line[4]) for line in lines if line and line[3]]
    wanted = [("sign-in-refused", "401"), ("signed-in", "204"), ("signed-out", "204"), ("session-refused", "401"),
              ("token-refused", "401"), ("origin-refused", "403"), ("host-refused", "421"), ("method-refused", "405"),
              ("quota-refused", "431")]
    checks.that("each is told once", events[:len(wanted)] == wanted, events)
    flood = events[len(wanted):]
    left_out = sum(int(line[2]) for line in lines if line and line[2])
    checks.that("of a flood some", 20 <= len(flood) < 40 and set(flood) == {("token-missing", "401")}, flood)
    checks.that("and how many were left out", len(flood) + left_out == 100, left_out)


def ended(program, folder, name, tls, openings):
    """(exit code, seconds that it took, what it said) of a server that is stopped while clients have begun to speak."""
    with open(folder / "end.txt", "w+", encoding="utf-8") as told:
        with Served(program, folder / f"{name}.db", token=TOKEN, tls=tls, errors=told) as server:
            clients = [socket.create_connection(("127.0.0.1", server.port)) for _ in openings]
            for client, opening in zip(clients, openings):
                client.sendall(opening.replace(b"%s", server.host.encode()))
            time.sleep(0.5)
            begin = time.monotonic()
            code = server.stop()
            seconds = time.monotonic() - begin
        told.seek(0)
        text = told.read()
    for client in clients:
        client.close()
    return code, seconds, text


def nobody_is_waited_for_at_the_end(program, folder, checks):
    """Who has not said what is wanted, whose wrong token is only answered late, and who stays after the answer."""
    wrong = b"GET /api/tests HTTP/1.1\r\nHost: %s\r\nAuthorization: Bearer wrong-token-of-a-guess\r\n\r\n"
    stays = b"GET / HTTP/1.1\r\nHost: %s\r\nConnection: close\r\n\r\n"
    for name, tls, openings in (("plain", None, [b"", b"GET", stays] + 8 * [wrong]),
                                ("tls", made_certificate(folder, "end"), [b"", b"\x16\x03\x01"])):
        # A server that waits for somebody does so each time; one that a busy machine is slow to end does not.
        for _ in range(4):
            code, seconds, text = ended(program, folder, name, tls, openings)
            if seconds < ENDS_WITHIN_S:
                break
        is_false = "ended while requests" in text
        checks.that(f"{name}: it ends at once", code == 0 and seconds < ENDS_WITHIN_S, (code, seconds))
        checks.that(f"{name}: and says nothing of requests that were being answered", not is_false, text)


def what_was_left_out_is_told_where_it_is_cut_off(program, folder, checks):
    """A request that does not end is one that is waited for, and then the process ends without its last words."""
    with open(folder / "cut.txt", "w+", encoding="utf-8") as told:
        with Served(program, folder / "cut.db", token=TOKEN, errors=told) as server:
            for _ in range(30):
                server.request("GET", "/api/tests")
            with socket.create_connection(("127.0.0.1", server.port)) as half:
                half.sendall(head(server, "POST /api/tests HTTP/1.1", f"Authorization: Bearer {TOKEN}",
                                  "Content-Length: 100") + b"half")
                time.sleep(0.5)
                server.stop()
        told.seek(0)
        text = told.read()
    checks.that("it was cut off", "ended while requests were still being answered" in text, text)
    checks.that("and has told what was left out", "left-out event=token-missing count=10" in text, text)


def other_types_are_refused(server, checks):
    """A body that is no JSON by its type is none, whatever it holds; files have any type."""
    takes_files = {"/api/preview", "/api/evaluations", "/api/tests", "/api/tests/1/attachments", "/api/calibrations",
                   "/api/controls/1/table", "/api/tests/1/compensation", "/api/tests/1/compensations", "/api/tracking/station", "/api/tracking/station/report.1", "/api/tracking/evaluation",
                   "/api/tracking/evaluation/report.1", "/api/volumetric/identification",
                   "/api/volumetric/identification/report.1", "/api/volumetric/identification/residuals",
                   "/api/motions", "/api/motions/report.1", "/api/dynamic", "/api/dynamic/report.1", "/api/dynamic/series.csv",
                   "/api/dynamic/spectrum.csv", "/api/tracking/multilateration", "/api/tracking/multilateration/report.1",
                   "/api/tracking/multilateration/points", "/api/tracking/multilateration/residuals", "/api/tracking/polar",
                   "/api/tracking/polar/report.1", "/api/tracking/polar/points", "/api/volumetric/assembly",
                   "/api/volumetric/assembly/report.1"}
    for method, path in operations():
        if method == "GET" or path in takes_files:
            continue
        for fields in ({}, {"Content-Type": "text/plain"}, {"Content-Type": "application/x-www-form-urlencoded"}):
            answer = server.request(method, path, b"{}", fields)
            checks.that(f"{method} {path} with {fields} is refused", answer.status == 415, answer.status)
    answer = server.request("POST", "/api/preview", EXAMPLE, {"Content-Type": "text/plain"})
    checks.that("a file has any type", answer.status == 200, answer.body[:200])


def files_that_others_may_read_are_told(program, folder, checks):
    """At the start, of token and key; of those that are the owner's alone nothing is said."""
    certificate, key = made_certificate(folder, "open")
    token = folder / "token.txt"
    token.write_text(TOKEN)
    told_of = {0o644: (token, key), 0o640: (token,), 0o602: (token, key), 0o600: (), 0o711: ()}  # a group may use keys
    for mode, expected in told_of.items():
        token.chmod(mode)
        key.chmod(mode)
        with open(folder / "told.txt", "w+", encoding="utf-8") as told:
            with Served(program, folder / "modes.db", "--token-file", str(token), tls=(certificate, key), errors=told):
                pass
            told.seek(0)
            text = told.read()
        for file in (token, key):
            checks.that(f"{file.name} of mode {mode:o} is told or not", (f"{file}: found a file that others may read" in
                                                                         text) == (file in expected), text)


def no_program_is_started(program, checks):
    """There is not even a way to: the functions that begin another program are not linked."""
    done = subprocess.run(["nm", "-D", "--undefined-only", program], capture_output=True, text=True, check=True)
    names = {line.split()[-1].partition("@")[0] for line in done.stdout.splitlines()}
    checks.that("what it calls of the system is seen", {"socket", "getrlimit"} <= names, len(names))
    begins = re.compile(r"system|popen|exec[lv]p?e?|fexecve|posix_spawnp?|v?fork|wordexp")
    begins = {name for name in names if begins.fullmatch(name)}
    checks.that("none of it begins another program", not begins, begins)


def any_letters_are_a_token(program, folder, checks):
    token = "Größe ± 3 µm, ねこ 🔑 and a \"quote\""
    with Served(program, folder / "letters.db", token=token) as server:
        answer = server.request("POST", "/api/login", {"token": token})
        checks.that("any letters sign in", answer.status == 204, answer.status)
        answer = server.request("POST", "/api/login", {"token": token.replace("±", "+")})
        checks.that("and each of them counts", answer.status == 401, answer.status)


def made_certificate(folder, name):
    certificate, key = folder / f"{name}.pem", folder / f"{name}.key"
    subprocess.run(["openssl", "req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "2", "-subj", "/CN=localhost",
                    "-addext", "subjectAltName=DNS:localhost,IP:127.0.0.1", "-keyout", str(key), "-out",
                    str(certificate)], check=True, capture_output=True)
    return certificate, key


def told_to_a_false_database(program, settings, tls):
    """How `store verify` ends that is sent to a server which is none of PostgreSQL, and what that server hears."""
    heard = []

    def serve():
        client, _ = listener.accept()
        with client:
            heard.append(client.recv(8))
            client.sendall(b"S" if tls else b"N")
            try:
                heard.append((tls.wrap_socket(client, server_side=True) if tls else client).recv(1000))
            except OSError as error:  # TLS refused by the other side is one
                heard.append(type(error).__name__.encode())
    with socket.create_server(("127.0.0.1", 0)) as listener:
        listener.settimeout(30)
        thread = threading.Thread(target=serve)
        thread.start()
        address = f"postgresql://anna@127.0.0.1:{listener.getsockname()[1]}/archive?{settings}"
        done = subprocess.run([program, "store", "verify", "--store", address], capture_output=True, timeout=60,
                              check=False)
        thread.join()
    return done.returncode, heard


def database_is_proved_where_that_is_asked(program, folder, checks):
    """With sslmode=verify-full nothing is told to a server without TLS, or of another certificate."""
    asks_for_tls = b"\x00\x00\x00\x08\x04\xd2\x16\x2f"
    trusted, other = made_certificate(folder, "trusted")[0], made_certificate(folder, "other")
    context = ssl.SSLContext(ssl.PROTOCOL_TLS_SERVER)
    context.load_cert_chain(*other)
    for tls in (None, context):
        code, heard = told_to_a_false_database(program, f"sslmode=verify-full&sslrootcert={trusted}", tls)
        checks.that("TLS is asked for", heard[0] == asks_for_tls, heard)
        checks.that("no user is told", b"anna" not in b"".join(heard), heard)
        checks.that("and it fails", code == 2, code)
    code, heard = told_to_a_false_database(program, f"sslmode=verify-full&sslrootcert={other[0]}", context)
    checks.that("the one that is trusted is told", b"anna" in b"".join(heard), (code, heard))


def newest_tls_is_preferred(program, folder, checks):
    certificate, key = made_certificate(folder, "server")

    def tried(*options):
        done = subprocess.run(["openssl", "s_client", "-connect", server.host, *options], input="", text=True,
                              capture_output=True, timeout=20, check=False)
        return re.search(r"New, .*", done.stdout)[0]
    with Served(program, folder / "tls.db", token=TOKEN, tls=(certificate, key)) as server:
        checks.that("TLS 1.3 is taken where it is offered", tried().startswith("New, TLSv1.3"), tried())
        for version in ("-tls1", "-tls1_1"):
            checks.that(f"{version} is refused", "(NONE)" in tried(version, "-cipher", "ALL:@SECLEVEL=0"), version)
        for kind in ("eNULL", "aNULL", "PSK", "CAMELLIA"):
            checks.that(f"{kind} is refused", "(NONE)" in tried("-tls1_2", "-cipher", f"{kind}:@SECLEVEL=0"), kind)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    checks = Checks()
    no_program_is_started(program, checks)
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        with Served(program, folder / "door.db", token=TOKEN) as server:
            every_operation_asks(server, checks)
        store = folder / "archive.db"
        with Served(program, store) as server:
            with Watched(server) as watched:
                strangers_are_told_nothing(server, checks)
                nothing_is_said_twice(server, checks)
                what_was_not_asked_for_is_not_set(server, checks)
                statements_stay_text(server, checks)
                other_types_are_refused(server, checks)
                files_are_the_owners(server, store, checks)
            checks.that("it listens and answers on its port alone",
                        watched.looks > 1 and not watched.strange,
                        (watched.looks, watched.strange[:3]))
        log_holds_no_secret(program, folder, checks)
        security_events_are_told(program, folder, checks)
        any_letters_are_a_token(program, folder, checks)
        files_that_others_may_read_are_told(program, folder, checks)
        nobody_is_waited_for_at_the_end(program, folder, checks)
        what_was_left_out_is_told_where_it_is_cut_off(program, folder, checks)
        newest_tls_is_preferred(program, folder, checks)
        database_is_proved_where_that_is_asked(program, folder, checks)
    checks.finish()


if __name__ == "__main__":
    main()
