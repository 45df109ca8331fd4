#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Plays every operation of the API from an empty store to a downloaded report; served.py holds each answer against its
description.

Usage: api.py PROGRAM [--store postgresql://…]

A PostgreSQL store must be empty.
"""
import contextlib
import json
import math
import pathlib
import socket
import sys
import threading
import time
import tempfile
import urllib.parse

from described import OPENAPI, open_objects
from served import DESCRIPTION, Answer, Checks, Served

ROOT = pathlib.Path(__file__).parents[2]
EXAMPLE = (ROOT / "examples" / "iso230-2-table2.json").read_bytes()
# What somebody sends and gets back as it came, and what a program of another version may have written.
GIVEN_BACK = {"PlanFile.request", "TrackingPlanFile.program", "VolumetricModel", "VolumetricPlanFile.machine", "VolumetricResult"}
OPTIONS = {"methods": ["gum"], "trials": None, "seed": 1, "coverage": 0.95, "corrections": []}
PLAN = {"axis": "X", "kind": "linear", "from": 0, "to": 500, "positions": None, "targets": None, "cycle": "standard",
        "runs": 5, "feed": 1000, "dwell_s": 4, "overrun": None, "seed": 7, "further": {}}


class Play:
    """Requests with expectations."""

    def __init__(self, server, checks):
        self.server = server
        self.checks = checks

    def expect(self, status, method, path, body=None, headers=None):
        answer = self.server.request(method, path, body, headers)
        self.checks.that(f"{method} {path} answers {status}", answer.status == status, (answer.status, answer.body[:300]))
        return answer


def service(play):
    health = play.expect(200, "GET", "/api/health").json()
    play.checks.that("the store is empty", health["store"]["counts"]["tests"] == 0, health)
    served = play.expect(200, "GET", "/api/openapi.json").json()
    play.checks.that("it describes itself as it is held against", served == OPENAPI)
    german = play.expect(200, "GET", "/api/vocabulary?language=de").json()
    play.checks.that("the vocabulary has twelve parameters", len(german["parameters"]) == 12)
    play.expect(204, "POST", "/api/login", {"token": "of none that is wanted"})
    play.expect(204, "POST", "/api/logout")
    play.expect(404, "GET", "/api/nothing")
    play.expect(405, "PUT", "/api/health", {})


def faults_are_seen(play):
    """What holds answers against the description must see what is wrong with them."""
    whole = play.expect(200, "GET", "/api/health").json()
    other = [("GET", "/api/health", 200, {**whole, "colour": "red"}), ("GET", "/api/health", 200, {**whole, "status": "ill"}),
             ("GET", "/api/health", 200, {**whole, "store": {**whole["store"], "schema": 1.5}}),
             ("GET", "/api/health", 201, whole), ("GET", "/api/health", 404, whole), ("GET", "/api/healthy", 200, whole),
             ("PUT", "/api/health", 200, whole), ("GET", "/api/machines", 200, whole)]
    headers = {"content-type": "application/json"}
    for method, path, status, value in other:
        faults = DESCRIPTION.faults(method, path, None, Answer(status, headers, json.dumps(value).encode()))
        play.checks.that(f"{method} {path} {status} is seen not to be described", faults)
    text = Answer(200, {"content-type": "text/plain"}, b"ok")
    play.checks.that("another type is seen", DESCRIPTION.faults("GET", "/api/health", None, text))
    done = Answer(204, {}, b"")
    for sent in (None, b"{}", b'{"token": 1}'):
        play.checks.that(f"{sent} is seen not to be described", DESCRIPTION.faults("POST", "/api/login", sent, done))


def form(*parts):
    """multipart/form-data of (head, bytes), and its header."""
    lines = [b"--line\r\nContent-Disposition: form-data; " + head + b"\r\n\r\n" + content for head, content in parts]
    return b"\r\n".join(lines) + b"\r\n--line--\r\n", {"Content-Type": "multipart/form-data; boundary=line"}


def tables(play):
    """A table that leaves something open, and what a person says about it."""
    checks = play.checks
    rows = "".join(f"{x} {x / 1000 - 1} {x / 1000 + 1}\n" for x in range(0, 600, 100)).encode()
    file = (b'name="file"; filename="rows.dat"', rows)
    asked = play.expect(200, "POST", "/api/preview", *form(file)).json()
    checks.that("an open table is refused with its rows", asked["refused"] and len(asked["table"]["rows"]) == 6, asked)
    checks.that("what is open is asked", len(asked["table"]["questions"]) > 0, asked["table"])
    profile = {**asked["table"]["profile"], "target_unit": "mm", "reading_unit": "um", "direction": "names", "columns": [
        {"role": "target"}, {"role": "deviation", "direction": "up"}, {"role": "deviation", "direction": "down"}]}

    def said(members):
        return (b'name="profile"', json.dumps(members).encode())
    stated = play.expect(200, "POST", "/api/preview", *form(file, said(profile))).json()
    checks.that("the answers open it", stated["refused"] is None and stated["tests"][0]["targets"] == 6, stated)
    other = {**profile, "target_unit": "m"}
    ids = [play.expect(201, "POST", "/api/tests", *form(file, said(one))).json()["id"] for one in (profile, other)]
    for test, last in zip(ids, (500, 500_000)):
        kept = play.expect(200, "GET", f"/api/tests/{test}").json()
        checks.that("each test has its own profile", kept["readings"]["targets"][-1] == last, kept["readings"])
        checks.that("the profile is told", kept["file"]["profile"]["direction"] == "names", kept["file"])
        checks.that("its bytes are as they came", play.expect(200, "GET", f"/api/tests/{test}/raw").body == rows)
    for wrong in (b"{", b'{"format": "axiometry-import-profile/1", "columns": [{"role": "x"}]}', b" " * 70_000):
        play.expect(422, "POST", "/api/preview", *form(file, (b'name="profile"', wrong)))
    play.expect(422, "POST", "/api/tests", *form(file, file, said(profile)))


def words_of_users(play):
    """What a user wrote stays as it is in every language, also where it reads like the program's own words."""
    words = "found 4 runs, expected 5"
    test = json.loads(EXAMPLE)
    test["axis"]["name"] = words
    test["machine"]["name"] = words
    test.setdefault("test", {}).update(inspector=words, comment=words)
    sent, headers = json.dumps(test).encode(), {"X-File-Name": urllib.parse.quote(f"{words}.json")}
    told = {language: play.expect(200, "POST", f"/api/preview?language={language}", sent, headers).json()
            for language in ("en", "de", "fr")}
    for language, preview in told.items():
        result = preview["tests"][0]["evaluated"]["result"]
        play.checks.that(f"{language}: names and remarks stay", preview["file"]["name"] == f"{words}.json" and
                         preview["tests"][0]["machine"] == words and result["axis"]["name"] == words and
                         result["metadata"] == told["en"]["tests"][0]["evaluated"]["result"]["metadata"], result["metadata"])
        count = json.dumps(preview).count(words)
        play.checks.that(f"{language}: all of them", count == json.dumps(told["en"]).count(words) > 4, count)
        play.checks.that(f"{language}: titles are the program's", language == "en" or
                         [claim["title"] for claim in result["claims"]] !=
                         [claim["title"] for claim in told["en"]["tests"][0]["evaluated"]["result"]["claims"]], result["claims"])


def tests(play):
    checks = play.checks
    play.expect(200, "GET", "/api/tests")
    play.expect(404, "GET", "/api/tests/1")
    name = {"X-File-Name": "Pr%C3%BCfung.json"}
    preview = play.expect(200, "POST", "/api/preview", EXAMPLE, name).json()
    checks.that("the preview knows the format", preview["refused"] is None and len(preview["tests"]) == 1, preview)
    refused = play.expect(200, "POST", "/api/preview", b"nothing of use", name).json()
    checks.that("the preview says why", refused["refused"] is not None and refused["tests"] == [], refused)
    play.expect(422, "POST", "/api/tests", b"nothing of use", name)
    tried = play.expect(200, "POST", "/api/evaluations?draft=%7B%22changes%22%3A%7B%7D%7D", EXAMPLE, name).json()
    checks.that("a file is evaluated without being kept", tried["result"]["parameters"]["A"] > 9.5)
    received = play.expect(201, "POST", "/api/tests", EXAMPLE, {**name, "X-Actor": "J%C3%BCrgen"}).json()
    test = received["id"]
    checks.that("A is that of the standard's example", abs(received["result"]["parameters"]["A"] - 9.6) < 0.05)
    boundary = b"--line\r\nContent-Disposition: form-data; name=\"file\"; filename=\"two.json\"\r\n\r\n" + EXAMPLE + \
        b"\r\n--line--\r\n"
    again = play.expect(201, "POST", "/api/tests", boundary, {"Content-Type": "multipart/form-data; boundary=line"})
    checks.that("the same bytes make another test", again.json()["id"] != test)

    tables(play)

    kept = play.expect(200, "GET", f"/api/tests/{test}").json()
    checks.that("the name is as it was sent", kept["file"]["name"] == "Prüfung.json", kept["file"])
    checks.that("who sent it is known", kept["received"]["actor"] == "Jürgen", kept["received"])
    raw = play.expect(200, "GET", f"/api/tests/{test}/raw")
    checks.that("the bytes are as they came", raw.body == EXAMPLE)
    changes = {"machine.name": "VMC <850>", "tolerance.A": "9"}
    draft = play.expect(200, "POST", f"/api/tests/{test}/evaluate", {"changes": changes, "options": OPTIONS})
    checks.that("a draft is not kept", play.expect(200, "GET", f"/api/tests/{test}").json()["latest"] == 1)
    checks.that("GUM has been done", draft.status != 200 or draft.json()["result"]["uncertainty"]["gum"] is not None)
    revision = {"base_version": 1, "title": "Second", "reason": "name", "changes": {"machine.name": "VMC <850>"},
                "options": OPTIONS}
    play.expect(201, "POST", f"/api/tests/{test}/versions", revision)
    play.expect(409, "POST", f"/api/tests/{test}/versions", revision)
    play.expect(422, "POST", f"/api/tests/{test}/versions", {**revision, "base_version": 2, "changes": {"no.key": "1"}})
    play.expect(200, "GET", f"/api/tests/{test}?version=1")
    play.expect(200, "POST", f"/api/tests/{test}/withdraw", {"reason": "wrong axis"})
    checks.that("a withdrawn test is out of the list",
                all(row["id"] != test for row in play.expect(200, "GET", "/api/tests").json()["tests"]))
    play.expect(200, "POST", f"/api/tests/{test}/reinstate", {"reason": "right after all"})
    return test


def reports(play, test):
    checks = play.checks
    for extension, begin in (("pdf", b"%PDF"), ("html", b"<!"), ("svg", b"<"), ("png", b"\x89PNG"), ("json", b"{"),
                             ("csv", b"")):
        answer = play.expect(200, "GET", f"/api/tests/{test}/report.{extension}?language=de&decimal=comma&download=1")
        checks.that(f"the {extension} begins as one", answer.body.startswith(begin) and answer.body, answer.body[:20])
    play.expect(404, "GET", f"/api/tests/{test}/report.exe")
    figures = play.expect(200, "GET", f"/api/tests/{test}/figures").json()["figures"]
    checks.that("there are figures", len(figures) > 0, figures)
    if figures:
        play.expect(200, "GET", f"/api/tests/{test}/figures/{figures[0]['id']}.svg?theme=dark")
    rules = play.expect(200, "GET", f"/api/tests/{test}/rules?standards=vdi-dgq-3441,export-lists&uncertainty=monte-carlo"
                                    "&trials=1000&language=de").json()
    checks.that("a test is told by the rules that are named", [rule["id"] for rule in rules["rules"]] ==
                ["vdi-dgq-3441", "export-lists"], rules["rules"])
    play.expect(422, "GET", f"/api/tests/{test}/rules?standards=nmtba")
    for extension, begin in (("pdf", b"%PDF"), ("html", b"<!"), ("json", b"{"), ("csv", b"")):
        answer = play.expect(200, "GET", f"/api/tests/{test}/rules/report.{extension}?language=de&decimal=comma")
        checks.that(f"the {extension} by other rules begins as one", answer.body.startswith(begin) and answer.body,
                    answer.body[:20])
    play.expect(404, "GET", f"/api/tests/{test}/rules/report.svg")
    periodic = play.expect(200, "GET", f"/api/tests/{test}/periodic?min_period=400&max_period=900&language=de&theme=dark").json()
    checks.that("each direction has its periodic error", [one["direction"] for one in periodic["directions"]] ==
                ["up", "down"], periodic["directions"])
    play.expect(422, "GET", f"/api/tests/{test}/periodic?period=0")
    for extension, begin in (("pdf", b"%PDF"), ("html", b"<!"), ("json", b"{"), ("csv", b""), ("svg", b"<"), ("png", b"\x89PNG")):
        answer = play.expect(200, "GET", f"/api/tests/{test}/periodic/report.{extension}?language=de&period=600")
        checks.that(f"the {extension} of a periodic error begins as one", answer.body.startswith(begin) and answer.body,
                    answer.body[:20])
    issued = play.expect(201, "POST", f"/api/tests/{test}/reports", {"extension": "pdf", "language": "en"}).json()
    document = play.expect(200, "GET", f"/api/documents/{issued['id']}")
    checks.that("the issued report is a PDF", document.body.startswith(b"%PDF"), document.body[:20])
    play.expect(201, "POST", f"/api/tests/{test}/attachments", b"\x89PNG\r\n\x1a\n",
                {"X-File-Name": "photo.png", "Content-Type": "image/png"})
    log = play.expect(201, "POST", f"/api/tests/{test}/attachments", b"time;Oil [C]\n2026-03-02 09:00;20\n",
                      {"X-File-Name": "oil.csv", "Content-Type": "text/csv"}).json()
    sensors = play.expect(200, "GET", f"/api/documents/{log['id']}/temperature-sensors").json()["sensors"]
    checks.that("a log's sensors are told, whatever their names tell", sensors == ["Oil"], sensors)


def equipment(play):
    checks = play.checks
    machines = play.expect(200, "GET", "/api/machines").json()["machines"]
    checks.that("tests bring their machines", len(machines) > 0, machines)
    machine = play.expect(201, "POST", "/api/machines", {"name": "Lathe", "serial_number": "L-1"}).json()
    play.expect(200, "GET", f"/api/machines/{machine['id']}")
    change = {"name": "Lathe 2", "serial_number": "L-1", "base_version": 1, "reason": "a better name"}
    play.expect(200, "PUT", f"/api/machines/{machine['id']}", change)
    play.expect(409, "PUT", f"/api/machines/{machine['id']}", change)
    play.expect(200, "GET", f"/api/machines/{machine['id']}/versions")
    axis = play.expect(201, "POST", "/api/axes", {"machine": machine["id"], "name": "Z", "kind": "linear", "notes": "",
                                                  "limits": [{"parameter": "A", "value": 10}]}).json()
    play.expect(200, "GET", "/api/axes")
    play.expect(200, "GET", f"/api/axes/{axis['id']}")
    play.expect(200, "PUT", f"/api/axes/{axis['id']}", {"machine": machine["id"], "name": "Z", "kind": "linear",
                                                        "limits": [], "notes": "", "base_version": 1, "reason": ""})
    play.expect(200, "GET", f"/api/axes/{axis['id']}/versions")
    play.expect(200, "GET", f"/api/axes/{axis['id']}/trend?parameters=A,E,R,B&limit=10")
    laser = {"role": "Laser interferometer", "manufacturer": "Someone", "type": "L1", "serial_number": "7",
             "certificate": "C-1", "calibrated_on": "2026-01-01", "calibration_due": "2027-01-01", "inputs": {},
             "notes": ""}
    instrument = play.expect(201, "POST", "/api/instruments", laser).json()
    play.expect(200, "GET", "/api/instruments")
    play.expect(200, "GET", f"/api/instruments/{instrument['id']}")
    play.expect(200, "PUT", f"/api/instruments/{instrument['id']}", {**laser, "base_version": 1, "reason": "due"})
    play.expect(200, "GET", f"/api/instruments/{instrument['id']}/versions")
    tested = [axis for machine in machines for axis in machine["axes"]]
    if tested:
        trend = play.expect(200, "GET", f"/api/axes/{tested[0]['id']}/trend?parameters=A,E,R,B&limit=10").json()
        checks.that("the trend has the tests", len(trend["points"]) > 0, trend)
    audit = play.expect(200, "GET", "/api/audit?limit=100").json()["entries"]
    checks.that("all that was done is in the audit trail", len(audit) >= 10, len(audit))


def plans(play):
    play.expect(200, "POST", "/api/plans/draft", {"request": PLAN})
    play.expect(422, "POST", "/api/plans/draft", {"request": {**PLAN, "to": 0}})
    play.expect(200, "POST", "/api/plans/draft/program", {"request": PLAN, "dialect": "linuxcnc", "options": {}})
    play.expect(200, "POST", "/api/plans/draft/sheet.pdf", {"request": PLAN})
    plan = play.expect(201, "POST", "/api/plans", {"title": "X 500", "axis": None, "request": PLAN}).json()
    number = plan["id"]
    play.expect(200, "GET", "/api/plans")
    play.expect(200, "GET", f"/api/plans/{number}")
    play.expect(200, "PUT", f"/api/plans/{number}", {"title": "X 500 slow", "axis": None, "base_version": 1, "reason": "",
                                                     "request": {**PLAN, "feed": 500}})
    play.expect(200, "GET", f"/api/plans/{number}/versions")
    play.expect(200, "GET", f"/api/plans/{number}/plan.json")
    play.expect(200, "GET", f"/api/plans/{number}/sheet.html?language=de")
    program = play.expect(200, "GET", f"/api/plans/{number}/program?dialect=linuxcnc&unrolled=1")
    play.checks.that("the program moves the axis", b"X" in program.body, program.body[:200])


def tracking(play):
    """From the set-up to the report of seven lines, with lengths of a perfect machine."""
    at = [100, 80, -600]
    setup = {"travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 600, 0]}, "tool_offset_mm": [0, 0, -120],
             "station": {"position_mm": at}}
    wish = {"request": {"setup": setup, "turn_reflector": True, "runs": 2, "seed": 7}}
    draft = play.expect(200, "POST", "/api/tracking/lines", wish).json()
    play.checks.that("seven lines are planned", len(draft["lines"]) == 7, draft["lost"])
    play.expect(200, "POST", "/api/tracking/lines/program", {"plan": draft["plan"], "dialect": "heidenhain"})
    play.expect(200, "POST", "/api/tracking/lines/sheet.pdf", {"plan": draft["plan"]})
    play.expect(422, "POST", "/api/tracking/lines", {"request": {"setup": {}}})
    play.expect(200, "POST", "/api/tracking/station/advice", wish)
    points = play.expect(200, "POST", "/api/tracking/points", wish).json()["points"]
    play.expect(200, "POST", "/api/tracking/points/sheet.html", wish)
    places = [point["reflector"] for point in points]
    rows = [[*place, math.dist(place, at) - math.dist(places[0], at)] for place in places]
    table = "\n".join(["x_mm,y_mm,z_mm,length_difference_mm", *(",".join(map(repr, row)) for row in rows)]).encode()
    found = play.expect(200, "POST", "/api/tracking/station", table, {"X-File-Name": "points.csv"}).json()
    play.checks.that("the station is found", math.dist(found["refined"]["station"], at) < 0.01, found["refined"])
    station = play.expect(200, "POST", "/api/tracking/station/report.json", table).body
    lengths = "\n".join(["line,target,direction,run,length_difference_mm", *(
        f"{line['id']},{k + 1},{way},{run},{math.dist(place, at)!r}" for line in draft["lines"] for run in (1, 2)
        for way in ("up", "down") for k, place in enumerate(line["targets"]))]).encode()
    sent = form((b'name="plan"; filename="lines.json"', json.dumps(draft["plan"]).encode()),
                (b'name="station"; filename="station.json"', station), (b'name="lengths"; filename="lengths.csv"', lengths),
                (b'name="options"', b'{"tolerances": ["E=5um"]}'))
    lines = play.expect(200, "POST", "/api/tracking/evaluation", *sent).json()["lines"]
    play.checks.that("all lines conform", all(line["test"]["verdict"] == "conforms" for line in lines),
                     [line["test"].get("tolerances") for line in lines][:1])
    play.expect(200, "POST", "/api/tracking/evaluation/report.pdf", *sent)
    play.expect(413, "POST", "/api/tracking/station", bytes(300 << 10), {"X-File-Name": "points.csv"})


def calibrations(play):
    """Kept with their files, evaluated again, compared, withdrawn and brought back."""
    measured = pathlib.Path(__file__).resolve().parent.parent / "transcripts" / "volumetric.files"
    lengths, machine = ((measured / name).read_bytes() for name in ("lengths.csv", "machine.json"))
    sent = form((b'name="kind"', b"volumetric"), (b'name="about"', b'{"title": "before"}'), (b'name="options"', b'{"spans": 3}'),
                (b'name="lengths"; filename="lengths.csv"', lengths), (b'name="machine"; filename="machine.json"', machine))
    kept = play.expect(201, "POST", "/api/calibrations", *sent).json()
    play.checks.that("its figures are of the volume", kept["figures"][0]["parameter"] == "volume_largest", kept["figures"])
    first, path = kept["id"], f"/api/calibrations/{kept['id']}"
    second = play.expect(201, "POST", "/api/calibrations", *sent).json()["id"]
    play.checks.that("both are listed", play.expect(200, "GET", "/api/calibrations?kind=volumetric").json()["total"] == 2)
    again = play.expect(201, "POST", f"{path}/versions", {"base_version": 1, "options": {"spans": 4}, "reason": "finer"}).json()
    play.checks.that("a version more", again["version"] == 2 and len(again["versions"]) == 2, again["versions"])
    play.expect(409, "POST", f"{path}/versions", {"base_version": 1, "title": "other"})
    play.expect(422, "POST", f"{path}/versions", {"base_version": 2, "options": {"spans": 0}})
    play.checks.that("its files are as they came", play.expect(200, "GET", f"{path}/files/lengths").body == lengths)
    play.expect(200, "GET", f"{path}/report.pdf")
    play.expect(200, "GET", f"{path}/report.json?version=1")
    play.expect(200, "GET", f"{path}/comparison?with={second}")
    play.expect(200, "POST", f"{path}/withdraw", {"reason": "wrong machine"})
    play.expect(409, "POST", f"{path}/withdraw", {"reason": "wrong machine"})
    play.expect(200, "POST", f"{path}/reinstate", {"reason": "it was the right one"})
    play.checks.that("it is back", not play.expect(200, "GET", path).json()["withdrawn"])
    play.expect(404, "GET", f"/api/calibrations/{first + 99}")


def motions(play):
    """Readings of a straightness that are looked at and not kept."""
    readings = b"# error: EYX\nposition_mm,run,straightness_um\n0,1,0.1\n100,1,0.6\n200,1,0.2\n300,1,-0.3\n"
    sent = form((b'name="readings"; filename="y.csv"', readings))
    told = play.expect(200, "POST", "/api/motions", *sent).json()
    play.checks.that("it is a straightness", told["result"] == "straightness", told)
    play.expect(200, "POST", "/api/motions/report.pdf", *sent)
    play.expect(422, "POST", "/api/motions", *form((b'name="readings"; filename="y.csv"', b"no table")))


def dynamic(play):
    """A recording without standstills, which is looked at and not kept."""
    recording = "time_s,position_mm\n" + "".join(f"{k / 1000:.3f},{k / 100:.4f}\n" for k in range(2000))
    sent = recording.encode(), {"X-File-Name": "run.csv"}
    told = play.expect(200, "POST", "/api/dynamic", *sent).json()
    play.checks.that("its velocity is told", abs(told["velocity_per_s"]["highest"]["value"] - 10) < 0.1, told["velocity_per_s"])
    for path in ("report.pdf", "series.csv", "spectrum.csv"):
        play.expect(200, "POST", f"/api/dynamic/{path}", *sent)
    play.expect(422, "POST", "/api/dynamic", b"no recording", {"X-File-Name": "run.csv"})


def coordinates(play):
    """Points from the lengths of several stations, and from lengths and angles; nothing is kept."""
    transcripts = pathlib.Path(__file__).resolve().parent.parent / "transcripts"
    ranges = (transcripts / "tracking-multilaterate.files/ranges.csv").read_bytes()
    nominal = (transcripts / "tracking-multilaterate.files/nominal.csv").read_bytes()
    of_lengths = form((b'name="ranges"; filename="ranges.csv"', ranges), (b'name="points"; filename="nominal.csv"', nominal))
    found = play.expect(200, "POST", "/api/tracking/multilateration", *of_lengths).json()
    play.checks.that("there are points", len(found["points"]) > 3, found)
    for path in ("report.pdf", "points", "residuals"):
        play.expect(200, "POST", f"/api/tracking/multilateration/{path}", *of_lengths)
    tracker = (transcripts / "tracking-polar.files/tracker.csv").read_bytes()
    of_angles = form((b'name="readings"; filename="tracker.csv"', tracker), (b'name="options"', b'{"instruments": ["leica-at901"]}'))
    found = play.expect(200, "POST", "/api/tracking/polar", *of_angles).json()
    play.checks.that("there are points of angles", len(found["points"]) > 3, found)
    for path in ("report.pdf", "points"):
        play.expect(200, "POST", f"/api/tracking/polar/{path}", *of_angles)


def assembly(play):
    """Errors measured one by one as a model of the machine, which is not kept."""
    singles = pathlib.Path(__file__).resolve().parent.parent / "transcripts/volumetric-assemble.files"
    parts = [(b'name="errors"; filename="' + name + b'"', (singles / name.decode()).read_bytes())
             for name in (b"exx.csv", b"eyx.csv", b"ecx.csv", b"exy.csv")]
    parts.append((b'name="machine"; filename="machine.json"', (singles / "machine.json").read_bytes()))
    options = {"errors": ["EXX=exx.csv", "EYX=eyx.csv", "ECX=ecx.csv", "EXY=exy.csv", "C0Y=-12.5,1.2"],
               "at": ["X=0,300,-200@short", "Y=500,0,-200@short"], "instruments": ["EYX=0.4,0.5"]}
    sent = form(*parts, (b'name="options"', json.dumps(options).encode()))
    made = play.expect(200, "POST", "/api/volumetric/assembly", *sent).json()
    play.checks.that("a model is made of them", made["curves"] and made["model"], made)
    play.expect(200, "POST", "/api/volumetric/assembly/report.pdf", *sent)


def compensations(play):
    """A table made of a test, kept, proved by another test, drawn, withdrawn and brought back."""
    measured = pathlib.Path(__file__).resolve().parent.parent / "transcripts" / "store-compensations.files"
    test, again = (play.expect(201, "POST", "/api/tests", (measured / name).read_bytes(), {"X-File-Name": name}).json()
                   for name in ("x.csv", "after.csv"))
    axis = play.expect(200, "GET", f"/api/tests/{test['id']}").json()["axis"]["id"]
    controls = play.expect(200, "GET", "/api/controls").json()
    play.checks.that("there are controls", len(controls) > 20 and any(c["id"] == "linuxcnc" for c in controls), controls)
    options = (b'name="options"', b'{"control": "linuxcnc"}')
    made = play.expect(200, "POST", f"/api/tests/{test['id']}/compensation", *form(options)).json()
    play.checks.that("the prediction is better", made["result"]["predicted"]["E"] < made["result"]["before"]["E"], made["result"])
    table = (b'name="table"; filename="x.comp"', made["table"].encode())
    read = play.expect(200, "POST", "/api/controls/linuxcnc/table", *form((b'name="options"', b'{"axis": "X"}'), table)).json()
    play.checks.that("it is read as it was made", read["table"] == made["result"]["table"], read["table"][:2])
    play.expect(404, "POST", "/api/controls/nobody/table", *form(table))
    play.expect(422, "POST", "/api/controls/linuxcnc/table", *form((b'name="table"; filename="x.comp"', b"1 2")))
    play.expect(422, "POST", f"/api/tests/{test['id']}/compensation", *form((b'name="options"', b'{"control": "linuxcnc", "stop": 1}')))
    kept = play.expect(201, "POST", f"/api/tests/{test['id']}/compensations", *form(options, (b'name="notes"', b"new screw"))).json()
    path = f"/api/compensations/{kept['id']}"
    play.checks.that("the table is the one that was looked at", kept["table"] == made["table"], kept["table"][:80])
    play.checks.that("its bytes", play.expect(200, "GET", f"{path}/files/table").body == made["table"].encode())
    play.expect(404, "GET", f"{path}/files/existing")
    proved = play.expect(201, "POST", f"{path}/versions", {"base_version": 1, "retest": again["id"], "reason": "loaded"}).json()
    play.checks.that("the re-test is linked", proved["retest"]["id"] == again["id"] and "retest" in proved["result"], proved["retest"])
    play.checks.that("and its figures", all(f["retest"] is not None for f in proved["figures"]), proved["figures"])
    play.expect(409, "POST", f"{path}/versions", {"base_version": 1, "notes": "other"})
    play.expect(422, "POST", f"{path}/versions", {"base_version": 2, "retest": test["id"]})
    for asked in (f"test={test['id']}", f"test={again['id']}", f"axis={axis}"):
        listed = play.expect(200, "GET", f"/api/compensations?{asked}").json()["compensations"]
        play.checks.that(f"found by {asked}", [row["id"] for row in listed] == [kept["id"]], listed)
    play.expect(200, "GET", f"{path}?version=1&language=de")
    play.expect(200, "GET", f"{path}/report.pdf")
    play.expect(200, "GET", f"{path}/report.json?version=1")
    play.expect(200, "POST", f"{path}/withdraw", {"reason": "wrong control"})
    play.expect(409, "POST", f"{path}/withdraw", {})
    play.expect(200, "POST", f"{path}/reinstate", {"reason": "it was the right one"})
    play.checks.that("it is back", not play.expect(200, "GET", path).json()["withdrawn"])
    play.expect(404, "GET", f"/api/compensations/{kept['id'] + 99}")


def volumetric(play):
    """From the machine to tables for a control, with lengths of a perfect machine."""
    machine = {"chain": "XFYZ", "travel_mm": {"X": [0, 800], "Y": [0, 500], "Z": [-500, 0]},
               "tools_mm": {"T1": [0, 0, -120], "T2": [60, 0, -120], "T3": [0, 60, -240]},
               "stations_mm": {"S1": [-100, -50, -700], "S2": [900, -50, -800], "S3": [900, 600, -700], "S4": [-100, 600, -850]}}
    wish = {"machine": machine, "points": 30, "limits": {"incidence_most_deg": 85}}
    draft = play.expect(200, "POST", "/api/volumetric/plan", wish).json()
    plan = draft["plan"]
    play.checks.that("all errors will be told", draft["expected"]["unseen"] == [], draft["expected"]["reasons"])
    play.expect(200, "POST", "/api/volumetric/plan/program", {"plan": plan, "dialect": "heidenhain", "options": {"part": 2}})
    play.expect(200, "POST", "/api/volumetric/plan/sheet.pdf", {"plan": plan})
    play.expect(422, "POST", "/api/volumetric/plan", {"machine": {}})
    rows = [f"{run['station']},{run['tool']},{','.join(map(repr, stop['at_mm']))},"
            + repr(math.dist([q + t for q, t in zip(stop["at_mm"], machine["tools_mm"][run["tool"]])],
                             machine["stations_mm"][run["station"]]) + 0.0001 * (k % 3 - 1))
            for run in plan["runs"] for k, stop in enumerate(run["stops"])]
    sent = form((b'name="machine"; filename="machine.json"', json.dumps(machine).encode()),
                (b'name="lengths"; filename="lengths.csv"', "\n".join(["station,tool,x_mm,y_mm,z_mm,length_mm", *rows]).encode()))
    result = play.expect(200, "POST", "/api/volumetric/identification", *sent).json()
    play.checks.that("all errors are found", result["unseen"] == [], result["findings"])
    play.expect(200, "POST", "/api/volumetric/identification/residuals", *sent)
    play.expect(200, "POST", "/api/volumetric/identification/report.pdf", *sent)
    play.expect(200, "POST", "/api/volumetric/result", {"result": result})
    own = {"title": "Reversal error", "note": "Findings"}
    shown = play.expect(200, "POST", "/api/volumetric/result?language=de", {"result": {**result, **own}}).json()
    play.checks.that("members of a user in a result stay", {name: shown[name] for name in own} == own,
                     (shown["title"], shown["note"]))
    model = result["model"]
    play.expect(200, "POST", "/api/volumetric/field", {"model": model, "nodes": 3})
    play.expect(200, "POST", "/api/volumetric/difference", {"before": model, "after": model, "nodes": 3})
    play.expect(200, "POST", "/api/volumetric/prediction", {"model": model, "axis": "Y", "at_mm": [400, 0, -250], "tool": "T1"})
    play.expect(200, "POST", "/api/volumetric/table", {"model": model, "table": "axis-csv", "tool": "T1"})
    play.expect(200, "POST", "/api/volumetric/compensation",
                {"model": model, "along": "X", "tool": "T1", "options": {"control": "linuxcnc"}})


def captures(play):
    if play.server.request("GET", "/api/sources").status == 404:
        return
    play.expect(200, "GET", "/api/sources")
    play.expect(200, "GET", "/api/captures")
    play.expect(404, "GET", "/api/captures/99")
    plan = play.expect(200, "GET", "/api/plans").json()["plans"][0]["id"]
    begun = play.expect(201, "POST", "/api/captures", {"plan": plan, "source": "simulator", "layout": "",
                                                       "options": {"speed": "60"}}).json()
    if "id" in begun:
        play.expect(200, "GET", f"/api/captures/{begun['id']}?after=0")
        play.expect(409, "POST", f"/api/captures/{begun['id']}/keys", {"key": "take"})
        play.expect(422, "POST", f"/api/captures/{begun['id']}/keys", {"key": "enter"})
        play.expect(200, "POST", f"/api/captures/{begun['id']}/stop", {})
    captured_lengths(play)


@contextlib.contextmanager
def instrument():
    """Sends a reading of 1.5 µm fifty times a second to whoever connects; gives the source that the program is told."""
    with socket.create_server(("127.0.0.1", 0)) as listener:
        def serve():
            with contextlib.suppress(OSError):
                while True:
                    peer, _ = listener.accept()
                    with peer, contextlib.suppress(OSError):
                        peer.sendall(b"time_s,straightness_um\n")
                        for k in range(1_000_000):
                            peer.sendall(f"{k / 50:.2f},1.5\n".encode())
                            time.sleep(0.02)

        threading.Thread(target=serve, daemon=True).start()
        yield f"laser=tcp://127.0.0.1:{listener.getsockname()[1]}"


def captured_readings(play):
    """A straightness: what is said at the stops counts once the instrument is heard."""
    request = {**PLAN, "positions": [50, 100, 150], "cycle": "unidirectional", "runs": 1, "further": {"error": "EYX"}}
    plan = play.expect(201, "POST", "/api/plans", {"title": "EYX", "axis": None, "request": request}).json()["id"]
    begun = play.expect(201, "POST", "/api/captures", {"plan": plan, "source": "laser", "options": {"stops": "keys"}}).json()
    path = f"/api/captures/{begun['id']}"
    for _ in range(600):
        if play.server.request("GET", path).json()["state"] == "running":
            break
        time.sleep(0.05)
    play.expect(200, "POST", f"{path}/keys", {"key": "skip"})
    play.expect(200, "POST", f"{path}/stop", {})
    simulated_readings(play, plan)


def simulated_readings(play, plan):
    """The same with the simulator, however the stops are told; what it made says so."""
    wish = {"plan": plan, "source": "simulator", "options": {"stops": "keys", "speed": 60, "seed": 7, "size": 8}}
    play.expect(422, "POST", "/api/captures", {**wish, "options": {**wish["options"], "size": 0}})
    play.expect(422, "POST", "/api/captures", {**wish, "options": {**wish["options"], "stream-axis": 2}})
    for stops in ("keys", "trigger", "readings", "position"):
        begun = play.expect(201, "POST", "/api/captures", {**wish, "options": {**wish["options"], "stops": stops}}).json()
        path = f"/api/captures/{begun['id']}"
        for _ in range(1200):
            capture = play.server.request("GET", path).json()
            if capture["state"] not in ("waiting", "running"):
                break
            if stops == "keys" and capture["now"] and capture["now"]["at_rest"] and not capture["motion"]["is_reading"]:
                play.server.request("POST", f"{path}/keys", {"key": "take"})
            time.sleep(0.05)
        play.checks.that(f"the simulated readings told by {stops} are all there",
                         capture["state"] == "complete" and capture["taken"] == 3, capture)
        table = play.expect(200, "GET", f"{path}/files/readings").body.decode()
        play.checks.that("their table says that they were simulated",
                         "# test.comment: Simulated, not measured: fault good, size 8 um; seed 7\n" in table, table)


def captured_lengths(play):
    plan = play.expect(200, "POST", "/api/volumetric/plan", {
        "machine": {"chain": "XFYZ", "travel_mm": {"X": [0, 800], "Y": [0, 500], "Z": [-500, 0]}, "tools_mm": {"T1": [0, 0, -120]},
                    "stations_mm": {"S1": [-100, -50, -700]}},
        "limits": {"incidence_most_deg": 85}, "points": 6, "dwell_s": 2, "feed_mm_per_min": 20000}).json()["plan"]
    subject = {"kind": "volume", "plan": plan, "part": 1}
    play.expect(422, "POST", "/api/captures", {"lengths": {**subject, "part": 2}, "source": "simulator"})
    begun = play.expect(201, "POST", "/api/captures", {"lengths": subject, "source": "simulator", "options": {"speed": "60"}}).json()
    if "id" not in begun:
        return
    path = f"/api/captures/{begun['id']}"
    for _ in range(300):
        state = play.expect(200, "GET", path).json()["state"]
        if state not in ("waiting", "running"):
            break
        time.sleep(0.1)
    play.checks.that("the lengths of a part are captured", state == "complete", state)
    play.expect(200, "GET", f"{path}/plan")
    parts = play.expect(200, "POST", "/api/captures/parts", subject).json()
    play.checks.that("the capture is found by its plan", len(parts["captures"]) == 1, parts)
    play.expect(200, "GET", f"{path}/files/raw")
    play.expect(404, "GET", f"{path}/files/order")
    play.expect(200, "POST", "/api/captures/lengths", {"captures": [begun["id"]]})
    play.expect(422, "POST", "/api/captures/lengths", {"captures": []})
    play.expect(200, "POST", f"{path}/discard", {})
    play.expect(404, "POST", f"{path}/discard", {})


def examples(play, program, folder):
    """Into an empty archive only, and once."""
    play.expect(409, "POST", "/api/examples", {})
    with Served(program, pathlib.Path(folder) / "examples.db") as server:
        fresh = Play(server, play.checks)
        loaded = fresh.expect(201, "POST", "/api/examples", {}).json()
        listed = fresh.expect(200, "GET", "/api/tests").json()
        play.checks.that("as many tests are loaded as are told", loaded["tests"] == listed["total"], loaded)
        fresh.expect(409, "POST", "/api/examples", {})


def main():
    program = str(pathlib.Path(sys.argv[1]).resolve())
    checks = Checks()
    with tempfile.TemporaryDirectory() as folder:
        store = sys.argv[3] if sys.argv[2:3] == ["--store"] else pathlib.Path(folder) / "api.db"
        with instrument() as source, Served(program, store, "--source", source) as server:
            play = Play(server, checks)
            service(play)
            faults_are_seen(play)
            words_of_users(play)
            test = tests(play)
            reports(play, test)
            equipment(play)
            plans(play)
            tracking(play)
            calibrations(play)
            motions(play)
            dynamic(play)
            coordinates(play)
            assembly(play)
            compensations(play)
            volumetric(play)
            captures(play)
            captured_readings(play)
            examples(play, program, folder)
            described = {(method.upper(), path) for path, operations in OPENAPI["paths"].items() for method in operations}
            played = {(method, path) for method, path, status in DESCRIPTION.answered if status < 400}
            rest = sorted(described - played)
            checks.that("every operation was played", not rest, rest)
            undescribed = sorted(set(open_objects()) - GIVEN_BACK)
            checks.that("every member of an answer is described", not undescribed, undescribed)
    checks.finish()


if __name__ == "__main__":
    main()
