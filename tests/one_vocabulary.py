#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Whether the page and the program call a thing by one word in each language.

What both say is one pair (language_pairs.py). Of what the page alone says, every text that differs from one of the program
by its first letter alone is compared in what a language makes of it; a meaning in brackets says that it is another thing.
Reports also every word that docs/terms.md has another one for (RULED_OUT). Exits with 1 where there is one of either.

    python3 tests/one_vocabulary.py
"""
import re
import sys

import language_pairs

# Words that are not used since docs/terms.md has another one.
RULED_OUT = {
    "de": ["Unsicherheitsbudget", "Totweg", "Rundachse", "rotatorische Achse", "Wiederholbarkeit", "Wiederholgenauigkeit",
               "Tracking-Interferometer", "Standort", "Umkehrfehler", "Befund"],
    "fr": ["trajet mort", "graine", "échauffement", "contributeur", "axe rotatif"],
}

# Of two things that stand near each other: what the English text speaks of, of which other thing alone the word is.
NOT_OF = {"de": [("instrument|measuring device", "equipment", "Messmittel"), ("equipment", "instrument|device", "Messgerät")]}


def plain(text):
    text = text.replace("\u00a0", " ").replace("\u202f", " ")
    return text[:1].lower() + text[1:]


def differences(tag):
    """How many texts were compared, and what differs."""
    of_program = {}
    for english, other in language_pairs.program_pairs(tag).items():
        of_program.setdefault(plain(english), set()).add(plain(other))
    compared, found = 0, []
    for english, other in language_pairs.page_pairs(tag).items():
        theirs = of_program.get(plain(english))
        compared += theirs is not None
        if theirs and plain(other) not in theirs:
            found.append(f'{tag}: "{english}" is "{other}" on the page, "{" / ".join(sorted(theirs))}" in the program')
    return compared, found


def ruled_out(tag):
    said = set(language_pairs.program_pairs(tag).values()) | set(language_pairs.page_pairs(tag).values())
    return [f'{tag}: "{text}" says "{word}"; docs/terms.md has another word'
            for text in sorted(said) for word in RULED_OUT.get(tag, ()) if re.search(rf"\b{word}", text, re.I)]


def of_another(tag):
    """The word of a thing where the English text speaks of the other one alone."""
    said = language_pairs.program_pairs(tag) | language_pairs.page_pairs(tag)
    return [f'{tag}: "{english}" is "{other}": "{word}" is another thing (docs/terms.md)'
            for english, other in sorted(said.items()) for thing, owner, word in NOT_OF.get(tag, ())
            if word in other and re.search(thing, english, re.I) and not re.search(owner, english, re.I)]


def main():
    results = [differences(tag) for tag in language_pairs.TAGS]
    found = [line for _, lines in results for line in lines] + [line for tag in language_pairs.TAGS for line in
                                                                     [*ruled_out(tag), *of_another(tag)]]
    for line in found:
        print(line)
    compared = min(count for count, _ in results)
    print(f"{compared} texts of the page alone are near one of the program, {len(found)} differences", file=sys.stderr)
    return 1 if found or not compared else 0


if __name__ == "__main__":
    sys.exit(main())
