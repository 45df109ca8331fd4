# SPDX-License-Identifier: Apache-2.0
"""Every document of the program in every language, from the examples and the files of the transcripts; and the words
that one shares with the English document though its language has others for them."""
import functools
import html
import json
import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile

import language_pairs

ROOT = pathlib.Path(__file__).resolve().parent.parent
# As the description of the API lists them, which a unit test holds against the program's list.
API = json.loads((ROOT / "apps/server/openapi.json").read_text(encoding="utf-8"))
LANGUAGES = [tag for tag in API["components"]["schemas"]["Language"]["enum"] if tag != "en"]
PLAN = "tracking plan --travel X=0:800,Y=0:600,Z=-500:0 --tool 0,0,-120 --seed 3 --date 2026-11-20"
TRIALS = "--trials 5000 --seed 1"

# Files of a transcript, and the command. {out} is the document; a command without it has a summary alone.
COMMANDS = [
    ("", "evaluate iso230-2-table2.json --report {out}"),
    ("", f"uncertainty iso230-2-table2.json {TRIALS} --tolerance A=10um --rule iso14253-1 --report {{out}}"),
    ("", f"uncertainty iso230-2-table2.csv {TRIALS} --measurand this-machine --report {{out}}"),
    ("", "evaluate iso230-2-table2.csv --tolerance-table tolerance-tables.csv:'Machining centre' "
         "--device-error-range-um-per-m 3.4 --misalignment-mm 1 --environmental-variation 1.7 --report {out}"),
    ("", "evaluate iso230-2-table2.csv iso230-2-table2.json --tolerance A=10um"),
    ("", "evaluate rotary-table.csv --report {out}"),
    ("", "evaluate simulated-backlash.json --report {out}"),
    ("", f"uncertainty simulated-ball-screw.json {TRIALS} --report {{out}}"),
    ("corrections", "evaluate vacuum.csv --correct air=ciddor,dead-path,drift --report {out}"),
    ("expansion", "evaluate warm.csv --nde-correct --report {out}"),
    ("artefact", f"uncertainty gauge.csv {TRIALS} --report {{out}}"),
    ("diagonal", "evaluate xy.csv --report {out}"),
    ("label", "evaluate step.csv --report {out}"),
    ("verdict", "evaluate one-run.csv --tolerance E=5um --report {out}"),
    ("capture", "evaluate run.csv --plan x.plan.json --report {out}"),
    ("capture", "evaluate missed.csv --plan x.plan.json --report {out}"),
    ("convert", "evaluate messung.txt --report {out}"),
    ("", "plan --axis X --machine Mill --travel 0:500 --period 10 --compensation-points 0:500:50 --seed 7 "
         "--out plan.json --sheet {out}"),
    ("", "plan --axis X --travel 0:5000 --seed 7 --out plan.json --sheet {out}"),
    ("", "plan --axis C --travel 0:360 --kind rotary --seed 7 --out plan.json --sheet {out}"),
    ("", "plan --axis X --travel 0:5000 --seed 7 --cycle step --out plan.json --sheet {out}"),
    ("", "plan --axis X --travel 0:800 --seed 7 --periodic 10 --out plan.json --sheet {out}"),
    ("", "plan --axis X --travel 0:800 --seed 7 --cycle pilgrim --warm-up 0 --dwell 0 --out plan.json --sheet {out}"),
    ("periodic", "periodic screw.csv --report {out}"),
    ("periodic", "periodic screw.csv --period 5 --report {out}"),
    ("periodic", "periodic coarse.csv --period 10 --report {out}"),
    ("label", "periodic step.csv --period 450 --report {out}"),
    ("", "periodic rotary-table.csv --report {out}"),
    ("error-motions", "straightness z-of-x.csv --report {out}"),
    ("error-motions", "straightness x-in-y.csv --instrument 0.1 --report {out}"),
    ("error-motions", "squareness x-in-y.csv y-in-x.csv --report {out}"),
    ("error-motions", "angles roll.csv pitch.csv yaw.csv --offset 0,100,250 --instrument 1 --report {out}"),
    ("error-motions", "angles pitch.csv --reference end-points --report {out}"),
    ("", "compare-rules iso230-2-table2.csv --report {out}"),
    ("", "compare-rules rotary-table.csv --report {out}"),
    ("", "compare-rules iso230-2-table2.json --uncertainty monte-carlo --trials 1000 --report {out}"),
    ("", "compare-rules iso230-2-table2.json --uncertainty monte-carlo --trials 1000 "
         "--set uncertainty.measurand=this-machine --report {out}"),
    ("", "compare-rules rotary-table.csv --uncertainty monte-carlo --trials 1000 --report {out}"),
    ("label", "compare-rules step.csv --report {out}"),
    ("verdict", "compare-rules one-run.csv --report {out}"),
    ("temperatures", "temperatures parts.csv --began 2026-03-02T08:30 --ended 2026-03-02T10:00 --highest 20.4 --rate 5 --sensor T1=air --report {out}"),
    ("temperatures", "temperatures parts.csv --lowest 19 --report {out}"),
    ("temperatures", "evaluate iso230-2-table2.json --temperatures parts.csv --began 2026-03-02T08:30 --ended 2026-03-02T10:00 "
                     "--agreed-lowest 20.5 --agreed-highest 20.9 --agreed-rate 0.5 --agreed-gradient 0.1 --report {out}"),
    ("temperatures", "evaluate iso230-2-table2.json --temperatures parts.csv --began 2026-03-02T08:30 --agreed-highest 24 "
                     "--agreed-rate 5 --agreed-gradient 1 --report {out}"),
    ("temperatures", "evaluate iso230-2-table2.json --temperatures parts.csv --sensor T1=machine --sensor T2=machine --report {out}"),
    ("label", "compensate step.csv --for siemens-lec --report {out}"),
    ("", f"{PLAN} --station 100,80,-600 --obstacle vice=box:450,130,-700:550,230,-520 --obstacle "
         "b=sphere:500,300,-300:50 --obstacle c=cylinder:300,500,-600:40:100 --machine Mill --sheet {out}"),
    ("", f"{PLAN} --station 100,-12,-600 --suggest --sheet {{out}}"),
    ("", f"{PLAN} --station 100,80,-600 --locate 6 --sheet {{out}}"),
    ("", f"{PLAN} --station 100,80,-600 --diagonals body --sheet {{out}}"),
    ("", f"{PLAN} --station 100,80,-600 --elevation 0:10 --range 0.5m:0.8m --incidence 20 --sheet {{out}}"),
    ("", f"{PLAN} --station 100,80,-600 --safe-radius 200 --min-length 300 --targets 3 --runs 1 --sheet {{out}}"),
    ("", "tracking plan --travel X=0:800,Y=0:600,Z=-500:0 --tool 0,0,-120 --seed 3 --diagonals body,face --sheet {out}"),
    ("dynamic", "dynamic x-axis.rtx --report {out}"),
    ("dynamic", "dynamic x-axis.rtx --feed 1200 --to 0.4 --report {out}"),
    ("tracking-evaluate", "tracking evaluate diagonals.csv --plan diagonals.json --report {out}"),
    ("tracking-evaluate", "tracking evaluate lengths.csv --plan seven.json --report {out}"),
    ("tracking-evaluate", "tracking evaluate lengths.csv --plan seven.json --tolerance A=10um --tolerance xyz:A=20um "
                          f"--rule iso14253-1 --uncertainty annex-a,gum,monte-carlo {TRIALS} --report {{out}}"),
    ("tracking-locate", "tracking locate points.csv --report {out}"),
    ("tracking-locate", "tracking locate plane.csv --report {out}"),
    ("tracking-locate", "tracking locate misread.csv --report {out}"),
    ("tracking-locate", "tracking locate cone.csv --machine-sigma 2um --report {out}"),
    ("tracking-locate", "tracking locate broken.csv --report {out}"),
    ("tracking-locate", "tracking locate axes.csv --tool 0,0,-150 --near 650,-30,260 --report {out}"),
    ("tracking-multilaterate", "tracking multilaterate ranges.csv --points nominal.csv --report {out}"),
    ("tracking-multilaterate", "tracking multilaterate broken.csv --points nominal.csv --scale common "
                               "--scale-prior 1e-6 --repeatability 1um --report {out}"),
    ("tracking-polar", "tracking polar tracker.csv tracer.csv --instrument leica-at901 "
                       "--instrument TR=etalon-lasertracer --points nominal.csv --report {out}"),
    ("tracking-polar", "tracking polar misread.csv --instrument leica-at901 --report {out}"),
    ("", "tracking instruments --report {out}"),
    ("volumetric-assemble", "volumetric assemble EXX=exx.csv EYX=eyx.csv ECX=ecx.csv EXY=exy.csv C0Y=-12.5,1.2 --machine "
                            "machine.json --at X=0,300,-200@short --at Y=500,0,-200@short --report {out}"),
    ("", "tracking compare-methods --travel X=0:800,Y=0:600,Z=0:500 --station -600,-500,100 --trials 100 "
         "--report {out}"),
    ("", "tracking length-difference --station-error 0.7978,0.2715,0.1965 --distances 100:1100:100 --direction 1,1,1 "
         "--report {out}"),
    ("", "tracking length-difference --distances 200:900:100 --station-uncertainty 0.003,0.003,0.01 --report {out}"),
]

WORD = re.compile(r"[A-Za-zÀ-ÖØ-öø-ÿœ][A-Za-zÀ-ÖØ-öø-ÿœ’'-]{2,}")
# The same in English and in German: words, names of persons, formats and standards, what stands for a value.
SAME = set("""
    Edlén
    Absolute Leica Polar adm ifm
    Amplitude Axiometry Carlo Ciddor DIN Drift Ellipsoid Format GUM ISO Information Interferometer JCGM JSON Lee Linear Median nde Monte
    Multilateration NDE Name Octant Phase Plan Position SHA- Segment Sensor Sensors Simulation Standard Station Student
    Ende Lauf Soll Test UTF- VDI Windows- bar csv- csv-long csv-wide deg eff json kPa linear min normal negative
    positive
    ppm    rad sin therm was Ist Mill generic time-position screw
    BACKLASH EEC SINUMERIK JIS DGQ with-backlash
    XFYZ simulation DEVICE EVE MACHINE MISALIGNMENT PROBING STATION TOOL EXX EYY EZZ ECC xij XYZ xyz
    CALIBRATION RDEVICE RMISALIGNMENT UCALIBRATION UDEVICE UEVE UMISALIGNMENT UPROBING USTATION dfarthest dnearest
""".split())
# Words of two letters that German does not have.
SHORT = set("as at be by if is no of on or to up we".split())
# Words that are English in every language, though a pair may quote them: what a control's file says, names of flags.
ENGLISH = set("""
    and are axis been both by cannot each error expected for found from given has have here is its kind less lengths line lines more moves
    not number of one only reading readings reversal runs target targets than that the there they this to too under was were which with without
""".split())
# What the examples and their files call things, and names of files and of metadata.
NAMES = re.compile(r"\w+[\w-]*\.(?:csv|json|txt|rtx)|[a-z]+\.[a-z_]+|--[a-z-]+|axiometry [a-z]+|this-machine|"
                   r"\"# quantity: position\"|\"Messprotokoll Positionierung\"|Table 2 of ISO 230-2 \(worked example\)|Tilting rotary table \(made up\)|Virtual machine|Fräse 7|Lira & Cargill|"
                   r"Machining centre|(?:leica|api|faro|etalon)-\w+|\b(?:P_?s,|U_?)(?:mean|max)\b|E[A-CX-Z][X-Z]\b|[NP0]{3}-[NP0]{3}|\bvice\b|\bshort\b")


def segments(page):
    """The texts of an HTML page, each between two tags that are not of running text; or the lines of a text."""
    if not page.startswith("<"):
        return page.split("\n")
    page = re.sub(r"<(style|script)[^>]*>.*?</\1>", " ", page, flags=re.S)
    page = re.sub(r'\b(?:alt|aria-label)="([^"]*)"', r">\1<", page)
    page = re.sub(r"</?(?:em|i|b|strong|sub|sup|tspan|span|var)\b[^>]*>", "", page)
    return [html.unescape(text).strip() for text in re.split(r"<[^>]*>", page)]


def words(text):
    text = NAMES.sub(" ", re.sub(r"\b[0-9a-f]{12,64}\b", " ", text))
    return set(WORD.findall(text)) | SHORT.intersection(re.findall(r"(?<![\w-])[a-z]{2}(?![\w-])", text))


@functools.cache
def own_words(tag):
    """Words that a text in that language may share with the English one: of German those of a list, of others those
    that its own side of the pairs has, but for what is English wherever it stands."""
    if tag == "de":
        return frozenset(SAME)
    said = {word for other in language_pairs.program_pairs(tag).values() for word in words(other)}
    pieces = {piece for word in said for piece in re.split(r"[’'-]", word)}
    return frozenset(SAME | ({word for each in said | pieces for word in (each, each.capitalize())} - ENGLISH))


def is_of_the_user(segment, inputs):
    """All of it stands in an input, as "scale | encoder" does."""
    parts = [part.strip() for part in re.split(r"[|;,]", segment)]
    return segment in inputs or all(part in inputs for part in parts)


def shared_words(english, other, tag, inputs):
    """Of each text in that language the words that it shares with the English document."""
    known = set().union(*(words(text) for text in segments(english)))
    for text in segments(other):
        found = (words(text) & known) - own_words(tag)
        if found and not is_of_the_user(text, inputs):
            yield found, text


def made(program, folder, transcript, command):
    """The command's summary, and its document as HTML, by language; and the text of all its inputs."""
    folder.mkdir()
    sources = list((ROOT / "examples").iterdir())
    if transcript:
        sources += (ROOT / f"tests/transcripts/{transcript}.files").iterdir()
    for source in sources:
        shutil.copy(source, folder)
    named = [argument.split(":")[0] for argument in shlex.split(command)]
    inputs = "\n".join(path.read_text(encoding="utf-8", errors="replace").replace("\\n", "\n")
                       for path in folder.iterdir() if path.name in named)
    results = {}
    for language in ("en", *LANGUAGES):
        arguments = shlex.split(command.format(out=f"{language}.html")) + ["--language", language]
        run = subprocess.run([program, *arguments], cwd=folder, capture_output=True, text=True, check=False,
                             env={**os.environ, "COLUMNS": "100", "NO_COLOR": "1"})
        if run.returncode not in (0, 3, 4):
            raise SystemExit(f"found exit code {run.returncode} of axiometry {' '.join(arguments)}: {run.stderr}")
        page = folder / f"{language}.html"
        results[language] = (run.stdout, page.read_text(encoding="utf-8") if page.exists() else "")
    return results, inputs


def english_words(program):
    """ "language, command: words in 'text'" for every text with words that are left English."""
    told = []
    with tempfile.TemporaryDirectory() as scratch:
        for number, (transcript, command) in enumerate(COMMANDS):
            results, inputs = made(program, pathlib.Path(scratch) / str(number), transcript, command)
            for tag in LANGUAGES:
                for what, one, other in zip(("summary", "document"), results["en"], results[tag]):
                    for found, text in shared_words(one, other, tag, inputs):
                        told.append(f"{tag}, {what} of '{command}': {', '.join(sorted(found))} in '{text}'")
    return list(dict.fromkeys(told))
