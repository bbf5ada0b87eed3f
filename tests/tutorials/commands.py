#!/usr/bin/env python3
# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""commands.py PAGE BUILD_FOLDER: does what a page of tutorials says, in an empty folder.

A block "```LANGUAGE NAME" is a file of that name; "```sh" are commands; each line of the "```text" after it is a part of
what they print, blanks apart. VFIFE is the folder of the project there, as the pages say.
"""
import importlib.util
import os
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(\w+)(?: (\S+))?\n(.*?)^```$", re.M | re.S)


def make_project(folder, build):
    """The project as pages see it, built in build/release whatever the build is."""
    project = folder / "project"
    (project / "build").mkdir(parents=True)
    (project / "build/release").symlink_to(build)
    for name in ("prm", "meshes", "examples", "source"):
        (project / name).symlink_to(ROOT / name)
    return project


def squeeze(text):
    return " ".join(text.split())


def shorten(text):
    return "\n".join(text.splitlines()[-30:])


def follow(page, build, folder):
    """What is wrong, a line each."""
    work = folder / "work"
    work.mkdir()
    project = make_project(folder, build)
    commands = folder / "commands"  # the program, and the Python that has the libraries
    commands.mkdir()
    (commands / "vfife").symlink_to(build / "vfife")
    (commands / "python3").symlink_to(sys.executable)
    environment = {**os.environ, "VFIFE": str(project), "PYTHONDONTWRITEBYTECODE": "1",
                   "PATH": f"{commands}:{os.environ['PATH']}"}
    printed, done, expected = "", 0, 0
    for language, name, text in BLOCK.findall(page.read_text(encoding="utf-8")):
        if name:
            (work / name).write_text(text, encoding="utf-8")
        elif language == "sh":
            ran = subprocess.run(["bash", "-e", "-o", "pipefail", "-c", text], cwd=work, env=environment, text=True,
                                 stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False)
            printed, done = ran.stdout, done + 1
            if ran.returncode:
                yield f"exit code {ran.returncode} of\n{text}{shorten(printed)}"
                return
        elif language == "text":
            for line in text.splitlines():
                expected += 1
                if squeeze(line) not in squeeze(printed):
                    yield f'the page says "{line}", but the last lines are\n{shorten(printed)}'
    if not (done and expected):
        yield f"{done} commands, {expected} lines of what they print"


def main():
    if not all(importlib.util.find_spec(name) for name in ("numpy", "matplotlib", "jinja2", "meshio")):
        print("skipped: the report lacks libraries")
        sys.exit(77)
    page, build = Path(sys.argv[1]), Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        wrong = list(follow(page, build, Path(name)))
    print("\n".join(wrong) or "ok")
    sys.exit(1 if wrong else 0)


if __name__ == "__main__":
    main()
