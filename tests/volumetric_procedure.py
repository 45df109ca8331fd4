#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""A whole volumetric calibration by continuous recordings: planned, recorded, identified, and held against its truth.

Usage: tests/volumetric_procedure.py PROGRAM

Recordings are simulated with noise, drift, breaks of the beam and stops that were missed. Every length that is taken out
of them must be that of the simulated table but for its dead path, whatever the order of the files; the errors must lie
within their uncertainties; what is given wrongly must be refused; and live captures of the parts, one of them killed and
gone on with, must give the same.
"""
import csv
import json
import os
import pathlib
import signal
import subprocess
import sys
import tempfile
import time

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent / "capture"))
import kill_test  # noqa: E402

CAPTURED = (0, 5)  # 5: readings are lost, as the simulation was told to

MACHINE = {
    "chain": "XFYZ", "travel_mm": {"X": [0, 800], "Y": [-300, 300], "Z": [-450, 0]},
    "tools_mm": {"short": [0, 0, -120], "long": [0, 0, -260], "side": [110, -70, -150]},
    "instrument": {"a_um": 0.2, "b_um_per_m": 0.3}, "repeatability_um": 0.3}
POINTS, PARTS = 40, 12


class Bench:
    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, *words, codes=(0, 3)):
        done = subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, timeout=600, cwd=self.folder)
        assert done.returncode in codes, (words, done.returncode, done.stderr[-2000:])
        return done.stdout

    def refused(self, because, *words):
        done = subprocess.run([self.program, *map(str, words)], capture_output=True, text=True, timeout=600, cwd=self.folder)
        assert done.returncode == 2 and because in done.stderr, (words, done.returncode, done.stderr[-2000:])

    def identify(self, *files, plan="plan.json"):
        return json.loads(self.run("volumetric", "identify", *files, "--plan", plan, "--lengths-out", "captured.csv", "--json", "-"))

    def rows(self, name):
        lines = [line for line in (self.folder / name).read_text().splitlines() if not line.startswith("#")]
        return {(r["station"], r["tool"], r["x_mm"], r["y_mm"], r["z_mm"]): (r["segment"], float(r["length_mm"])) for r in csv.DictReader(lines)}


def same_lengths(bench, name, least):
    """Each length of the table that was made, but for a dead path of each segment."""
    found, made, dead = bench.rows(name), bench.rows("lengths.csv"), {}
    assert len(found) >= least, (name, len(found), len(made))
    for place, (segment, length) in found.items():
        dead.setdefault(place[:2] + (segment, made[place][0]), []).append(length - made[place][1])
    for key, offsets in dead.items():
        # An untold break that nobody saw leaves two stretches, which identify finds.
        assert np.ptp(offsets) < 2.1, (name, key, offsets)
    spread = np.concatenate([np.abs(np.array(o) - np.median(o)) for o in dead.values()])
    assert np.median(spread) < 2e-4, (name, np.median(spread))


def within_bands(result, truth):
    held = []
    for name, nodes in truth["errors_in_gauge"].items():
        found = result["errors"][name]
        if isinstance(nodes, dict):
            held.append(abs(found["value"] - nodes["value"]) < 2 * found["u"])
            continue
        q = [n["position"] for n in found]
        true = np.interp(q, [n["position"] for n in nodes], [n["value"] for n in nodes])
        held += list(np.abs(np.array([n["value"] for n in found]) - true) < 2 * np.array([n["u"] for n in found]))
    return float(np.mean(held))


def wrongly(bench):
    """What is given wrongly is never used silently."""
    files = [f"run{k + 1}.csv" for k in range(PARTS)]
    identify = ("volumetric", "identify", "--plan", "plan.json")
    bench.refused("fit part 1 (station S1, tool short) far better, expected those of part 2", *identify, "--parts", "2,1", *files[:2])
    bench.refused("found a length at point", *identify, "run1.csv", "run1.csv")
    bench.refused("expected as many", *identify, "--parts", "1,2,3", *files[:2])
    bench.refused("expected the plan that was driven", "volumetric", "identify", "run1.csv", "--machine", "machine.json")
    bench.refused("found part 13 asked for, expected 1 to 12", *identify, "--parts", "13", "run1.csv")
    lines = (bench.folder / "lengths.csv").read_text().splitlines(keepends=True)
    swapped = [("S2" + line[2:] if line.startswith("S1,") else "S1" + line[2:] if line.startswith("S2,") else line) for line in lines]
    (bench.folder / "swapped.csv").write_text("".join(swapped))
    bench.refused("station or tool are named wrongly", *identify, "swapped.csv")
    turned = (bench.folder / "run1.csv").read_text().splitlines()
    (bench.folder / "turned.csv").write_text("\n".join(turned[:2] + [f"{t},{-float(y)}" for t, y in (line.split(",") for line in turned[2:])]) + "\n")
    bench.refused("the instrument counts the other way", *identify, "--parts", "1", "turned.csv")
    (bench.folder / "short.csv").write_text("\n".join(turned[:250]) + "\n")
    bench.refused("say which part it is", *identify, "short.csv")


def live(bench):
    """Every part out of a stream, the second one killed and gone on with."""
    sent = {k: (bench.folder / f"run{k}.csv").read_bytes().splitlines(keepends=True) for k in (1, 2)}
    capture = ["capture", "--plan", "plan.json"]
    bench.run(*capture, "--part", 1, "--from", "run1.csv", "--out", "file1.csv", codes=CAPTURED)

    server = kill_test.Server(sent[1])
    bench.refused("expected which one is measured: 1 to 12 (--part)", *capture, "--from", f"tcp://127.0.0.1:{server.port}", "--out", "live1.csv")
    bench.run(*capture, "--part", 1, "--from", f"tcp://127.0.0.1:{server.port}", "--out", "live1.csv", "--give-up", 1, codes=CAPTURED)
    server.close()
    assert bench.rows("live1.csv") == bench.rows("file1.csv")
    server = kill_test.Server(sent[1])
    bench.refused("fit part 1 (station S1, tool short) far better", *capture, "--part", 5, "--from", f"tcp://127.0.0.1:{server.port}", "--out", "live5.csv", "--give-up", 1)
    server.close()
    assert not (bench.folder / "live5.csv").exists() and (bench.folder / "live5.csv.raw").stat().st_size > 10_000

    server, killed, raw = kill_test.Server(sent[2]), bench.folder / "live2.csv", bench.folder / "live2.csv.raw"
    words = [bench.program, *capture, "--part", "2", "--from", f"tcp://127.0.0.1:{server.port}", "--out", "live2.csv"]
    process = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, cwd=bench.folder)
    until = time.monotonic() + 30
    while (not raw.exists() or raw.stat().st_size < 60_000) and time.monotonic() < until:
        time.sleep(0.002)
    os.kill(process.pid, signal.SIGKILL)
    process.wait()
    assert not killed.exists(), "a table before the end"
    bench.run(*capture, "--part", 2, "--from", f"tcp://127.0.0.1:{server.port}", "--resume", "live2.csv.raw", "--out", "live2.csv", "--give-up", 1, codes=CAPTURED)
    server.close()
    same_lengths(bench, "live2.csv", POINTS - 4)
    for part in range(3, PARTS + 1):
        bench.run(*capture, "--part", part, "--from", f"run{part}.csv", "--out", f"live{part}.csv", "-q", codes=CAPTURED)
    result = bench.identify(*(f"live{part}.csv" for part in range(PARTS, 0, -1)))
    assert len(result["source"]["files"]) == PARTS and not result["unseen"], result["source"]
    bench.refused("expected each station with each tool in one file", "volumetric", "identify", "--plan", "plan.json", "live1.csv", "file1.csv")


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    with tempfile.TemporaryDirectory() as name:
        bench = Bench(program, pathlib.Path(name))
        (bench.folder / "machine.json").write_text(json.dumps(MACHINE))
        bench.run("volumetric", "plan", "--machine", "machine.json", "--stations", "auto", "--incidence", 80, "--points", POINTS, "--dwell", 2, "--feed", 6000, "--out", "plan.json")
        simulate = ("volumetric", "simulate", "--plan", "plan.json", "--seed", 5, "--drift", "1um", "--breaks", 6,
                    "--untold-breaks", 2, "--lost", 6, "--rate", 25, "--sample-noise", "0.2um")
        bench.run(*simulate, "--lengths", "lengths.csv", "--truth", "truth.json", "--recording", "run{part}.csv")
        truth = json.loads((bench.folder / "truth.json").read_text())

        order = [7, 2, 12, 1, 9, 4, 3, 11, 5, 10, 8, 6]
        result = bench.identify(*(f"run{part}.csv" for part in order))
        told = [(f["file"], f["first_part"], f["last_part"]) for f in result["source"]["files"]]
        assert told == [(f"run{part}.csv", part, part) for part in order], told
        assert all(len(f["sha256"]) == 64 and f["recording"] for f in result["source"]["files"])
        same_lengths(bench, "captured.csv", POINTS * PARTS - 12)
        messages = [f["message"] for f in result["findings"]]
        assert sum("no length for point" in m for m in messages) > 0, messages
        held = within_bands(result, truth)
        assert held > 0.9, f"{100 * held:.1f} % of the values within 2 u"
        table = json.loads(bench.run("volumetric", "identify", "captured.csv", "--plan", "plan.json", "--json", "-"))
        assert table["errors"] == result["errors"], "the table says something else than the recordings"

        bench.run(*simulate, "--recording", "all.csv")
        result = bench.identify("all.csv")
        assert [(f["first_part"], f["last_part"]) for f in result["source"]["files"]] == [(1, PARTS)]
        same_lengths(bench, "captured.csv", POINTS * PARTS - 16)

        # Nobody puts an instrument where it is planned to a hundredth of a millimetre.
        rough = json.loads((bench.folder / "plan.json").read_text())
        for station, off in zip(rough["machine"]["stations_mm"].values(), ((9, -6, 4), (-8, 8, -3), (5, 9, 7), (-6, -7, 8))):
            station[:] = [a + b for a, b in zip(station, off)]
        (bench.folder / "rough.json").write_text(json.dumps(rough))
        bench.identify(*(f"run{part}.csv" for part in order), plan="rough.json")
        same_lengths(bench, "captured.csv", POINTS * PARTS - 16)

        wrongly(bench)
        live(bench)
        print(f"volumetric procedure: ok, {100 * held:.1f} % of the values within 2 u")


if __name__ == "__main__":
    main()
