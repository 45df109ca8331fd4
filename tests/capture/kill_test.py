#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Kills `axiometry capture` at many random moments and proves that nothing that it has shown is lost.

Usage: kill_test.py PROGRAM [KILLS]

A server streams a made-up run much faster than real time. The program is killed with SIGKILL; then its raw file is
played again (--from RAW), and gone on with (--resume RAW). Every reading that was shown must be there again, the same to
the last digit, and the test file must be whole. Also: connections that break in the middle of lines, a source that is
there only later, or never, and a run that ends in its middle.
"""
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import sys
import tempfile
import threading
import time

import made_up_run

RATE = 500
MOST_BEFORE_A_KILL = 28  # of the 30 readings of the run
MOST_UNREAD = 8000  # bytes, of a second of the run: what a kill loses must not be a whole run, however slow the machine


class Server:
    """Sends lines to whoever connects, from where the time of the stream is now; breaks off where it is told to."""

    def __init__(self, lines, pause=0.001, block=40, breaks=(), port=0):
        self.lines, self.pause, self.block, self.breaks = lines, pause, block, set(breaks)
        self.at, self.done = 0, False
        self.socket = socket.create_server(("127.0.0.1", port))
        self.port = self.socket.getsockname()[1]
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while not self.done:
            try:
                peer, _ = self.socket.accept()
            except OSError:
                return
            with peer:
                try:
                    while self.at < len(self.lines) and not self.done:
                        block = b"".join(self.lines[self.at:self.at + self.block])
                        self.at += self.block
                        broken = next((b for b in self.breaks if b < self.at), None)
                        if broken is not None:
                            self.breaks.discard(broken)
                            peer.sendall(block[:len(block) // 2 + 3])  # within a line
                            break
                        peer.sendall(block)
                        time.sleep(self.pause)
                        self.wait_until_read()
                except OSError:
                    pass

    def wait_until_read(self):
        """Until the program has taken nearly all that was sent to it; it may be dead by then."""
        while not self.done and self.unread() > MOST_UNREAD:
            time.sleep(0.001)

    def unread(self):
        """Bytes that wait for the program, as the system tells of connections to our port."""
        to_us = f":{self.port:04X}"
        with open("/proc/net/tcp", encoding="ascii") as file:
            queues = [fields[4] for fields in map(str.split, file) if fields[2].endswith(to_us)]
        return max((int(queue.split(":")[1], 16) for queue in queues), default=0)

    def close(self):
        self.done = True
        self.socket.close()


def capture(program, folder, *arguments):
    return subprocess.Popen([program, "capture", "--plan", f"{folder}/plan.json", *arguments], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True)


def readings_of(output):
    """What was shown: approach → the whole line. A line that was cut off by the kill was not shown."""
    whole = output[:output.rfind("\n") + 1]
    return {line[:17].strip(): line for line in whole.splitlines() if line.startswith("target ")}


def demand(condition, message):
    if not condition:
        sys.exit(f"failed: {message}")


def check_test_file(name, shown):
    """Whole JSON, and as many readings as were shown, or more."""
    if not os.path.exists(name):
        demand(len({line.split()[1][:-1] for line in shown}) < 2, "no test file although two targets were shown")
        return
    with open(name, encoding="utf-8") as file:
        series = json.load(file)["series"]
    count = sum(x is not None for key in ("up", "down") for run in series.get(key, []) for x in run)
    demand(count >= len(shown), f"the test file holds {count} readings, {len(shown)} were shown")


def play(program, folder, raw, out):
    done = capture(program, folder, "--from", raw, "--out", out)
    output, errors = done.communicate(timeout=60)
    return readings_of(output), done.returncode, errors


def kill_when_shown(process, count, pause):
    """All that was shown. Counted in readings and not in seconds, so that a busy machine is killed amid the run too."""
    output = ""
    while len(readings_of(output)) < count:
        line = process.stdout.readline()
        if not line:
            break
        output += line
    time.sleep(pause)
    process.send_signal(signal.SIGKILL)
    rest, errors = process.stdout.read(), process.stderr.read()  # communicate() would lose what readline() has buffered
    process.wait()
    demand(process.returncode in (-signal.SIGKILL, 0), f"exit code {process.returncode} before the kill: {errors}")
    return output + rest


def kill_once(program, folder, lines, rng, number):
    raw, out = f"{folder}/{number}.raw", f"{folder}/{number}.json"
    server = Server(lines)
    process = capture(program, folder, "--from", f"tcp://127.0.0.1:{server.port}", "--raw", raw, "--out", out)
    shown = readings_of(kill_when_shown(process, rng.choice([0, *range(MOST_BEFORE_A_KILL)]), rng.uniform(0, 0.02)))
    if not os.path.exists(raw):
        server.close()
        return 0
    check_test_file(out, shown)
    again, _, errors = play(program, folder, raw, f"{folder}/{number}.again.json")
    for approach, line in shown.items():
        demand(again.get(approach) == line, f"{approach} was shown as {line!r}, played as {again.get(approach)!r} {errors}")
    # The rest of the run, with a gap where the program was dead.
    resumed = capture(program, folder, "--from", f"tcp://127.0.0.1:{server.port}", "--resume", raw, "--out", out,
                      "--give-up", "0")
    output, errors = resumed.communicate(timeout=60)
    after = readings_of(output)
    for approach, line in shown.items():
        demand(after.get(approach) == line, f"{approach} was shown as {line!r}, resumed as {after.get(approach)!r}")
    check_values(after)
    final, _, _ = play(program, folder, raw, f"{folder}/{number}.final.json")
    demand(final == after, "playing the whole raw file gives something else than the resumed run")
    check_test_file(out, after)
    server.close()
    return len(shown)


def check_values(shown):
    """Against the truth: half a micrometre is far more than the noise leaves, far less than any mistaken approach."""
    truth = {f"target {a[0]}{a[1]} run {a[2]}": 1000 * made_up_run.deviation_mm(a[0] - 1, a[1] == "↑", a[2] - 1)
             for _, _, a in made_up_run.stops() if a}
    for approach, line in shown.items():
        value = float(line[17:].split()[2].replace("−", "-"))
        demand(abs(value - truth[approach]) < 0.1, f"{approach}: found {value}, expected {truth[approach]}")


def broken_connections(program, folder, lines, rng):
    breaks = sorted(rng.sample(range(500, len(lines) - 2000), 3))
    server = Server(lines, breaks=breaks)
    out = f"{folder}/broken.json"
    process = capture(program, folder, "--from", f"tcp://127.0.0.1:{server.port}", "--out", out, "--give-up", "3")
    output, errors = process.communicate(timeout=120)
    shown = readings_of(output)
    demand(errors.count("connection lost") >= 3, f"three breaks were not told: {errors}")
    check_values(shown)
    total = sum(1 for _, _, a in made_up_run.stops() if a)
    demand(len(shown) >= total - 6, f"only {len(shown)} of {total} readings with three short breaks: {output}")
    again, _, _ = play(program, folder, out + ".raw", f"{folder}/broken.again.json")
    demand(again == shown, "the raw file with breaks plays differently")
    refused = capture(program, folder, "--from", f"tcp://127.0.0.1:{server.port}", "--out", out)
    demand(refused.wait(timeout=20) == 2, "an existing raw file was not refused")
    server.close()


def interrupted(program, folder, lines):
    server = Server(lines)
    out = f"{folder}/interrupted.json"
    process = capture(program, folder, "--from", f"tcp://127.0.0.1:{server.port}", "--out", out)
    for _ in range(6):
        process.stdout.readline()
    process.send_signal(signal.SIGINT)
    rest = process.stdout.read()
    process.wait(timeout=20)
    demand(process.returncode == 130, f"Ctrl-C gave exit code {process.returncode}")
    demand("readings from" in rest, "Ctrl-C did not end with a summary")
    check_test_file(out, {})
    server.close()


def late_source(program, folder, lines):
    """The instrument is switched on after the program, or never."""
    with socket.create_server(("127.0.0.1", 0)) as taken:
        port = taken.getsockname()[1]
    process = capture(program, folder, "--from", f"tcp://127.0.0.1:{port}", "--out", f"{folder}/late.json")
    demand("trying again for 60 s" in process.stderr.readline(), "a source that is not there yet was not told")
    server = Server(lines, port=port)
    output, errors = process.communicate(timeout=60)
    demand("connected after " in errors, f"the late source was not told: {errors}")
    demand(process.returncode == 0, f"a whole plan from a late source gave exit code {process.returncode}: {output}")
    server.close()
    silent = socket.socket()  # has a port and does not listen
    silent.bind(("127.0.0.1", 0))
    port = silent.getsockname()[1]
    begun = time.monotonic()
    process = capture(program, folder, "--from", f"tcp://127.0.0.1:{port}", "--out", f"{folder}/never.json",
                      "--give-up", "1")
    _, errors = process.communicate(timeout=30)
    demand(process.returncode == 2 and "attempts in 1 s" in errors, f"{process.returncode}: {errors}")
    demand(0.9 < time.monotonic() - begun < 10, "it was not given up in time")
    process = capture(program, folder, "--from", f"tcp://127.0.0.1:{port}", "--out", f"{folder}/never.json")
    process.stderr.readline()
    process.send_signal(signal.SIGINT)
    process.communicate(timeout=10)
    demand(process.returncode == 130, f"Ctrl-C while waiting for a source gave exit code {process.returncode}")
    silent.close()


def half_a_run(program, folder, lines):
    """A script learns that readings are missing."""
    server = Server(lines[:len(lines) // 2])
    out = f"{folder}/half.json"
    process = capture(program, folder, "--from", f"tcp://127.0.0.1:{server.port}", "--out", out, "--give-up", "0")
    output, _ = process.communicate(timeout=60)
    demand(process.returncode == 5, f"half a run gave exit code {process.returncode}: {output}")
    check_test_file(out, readings_of(output))
    server.close()


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    kills = int(sys.argv[2]) if len(sys.argv) > 2 else 25
    rng = random.Random(20261121)
    lines = made_up_run.text(RATE)
    with tempfile.TemporaryDirectory() as folder:
        made_up_run.write_plan(f"{folder}/plan.json")
        shown = [kill_once(program, folder, lines, rng, number) for number in range(kills)]
        broken_connections(program, folder, lines, rng)
        interrupted(program, folder, lines)
        late_source(program, folder, lines)
        half_a_run(program, folder, lines)
    total = sum(1 for _, _, a in made_up_run.stops() if a)
    amid = sum(0 < count < total for count in shown)
    print(f"{kills} kills, {amid} amid the run, {sum(shown)} readings shown before them, none lost or different")
    demand(2 * amid > kills, "too few kills came amid the run to prove anything")


if __name__ == "__main__":
    main()
