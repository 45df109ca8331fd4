#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""`axiometry capture` of an HPI-3D interferometer at a serial port: asked for its stream, disturbed, and unplugged.

Usage: hpi_test.py PROGRAM

The instrument is a pseudo terminal. Its frames and checks are made here, after nothing of the program's; the axis walks a
plan, faster than real time. Whatever is disturbed, the readings that come of it must be where the axis stood.
"""
import json
import os
import pathlib
import pty
import select
import subprocess
import sys
import tempfile
import threading
import time
import tty

RATE = 25.0
SPEED = 40.0  # times real time


def check_of(data):
    """CRC-8, polynomial 31 hex, begun with FF, bit by bit."""
    check = 0xFF
    for byte in data:
        for bit in range(7, -1, -1):
            turn = (check >> 7 ^ byte >> bit) & 1
            check = (check << 1 & 0xFF) ^ (0x31 if turn else 0)
    return check


def frame(command, data):
    body = bytes([0xAA, 0xB0, command]) + bytes(data)
    assert len(body) in (7, 15)
    return body + bytes([check_of(body)])


def distance(mm, too_fast=False, weak=False):
    steps = round(mm * 1e7)
    flags = [8 if too_fast else 0, (0 if weak else 8) | 1, 90]
    return frame(0x15, steps.to_bytes(7, "big", signed=True) + bytes([0, 0] + flags))


def weather(sensor, celsius, percent, hpa):
    return frame(0x0A, bytes([sensor]) + round(celsius * 100).to_bytes(2, "big", signed=True) + bytes([percent, 80, 60])
                 + round(hpa * 10).to_bytes(2, "big") + bytes(4))


def positions(plan, error_mm):
    """Where the axis is, RATE times a second: at rest on every target, on the way between."""
    places = []
    at = plan["targets"][0] - plan["overrun"]

    def go(to):
        nonlocal at
        steps = max(25, round(abs(to - at) / 20.0 * RATE))  # a second and more: a turn is no standstill
        places.extend(at + (to - at) * k / steps for k in range(1, steps))
        at = to

    def rest(to):
        go(to)
        places.extend([to + error_mm(to)] * round(plan["dwell_s"] * RATE))

    for _ in range(plan["runs"]):
        go(plan["targets"][0] - plan["overrun"])
        for target in plan["targets"]:
            rest(target)
        go(plan["targets"][-1] + plan["overrun"])
        for target in reversed(plan["targets"]):
            rest(target)
    go(plan["targets"][0] - plan["overrun"])
    return places


class Instrument(threading.Thread):
    """Sends once it was asked to; what is to be disturbed is the caller's."""

    def __init__(self, frames):
        super().__init__(daemon=True)
        self.master, slave = pty.openpty()
        tty.setraw(slave)
        self.slave = slave
        self.name_of_port = os.ttyname(slave)
        self.frames = frames
        self.asked = b""

    def run(self):
        while len(self.asked) < 16:
            if select.select([self.master], [], [], 20)[0]:
                self.asked += os.read(self.master, 64)
        try:
            for data in self.frames:
                os.write(self.master, data)
                time.sleep(1.0 / RATE / SPEED)
        except OSError:
            pass  # the program has all that it wants

    def close(self):
        os.close(self.master)
        os.close(self.slave)


def captured(program, plan, folder, frames, name):
    instrument = Instrument(frames)
    instrument.start()
    out = folder / f"{name}.json"
    port = f"serial://{instrument.name_of_port}?baud=3000000&ask=hpi-3d"
    # Arrivals are that of the fast clock: times are given by the rate.
    done = subprocess.run([program, "capture", "--plan", plan, "--from", port, "--rate", str(RATE), "--out", out,
                           "--give-up", "0"], capture_output=True, text=True, timeout=60)
    instrument.close()
    assert done.returncode == 0, (name, done.returncode, done.stdout[-600:], done.stderr)
    assert instrument.asked == frame(0x32, bytes(4)) + frame(0x79, bytes(4)), instrument.asked.hex(" ")
    raw = folder / f"{name}.json.raw"
    again = folder / f"{name}-again.json"
    played = subprocess.run([program, "capture", "--plan", plan, "--from", raw, "--rate", str(RATE), "--out", again, "-q"],
                            capture_output=True, text=True, timeout=60)
    assert played.returncode == 0, (name, played.stderr)
    test = json.loads(out.read_text())
    assert json.loads(again.read_text())["series"] == test["series"], name
    return test, done


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        plan = folder / "x.plan.json"
        subprocess.run([program, "plan", "--axis", "X", "--travel", "0:200", "--targets", "5", "--runs", "2", "--dwell",
                        "2", "--seed", "4", "--out", plan, "-q"], check=True, timeout=60)
        planned = json.loads(plan.read_text())
        places = positions(planned, lambda x: 0.0123 * x / 200.0)
        frames = []
        for k, place in enumerate(places):
            if k % 25 == 0:
                frames.append(weather(0, 20.0 + k / 10000.0, 45, 1013.2))
                frames.append(weather(1, 21.5, 0, 0))
            frames.append(distance(place))
        frames.insert(1, frame(0x32, bytes(12)))  # its answer to what it was asked

        test, done = captured(program, plan, folder, frames, "sound")
        assert "lost" not in done.stdout, done.stdout
        series = test["series"]
        for direction in ("up", "down"):
            for run in series[direction]:
                for target, deviation in zip(series["targets"], run):
                    assert abs(deviation - 12.3 * target / 200.0) < 0.01, (direction, target, deviation)
        environment = json.dumps(test)
        assert "sensor 1" in environment and "21.5" in environment and "101.32" in environment, environment[:3000]

        disturbed = list(frames)
        harmed_weather = 0
        for k in range(40, len(disturbed), 97):
            harmed_weather += disturbed[k][1:3] == b"\xb0\x0a"
            harmed = bytearray(disturbed[k])
            harmed[5] ^= 0x10
            disturbed[k] = bytes(harmed)
        for k in range(60, len(disturbed), 211):
            disturbed[k] = disturbed[k][5:]  # bytes that the port lost
        harmed, done = captured(program, plan, folder, disturbed, "disturbed")
        lost = len(range(40, len(disturbed), 97)) - harmed_weather + len(range(60, len(disturbed), 211))
        assert harmed_weather > 0, "a damaged frame of the weather is no lost distance"
        assert f"{lost} lost" in done.stdout, (lost, done.stdout)
        assert harmed["series"] == series, "disturbed frames changed a reading"
    print("capture of an HPI-3D: sound and disturbed streams give the same readings")


if __name__ == "__main__":
    main()
