#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Seals that an authority stamps (RFC 3161), with an authority of our own: openssl behind a small server.

Usage: time_stamp_test.py PROGRAM FAILING_NAMES; the latter is the library that failing_names.cpp becomes.
"""
import http.server
import os
import pathlib
import socket
import subprocess
import sys
import tempfile
import threading

ROOT = pathlib.Path(__file__).resolve().parents[2]
failures = 0

AUTHORITY = """
[tsa]
serial = {folder}/serial
signer_cert = {folder}/tsa.pem
signer_key = {folder}/tsa.key
signer_digest = sha256
default_policy = 1.2.3.4.1
digests = sha256
ordering = yes
ess_cert_id_alg = sha256
[purpose]
extendedKeyUsage = critical,timeStamping
"""


def that(what, holds, found=""):
    global failures
    if not holds:
        failures += 1
        print(f"FAILED  {what}\n{found}", flush=True)


def openssl(*words, bytes_in=None):
    return subprocess.run(["openssl", *map(str, words)], input=bytes_in, check=True, capture_output=True).stdout


def authority_in(folder):
    """A root and, signed by it, the certificate of an authority."""
    folder.mkdir()
    (folder / "serial").write_text("01\n")
    (folder / "tsa.cnf").write_text(AUTHORITY.format(folder=folder))
    openssl("req", "-x509", "-newkey", "rsa:2048", "-nodes", "-days", "3", "-subj", f"/CN=Root of {folder.name}",
            "-keyout", folder / "root.key", "-out", folder / "root.pem")
    openssl("req", "-newkey", "rsa:2048", "-nodes", "-subj", f"/CN=Clock of {folder.name}", "-keyout", folder / "tsa.key",
            "-out", folder / "tsa.csr")
    openssl("x509", "-req", "-in", folder / "tsa.csr", "-CA", folder / "root.pem", "-CAkey", folder / "root.key",
            "-CAcreateserial", "-days", "2", "-extfile", folder / "tsa.cnf", "-extensions", "purpose", "-out", folder / "tsa.pem")
    return folder


def stamped(folder, request):
    (folder / "asked").write_bytes(request)
    return openssl("ts", "-reply", "-config", folder / "tsa.cnf", "-section", "tsa", "-queryfile", folder / "asked")


class Server(http.server.ThreadingHTTPServer):
    """Answers each path in a way of its own."""

    def __init__(self, folder):
        self.folder, self.last = folder, b""
        super().__init__(("127.0.0.1", 0), Answering)
        threading.Thread(target=self.serve_forever, daemon=True).start()

    def url(self, path):
        return f"http://127.0.0.1:{self.server_port}{path}"


class Answering(http.server.BaseHTTPRequestHandler):
    def do_POST(self):
        request = self.rfile.read(int(self.headers["Content-Length"]))
        folder = self.server.folder
        good = self.headers["Content-Type"] == "application/timestamp-query"
        body, status, kind = b"", 200, "application/timestamp-reply"
        if self.path == "/good" and good:
            body = self.server.last = stamped(folder, request)
        elif self.path == "/again":
            body = self.server.last
        elif self.path == "/refused":
            body = stamped(folder, b"no request")
        elif self.path == "/garbage":
            body = b"\x30\x82" + b"x" * 1000
        elif self.path == "/page":
            body, kind = b"<html>", "text/html"
        elif self.path == "/large":
            body = b"x" * (2 << 20)
        elif self.path == "/at@sign?and=1" and self.headers["Host"] == f"127.0.0.1:{self.server.server_port}":
            body = self.server.last
        else:
            status = 403
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        try:
            self.wfile.write(body)
        except OSError:
            pass  # the client has heard enough

    def log_message(self, *_):
        pass


def check_read_once(program, root, store, seal):
    """From a pipe, which gives its bytes once: what is proved of a seal and of its stamp is of the same bytes."""
    pipe = seal.with_name("once.seal")
    os.mkfifo(pipe)
    pipe.with_name("once.seal.tsr").write_bytes(seal.with_name(seal.name + ".tsr").read_bytes())
    threading.Thread(target=lambda: pipe.write_bytes(seal.read_bytes()), daemon=True).start()
    try:
        done = subprocess.run([program, "store", "verify", store, "--seal", pipe, "--authority", root], capture_output=True,
                              text=True, check=False, timeout=60)
        that("a seal is read once", done.returncode == 0 and "CN=Clock of here" in done.stdout, done.stdout + done.stderr)
    except subprocess.TimeoutExpired:
        that("a seal is read once", False, "it waits for more of a pipe")


def check_interrupted(program, failing, server, root, store, seal):
    """Whatever fails or kills the writing of a seal with its stamp, the one that is there has its stamp, under one of two
    names; and the next one puts all in its place."""
    stamp, new = (seal.with_name(seal.name + ending) for ending in (".tsr", ".tsr.new"))
    files = (seal, stamp, new)

    def run(*words, **environment):
        done = subprocess.run([program, "store", *map(str, words)], capture_output=True, text=True, check=False,
                              env={**os.environ, **environment})
        return done.returncode, done.stdout + done.stderr

    def write(**environment):
        return run("seal", seal, "--store", store, "--time-stamp", server.url("/good"), **environment)

    def is_stamped():
        code, said = run("verify", store, "--seal", seal, "--authority", root)
        return code == 0 and "proved: the seal of" in said and "CN=Clock of here" in said, said

    write()
    before = {file: file.read_bytes() for file in (seal, stamp)}
    interrupted, told = 0, 0
    for how in ("fails", "before", "after"):
        for at in range(1, 10):
            for file in files:
                file.unlink(missing_ok=True)
            for file, was in before.items():
                file.write_bytes(was)
            code, said = write(LD_PRELOAD=failing, NAMES_FAIL_OF=seal.name, NAMES_FAIL_AT=str(at), NAMES_FAIL_HOW=how)
            if code == 0:
                break
            interrupted += 1
            what = f"change {at} of a name, {how}"
            holds, said = is_stamped()
            that(f"{what}: the seal that is there has its stamp", holds, said)
            that(f"{what}: a stamp under the new name is told", not new.exists() or seal.read_bytes() == before[seal] or
                 not stamp.exists() or stamp.read_bytes() != before[stamp] or f"noted: {new}" in said, said)
            told += f"noted: {new}" in said
            that(f"{what}: the old stamp stands as long as the new seal does not",
                 seal.read_bytes() != before[seal] or (stamp.exists() and stamp.read_bytes() == before[stamp]))
            code, said = write()
            that(f"{what}: the next seal is written", code == 0, said)
            checked = subprocess.run(["openssl", "ts", "-verify", "-data", seal, "-in", stamp, "-CAfile", root],
                                     capture_output=True, text=True, check=False)
            that(f"{what}: and stamped under its usual name", checked.returncode == 0 and not new.exists(), checked.stderr)
    that("each step was interrupted, and between seal and stamp, too", interrupted >= 11 and told >= 3,
         f"{interrupted}, {told}")


def main():
    program, failing = sys.argv[1:3]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)

        def run(*words):
            done = subprocess.run([program, "store", *map(str, words)], capture_output=True, text=True, check=False)
            return done.returncode, done.stdout + done.stderr

        store, seal = folder / "a.db", folder / "a.seal"
        stamp = folder / "a.seal.tsr"
        run("add", ROOT / "examples" / "iso230-2-table2.csv", "--store", store)
        here, other = authority_in(folder / "here"), authority_in(folder / "other")
        server = Server(here)

        for path, expected in (("/refused", "refused the time stamp, status 2"), ("/garbage", "no answer of a time stamp authority"),
                               ("/page", "expected application/timestamp-reply"), ("/large", "no answer from"),
                               ("/nowhere", "status 403")):
            code, said = run("seal", seal, "--store", store, "--time-stamp", server.url(path))
            that(f"{path} is refused", code == 2 and expected in said, said)
            that(f"{path} leaves no seal", not seal.exists() and not stamp.exists())
        for url, expected in (("ftp://a/b", "expected one such as"), ("http://127.0.0.1:1/x", "no answer from"), ("http://", "expected one such as"),
                              ("http://a@b/", "expected one such as"), ("http://[::1/", "expected one such as")):
            code, said = run("seal", seal, "--store", store, "--time-stamp", url)
            that(f"{url} is refused", code == 2 and expected in said, said)
        with socket.socket() as silent:
            silent.bind(("127.0.0.1", 0))
            silent.listen()
            code, said = run("seal", seal, "--store", store, "--time-stamp", f"http://127.0.0.1:{silent.getsockname()[1]}/")
            that("who never answers is given up", code == 2 and "took longer than" in said, said)

        code, said = run("seal", seal, "--store", store, "--time-stamp", server.url("/good"))
        that("a seal is stamped", code == 0 and stamp.exists(), said)
        checked = subprocess.run(["openssl", "ts", "-verify", "-data", seal, "-in", stamp, "-CAfile", here / "root.pem"],
                                 capture_output=True, text=True, check=False)
        that("openssl finds the stamp good", checked.returncode == 0, checked.stderr)
        code, said = run("verify", store, "--seal", seal)
        that("a stamp of whom nobody knows proves nothing", code == 0 and "not proved: when the seal" in said, said)
        code, said = run("verify", store, "--seal", seal, "--authority", here / "root.pem")
        that("a stamp proves the moment", code == 0 and "proved: the seal" in said and "CN=Clock of here" in said, said)
        code, said = run("verify", store, "--seal", seal, "--authority", other / "root.pem")
        that("another authority did not stamp it", code == 2 and "does not hold" in said, said)
        (folder / "torn.pem").write_bytes((here / "root.pem").read_bytes() + (other / "root.pem").read_bytes()[:400] +
                                          b"\n-----END CERTIFICATE-----\n")
        code, said_of_torn = run("verify", store, "--seal", seal, "--authority", folder / "torn.pem")
        that("a damaged certificate is not passed over", code == 2 and "block 2" in said_of_torn, said_of_torn)
        code, said = run("verify", store, "--seal", seal, "--authority", store)
        that("an archive is no certificate", code == 2 and "no certificate" in said, said)

        code, said = run("seal", seal, "--store", store)
        that("a stamped seal is not replaced by one without", code == 2 and "time stamp" in said, said)
        run("add", ROOT / "examples" / "iso230-2-table2.json", "--store", store)
        code, said = run("seal", seal, "--store", store, "--time-stamp", server.url("/again"))
        that("the stamp of another seal is refused", code == 2 and "does not hold" in said, said)
        code, said = run("seal", seal, "--store", store, "--time-stamp", server.url("/at@sign?and=1#end"))
        that("an address may have all that addresses have", code == 2 and "does not hold" in said, said)
        code, said = run("verify", store, "--seal", seal, "--authority", here / "root.pem")
        that("the seal of before is still there", code == 0, said)
        code, said = run("seal", seal, "--store", store, "--time-stamp", server.url("/good"))
        that("a stamped seal is replaced by a stamped one", code == 0, said)
        code, said = run("verify", store, "--seal", seal, "--authority", here / "root.pem")
        that("and that holds", code == 0 and "CN=Clock of here" in said, said)

        check_read_once(program, here / "root.pem", store, seal)
        check_interrupted(program, failing, server, here / "root.pem", store, seal)
        whole = stamp.read_bytes()
        for at in range(0, len(whole), 97):
            stamp.write_bytes(whole[:at] + bytes([whole[at] ^ 4]) + whole[at + 1:])
            code, said = run("verify", store, "--seal", seal, "--authority", here / "root.pem")
            # What no signature covers, such as unused parts of the outer structure, may change.
            that(f"byte {at} of a stamp", code in (0, 2) and (code == 2 or "CN=Clock of here" in said), said)
        stamp.write_bytes(whole[:-1])
        that("a stamp that is cut off", run("verify", store, "--seal", seal, "--authority", here / "root.pem")[0] == 2)
        stamp.unlink()
        code, said = run("verify", store, "--seal", seal, "--authority", here / "root.pem")
        that("a stamp that is asked for must be there", code == 2 and "a.seal.tsr" in said, said)
        server.shutdown()
    print(f"{failures} failures")
    return 1 if failures else 0


if __name__ == "__main__":
    sys.exit(main())
