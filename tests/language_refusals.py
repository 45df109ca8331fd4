# SPDX-License-Identifier: Apache-2.0
"""Wrong files and wrong requests, and the English words in what the workbench answers to them in other languages."""
import json
import pathlib
import re
import sys
import tempfile
import urllib.parse

import language_documents

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests/server"))
from served import Served  # noqa: E402

HEAD = b"target_mm,direction,run,deviation_um\n"
EXAMPLE = (ROOT / "examples/iso230-2-table2.json").read_bytes()
RECORDING = (ROOT / "tests/transcripts/capture.files/run.csv").read_bytes()
QUESTION = (ROOT / "tests/transcripts/convert.files/ecarts.csv").read_bytes()


def changed(**series):
    """The example with other members of its series; None takes one away."""
    test = json.loads(EXAMPLE)
    test["series"].update(series)
    test["series"] = {key: value for key, value in test["series"].items() if value is not None}
    return json.dumps(test).encode()


WRONG_FILES = {
    "blank.csv": b"  \n\n", "picture.png": b"\x89PNG\r\n\x1a\n\x00\x00\x00\rIHDR" + bytes(100), "list.txt": b"milk\nbread\n",
    "paper.pdf": b"%PDF-1.7\n1 0 obj\n<<>>\nendobj\n", "sheet.xlsx": b"PK\x03\x04" + b"\x14\x00\x06\x00" * 30,
    "half.json": EXAMPLE[:len(EXAMPLE) // 2], "comma.json": b'{"a":1,}', "list.json": b"[1,2]",
    "other.json": b'{"hello":1}', "unit.json": changed(unit=None), "furlong.json": changed(unit="furlong"),
    "short.json": changed(up=[[1, 2]]), "words.json": changed(targets=["a", "b"]), "member.json": changed(foo=1),
    "plan.json": (ROOT / "tests/transcripts/capture.files/x.plan.json").read_bytes(), "nothing.csv": HEAD,
    "sideways.csv": HEAD + b"0,sideways,1,1\n", "abc.csv": HEAD + b"0,up,1,abc\n", "run.csv": HEAD + b"0,up,0,1\n",
    "twice.csv": HEAD + b"0,up,1,1\n0,up,1,2\n", "cut.csv": HEAD + b"0,up,1,1\n0,up\n", "wide.csv": HEAD + b"0,up,1,1,5\n",
    "marks.csv": b"target_mm;direction;run;deviation_um\n0,0;up;1;1,5\n100.0;up;1;1.5\n",
    "units.csv": b"target_mm,direction,run,deviation_um,deviation_mm\n0,up,1,1,1\n",
    "unitless.csv": b"target,direction,run,deviation\n0,up,1,1\n100,up,1,1\n", "bare.csv": b"0,up,1,1\n100,up,1,2\n",
    "quote.csv": HEAD + b'"0,up,1,1\n', "huge.csv": HEAD + b"0,up,1,1e12\n", "key.csv": b"# machin: x\n" + HEAD + b"0,up,1,1\n",
    "rotary.csv": b"# axis.kind: rotary\n" + HEAD + b"0,up,1,1\n100,up,1,1\n", "nul.csv": HEAD + b"0,up,1,1\x000\n",
    "blanks.csv": b"target_mm direction run deviation_um\n0 up 1 1\n", "recording.csv": RECORDING, "question.csv": QUESTION,
    "database.db": b"SQLite format 3\x00" + bytes(200), "page.html": b"<html><body>no</body></html>",
}
DRAFT = {"axis": "X", "kind": "linear", "from": 0, "to": 500, "positions": None, "targets": None, "cycle": "standard",
         "runs": 5, "feed": 1000, "dwell_s": 4, "overrun": None, "seed": 7, "further": {}}
WRONG_PLANS = [{"from": 500, "to": 0}, {"to": "x"}, {"kind": "foo"}, {"cycle": "foo"}, {"runs": 0}, {"feed": 0},
               {"dwell_s": -1}, {"overrun": 300}, {"targets": 1}, {"positions": [1, 1]}, {"positions": "x"}, {"to": 1e9},
               {"further": {"acceleration": "x"}}, {"further": {"foo": "1"}}, {"cycle": "user-defined"}]
SETUP = {"travel": {"lowest_mm": [0, 0, -500], "highest_mm": [800, 600, 0]}, "station": {"position_mm": [100, 80, -400]}}
WRONG_LINES = [{"setup": {}}, {"setup": 5}, {"setup": {**SETUP, "station": "here"}}, {"setup": {**SETUP, "colour": 1}},
               {"setup": {**SETUP, "travel": {"lowest_mm": [0, 0, 0], "highest_mm": [0, 1, 1]}}}, {"runs": 0}, {"runs": 1e6},
               {"setup": {**SETUP, "station": {"position_mm": [9e5, 0, 0]}}}, {"turn_reflector": "yes"}, {"rule": "foo"},
               {"setup": {**SETUP, "obstacles": [{"name": "a"}] * 2}}, {"lines": ["foo"]}, {"lines": ["x"] * 60},
               {"targets": 9000, "runs": 2}, {"targets": 1}, {"periods_mm": [1]}, {"periods_mm": [-1, None, None]},
               {"seed": 0.5}, {"step_mm": 0}, {"feed": 0}, {"machine": "x" * 600}, {"foo": 1}, {"overrun_mm": 900},
               {"setup": {**SETUP, "obstacles": [{"sphere": {"centre_mm": [1, 1, 1], "radius_mm": 1}}] * 101}},
               {"setup": {**SETUP, "ranging": {"constant_um": 0, "per_length_um_per_m": 0}}}]
WRONG_POINTS = [b"", b"x_mm,y_mm\n1,2\n", b"x_mm,y_mm,z_mm,length_difference_mm\n1,2,three,4\n",
                b"x_mm,y_mm,z_mm,length_difference_mm\n1,2,3,4\n"]


def form(**parts):
    """A form of files, and of options without a file name."""
    text = ""
    for name, content in parts.items():
        file = "" if name in ("options", "about", "kind") else f'; filename="{name}.x"'
        text += f'--b\r\nContent-Disposition: form-data; name="{name}"{file}\r\n\r\n{content}\r\n'
    return (text + "--b--\r\n").encode()


MACHINE = (ROOT / "tests/transcripts/volumetric.files/machine.json").read_text(encoding="utf-8")
WRONG_FORMS = [form(lengths="a"), form(plan="{}"), form(plan="{}", lengths="a"), form(colour="red"), form(options="{"),
               form(options='{"foo": 1}'), form(options='{"tolerances": ["Q=1um"]}'), form(options='{"rule": "foo"}'),
               form(options='{"tolerances": ["A=1um", "A=2um"]}'), form(options='{"break_threshold_mm": 0}'),
               form(options='{"reversed": 1}'), form(options=json.dumps({"tolerances": ["A=1um"] * 300})), b"",
               form(plan=""), form(plan="{}").replace(b'; filename="plan.x"', b"")]
WRONG_FILES_OF_FORMS = [form(a="a", options="{}"), form(a="a", profile="{}"), form(a="")]
WRONG_CALIBRATIONS = [form(kind="x"), form(kind="lines", lengths="a"), form(kind="lines", photo="a"), form(colour="red"),
                      form(kind="volumetric", lengths="a"), form(about="{"), form(about='{"foo": 1}'),
                      form(about='{"measured_on": "soon"}'), form(about='{"machine": "x"}'),
                      *(form(kind="volumetric", lengths="a", machine="{}", options=options) for options in (
                          '{"spans": 0}', '{"spans": [1]}', '{"curves": "x"}', '{"find_breaks": 1}', '{"foo": 1}'))]
RANGES = "station,point,length_mm,x_mm,y_mm,z_mm\nA,1,100,0,0,0\n"
WRONG_RANGES = [form(colour="red"), form(points="a"), b"", *(form(ranges=RANGES, options=options) for options in (
    "{", '{"foo": 1}', '{"scale": "x"}', '{"scale_prior_ppm": 1}', '{"scale_prior_ppm": 0}', '{"scale": "free", "scale_prior_ppm": 0}',
    '{"ranging": "x"}', '{"ranging": "0um"}', '{"repeatability": "-1um"}', '{"repeatability": "x"}', '{"find_breaks": 1}'))]
WRONG_POLAR = [form(colour="red"), form(points="a"), b"", *(form(readings=RANGES, options=options) for options in (
    '{"instruments": ["=x"]}', '{"instruments": ["x"]}', '{"ranging": "leica-at901"}', '{"angles": "x"}', '{"in_station": true}'))]
WRONG_SINGLES = [form(colour="red"), form(errors="a"), form(machine="{}"), b"", *(form(machine=MACHINE, errors="a", options=options) for options in (
    '{"errors": []}', '{"errors": ["x"]}', '{"errors": ["EXX=other.x"]}', '{"errors": ["EXX=errors.x"], "at": ["x"]}', '{"errors": ["C0Y=1,1"]}',
    '{"errors": ["EXX=errors.x"], "instruments": ["EYX=1"]}', '{"errors": ["EXX=errors.x"], "reversal": "constant"}'))]
WRONG_MOTIONS = ['{"kind": "x"}', '{"stream": "x"}', '{"rate_hz": 0}', '{"stream_axis": 0}', '{"window_s": 0}', '{"even_percent": 51}',
                 '{"skip_damaged": 1}', '{"foo": 1}', '{"from_s": "x"}']
ENGLISH = re.compile(r"(?<![\w\"„'.-])(?:found|expected|the|of|with|and|one|not|no|is|are|must|some|twice|beside|from|to|by|"
                     r"whole|number|which|without|below|above|least|each|they|there|than)(?![\w\"“'.=-])")


def answers(program, tag):
    """What it answers in that language, with what it answers to."""
    accepted = {"Accept-Language": tag}
    with tempfile.TemporaryDirectory() as folder, Served(program, pathlib.Path(folder) / "store.axm") as server:
        def ask(method, path, body=None, **headers):
            answer = server.request(method, path, body, {**accepted, **headers}).json()
            refused = answer.get("error") or answer.get("refused")
            return f"{method} {path} {headers.get('X-File-Name', '')}", refused["message"] if refused else ""
        for name, content in WRONG_FILES.items():
            yield ask("POST", "/api/preview", content, **{"X-File-Name": name})
        yield ask("POST", "/api/tests", b"", **{"X-File-Name": "empty.csv"})
        for content in WRONG_FILES_OF_FORMS:
            yield ask("POST", "/api/tests", content, **{"Content-Type": "multipart/form-data; boundary=b"})
        yield ask("POST", "/api/tests", EXAMPLE, **{"X-File-Name": "a.json"})
        yield ask("POST", "/api/preview", bytes(65 << 20), **{"X-File-Name": "large.csv"})
        for change in ({}, {"base_version": 9, "changes": {}}, {"base_version": 1, "changes": {"foo.bar": "1"}},
                       {"base_version": 1, "changes": {"axis.kind": "x"}}, {"base_version": 1, "changes": []}, [1]):
            yield ask("POST", "/api/tests/1/versions", change)
        for change in WRONG_PLANS:
            yield ask("POST", "/api/plans/draft", {**DRAFT, **change})
        for change in WRONG_LINES:
            yield ask("POST", "/api/tracking/lines", {"request": {"setup": SETUP, "turn_reflector": True, **change}})
        for body in ({}, {"request": {"setup": SETUP}, "plan": {}}, {"plan": {}}, {"plan": 5}):
            yield ask("POST", "/api/tracking/lines", body)
        for body in ({}, {"request": {"setup": SETUP}, "count": 0.5}, {"request": {"setup": SETUP}, "count": 99}):
            yield ask("POST", "/api/tracking/points", body)
        yield ask("POST", "/api/tracking/lines/program", {"request": {"setup": SETUP, "turn_reflector": True}, "dialect": "foo"})
        yield ask("POST", "/api/tracking/lines/program", {"request": {"setup": SETUP, "turn_reflector": True},
                                                          "dialect": "fanuc", "line": "foo"})
        yield ask("POST", "/api/tracking/lines/sheet.docx", {"request": {"setup": SETUP, "turn_reflector": True}})
        for content in WRONG_POINTS:
            yield ask("POST", "/api/tracking/station", content, **{"X-File-Name": "points.csv"})
        for options in ('{"foo":1}', '{"machine_sigma_um":-1}', '{"near_mm":[1]}', "{", f'{{"a":"{"x" * 9}"}}'):
            yield ask("POST", "/api/tracking/station?options=" + urllib.parse.quote(options), WRONG_POINTS[3])
        for content in WRONG_FORMS:
            yield ask("POST", "/api/tracking/evaluation", content, **{"Content-Type": "multipart/form-data; boundary=b"})
        yield ask("POST", "/api/tracking/evaluation", b"a", **{"Content-Type": "text/csv"})
        for path, contents in (("tracking/multilateration", WRONG_RANGES), ("tracking/polar", WRONG_POLAR), ("volumetric/assembly", WRONG_SINGLES)):
            for content in contents:
                yield ask("POST", f"/api/{path}", content, **{"Content-Type": "multipart/form-data; boundary=b"})
            yield ask("POST", f"/api/{path}", b"a", **{"Content-Type": "text/csv"})
        for options in WRONG_MOTIONS:
            yield ask("POST", "/api/dynamic?options=" + urllib.parse.quote(options), RECORDING, **{"X-File-Name": "run.csv"})
        yield ask("POST", "/api/motions", form(kind="straightness", options='{"offset_mm": [1e6, 0, 0]}', readings="a"),
                  **{"Content-Type": "multipart/form-data; boundary=b"})
        for content in WRONG_CALIBRATIONS:
            yield ask("POST", "/api/calibrations", content, **{"Content-Type": "multipart/form-data; boundary=b"})
        yield ask("POST", "/api/calibrations", b"a", **{"Content-Type": "text/csv"})
        for path in ("/api/calibrations?kind=x", "/api/calibrations?order=x", "/api/calibrations/99",
                     "/api/calibrations/1/comparison", "/api/calibrations/99/files/plan"):
            yield ask("GET", path)
        for query in ("sha256=x", "machine=0", "from=2026-02-02&to=2026-01-01"):
            yield ask("GET", f"/api/tests?{query}")
        yield ask("GET", "/api/audit?subject=x")
        for path in ("/api/tests/99", "/api/machines/99", "/api/nothing", "/api/tests?limit=abc", "/api/tests/1/report.docx"):
            yield ask("GET", path)
        for body in ({}, {"name": ""}, {"name": 5}, {"name": "x" * 5000}):
            yield ask("POST", "/api/machines", body)
        yield ask("GET", "/api/tests", None, Host="evil.example")
        yield ask("POST", "/api/tests", EXAMPLE, Origin="http://evil.example")


def english_refusals(program):
    """ "language, request: words in 'message'" for each that is not wholly in that language."""
    told = []
    for tag in language_documents.LANGUAGES:
        seen = 0
        for request, message in answers(program, tag):
            seen += message != ""
            # `to` in front is a member of the request, not a word.
            found = sorted(set(ENGLISH.findall(re.sub(r'"[^"]*"|^to\s?:', " ", message))))
            if found:
                told.append(f"{tag}, {request}: {', '.join(found)} in '{message}'")
        if seen < 60:
            raise SystemExit(f"found {seen} refusals, expected at least 60")
    return told
