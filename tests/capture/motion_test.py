#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`axiometry capture --stops` of a straightness from a live stream: led by keys, by a trigger, by single readings and by
the position beside them; killed and gone on with; a missed trigger, one too many, an end too early, a wrong unit.

Usage: motion_test.py PROGRAM

The stream is made up, 50 samples a second, and sent faster than real time. What is said at a stop is typed once the
program has that stop in its raw file. The table must be the truth, the same when the recording is played again, and
what `axiometry straightness` evaluates.
"""
import csv
import json
import os
import pathlib
import random
import signal
import socket
import subprocess
import sys
import tempfile
import time

STEP_S = 0.02
DWELL_S = 4
FEED = 1000


def truth(position, direction, run):
    """µm"""
    return 0.02 * position + 1e-4 * position * (200 - position) + (0.5 if direction == "down" else 0) + 0.1 * (run - 1)


def approaches():
    return [(x, direction, run) for run in (1, 2) for direction, way in (("up", (0, 100, 200)), ("down", (200, 100, 0)))
            for x in way]


def stream(unit=1.0):
    """Lines, and for each stop the number of the line at which it begins."""
    draw = random.Random(5)
    lines, stops = ["time_s,position_mm,reading,trigger\n"], []
    at, level = -5.0, 0.0

    def add(noise, trigger):
        lines.append(f"{STEP_S * (len(lines) - 1):.2f},{at:.4f},{(level + draw.uniform(-noise, noise)) / unit:.7f},"
                     f"{trigger}\n")

    def go(to):
        nonlocal at
        step = FEED / 60 * STEP_S
        while abs(to - at) > step:
            at += step if to > at else -step
            add(3.0, 0)
        at = to

    before = "up"
    for x, direction, run in approaches():
        if direction != before:
            go(205.0 if direction == "down" else -5.0)
        before = direction
        go(x)
        level = truth(x, direction, run)
        stops.append(len(lines))
        count = round(DWELL_S / STEP_S)
        for k in range(count):
            add(0.2, int(count // 2 <= k < count // 2 + 5))
    go(-5.0)
    return [line.encode() for line in lines], stops


def table_of(path):
    rows = csv.DictReader(line for line in path.read_text().splitlines() if not line.startswith("#"))
    return {(float(r["position_mm"]), r["direction"], int(r["run"])): float(r["EYX_um"]) for r in rows}


def check(table, expected, near=0.06):
    assert set(table) == set(expected), (sorted(set(expected) - set(table)), sorted(set(table) - set(expected)))
    for place, value in table.items():
        assert abs(value - truth(*place)) < near, (place, value, truth(*place))


class Led:
    """A capture that is connected to us, whose keys we type."""

    def __init__(self, program, folder, out, *arguments):
        self.socket = socket.create_server(("127.0.0.1", 0))
        port = self.socket.getsockname()[1]
        self.raw = pathlib.Path(arguments[arguments.index("--resume") + 1]) if "--resume" in arguments else \
            pathlib.Path(f"{out}.raw")
        self.keys = pathlib.Path(f"{self.raw}.keys")
        self.sent = self.raw.stat().st_size if self.raw.exists() else 0
        self.process = subprocess.Popen(
            [program, "capture", "--plan", folder / "plan.json", "--from", f"tcp://127.0.0.1:{port}", "--out", out,
             "--give-up", "1", *map(str, arguments)],
            stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
        self.peer, _ = self.socket.accept()

    def send(self, lines):
        data = b"".join(lines)
        self.peer.sendall(data)
        self.sent += len(data)

    def wait(self, what, text):
        until = time.monotonic() + 30
        while not what():
            assert self.process.poll() is None and time.monotonic() < until, (text, self.process.poll())
            time.sleep(0.005)

    def type(self, line):
        """Once all that was sent is in the raw file; until it is kept."""
        self.wait(lambda: self.raw.exists() and self.raw.stat().st_size >= self.sent, "the raw file")
        before = self.said()
        self.process.stdin.write(line + "\n")
        self.process.stdin.flush()
        self.wait(lambda: self.said() > before, "the key")

    def said(self):
        return len(self.keys.read_text().splitlines()) if self.keys.exists() else 0

    def end(self, code):
        self.peer.close()
        self.socket.close()
        try:
            out, err = self.process.communicate(timeout=60)
        except ValueError:  # the standard input was closed before
            out, err = self.process.stdout.read(), self.process.stderr.read()
        assert self.process.wait(60) == code, (self.process.returncode, out, err)
        return out, err

    def kill(self):
        os.kill(self.process.pid, signal.SIGKILL)
        self.process.wait()
        self.peer.close()
        self.socket.close()


def lead(led, lines, stops, first=0, last=None, begin=0):
    """Types Enter a second after each stop; the line behind that."""
    at = begin
    for stop in stops[first:last]:
        led.send(lines[at:stop + 50])
        at = stop + 50
        led.type("")
    return at


def play(program, folder, raw, out, *arguments, code=0):
    done = subprocess.run([program, "capture", "--plan", folder / "plan.json", "--from", raw, "--out", out,
                           *map(str, arguments)], capture_output=True, text=True, timeout=60)
    assert done.returncode == code, (done.returncode, done.stdout, done.stderr)
    return done


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    lines, stops = stream()
    whole = approaches()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plan = folder / "plan.json"
        subprocess.run([program, "plan", "--axis", "X", "--travel", "-10:210", "--targets", "0,100,200", "--runs", "2", "--overrun", "5",
                        "--feed", str(FEED), "--dwell", str(DWELL_S), "--warm-up", "0", "--error", "EYX", "--out",
                        plan], check=True, capture_output=True)
        assert len(json.loads(plan.read_text())["targets"]) == 3
        keys = ["--stops", "keys", "--unit", "um", "--stream-axis", 2, "--positive", "+Y"]

        # Led by keys to the end: each target is told before it is read.
        led = Led(program, folder, folder / "keys.csv", *keys)
        at = lead(led, lines, stops)
        led.send(lines[at:])
        out, _ = led.end(0)
        check(table_of(folder / "keys.csv"), whole)
        assert "next               target 3↑ run 1 at 200.0000 mm" in out, out
        assert "target 3↑ run 1" in out.split("next               target 3↑ run 1")[1]
        play(program, folder, folder / "keys.csv.raw", folder / "again.csv", *keys)
        assert table_of(folder / "keys.csv") == table_of(folder / "again.csv")
        evaluated = subprocess.run([program, "straightness", folder / "keys.csv"], capture_output=True, text=True)
        assert evaluated.returncode == 0 and "Straightness EYX" in evaluated.stdout, evaluated

        # A reading that is taken back and read again, one that is skipped, a reading while the axis moves, the end.
        led = Led(program, folder, folder / "said.csv", *keys)
        led.send(lines[:stops[0] + 50])
        led.type("")
        led.send(lines[stops[0] + 50:stops[0] + 150])
        led.type("u")
        led.type("skip")
        led.send(lines[stops[0] + 150:stops[1] + 50])
        led.type("")
        led.send(lines[stops[1] + 50:stops[1] + 150])
        for rest in ("", "u", "skip"):  # lines longer than any key, whose rest is none either
            for piece in ("x" * 1025, rest + "\n"):  # each is read before the next, and before the end
                led.process.stdin.write(piece)
                led.process.stdin.flush()
                time.sleep(0.3)
        led.process.stdin.write("e\n")
        led.process.stdin.flush()
        out, err = led.end(5)
        assert "taken back" in out and "skipped" in out and "incomplete" in out, out
        assert err.count('found "' + "x" * 40 + '…", expected Enter, s (skip), u (undo) or e (end)') == 3, err
        check(table_of(folder / "said.csv"), [whole[1]])
        play(program, folder, folder / "said.csv.raw", folder / "said-again.csv", *keys, code=5)
        assert table_of(folder / "said.csv") == table_of(folder / "said-again.csv")
        half = subprocess.run([program, "straightness", folder / "said.csv"], capture_output=True, text=True)
        assert half.returncode == 2, "half a series has no straightness"

        # Killed, and gone on with: nothing that was said is said again.
        led = Led(program, folder, folder / "killed.csv", *keys)
        at = lead(led, lines, stops, last=6)
        led.send(lines[at:stops[5] + 195])
        led.wait(lambda: len(table_of(folder / "killed.csv")) == 6 if (folder / "killed.csv").exists() else False, "6")
        led.kill()
        led = Led(program, folder, folder / "killed.csv", *keys, "--resume", folder / "killed.csv.raw")
        at = lead(led, lines, stops, first=6, begin=stops[5] + 195)
        led.send(lines[at:])
        led.end(0)
        check(table_of(folder / "killed.csv"), whole)

        # The standard input ends: nobody can say anything any more.
        led = Led(program, folder, folder / "left.csv", *keys)
        at = lead(led, lines, stops, last=2)
        led.send(lines[at:stops[2]])
        led.process.stdin.close()
        led.process.wait(30)
        assert led.process.returncode == 5
        check(table_of(folder / "left.csv"), whole[:2])

        # A trigger, live and from a file; one missed, one too many, an end too early.
        trigger = ["--stops", "trigger", "--stop-column", 3, "--unit", "um", "--stream-axis", 2]
        led = Led(program, folder, folder / "trigger.csv", *trigger)
        led.send(lines)
        led.end(0)
        check(table_of(folder / "trigger.csv"), whole)
        recorded = folder / "run.csv"
        recorded.write_bytes(b"".join(lines))
        play(program, folder, recorded, folder / "file.csv", *trigger)
        assert table_of(folder / "file.csv") == table_of(folder / "trigger.csv")
        missed = [line.replace(b",1\n", b",0\n") if stops[4] < k < stops[4] + 200 else line
                  for k, line in enumerate(lines)]
        recorded.write_bytes(b"".join(missed))
        done = play(program, folder, recorded, folder / "missed.csv", *trigger, code=5)
        assert "doubtful           so late that target 2↓ run 1 may have been passed" in done.stdout, done.stdout
        check(table_of(folder / "missed.csv"), whole[:4])
        led = Led(program, folder, folder / "told.csv", *trigger)
        led.send(missed[:stops[5] + 190])
        led.wait(lambda: (folder / "told.csv").exists() and "doubtful" in (folder / "told.csv").read_text(), "doubt")
        led.type("s")
        led.send(missed[stops[5] + 190:])
        led.end(5)
        check(table_of(folder / "told.csv"), whole[:4] + whole[5:])
        play(program, folder, folder / "told.csv.raw", folder / "told-again.csv", *trigger, code=5)
        assert table_of(folder / "told.csv") == table_of(folder / "told-again.csv")
        twice = [line.replace(b",0\n", b",1\n") if stops[2] + 190 < k < stops[2] + 194 else line
                 for k, line in enumerate(lines)]
        recorded.write_bytes(b"".join(twice))
        done = play(program, folder, recorded, folder / "twice.csv", *trigger)
        assert "repeated           sooner than the axis can be at" in done.stdout, done.stdout
        check(table_of(folder / "twice.csv"), whole)
        recorded.write_bytes(b"".join(lines[:stops[7]]))
        done = play(program, folder, recorded, folder / "early.csv", *trigger, code=5)
        assert "the recording ended before target 2↑ run 2 and the 4 behind it" in done.stdout, done.stdout

        # The position beside the reading.
        recorded.write_bytes(b"".join(lines))
        position = ["--stops", "position", "--stop-column", 1, "--unit", "um", "--stream-axis", 2]
        play(program, folder, recorded, folder / "position.csv", *position)
        check(table_of(folder / "position.csv"), whole)

        # One reading at each stop, in mm.
        single = folder / "single.csv"
        single.write_text("time_s,reading_mm\n" + "".join(
            f"{STEP_S * stop + 2:.2f},{truth(*place) / 1000:.7f}\n" for stop, place in zip(stops, whole)))
        play(program, folder, single, folder / "one.csv", "--stops", "readings")
        check(table_of(folder / "one.csv"), whole, 1e-4)

        # Units: nobody says one; the stream says another; of the other kind.
        done = play(program, folder, recorded, folder / "none.csv", "--stops", "trigger", "--stop-column", 3,
                    "--stream-axis", 2, code=2)
        assert "found readings without a unit, expected the unit of the stream" in done.stderr, done.stderr
        done = play(program, folder, single, folder / "none.csv", "--stops", "readings", "--unit", "um", code=2)
        assert "found readings in mm by the stream's header, expected µm as stated" in done.stderr, done.stderr
        done = play(program, folder, single, folder / "none.csv", "--stops", "readings", "--unit", "urad", code=2)
        assert "found EYX in µrad, expected readings of a length" in done.stderr, done.stderr
        assert not (folder / "none.csv").exists()
        done = play(program, folder, recorded, folder / "none.csv", "--stop-column", 3, code=1)
        assert "--stop-column: found without --stops, expected with it" in done.stderr, done.stderr
        done = play(program, folder, recorded, folder / "none.csv", code=2)
        assert "made for EYX, expected one of positions; one of other errors is captured where it is stated what tells the stops (capture --stops)" in done.stderr, done.stderr
        print("straightness from live streams: ok")


if __name__ == "__main__":
    main()
