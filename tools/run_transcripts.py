#!/usr/bin/env python3
# SPDX-License-Identifier: Apache-2.0
"""Runs command transcripts: each `$ command` line of a file must print the lines that follow it.

Usage: run_transcripts.py PROGRAM TRANSCRIPT...   (add --update to rewrite the transcripts)

A transcript is a text file, or a Markdown document whose ```console blocks are transcripts. The commands run in a fresh
folder that holds a copy of examples/ and of the transcript's own folder `<stem>.files/`, for a document also
tests/conformance/, by `bash`, with `axiometry` on the PATH; standard error is shown after the standard output, and an
exit code other than 0 as a last line `[exit 2]`.
"""
import difflib
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent


def run(command, folder, environment):
    done = subprocess.run(["bash", "-c", command], cwd=folder, env=environment, capture_output=True, stdin=subprocess.DEVNULL)
    output = (done.stdout + done.stderr).decode("utf-8", "replace")
    if output and not output.endswith("\n"):
        output += "\n"
    if done.returncode:
        output += f"[exit {done.returncode}]\n"
    return output


def answered(lines, answer):
    """The lines of a transcript with what the commands print now."""
    comment = True
    for line in lines:
        if line.startswith("$ "):
            comment = False
            yield line
            yield answer(line[2:])
        elif line.startswith("#"):
            comment = True
            yield line
        elif comment:
            yield line


def answered_document(lines, answer):
    """The same for the console blocks of a Markdown document; a `#` there is printed text."""
    block = None
    for line in lines:
        if block is None:
            yield line
            if line.rstrip() == "```console":
                block = []
        elif line.rstrip() == "```":
            yield from answered(block, answer)
            yield line
            block = None
        elif line.startswith("$ ") or not block:
            block.append(line)


def actual(transcript, program):
    text = transcript.read_text(encoding="utf-8")
    document = transcript.suffix == ".md"
    with tempfile.TemporaryDirectory() as folder:
        os.symlink(program, pathlib.Path(folder) / "axiometry")
        work = pathlib.Path(folder) / "work"
        shutil.copytree(ROOT / "examples", work)
        if document:
            shutil.copytree(ROOT / "tests" / "conformance", work / "tests" / "conformance")
        files = transcript.with_suffix(".files")
        if files.is_dir():
            shutil.copytree(files, work, dirs_exist_ok=True)
        environment = {"PATH": f"{folder}:/usr/bin:/bin", "HOME": folder, "LC_ALL": "C.UTF-8", "TZ": "UTC",
                       "SOURCE_DATE_EPOCH": "1795262400"}
        answers = answered_document if document else answered
        return text, "".join(answers(text.splitlines(keepends=True), lambda command: run(command, work, environment)))


def main():
    update = "--update" in sys.argv
    program, *transcripts = [a for a in sys.argv[1:] if a != "--update"]
    failed = 0
    for name in transcripts:
        transcript = pathlib.Path(name)
        expected, got = actual(transcript, pathlib.Path(program).resolve())
        if expected == got:
            continue
        if update:
            transcript.write_text(got, encoding="utf-8")
            continue
        failed += 1
        sys.stdout.writelines(difflib.unified_diff(expected.splitlines(True), got.splitlines(True), name, "now"))
    print(f"{len(transcripts) - failed} passed, {failed} failed")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
