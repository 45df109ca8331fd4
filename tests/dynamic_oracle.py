#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""`axiometry dynamic` against numpy: velocities and accelerations by polyfit in every window, amplitudes by numpy's FFT,
stretches of even motion against the motion that was made; .rtx and .npy of one motion alike.

Usage: tests/dynamic_oracle.py PROGRAM
"""
import csv
import json
import pathlib
import struct
import subprocess
import sys
import tempfile

import numpy as np


def run(program, *arguments, codes=(0,)):
    done = subprocess.run([program, *map(str, arguments)], capture_output=True, text=True, timeout=120)
    if done.returncode not in codes:
        raise SystemExit(f"{' '.join(map(str, arguments))}\nexit {done.returncode}: {done.stdout}{done.stderr}")
    return done


def rtx(positions, rate, interval=None):
    head = ["HEADER::", "File name: x.rtx", "Owner: CARTO-Dynamic", "Version no: 4.13.9237.28405", "File Type: rtx",
            "Velocity: ", f"Sample rate: {rate:g}", f"Sample no: {len(positions)}", "Trigger point: 0",
            f"Trigger interval: {interval or 1 / rate:g}", f"Actual sample rate: {rate:g}", "Flags: 0 1 2 0 2",
            "USER-TEXT::", "Machine: Mill 5", "Serial No:", "Date: 10/02/2025 12:58:22", "By:", "Axis: X", "Location:",
            "Data:", ""]
    return "\r\n".join(head).encode() + struct.pack(f"<{len(positions)}d", *positions) + b"\r\nEOF::\r\n"


def motion(rate, rng):
    """Rest, 50 mm/s up, rest, 50 mm/s down; a screw of 5 mm with 80 nm, a vibration of 120.3 Hz with 50 nm."""
    t = np.arange(int(7 * rate)) / rate
    v = np.interp(t, [0, .5, .6, 2.6, 2.7, 3.7, 3.8, 5.8, 5.9, 7], [0, 0, 50, 50, 0, 0, -50, -50, 0, 0])
    x = np.cumsum(v) / rate
    true_v = v
    x = x + 80e-6 * np.sin(2 * np.pi * x / 5) + 50e-6 * np.sin(2 * np.pi * 120.3 * t) + rng.normal(0, 5e-6, len(t))
    return t, x, true_v


def close(what, found, expected, within):
    if not np.all(np.abs(np.asarray(found) - np.asarray(expected)) <= within):
        raise SystemExit(f"{what}: found {found}, expected {expected} within {within}")


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    rng = np.random.default_rng(5)
    rate = 2000.0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        t, x, _ = motion(rate, rng)
        (folder / "x.rtx").write_bytes(rtx(x, rate))
        done = run(program, "dynamic", folder / "x.rtx", "--feed", 3000, "--json", folder / "x.json", "--series",
                   folder / "x.csv", "--spectrum", folder / "s.csv", "--report", folder / "x.html", "--report",
                   folder / "x.csv2.csv")
        assert "No test of ISO 230-2" in done.stdout and "day or the month" in done.stdout, done.stdout
        assert "<svg" in (folder / "x.html").read_text()
        r = json.loads((folder / "x.json").read_text())
        assert r["samples"] == len(x) and r["rate_hz"] == rate

        series = np.array([[float(c) for c in row] for row in list(csv.reader((folder / "x.csv").open()))[1:]])
        assert series.shape == (len(x), 4)
        close("times", series[:, 0], t, 1e-9)
        close("positions", series[:, 1], x, 0)
        half = round((r["window_s"] * rate - 1) / 2)
        j = np.arange(-half, half + 1)
        windows = np.lib.stride_tricks.sliding_window_view(x, 2 * half + 1)
        fits = np.polynomial.polynomial.polyfit(j, (windows - windows[:, half:half + 1]).T, 2)
        inner = slice(half, len(x) - half)
        close("velocity", series[inner, 2], fits[1] * rate, 1e-6)
        close("acceleration", series[inner, 3], 2 * fits[2] * rate ** 2, 1e-2)
        close("highest velocity", r["velocity_per_s"]["highest"]["value"], series[inner, 2].max(), 0)
        close("lowest acceleration", r["acceleration_per_s2"]["lowest"]["value"], series[inner, 3].min(), 0)
        close("noise", r["noise"]["position"], 5e-6, 1e-6)

        up, down = r["uniform"]
        assert (up["direction"], down["direction"]) == ("up", "down")
        for stretch, begin in ((up, .6), (down, 3.8)):
            close("begin", stretch["begin_s"], begin, 0.06)  # the ripple has a period of 0.1 s
            close("end", stretch["end_s"], begin + 2, 0.06)
            assert stretch["deviation_range"] < 0.4, stretch  # 11 µm with the ends where it gathers speed
            k = slice(round(stretch["begin_s"] * rate), round(stretch["end_s"] * rate) + 1)
            line = np.polyfit(t[k], x[k], 1)
            rest = x[k] - np.polyval(line, t[k])
            close("velocity of a stretch", stretch["velocity_per_s"], line[0], 1e-7)
            close("range", stretch["deviation_range"], 1000 * np.ptp(rest), 1e-4)
            close("rms", stretch["deviation_rms"], 1000 * np.sqrt(np.mean(rest ** 2)), 1e-4)
            close("feed", stretch["feed_error_percent"], 100 * (abs(line[0]) * 60 / 3000 - 1), 1e-6)

        s = r["spectrum"]
        assert s["of"] == "longest_stretch"
        k = slice(round(s["begin_s"] * rate), round(s["end_s"] * rate) + 1)
        rest = 1000 * (x[k] - np.polyval(np.polyfit(t[k], x[k], 1), t[k]))
        n = len(rest)
        window = 0.5 - 0.5 * np.cos(2 * np.pi * (np.arange(n) + 0.5) / n)
        size = round(rate / s["step_hz"])
        amplitudes = 2 * np.abs(np.fft.rfft(window * (rest - (window * rest).sum() / window.sum()), size)) / window.sum()
        spectrum = np.array([[float(c) for c in row] for row in list(csv.reader((folder / "s.csv").open()))[1:]])
        close("amplitudes", spectrum[:, 1], amplitudes, 1e-7)
        close("frequencies", spectrum[:, 0], np.arange(len(amplitudes)) * rate / size, 1e-9)
        first, second = s["peaks"][:2]
        close("screw, Hz", first["frequency_hz"], 10.0, 0.02)
        close("screw, µm", first["amplitude"], 0.080, 0.001)
        close("screw, mm", first["period"], 5.0, 0.01)
        close("vibration, Hz", second["frequency_hz"], 120.3, 0.01)
        close("vibration, µm", second["amplitude"], 0.050, 0.001)

        np.save(folder / "x.npy", np.column_stack([t, x]))
        again = json.loads(run(program, "dynamic", folder / "x.npy", "--feed", 3000, "--json", "-").stdout)
        close("npy", again["uniform"][0]["velocity_per_s"], up["velocity_per_s"], 1e-9)
        part = json.loads(run(program, "dynamic", folder / "x.rtx", "--from", 0.6, "--to", 2.6, "--reverse", "--json",
                              "-").stdout)
        assert [u["direction"] for u in part["uniform"]] == ["down"] and part["feed_per_min"] is None
        rest_only = json.loads(run(program, "dynamic", folder / "x.rtx", "--to", 0.5, "--json", "-").stdout)
        assert rest_only["uniform"] == [] and rest_only["spectrum"]["of"] == "recording"
        close("at rest", rest_only["spectrum"]["peaks"][0]["frequency_hz"], 120.3, 0.1)

        (folder / "place.rtx").write_bytes(rtx(x, rate, 0.01))
        assert "triggered by position" in run(program, "dynamic", folder / "place.rtx").stdout
        for data, words in [(rtx(x, rate)[:-2000], "cut off"), (rtx(x[:10], rate), "expected 64 at least"),
                            (b"HEADER::\r\nSample no: 5\r\nData:\r\n", "as sample rate"),
                            (rtx(np.where(t == 1.0, np.nan, x), rate), "beyond 1e15, or none")]:
            (folder / "bad.rtx").write_bytes(data)
            done = run(program, "dynamic", folder / "bad.rtx", codes=(2,))
            assert words in done.stderr, (words, done.stderr)
        uneven = np.delete(np.column_stack([t, x]), slice(3000, 3010), axis=0)
        np.save(folder / "uneven.npy", uneven)
        done = run(program, "dynamic", folder / "uneven.npy", codes=(2,))
        assert "not evenly spaced" in done.stderr, done.stderr
        run(program, "dynamic", folder / "x.rtx", "--window", 2, codes=(2,))
        run(program, "dynamic", folder / "x.rtx", "--even", 0, codes=(1,))
        run(program, "dynamic", folder / "x.rtx", "--series", folder / "x.rtx", codes=(1, 2))
        run(program, "dynamic", folder / "x.rtx", "--rate", 100, codes=(2,))
        run(program, "dynamic", folder / "x.rtx", "--series", folder / "o", "--spectrum", folder / "o", codes=(1,))
        run(program, "dynamic", folder / "x.rtx", "--series", "-", "--json", "-", codes=(1,))
        assert not (folder / "o").exists()
        german = run(program, "dynamic", folder / "x.rtx", "--language", "de").stdout
        assert "Keine Prüfung nach ISO 230-2" in german and "Highest" not in german, german
    print("motion, stretches and spectrum of recordings agree with numpy")


if __name__ == "__main__":
    main()
