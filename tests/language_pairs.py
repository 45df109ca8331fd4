# SPDX-License-Identifier: Apache-2.0
"""The files of pairs, one for each language but English: src/axiometry/language/phrase_file.h says what they hold."""
import functools
import pathlib

FOLDER = pathlib.Path(__file__).resolve().parent.parent / "src/axiometry/language"
TAGS = sorted(path.stem for path in FOLDER.glob("*.txt"))
PAGE_SUBJECT = "# The page"


@functools.cache
def subjects(tag):
    """(comment, {English: other}) of each subject."""
    found, was_comment, english = [], False, None
    for line in (FOLDER / f"{tag}.txt").read_text(encoding="utf-8").splitlines():
        is_comment = line.startswith("#")
        if is_comment and not was_comment:
            found.append((line, {}))
        was_comment = is_comment
        if is_comment or not line:
            english = None
        elif english is None:
            english = line
        else:
            found[-1][1][english] = line
    return found


def program_pairs(tag):
    """What the program says; the page says some of it too."""
    return {english: other for comment, pairs in subjects(tag) if not comment.startswith(PAGE_SUBJECT)
            for english, other in pairs.items()}


def page_pairs(tag):
    """What the page alone says; in square brackets behind the English may stand which of its meanings it has."""
    return {english: other for comment, pairs in subjects(tag) if comment.startswith(PAGE_SUBJECT)
            for english, other in pairs.items()}
