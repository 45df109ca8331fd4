# SPDX-License-Identifier: Apache-2.0
"""Wrong files and wrong requests, and the English words in what the workbench answers to them in German."""
import json
import pathlib
import re
import sys
import tempfile

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
ENGLISH = re.compile(r"(?<![\w\"„'.-])(?:found|expected|the|of|with|and|one|not|no|is|are|must|some|twice|beside|from|to|by|"
                     r"whole|number|which|without|below|above|least|each|they|there|than)(?![\w\"“'.=-])")


def answers(program):
    """What it answers, with what it answers to."""
    german = {"Accept-Language": "de"}
    with tempfile.TemporaryDirectory() as folder, Served(program, pathlib.Path(folder) / "store.axm") as server:
        def ask(method, path, body=None, **headers):
            answer = server.request(method, path, body, {**german, **headers}).json()
            refused = answer.get("error") or answer.get("refused")
            return f"{method} {path} {headers.get('X-File-Name', '')}", refused["message"] if refused else ""
        for name, content in WRONG_FILES.items():
            yield ask("POST", "/api/preview", content, **{"X-File-Name": name})
        yield ask("POST", "/api/tests", b"", **{"X-File-Name": "empty.csv"})
        yield ask("POST", "/api/tests", EXAMPLE, **{"X-File-Name": "a.json"})
        yield ask("POST", "/api/preview", bytes(65 << 20), **{"X-File-Name": "large.csv"})
        for change in ({}, {"base_version": 9, "changes": {}}, {"base_version": 1, "changes": {"foo.bar": "1"}},
                       {"base_version": 1, "changes": {"axis.kind": "x"}}, {"base_version": 1, "changes": []}, [1]):
            yield ask("POST", "/api/tests/1/versions", change)
        for change in WRONG_PLANS:
            yield ask("POST", "/api/plans/draft", {**DRAFT, **change})
        for path in ("/api/tests/99", "/api/machines/99", "/api/nothing", "/api/tests?limit=abc", "/api/tests/1/report.docx"):
            yield ask("GET", path)
        for body in ({}, {"name": ""}, {"name": 5}, {"name": "x" * 5000}):
            yield ask("POST", "/api/machines", body)
        yield ask("GET", "/api/tests", None, Host="evil.example")
        yield ask("POST", "/api/tests", EXAMPLE, Origin="http://evil.example")


def english_refusals(program):
    """ "request: words in 'message'" for each that is not wholly German."""
    told, seen = [], 0
    for request, message in answers(program):
        seen += message != ""
        found = sorted(set(ENGLISH.findall(re.sub(r'"[^"]*"', " ", message))))
        if found:
            told.append(f"{request}: {', '.join(found)} in '{message}'")
    if seen < 60:
        raise SystemExit(f"found {seen} refusals, expected at least 60")
    return told
