# SPDX-License-Identifier: Apache-2.0
"""A running `axiometry serve`, for the tests beside this file. Whatever it answers must be as apps/server/openapi.json
describes it, or the test fails at its end."""
import atexit
import dataclasses
import http.client
import json
import os
import re
import signal
import socket
import ssl
import subprocess
import sys
import urllib.parse

from described import Description

DESCRIPTION = Description()


@dataclasses.dataclass
class Answer:
    status: int
    headers: dict
    body: bytes

    def json(self):
        return json.loads(self.body)


def end_as_failed():
    sys.stdout.flush()
    os._exit(1)


class Served:
    """The server on a free port of 127.0.0.1; `with` ends it by SIGTERM. Where `measured` its answers are read no
    further than those of their kind before, which takes time of those that are measured."""

    def __init__(self, program, store, *more, token=None, tls=None, errors=None, measured=False):
        self.tls = tls
        self.measured = measured
        self.undescribed = []
        command = [program, "serve", "--store", str(store), "--port", "0", "--quiet", *more]
        if tls:
            command += ["--certificate", str(tls[0]), "--key", str(tls[1])]
        environment = {**os.environ}
        environment.pop("AXIOMETRY_TOKEN", None)
        if token:
            environment["AXIOMETRY_TOKEN"] = token
        self.process = subprocess.Popen(command, stdout=subprocess.PIPE, stderr=errors, env=environment, text=True)
        line = self.process.stdout.readline()
        found = re.fullmatch(r"Axiometry workbench: https?://127\.0\.0\.1:(\d+)/\n", line)
        if not found:
            self.process.kill()
            raise SystemExit(f"found the line {line!r}, expected the server's address")
        self.port = int(found[1])
        self.host = f"127.0.0.1:{self.port}"

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            code = self.stop()
            if code != 0:
                raise SystemExit(f"found the server's exit code {code}, expected 0")

    def stop(self, number=signal.SIGTERM):
        self.process.send_signal(number)
        return self.process.wait(timeout=15)

    def connection(self, timeout=60):
        if self.tls:
            context = ssl.create_default_context(cafile=str(self.tls[0]))
            context.check_hostname = False
            return http.client.HTTPSConnection("127.0.0.1", self.port, timeout=timeout, context=context)
        return http.client.HTTPConnection("127.0.0.1", self.port, timeout=timeout)

    def request(self, method, path, body=None, headers=None, connection=None):
        """`body`: bytes, or what becomes JSON."""
        headers = dict(headers or {})
        if body is not None and not isinstance(body, bytes):
            body = json.dumps(body).encode()
            headers.setdefault("Content-Type", "application/json")
        own = connection or self.connection()
        own.request(method, path, body, headers)
        response = own.getresponse()
        answer = Answer(response.status, {k.lower(): v for k, v in response.getheaders()}, response.read())
        if connection is None:
            own.close()
        self.hold(method, path, body, answer)
        return answer

    def hold(self, method, path, body, answer):
        """Against the description."""
        for fault in DESCRIPTION.faults(method, path, body, answer, not self.measured):
            if not self.undescribed:
                atexit.register(end_as_failed)
            self.undescribed.append(fault)
            print(f"FAILED: openapi.json, {method} {path} with the status {answer.status}: {fault}", flush=True)

    def upload(self, path, name, content, connection=None):
        return self.request("POST", path, content, {"X-File-Name": urllib.parse.quote(name)}, connection)

    def raw(self, data, timeout=20.0):
        """All that the server answers to these bytes until it closes or is silent for the time."""
        with socket.create_connection(("127.0.0.1", self.port), timeout=timeout) as client:
            client.sendall(data)
            answered = read_all(client)
        self.hold_first(data, answered)
        return answered

    def hold_first(self, data, answered):
        """The answer to the first request, where both are whole."""
        asked = re.match(rb"([A-Z]+) (/\S*) HTTP/1\.1\r\n", data)
        told = re.match(rb"HTTP/1\.1 (\d+) [^\r]*\r\n(.*?\r\n)\r\n", answered, re.DOTALL)
        if not asked or not told:
            return
        headers = {name.lower(): value for name, value in re.findall(r"([^:\r\n]+): ([^\r\n]*)", told[2].decode("latin-1"))}
        body = answered[told.end():told.end() + int(headers.get("content-length", 0))]
        if int(told[1]) >= 400:
            self.hold(asked[1].decode(), asked[2].decode("latin-1"), None, Answer(int(told[1]), headers, body))

    def descriptors(self):
        return len(os.listdir(f"/proc/{self.process.pid}/fd"))

    def resident_kib(self):
        with open(f"/proc/{self.process.pid}/status", encoding="ascii") as status:
            return int(re.search(r"VmRSS:\s+(\d+)", status.read())[1])


def read_all(client):
    pieces = []
    try:
        while piece := client.recv(65536):
            pieces.append(piece)
    except (TimeoutError, ConnectionResetError):
        pass
    return b"".join(pieces)


class Checks:
    """Counts what is as expected and tells what is not."""

    def __init__(self):
        self.done = 0
        self.failed = 0

    def that(self, what, holds, found=""):
        self.done += 1
        if not holds:
            self.failed += 1
            print(f"FAILED: {what}: found {found!r}", flush=True)

    def finish(self):
        print(f"{self.done - self.failed} of {self.done} checks hold")
        sys.exit(1 if self.failed else 0)
