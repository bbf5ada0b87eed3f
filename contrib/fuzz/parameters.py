# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Mutants of the parameter files of prm/, checked without being run."""
import re
import shutil
from pathlib import PurePosixPath

from job import ROOT, Job
from mutation import BYTES, NUMBERS, UNITS, change_bytes, change_lines, change_number, misspell, pick

# Meshes of hundreds of thousands of cells, which take seconds each.
LARGE = {"prm/spiral_bevel.prm", "prm/fem/loaded_spiral_bevel.prm",
         "prm/spiral_bevel_no_web.prm", "prm/fem/loaded_spiral_bevel_no_web.prm"}
SET = re.compile(r"^(\s*set\s+)([^=]*?)(\s*=\s*)(.*)$")
INCLUDE = re.compile(r"^\s*include\s+(\S+)", re.M)


def read_entries():
    """(section, name, default, meaning) of the generated reference."""
    entries, sections = [], []
    for line in (ROOT / "doc/parameter_reference.md").read_text().splitlines():
        if line.startswith("## "):
            sections = line[3:].split(", ")
        elif line.startswith("| ") and not line.startswith("| entry |"):
            cells = [cell.strip() for cell in line.strip("| ").split(" | ")]
            if len(cells) >= 3:
                entries += [(section, cells[0], cells[1].split(";")[0], cells[-1]) for section in sections]
    return entries


def closure(name):
    """A file and all that it includes, by names from the project's folder."""
    names = [name]
    for included in INCLUDE.findall((ROOT / name).read_text()):
        path = (ROOT / PurePosixPath(name).parent / included).resolve().relative_to(ROOT)
        names += closure(str(path))
    return names


class Seeds:
    def __init__(self, runner, folder):
        paths = sorted(path.relative_to(ROOT).as_posix() for path in (ROOT / "prm").rglob("*.prm"))
        self.files = [name for name in paths if name not in LARGE]
        self.entries, self.runner, self.in_force = read_entries(), runner, {}

    def entries_in_force(self, name, folder):
        """All entries that a file's study knows, with their values."""
        if name not in self.in_force:
            printed = self.runner.print_parameters(ROOT / name, folder)
            sections, entries = [], []
            for line in printed.splitlines():
                words = line.split("#")[0].strip()
                if words.startswith("subsection "):
                    sections.append(words.split(" ", 1)[1])
                elif words == "end":
                    sections.pop()
                elif words.startswith("set "):
                    entry, _, value = words[4:].partition("=")
                    entries.append(("/".join([*sections, entry.strip()]), value.strip()))
            self.in_force[name] = entries
        return self.in_force[name]

    def make_overrides(self, rng, name, folder):
        """One to three entries with values of their own kind, which are out of any reason."""
        overrides = []
        for _ in range(pick(rng, [1, 1, 1, 2, 3])):
            entry, value = pick(rng, self.entries_in_force(name, folder))
            changed = change_number(rng, value)
            if changed == value:
                changed = self.random_value(rng, value, "")
            overrides.append(f"{entry}={changed}")
        return overrides

    def random_value(self, rng, default, meaning):
        """For an entry: a number, one of its words, or anything."""
        words = re.findall(r"\(([^()]*, [^()]*)\)$", meaning)
        how = rng.random()
        if words and how < 0.5:
            return pick(rng, words[0].split(", "))
        if how < 0.75:
            return pick(rng, NUMBERS)
        if how < 0.9:
            return f"{pick(rng, NUMBERS)} {pick(rng, UNITS)}"
        return pick(rng, [misspell(rng, default), "", "a, b, a", "x" * 3000, "{}", "../..", "/", "%s%n", "1/0", "sin(", "x^y^t"])

    def random_entry(self, rng, text):
        """An entry that the file may not have, in its sections."""
        section, name, default, meaning = pick(rng, self.entries)
        known = re.findall(r"subsection ((?:Body|Constraint|Contact|Load|Probe) \w+)", text)
        sections = []
        for part in section.split("/"):
            same = [one for one in known if one.split()[0] == part.split()[0]] if part.endswith(" NAME") else []
            sections.append(pick(rng, same) if same else part)
        value = self.random_value(rng, default, meaning)
        lines = [f"subsection {part}" for part in sections] + [f"set {name} = {value}"] + ["end"] * len(sections)
        return lines, f"{'/'.join(sections)}/{name} = {value[:60]}"

    def mutate(self, rng, content, name):
        lines = content.decode("utf-8", "surrogateescape").split("\n")
        how = rng.random()
        settings = [k for k, line in enumerate(lines) if SET.match(line)]
        if how < 0.35 and settings:
            place = pick(rng, settings)
            before, entry, equals, value = SET.match(lines[place]).groups()
            what = rng.randrange(5)
            if what == 0:
                entry = misspell(rng, entry)
            elif what == 1:
                value = f"{pick(rng, NUMBERS)} {pick(rng, UNITS)}"
            elif what == 2:
                value = change_number(rng, value)
            elif what == 3:
                value = self.random_value(rng, value, "")
            else:
                value = misspell(rng, value)
            lines[place] = before + entry + equals + value
            note = f"line {place + 1} is {lines[place].strip()[:80]!r}"
        elif how < 0.6:
            more, note = self.random_entry(rng, "\n".join(lines))
            lines += more
        elif how < 0.75:
            note = change_lines(rng, lines)
        elif how < 0.85:
            place = rng.randrange(len(lines) + 1)
            line = pick(rng, ["end", "subsection", "subsection " + "x" * 500, "set", "set =", "set = 1", "set x", "include",
                              f"include {PurePosixPath(name).name}", "include .", "include /dev/null", "include /",
                              "include missing.prm", "subsection Model", "subsection Study", "\\", "set kind = \\",
                              "x", "end end", "subsection A/B", "set a/b = 1", "subsection Model\\", "#" * 10000])
            lines.insert(place, line)
            note = f"line {place + 1} added: {line[:60]!r}"
        elif how < 0.95:
            place = rng.randrange(len(lines))
            line = lines[place].encode("utf-8", "surrogateescape")
            column = rng.randrange(len(line) + 1)
            bad = pick(rng, BYTES)
            lines[place] = (line[:column] + bad + line[column:]).decode("utf-8", "surrogateescape")
            note = f"{bad!r} in line {place + 1}"
        else:
            note, content = change_bytes(rng, content)
            return note, content
        return note, "\n".join(lines).encode("utf-8", "surrogateescape")

    def make(self, rng, folder):
        main = pick(rng, self.files)
        names = closure(main)
        for name in names:
            (folder / name).parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(ROOT / name, folder / name)
        # What a compare or sweep runs lies beside.
        for path in (ROOT / "prm").rglob("*.prm"):
            target = folder / path.relative_to(ROOT)
            if not target.exists():
                target.parent.mkdir(parents=True, exist_ok=True)
                target.symlink_to(path)
        (folder / "meshes").symlink_to(ROOT / "meshes")
        if rng.random() < 0.5:
            overrides = self.make_overrides(rng, main, folder)
            return Job(folder, [main, "--check", *(f"--set={one}" for one in overrides)], f"{main}: {overrides}")
        name = main if rng.random() < 0.8 else pick(rng, names)
        content, notes = (folder / name).read_bytes(), []
        for _ in range(pick(rng, [1, 1, 1, 2, 3])):
            note, content = self.mutate(rng, content, name)
            notes.append(note)
        (folder / name).write_bytes(content)
        return Job(folder, [main, "--check"], f"{name}: {'; '.join(notes)}")
