#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`axiometry capture` of the lines of a tracking plan from a live stream: whole, broken off within a line, and killed.

Usage: lengths_test.py PROGRAM

The stream is a simulated recording, sent much faster than real time. The table of a whole stream must be that of the
file; a capture that is killed and gone on with (--resume) must give the same readings as the raw file it kept; and raw
file and table must be evaluated alike.
"""
import csv
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import kill_test


LOST = (0, 5)  # a break may cost a reading


def run(*arguments, codes=(0,), **options):
    done = subprocess.run(list(map(str, arguments)), capture_output=True, text=True, timeout=120, **options)
    assert done.returncode in codes, (arguments, done.returncode, done.stderr)
    return done.stdout


def readings(table):
    rows = csv.DictReader(line for line in table.read_text().splitlines() if not line.startswith("#"))
    return {(r["line"], r["target"], r["direction"], r["run"]): float(r["length_difference_mm"]) for r in rows}


def results(program, lengths):
    printed = run(program, "tracking", "evaluate", lengths, "--plan", lengths.parent / "lines.json")
    return [line for line in printed.splitlines() if line.startswith(("x ", "xy "))]


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plan, recorded, table = folder / "lines.json", folder / "run.csv", folder / "whole.csv"
        run(program, "tracking", "plan", "--travel", "X=0:800,Y=0:600,Z=-500:0", "--tool", "0,0,-120", "--station",
            "100,80,-600", "--lines", "x,xy", "--targets", 5, "--runs", 2, "--dwell", 2, "--warm-up", 0, "--seed", 3,
            "--out", plan)
        run(program, "tracking", "simulate", "--plan", plan, "--noise", "0.3um", "--rate", 50, "--recording", recorded)
        capture = [program, "capture", "--plan", plan]
        run(*capture, "--from", recorded, "--out", table)
        whole = readings(table)
        assert len(whole) == 40, len(whole)
        lines = recorded.read_bytes().splitlines(keepends=True)

        server = kill_test.Server(lines)
        live = folder / "live.csv"
        run(*capture, "--from", f"tcp://127.0.0.1:{server.port}", "--out", live, "--give-up", 1)
        server.close()
        assert readings(live) == whole
        raw = pathlib.Path(f"{live}.raw")
        assert recorded.read_bytes().startswith(raw.read_bytes()[:100_000])
        assert results(program, live) == results(program, table)
        assert results(program, raw) == results(program, table)

        # Broken off within a line, in the middle of the test: one gap, a reading lost at most, none shifted.
        server = kill_test.Server(lines, breaks=(9_000,))
        broken = folder / "broken.csv"
        run(*capture, "--from", f"tcp://127.0.0.1:{server.port}", "--out", broken, "--give-up", 5,
            codes=LOST)
        server.close()
        found = readings(broken)
        assert len(found) >= len(whole) - 1, len(found)
        assert all(abs(found[k] - whole[k]) < 0.001 for k in found), "a reading of another approach"

        # Killed, and gone on with.
        server = kill_test.Server(lines)
        killed = folder / "killed.csv"
        process = subprocess.Popen(list(map(str, capture + ["--from", f"tcp://127.0.0.1:{server.port}", "--out", killed])),
                                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        kept = pathlib.Path(f"{killed}.raw")
        until = time.monotonic() + 30
        while (not kept.exists() or kept.stat().st_size < 120_000) and time.monotonic() < until:
            time.sleep(0.002)
        os.kill(process.pid, signal.SIGKILL)
        process.wait()
        assert not killed.exists(), "a table before the end"
        run(*capture, "--from", f"tcp://127.0.0.1:{server.port}", "--resume", kept, "--out", killed, "--give-up", 1,
            codes=LOST)
        server.close()
        again = folder / "again.csv"
        run(*capture, "--from", kept, "--out", again, codes=LOST)
        assert readings(killed) == readings(again)
        assert len(readings(killed)) >= len(whole) - 3, len(readings(killed))
        print("lengths from live streams: ok")


if __name__ == "__main__":
    main()
