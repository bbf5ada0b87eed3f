# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The tables of mutants: one wrong edit of one source file each, and the tests that have to find it.

    === dynamics/watch/energy_book.cc          the file below source/, for all that follows
    work of the torques counts twice           what is wrong, one line
    - ledger_.torque_work += time              the text, once in the file; any white space stands for any other
    + ledger_.torque_work += 2 * time          what comes in its place; without this line nothing
    > dynamics/loads study/moments             tests as ctest names them, without .mpirun=2
    = equal because ...                        only where no test can find it: the argument

An empty line ends a mutant, # begins a comment line. Several lines of - or + are one text.
"""
import re
from dataclasses import dataclass, field
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
TABLES = Path(__file__).resolve().parent / "table"


class TableError(Exception):
    pass


@dataclass
class Mutant:
    place: str  # of its table: file and line
    file: str  # below source/
    title: str
    old: str = ""
    new: str = ""
    tests: list = field(default_factory=list)
    argument: str = ""  # why no test can find it
    number: int = 0  # in the order of all tables

    @property
    def folder(self):
        return self.file.split("/")[0]

    @property
    def path(self):
        return "source/" + self.file

    def key(self):
        """By which results are kept: another edit or other tests are another mutant."""
        return "\t".join([self.file, self.old, self.new, *self.tests])

    def find(self, content):
        """Places of the text in the content of its file."""
        words = [re.escape(word) for word in self.old.split()]
        return list(re.finditer(r"\s+".join(words), content))

    def state(self, root=ROOT):
        """Empty, or why the edit cannot be made."""
        path = root / self.path
        if not path.is_file():
            return "stale: there is no such file"
        found = len(self.find(path.read_text(encoding="utf-8")))
        if found != 1:
            return f"stale: its text is found {found} times" if found else "stale: its text is not there any more"
        for test in self.tests:
            if not list((root / "tests").glob(test + ".*")):
                return f"stale: there is no test {test}"
        return ""

    def apply(self, content):
        place, = self.find(content)
        return content[:place.start()] + self.new + content[place.end():]


def read_table(path):
    file, mutant, mutants = None, None, []

    def fail(number, what):
        raise TableError(f"{path.relative_to(ROOT)}:{number}: {what}")

    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines() + [""], 1):
        mark, _, text = line.partition(" ")
        if mark == "#":
            continue
        if not line.strip():
            if mutant is not None:
                if not mutant.old or not mutant.tests or mutant.old.split() == mutant.new.split():
                    fail(number, f'"{mutant.title}" needs a text (-), another one (+) and tests (>)')
                mutants.append(mutant)
            mutant = None
        elif mark == "===":
            file = text.strip()
        elif mutant is None:
            if file is None:
                fail(number, "a file is needed first (===)")
            mutant = Mutant(f"{path.relative_to(ROOT)}:{number}", file, line.strip())
        elif mark == "-":
            mutant.old += ("\n" if mutant.old else "") + text
        elif mark == "+":
            mutant.new += ("\n" if mutant.new else "") + text
        elif mark == ">":
            mutant.tests += text.split()
        elif mark == "=":
            mutant.argument += (" " if mutant.argument else "") + text.strip()
        else:
            fail(number, f'"{line}" is no line of a mutant')
    return mutants


def read_tables():
    """All mutants, numbered from 1: table by table, those of a file one after the other."""
    mutants = [mutant for path in sorted(TABLES.glob("*.txt")) for mutant in read_table(path)]
    known = {}
    for number, mutant in enumerate(mutants, 1):
        mutant.number = number
        edit = (mutant.file, mutant.old, mutant.new)
        if edit in known:
            raise TableError(f"{mutant.place}: the same edit as {known[edit]}")
        known[edit] = mutant.place
    return mutants
