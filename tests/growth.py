#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""What a reader may cost: every verb that reads a file is given files of repeated pieces.

Usage: growth.py PROGRAM [--all] [--only WORD] [--seed N]

Each seed file is mutated automatically: a line, a word, a sign or the whole file repeated up to a size, lines numbered so
that none is like another, values of JSON repeated, nested and named anew. Whatever the program answers, it must end by
itself, take at most 64 MiB + 50 times the file, and its processor time must grow about as the file does: four times the
file may cost eight times, where a cost that grows with the square has sixteen. Without --all so many mutations of each
seed are drawn as fit into the suite, other ones for another --seed.
"""
import argparse
import json
import os
import pathlib
import random
import re
import resource
import signal
import struct
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parent.parent
SIZES = (1_000, 10_000, 100_000, 1_000_000)
MIB = 1 << 20
TIME_LIMIT_S = 60
EXPECTED = (0, 1, 3, 4)  # of a seed file itself: that it is read, whatever is found in it
UNSEEN_S = 0.35  # processor time that is no growth yet: starting, and a large file simply read
PACE_S = 0.075  # processor time of what `slowness` counts on a machine at rest


def bound(size, command=()):
    """Trials hold 80 draws of every reading at once, and what is known of it under twenty hypotheses about noise."""
    return 64 * MIB + (450 if "--trials" in command else 50) * size


def small_bound(command):
    """Processor time of a small file on a machine at rest. The sixty steps of a fit of 21 curves cost what they cost, and so
    does what trials know of a thousand targets under twenty hypotheses about noise."""
    return 2.5 if command[:2] == ["volumetric", "identify"] or "--trials" in command else 1.0


# ---------------------------------------------------------------- what is read, and by which command; @ is the file

def seeds(program, folder):
    """(name, command, bytes) of everything that reads a file."""
    files = ROOT / "tests" / "transcripts"
    for path in sorted((ROOT / "tests" / "fuzz" / "corpus" / "formats").iterdir()) + sorted((ROOT / "examples").glob("[!t]*.*")):
        yield path.name, ["evaluate", "-q", "@"], path.read_bytes()
    for path in ("convert.files/across.csv", "convert.files/messung.txt"):
        yield path, ["convert", "@", "--guess"], (files / path).read_bytes()
    yield "converted", ["convert", "@", "-", "--to", "csv-long"], (ROOT / "examples" / "iso230-2-table2.json").read_bytes()
    table2 = str(ROOT / "examples" / "iso230-2-table2.csv")
    yield "tolerance table", ["evaluate", "-q", table2, "--tolerance-table", "@:Machining centre"], (ROOT / "examples" / "tolerance-tables.csv").read_bytes()
    yield "drift recording", ["evaluate", "-q", table2, "--drift-recording", "@"], DRIFT.encode()
    profile = folder / "profile.json"
    strange = str(files / "convert.files/ecarts.csv")
    subprocess.run([program, "convert", strange, "--guess", "--save-profile", str(profile)], capture_output=True, check=False)
    answered = profile.read_bytes().replace(b'"target_unit": null', b'"target_unit": "mm"').replace(b'"reading_unit": null', b'"reading_unit": "um"')
    (folder / "answered.json").write_bytes(answered)
    yield "import profile", ["evaluate", "-q", strange, "--profile", "@"], answered
    yield "table read after a profile", ["evaluate", "-q", "@", "--profile", str(folder / "answered.json")], pathlib.Path(strange).read_bytes()
    yield "straightness", ["straightness", "@"], (files / "error-motions.files/z-of-x.csv").read_bytes()
    yield "periodic", ["periodic", "@", "--period", "10"], (files / "periodic.files/screw.csv").read_bytes()
    yield "temperature log", ["temperatures", "-q", "@"], TEMPERATURES.encode()
    yield "rules compared", ["compare-rules", "@"], (files / "periodic.files/screw.csv").read_bytes()
    yield "rules compared by trials", ["compare-rules", "@", "--uncertainty", "monte-carlo", "--trials", "100"], (files / "periodic.files/screw.csv").read_bytes()
    for case in sorted((ROOT / "tests" / "conformance").rglob("*.case"))[::6]:
        yield case.name, ["check", "@"], case.read_bytes()
    plan = (files / "nc.files/plan.json").read_bytes()
    yield "plan checked", ["plan", "--check", "@"], plan
    yield "plan programmed", ["nc", "@", "--dialect", "linuxcnc", "--out", "-"], plan
    yield "plan simulated", ["simulate", "--plan", "@", "--out", "-", "-q"], plan
    yield "sequence", ["plan", "--travel", "0:500", "--targets", "4", "--cycle", "user-defined", "--sequence", "@", "--out", "-"], b"1+ 2+ 3+ 4+\n4- 3- 2- 1-\n"
    yield "pitch table", ["simulate", "--seed", "1", "--pitch-table", "@", "--out", "-", "-q"], b"0 0\n100 1.5\n200 -0.5\n500 2\n"
    samples = [line.split(",") for line in (files / "capture.files/run.csv").read_text().split()[1:]]
    capture = ["capture", "--plan", str(files / "capture.files/x.plan.json")]
    yield "recording", capture + ["--from", "@"], (files / "capture.files/run.csv").read_bytes()
    yield "counter", capture + ["--from", "@", "--wavelength", "632.82", "--counts-per-wavelength", "8", "--zero", "first-target"], (files / "capture.files/counter.txt").read_bytes()
    yield "array", capture + ["--from", "@"], npy(samples)
    yield "monitor", capture + ["--from", "@"], monitor(samples)
    yield "frames", capture + ["--from", "@"], b"".join(frame(float(x)) for _, x in samples)
    yield "motion", ["dynamic", "-q", "@"], rtx([float(x) for _, x in samples])
    yield "capture's plan", ["capture", "--plan", "@", "--from", str(files / "capture.files/run.csv")], (files / "capture.files/x.plan.json").read_bytes()
    tracking = files / "tracking-evaluate.files"
    yield "lengths", ["tracking", "evaluate", "@", "--plan", str(tracking / "seven.json")], (tracking / "lengths.csv").read_bytes()
    recorded = folder / "recorded.csv"
    subprocess.run([program, "tracking", "simulate", "--plan", str(tracking / "seven.json"), "--noise", "0.2um", "--rate", "25", "--recording", str(recorded), "-q"], capture_output=True, check=True)
    yield "recorded lengths", ["tracking", "evaluate", "@", "--plan", str(tracking / "seven.json")], recorded.read_bytes()
    yield "lengths' plan", ["tracking", "evaluate", str(tracking / "lengths.csv"), "--plan", "@"], (tracking / "seven.json").read_bytes()
    yield "set-up", ["tracking", "plan", "--setup", "@", "--station", "100,80,-600", "--seed", "3", "--out", "-"], (files / "nc-lines.files/tracking.json").read_bytes()
    yield "tracking simulated", ["tracking", "simulate", "--plan", "@", "--seed", "3", "--lengths", "-"], (tracking / "seven.json").read_bytes()
    for name in ("points.csv", "axes.csv", "cone.csv"):
        yield name, ["tracking", "locate", "@"], (files / "tracking-locate.files" / name).read_bytes()
    several = files / "tracking-multilaterate.files"
    yield "ranges", ["tracking", "multilaterate", "@", "--points", str(several / "nominal.csv")], (several / "ranges.csv").read_bytes()
    yield "nominal points", ["tracking", "multilaterate", str(several / "ranges.csv"), "--points", "@"], (several / "nominal.csv").read_bytes()
    polar = files / "tracking-polar.files"
    yield "polar readings", ["tracking", "polar", "@", "--instrument", "leica-at901"], (polar / "tracker.csv").read_bytes()
    volume = files / "volumetric.files"
    identify = ["volumetric", "identify", "-q", "--json", "-"]
    yield "volumetric lengths", identify + ["@", "--machine", str(volume / "machine.json")], (volume / "lengths.csv").read_bytes()
    yield "machine", identify + [str(volume / "lengths.csv"), "--machine", "@"], (volume / "machine.json").read_bytes()
    made = {name: folder / name for name in ("volume.json", "truth.json", "found.json", "run.csv")}
    subprocess.run([program, "volumetric", "plan", "--machine", str(volume / "machine.json"), "--points", "12", "--out", str(made["volume.json"]), "-q"], capture_output=True)
    simulated = [program, "volumetric", "simulate", "--plan", str(made["volume.json"]), "-q"]
    subprocess.run(simulated + ["--truth", str(made["truth.json"]), "--rate", "20", "--recording", str(made["run.csv"])], capture_output=True, check=True)
    subprocess.run([program] + identify[:2] + [str(volume / "lengths.csv"), "--machine", str(volume / "machine.json"), "--out", str(made["found.json"])], capture_output=True)
    yield "volumetric plan", ["volumetric", "simulate", "--plan", "@", "--lengths", "-"], made["volume.json"].read_bytes()
    yield "volumetric plan recorded", ["volumetric", "simulate", "--plan", "@", "--rate", "0.001", "--recording", str(folder / "recorded.csv"), "-q"], made["volume.json"].read_bytes()
    yield "volumetric plan programmed", ["nc", "@", "--part", "1", "--dialect", "linuxcnc", "--out", "-"], made["volume.json"].read_bytes()
    yield "volumetric recording", identify + ["@", "--plan", str(made["volume.json"])], made["run.csv"].read_bytes()
    yield "volumetric recording's plan", identify + [str(made["run.csv"]), "--plan", "@"], made["volume.json"].read_bytes()
    yield "volumetric truth", ["volumetric", "simulate", "--machine", str(volume / "machine.json"), "--station", "100,80,-700", "--points", "5", "--errors", "@", "--lengths", "-"], made["truth.json"].read_bytes()
    yield "volumetric result", ["volumetric", "field", "@", "--at", str(volume / "points.csv"), "-q"], made["found.json"].read_bytes()
    yield "volume points", ["volumetric", "field", str(made["found.json"]), "--at", "@", "-q"], (volume / "points.csv").read_bytes()
    yield "machine planned", ["volumetric", "plan", "--machine", "@", "--points", "12", "--out", "-", "-q"], (volume / "machine.json").read_bytes()
    yield "kept", ["store", "add", "@", "--store", str(folder / "kept.db")], (ROOT / "examples" / "iso230-2-table2.csv").read_bytes()
    subprocess.run([program, "store", "add", table2, "--store", str(folder / "made.db")], capture_output=True, check=True)
    (folder / "backlash.csv").write_text(BACKLASH)
    axes = str(files / "store-compensations.files" / "x.csv"), str(folder / "backlash.csv")
    for table in sorted((ROOT / "tests" / "fuzz" / "corpus" / "tables").iterdir()):
        yield f"table for {table.name}", existing(axes, table.name), table.read_bytes()[1:]
    calibrate = ["store", "calibrate", "--store", str(folder / "calibrated.db")]
    of_lines, of_volume = [str(tracking / "lengths.csv"), "--plan", str(tracking / "seven.json")], [str(volume / "lengths.csv"), "--machine", str(volume / "machine.json")]
    yield "calibrated lengths", calibrate + ["@"] + of_lines[1:], (tracking / "lengths.csv").read_bytes()
    yield "calibrated plan", calibrate + of_lines[:2] + ["@"], (tracking / "seven.json").read_bytes()
    yield "calibrated lines' options", calibrate + of_lines + ["--options", "@"], b'{"tolerances": ["E=20um", "x:A=30um"], "rule": "iso14253-1", "break_threshold_mm": 0.02}'
    yield "calibrated volume's options", calibrate + of_volume + ["--options", "@"], b'{"curves": "b-spline", "spans": [4, 3, 3], "reversal": "none", "drift": "auto", "find_breaks": true}'
    yield "verified", ["store", "verify", "@"], (folder / "made.db").read_bytes()


def existing(axes, control):
    """A table that was active while an axis was tested; the second one for those that fit no other."""
    counts = control in ("grblhal", "marlin", "smoothie")
    flags = ["--steps-per-unit", "80"] if counts else ["--hold-ends"] + (["--curves", "both-ways"] if control == "pmac" else [])
    return ["compensate", axes[1 if counts or control == "haas" else 0], "--for", control, "--existing", "@", *flags, "-q"]


BACKLASH = "# axis.name: X\ntarget_mm,run,direction,deviation_um\n" + "".join(
    f"{-50.8 * k:.1f},{run},{way},{-1.016 * k + turn + 0.1 * ((7 * k + 3 * run) % 5 - 2):.2f}\n"
    for k in range(9) for run in (1, 2, 3) for way, turn in (("up", 0), ("down", 5)))


TEMPERATURES = "time;Air [°C];Bed [°C]\n" + "".join(f"2026-03-02 {8 + k // 60:02}:{k % 60:02};{20 + k % 5 / 10};21\n" for k in range(60))
DRIFT = "time_s,deviation_um\n" + "".join(f"{10 * k},{(k * 37 % 11) / 10 - 0.5}\n" for k in range(60))


def monitor(samples):
    """Samples as the monitor of a control system writes them."""
    return "".join(f"A:Laser 2026-01-31 10:{float(t) // 60:02.0f}:{float(t) % 60:05.2f} {x}\n" for t, x in samples).encode()


def frame(mm):
    """A distance as an HPI-3D sends it."""
    body = b"\xaa\xb0\x15" + round(mm * 1e7).to_bytes(7, "big", signed=True) + bytes([0, 0, 0, 9, 90])
    check = 0xFF
    for byte in body:
        check ^= byte
        for _ in range(8):
            check = (check << 1 ^ (0x31 if check & 0x80 else 0)) & 0xFF
    return body + bytes([check])


def rtx(positions):
    """A dynamic recording of Renishaw."""
    head = f"HEADER::\r\nSample no: {len(positions)}\r\nActual sample rate: 1000\r\nData:\r\n"
    return head.encode() + struct.pack(f"<{len(positions)}d", *positions) + b"\r\nEOF::\r\n"


def npy(samples):
    """Samples as an array of NumPy."""
    header = f"{{'descr': '<f8', 'fortran_order': False, 'shape': ({len(samples)}, 2), }}"
    header += " " * (63 - (10 + len(header)) % 64) + "\n"
    body = b"".join(struct.pack("<dd", float(t), float(x)) for t, x in samples)
    return b"\x93NUMPY\x01\x00" + len(header).to_bytes(2, "little") + header.encode() + body


def series(targets, runs):
    """A test of which more is asked than to be read: its uncertainty is stated, and every 50th reading is far out."""
    def grow(size):
        chance = random.Random(size)
        lines, length = ["# uncertainty.environmental_variation: 1", "target_mm,direction,run,deviation_um"], 80
        m, n = (targets or size // (34 * runs) + 2), (runs or size // (34 * targets) + 2)
        for place in range(2 * m * n):
            j, d, i = place // (2 * m) + 1, place // m % 2, place % m
            far = 500 if place % 50 == 7 else 0
            lines.append(f"{i},{'+-'[d]},{j},{chance.gauss(far, 1):.2f}")
        return ("\n".join(lines) + "\n").encode()
    return grow


def evaluated():
    """(name, command, growth) of files that are long rather than strange."""
    for name, grow in (("many runs", series(12, None)), ("many targets", series(None, 5)), ("nothing but runs", series(2, None))):
        yield name, ["evaluate", "-q", "--uncertainty", "gum", "@"], grow
    few_trials = ["--uncertainty", "monte-carlo", "--trials", "100", "--threads", "1", "--seed", "1"]
    yield "many targets, few trials", ["evaluate", "-q", *few_trials, "@"], series(None, 5)
    for kind in ("pdf", "png", "html"):
        yield f"many targets, report as {kind}", ["evaluate", "-q", "@", "--report", f"@.{kind}"], series(None, 5)
    yield "periods of many targets", ["periodic", "-q", "@"], series(None, 2)


# ---------------------------------------------------------------- how a file grows

def fill(before, piece, behind, size, number=None):
    """`piece` again and again between both, up to that size; numbered where `number` says how."""
    if number is None:
        times = max(1, (size - len(before) - len(behind)) // max(1, len(piece)))
        return before + piece * times + behind
    parts, length = [before], len(before) + len(behind)
    for k in range(size):
        part = number(piece, k)
        length += len(part)
        if length > size and k > 0:
            break
        parts.append(part)
    return b"".join(parts + [behind])


def with_number(piece, k):
    """The first number of a line counted up, so that no two lines are alike."""
    return re.sub(rb"\d+", lambda found: str(int(found.group()[:9]) + k).encode(), piece, count=1)


def with_last_number(piece, k):
    return re.sub(rb"\d+(?=\D*$)", lambda found: str(int(found.group()[:9]) + k).encode(), piece, count=1)


def text_mutations(seed):
    lines = seed.splitlines(keepends=True)
    known = set()
    for n, line in enumerate(lines[:400]):
        shape = re.sub(rb"\d+", b"0", line)
        if shape in known:
            continue
        known.add(shape)
        before, behind = b"".join(lines[:n]), b"".join(lines[n + 1:])
        ended = line if line.endswith(b"\n") else line + b"\n"
        yield f"line {n + 1} repeated", lambda size, b=before, p=ended, e=behind: fill(b, p, e, size)
        yield f"line {n + 1} numbered", lambda size, b=before, p=ended, e=behind: fill(b, p, e, size, with_number)
        yield f"line {n + 1} numbered at its end", lambda size, b=before, p=ended, e=behind: fill(b, p, e, size, with_last_number)
        pieces = list(re.finditer(rb"[A-Za-z\x80-\xff]+|\d+|[^A-Za-z0-9\x80-\xff\r\n]", line))
        for piece in pieces[:40]:
            head, tail = before + line[:piece.end()], line[piece.end():] + behind
            yield f"line {n + 1}, {piece.group()!r} repeated", lambda size, b=head, p=piece.group(), e=tail: fill(b, p, e, size)
        for first, second in list(zip(pieces, pieces[1:]))[:20]:
            head, tail = before + line[:second.end()], line[second.end():] + behind
            pair = line[first.start():second.end()]
            yield f"line {n + 1}, {pair!r} repeated", lambda size, b=head, p=pair, e=tail: fill(b, p, e, size)
            yield f"line {n + 1}, {pair!r} numbered", lambda size, b=head, p=pair, e=tail: fill(b, p, e, size, with_number)
    yield "the file repeated", lambda size: fill(b"", seed if seed.endswith(b"\n") else seed + b"\n", b"", size)
    for sign in (b"a ", b"word ", b"1,", b"-", b"(", b"[", b'"', b"\n", b"#", b"# a: b\n", b"\t", b";", b"\xc3\xa9", b"\0", b"1 "):
        yield f"{sign!r} behind", lambda size, s=sign: fill(seed, s, b"", size)
        yield f"{sign!r} before", lambda size, s=sign: fill(b"", s, b"\n" + seed, size)


def places(value, path=()):
    """Every place of a JSON document that can grow, one for each shape of its path."""
    yield path, value
    if isinstance(value, dict):
        for key, item in value.items():
            yield from places(item, path + (key,))
    elif isinstance(value, list) and value:
        yield from places(value[0], path + (0,))


def replaced(value, path, new):
    if not path:
        return new
    copy = value.copy()
    copy[path[0]] = replaced(value[path[0]], path[1:], new)
    return copy


def spelled(document, path, text):
    """The document as JSON with that text in place of what stands there."""
    mark = "\x01here\x01"
    before, behind = json.dumps(replaced(document, path, mark)).split(json.dumps(mark), 1)
    return lambda piece, size: fill((before + text[0]).encode(), piece, (text[1] + behind).encode(), size)


def json_mutations(seed):
    document = json.loads(seed)
    for path, value in places(document):
        where = "/".join(map(str, path))
        if isinstance(value, list):
            for item in value[:1] or [0]:
                grown = spelled(document, path, ("[", json.dumps(item) + "]"))
                piece = (json.dumps(item) + ",").encode()
                yield f"{where}: elements", lambda size, g=grown, p=piece: g(p, size)
            counted = spelled(document, path, ("[", "0]"))
            first = spelled(document, path, ("", ""))
            yield f"{where}: numbers", lambda size, g=counted: g(b"1,", size)
            yield f"{where}: numbers counted", lambda size, d=document, p=path, v=value: counted_array(d, p, size, v)
            yield f"{where}: empty ones", lambda size, g=counted: g(b"[],", size)
            yield f"{where}: nested", lambda size, g=first: g(b"[", size)
        if isinstance(value, dict):
            yield f"{where}: unknown members", lambda size, d=document, p=path, v=value: more_members(d, p, v, size)
        if isinstance(value, str):
            yield f"{where}: long", lambda size, g=spelled(document, path, ('"', '"')): g(b"a ", size)
            yield f"{where}: escapes", lambda size, g=spelled(document, path, ('"', '"')): g(b"\\u00e9", size)
        if isinstance(value, (int, float)):
            yield f"{where}: digits", lambda size, g=spelled(document, path, ("1", "")): g(b"0", size)
            yield f"{where}: large", lambda size, d=document, p=path: json.dumps(replaced(d, p, size)).encode()


def counted_array(document, path, size, value):
    """An array as the one there, its numbers all different."""
    item = value[0] if value else 0
    items, length, k = [], 0, 0
    while length < size:
        text = with_number(json.dumps(item).encode(), k) if re.search(r"\d", json.dumps(item)) else json.dumps(item).encode()
        items.append(text)
        length += len(text) + 1
        k += 1
    mark = "\x01here\x01"
    before, behind = json.dumps(replaced(document, path, mark)).split(json.dumps(mark), 1)
    return before.encode() + b"[" + b",".join(items) + b"]" + behind.encode()


def more_members(document, path, value, size):
    grown = dict(value)
    for k in range(size // 12):
        grown[f"m{k}"] = k
    return json.dumps(replaced(document, path, grown)).encode()


def mutations(seed):
    if seed.lstrip().startswith(b"{"):
        yield from json_mutations(seed)
    yield from text_mutations(seed)


# ---------------------------------------------------------------- what it costs

class Cost:
    def __init__(self, seconds, bytes_, code):
        self.seconds, self.bytes, self.code = seconds, bytes_, code

    def __str__(self):
        return f"{self.seconds:.2f} s, {self.bytes / MIB:.0f} MiB, exit {self.code}"


class Launcher:
    """Runs commands and measures each. A process of its own, begun while this one is still small: what a command has
    taken at most counts from the fork on."""

    def __init__(self):
        ask, self.ask = os.pipe()
        self.answer, answer = os.pipe()
        if os.fork() == 0:
            os.close(self.ask)
            with os.fdopen(ask) as commands, os.fdopen(answer, "w", buffering=1) as costs:
                for line in commands:
                    print(json.dumps(self.run(json.loads(line))), file=costs)
            os._exit(0)
        os.close(ask)
        self.commands, self.costs = os.fdopen(self.ask, "w", buffering=1), os.fdopen(self.answer)

    def cost(self, arguments):
        print(json.dumps(arguments), file=self.commands)
        return Cost(*json.loads(self.costs.readline()))

    @staticmethod
    def run(arguments):
        child = os.fork()
        if child == 0:
            try:
                resource.setrlimit(resource.RLIMIT_CPU, (TIME_LIMIT_S, TIME_LIMIT_S))
                resource.setrlimit(resource.RLIMIT_AS, (4 << 30, 4 << 30))
                resource.setrlimit(resource.RLIMIT_FSIZE, (1 << 30, 1 << 30))
                resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
                null = os.open(os.devnull, os.O_RDWR)
                for descriptor in (0, 1, 2):
                    os.dup2(null, descriptor)
                os.execv(arguments[0], arguments)
            finally:
                os._exit(127)
        _, status, usage = os.wait4(child, 0)
        code = -os.WTERMSIG(status) if os.WIFSIGNALED(status) else os.WEXITSTATUS(status)
        return usage.ru_utime + usage.ru_stime, usage.ru_maxrss * 1024, code


def slowness():
    """How many times as long work takes now: other work on a processor's other half costs it up to twice its time."""
    started = time.process_time()
    sum(k * k for k in range(2_000_000))
    return max(1.0, (time.process_time() - started) / PACE_S)


def cost(launcher, program, command, file):
    return launcher.cost([program] + [word.replace("@", str(file)) for word in command])


def faults(launcher, program, command, grow, file):
    """What is wrong with how a command's cost grows; the largest file first, since most cost nothing."""
    def of(size):
        content = grow(size)
        file.write_bytes(content)
        return len(content), cost(launcher, program, command, file)

    size, large = of(SIZES[-1])
    if large.code < 0:
        return f"ended by {signal.Signals(-large.code).name} on {size} bytes ({large})"
    if large.bytes > bound(size, command):
        return f"{large.bytes / MIB:.0f} MiB for {size} bytes, expected at most {bound(size, command) / MIB:.0f} MiB"
    if large.seconds > UNSEEN_S:
        quarter, small = of(SIZES[-1] // 4)
        if large.seconds > 8 * max(small.seconds, UNSEEN_S / 4) and size > 2 * quarter:
            return f"{small.seconds:.2f} s for {quarter} bytes, {large.seconds:.2f} s for {size}"
    for smaller in SIZES[:-1]:
        size, small = of(smaller)
        if small.code < 0 or small.bytes > bound(size, command):
            return f"{size} bytes: {small}"
        most = small_bound(command)
        if small.seconds > most and small.seconds > (slow := slowness()) * most:
            return f"{size} bytes: {small}, where work takes {slow:.2f} times as long as at rest"
    return None


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    parser.add_argument("--all", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--seed", type=int, default=15)
    parser.add_argument("--each", type=int, default=6, help="mutations drawn for each seed file")
    options = parser.parse_args()
    launcher = Launcher()
    chance = random.Random(options.seed)
    tried = failed = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for title, command, seed in seeds(options.program, folder):
            if options.only and options.only not in title:
                continue
            (folder / "grown").write_bytes(seed)
            itself = cost(launcher, options.program, command, folder / "grown")
            if itself.code not in EXPECTED:
                failed += 1
                print(f"FAILED  {title}: the file itself: {itself}\n        axiometry {' '.join(command)}", flush=True)
            ways = list(mutations(seed))
            drawn = ways if options.all else chance.sample(ways, min(len(ways), options.each))
            for way, grow in drawn:
                tried += 1
                if fault := faults(launcher, options.program, command, grow, folder / "grown"):
                    failed += 1
                    print(f"FAILED  {title}: {way}: {fault}\n        axiometry {' '.join(command)}", flush=True)
        for title, command, grow in evaluated():
            if options.only and options.only not in title:
                continue
            tried += 1
            if fault := faults(launcher, options.program, command, grow, folder / "grown"):
                failed += 1
                print(f"FAILED  {title}: {fault}\n        axiometry {' '.join(command)}", flush=True)
    print(f"{tried} ways to grow a file, {failed} cost too much")
    return 1 if failed or tried == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
