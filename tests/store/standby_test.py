#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""standby_test.py PROGRAM: an archive is verified on a hot standby, which answers and accepts no changes.

Beside the server of with_postgresql a copy of it is started that follows it (pg_basebackup, streaming).
"""
import glob
import json
import os
import pathlib
import pwd
import shutil
import subprocess
import sys
import tempfile
import time

WAIT_S = 60
PRIMARY = os.environ["AXIOMETRY_TEST_POSTGRESQL"]
PRIMARY_FOLDER = PRIMARY.split("host=")[1]


def tool(name):
    folders = sorted(glob.glob("/usr/lib/postgresql/*/bin"), key=lambda f: int(pathlib.Path(f).parent.name))
    return shutil.which(name, path=os.pathsep.join(reversed(folders)) + os.pathsep + os.environ.get("PATH", ""))


def server_user():
    owner = os.stat(PRIMARY_FOLDER).st_uid
    return {} if owner == os.geteuid() else {"user": owner, "group": pwd.getpwuid(owner).pw_gid, "extra_groups": []}


def primary(sql):
    subprocess.run([tool("psql"), "--quiet", "--host", PRIMARY_FOLDER, "--username=axiometry", "axiometry", "-c", sql],
                   check=True)


def start(folder, user):
    data = folder / "data"
    subprocess.run([tool("pg_basebackup"), "--host", PRIMARY_FOLDER, "--username=axiometry", "--pgdata", data,
                    "--write-recovery-conf", "--checkpoint=fast", "--no-sync"], check=True, cwd=folder, **user)
    return subprocess.Popen([tool("postgres"), "-D", data, "-k", folder, "-c", "listen_addresses=",
                             "-c", "max_connections=300"], cwd=folder,  # no fewer than the server it follows
                            stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, **user)


def verified(program, address):
    done = subprocess.run([program, "store", "verify", address, "--json"], capture_output=True, text=True)
    return done.returncode, json.loads(done.stdout) if done.returncode in (0, 3) else done.stderr


def problems_of(program, address):
    """No word of any while it cannot be read, as when the server is just applying a change."""
    code, found = verified(program, address)
    return found["problems"] if code in (0, 3) else []


def wait_until(what, question):
    deadline = time.monotonic() + WAIT_S
    while not question():
        if time.monotonic() > deadline:
            sys.exit(f"standby_test: found no {what} within {WAIT_S} s")
        time.sleep(0.1)


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    test = pathlib.Path(__file__).resolve().parent / "tamper_test.py"
    sys.path.insert(0, str(test.parent))
    from tamper_test import measured_file  # noqa: PLC0415
    user = server_user()
    folder = pathlib.Path(tempfile.mkdtemp(prefix="axiometry-standby-", dir="/tmp"))
    standby = None
    try:
        subprocess.run([program, "store", "add", measured_file(folder, 1), "--store", PRIMARY], check=True,
                       stdout=subprocess.DEVNULL)
        if user:
            os.chown(folder, user["user"], user["group"])
        standby = start(folder, user)
        address = f"postgresql://axiometry@/axiometry?host={folder}"
        wait_until("standby that answers", lambda: verified(program, address)[0] in (0, 3))
        code, found = verified(program, address)
        if code != 0 or found["tests"] != 1 or found["problems"]:
            sys.exit(f"standby_test: found {code} {found}, expected an archive that is whole")
        if not any("standby" in sentence for sentence in found["not_proved"]):
            sys.exit(f"standby_test: found {found['not_proved']}, expected what could not be compared")
        primary("ALTER TABLE axiometry.document ENABLE ALWAYS TRIGGER document_unchanged")
        for change, said in (("ALTER TABLE axiometry.figure DISABLE TRIGGER figure_unchanged", "figure_unchanged"),
                             ("ALTER TABLE axiometry.content ENABLE REPLICA TRIGGER content_unchanged", "content_unchanged"),
                             ("DROP TRIGGER audit_unchanged ON axiometry.audit", "audit_unchanged")):
            primary(change)
            wait_until(f"problem with {said}", lambda said=said: any(
                said in problem for problem in problems_of(program, address)))
        if any("document_unchanged" in problem for problem in problems_of(program, address)):
            sys.exit("standby_test: found a problem with a trigger that is always on, expected none")
    finally:
        if standby is not None:
            standby.terminate()
            standby.wait(WAIT_S)
        shutil.rmtree(folder, ignore_errors=True)
    print("an archive verified on a standby, and three triggers missed there")


if __name__ == "__main__":
    main()
