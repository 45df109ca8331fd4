#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the page and the program call a thing by one word in each language.

Takes every English text of the page's dictionary (web/src) that is also an English phrase of the program's
(src/axiometry/language) and compares what both make of it in German and in French, small and large first letters aside.
Reports also every word that docs/terms.md has another one for (RULED_OUT). Exits with 1 where there is one of either.

    python3 tests/one_vocabulary.py
"""
import json
import pathlib
import re
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
LANGUAGE = ROOT / "src/axiometry/language"
CPP_TEXT = r'"(?:[^"\\]|\\.)*"'
PAGE_TEXT = r"'(?:[^'\\\n]|\\.)*'|\"(?:[^\"\\\n]|\\.)*\""
PAGE_ROW = re.compile(rf"(?:\w|'):\s*\[\s*({PAGE_TEXT}),\s*({PAGE_TEXT})(?:,\s*({PAGE_TEXT}))?,?\s*\]")
# English texts (with their meaning on the page) that say one thing on the page and another in the program.
TWO_MEANINGS = {
    "Instrument",  # one that is kept, or a tracking interferometer
    "none", "All", "other", "Found", "Lost", "as found",  # of words of another gender or number
    "linear [drift]", "From", "To", "After", "Start", "Run",  # of drifts, dates, buttons and approaches, not of trials
    "Kept", "kept", "kept [action]",  # in the archive, not a limit
    "Number", "not told", "Figures", "Figure [picture]", "Interval", "plan", "table [compensation]", "Of", "direction",
    "Notes [findings]", "Missing [fields]", "Missing [findings]", "measured [position]",
    "the machine", "the air",  # "the mean temperature of …"
    "Tracking",  # a page about all of it, not a kind of instrument
}
# Words that are not used since docs/terms.md has another one.
RULED_OUT = {
    "German": ["Unsicherheitsbudget", "Totweg", "Rundachse", "rotatorische Achse", "Wiederholbarkeit", "Wiederholgenauigkeit",
               "Tracking-Interferometer", "Standort", "Umkehrfehler", "Befund"],
    "French": ["trajet mort", "graine", "échauffement", "contributeur", "axe rotatif"],
}


def unescaped(quoted):
    text = re.sub(r"\\u([0-9a-fA-F]{4})", lambda code: chr(int(code.group(1), 16)), quoted[1:-1])
    return re.sub(r"\\(.)", r"\1", text)


def plain(text):
    return text.replace("\u00a0", " ").replace("\u202f", " ")


def first_small(text):
    return text[:1].lower() + text[1:]


def german_of_program():
    phrases = {}
    for path in sorted((LANGUAGE / "german").rglob("*.cpp")):
        row = rf"\{{\s*((?:{CPP_TEXT}\s*)+),\s*((?:{CPP_TEXT}\s*)+)\}}"
        for english, german in re.findall(row, path.read_text(encoding="utf-8")):
            one, other = ("".join(map(unescaped, re.findall(CPP_TEXT, text))) for text in (english, german))
            phrases.setdefault(plain(one), set()).add(plain(other))
    return phrases


def french_of_program():
    phrases, lines = {}, (LANGUAGE / "fr.txt").read_text(encoding="utf-8").split("\n")
    pair = []
    for line in [line for line in lines if not line.startswith("#")] + [""]:
        if line:
            pair.append(plain(line))
        elif len(pair) == 2:
            phrases.setdefault(pair[0], set()).add(pair[1])
            pair = []
        else:
            pair = []
    return phrases


def rows_of_page():
    """(where, English, German, meaning or none)"""
    for path in sorted((ROOT / "web/src").rglob("*.ts*")):
        for row in PAGE_ROW.finditer(path.read_text(encoding="utf-8")):
            english, german, meaning = (text and plain(unescaped(text)) for text in row.groups())
            yield path.relative_to(ROOT), english, german, meaning


def phrases_of(book, english):
    """Those of this text as it is, or else of it with another first letter."""
    if english in book:
        return book[english]
    return set().union(*(texts for phrase, texts in book.items() if first_small(phrase) == first_small(english)))


def differing(english, ours, theirs):
    return theirs and not any(first_small(ours) == first_small(text) for text in theirs)


def main():
    german, french = german_of_program(), french_of_program()
    pairs = {plain(key): plain(text) for key, text in
             json.loads((ROOT / "web/src/i18n/fr.json").read_text(encoding="utf-8")).items()}
    seen, compared, found = set(), set(), []
    for path, english, german_text, meaning in rows_of_page():
        key = english if meaning is None else f"{english} [{meaning}]"
        if key not in pairs:
            continue  # two texts beside each other that are no row of a dictionary
        for name, ours, book in (("German", german_text, german), ("French", pairs[key], french)):
            theirs = phrases_of(book, english)
            if theirs:
                compared.add(english)
            if (name, key, ours) in seen or key in TWO_MEANINGS:
                continue
            seen.add((name, key, ours))
            if differing(english, ours, theirs):
                found.append(f'{path}: "{key}" is in {name} "{ours}" on the page, "{" / ".join(sorted(theirs))}" in the program')
    for name, texts in (("German", [*german.values(), {row[2] for row in rows_of_page()}]),
                        ("French", [*french.values(), set(pairs.values())])):
        for text in sorted(set().union(*texts)):
            found += [f'{name}: "{text}" says "{word}"; docs/terms.md has another word'
                      for word in RULED_OUT[name] if re.search(rf"\b{word}", text, re.I)]
    for line in found:
        print(line)
    print(f"{len(compared)} texts of the page are phrases of the program, {len(found)} differences", file=sys.stderr)
    return 1 if found or not compared else 0


if __name__ == "__main__":
    sys.exit(main())
