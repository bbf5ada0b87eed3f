# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters in force of a run, as the program writes them."""
import re

from .files import DamagedFile, read_json, read_text
from .shapes import PARAMETERS

UNIT = re.compile(r"\[([^\[\]]+)\]$")


def read_parameters(folder):
    """Values as texts by "Section/Sub/name", bare numbers with its entry's unit: parameters.json of a
    folder. Results of versions that wrote no such file, and those copied beside a sweep, have parameters.prm.
    Empty without either."""
    path, earlier = folder / "parameters.json", folder / "parameters.prm"
    if path.is_file():
        entries = read_json(path, PARAMETERS)
        return {name: add_unit(entry["value"], entry["unit"]) for name, entry in entries.items()}
    return read_parameter_file(earlier) if earlier.is_file() else {}


def read_given(folder):
    """Those of read_parameters() that differ from their defaults; empty where a folder does not tell defaults."""
    path = folder / "parameters.json"
    if not path.is_file():
        return {}
    return {name: add_unit(entry["value"], entry["unit"]) for name, entry in read_json(path, PARAMETERS).items()
            if entry["value"] != entry["default"]}


def read_parameter_file(path):
    """The same from parameters.prm."""
    return parse_parameters(read_text(path), path)


def parse_parameters(text, path):
    """The same from the text of parameters.prm, where the description before an entry ends in its unit; `path` is named
    where it is none."""
    values, sections, description = {}, [], []
    for number, line in enumerate(text.split("\n"), 1):
        line = line.strip()
        if line.startswith("#"):
            description.append(line[1:].strip())
            continue
        words = line.split(None, 1)
        if words and not (line == "end" and sections or words[0] in ("set", "subsection") and len(words) == 2):
            raise DamagedFile(f'{path}:{number}: "{line[:40]}" is no line of a parameter file')
        if words and words[0] == "subsection":
            sections.append(words[1])
        elif line == "end":
            sections.pop()
        elif words:
            name, _, value = words[1].partition("=")
            value = value.partition("# default:")[0].strip()
            unit = UNIT.search(" ".join(description))
            values["/".join(sections + [name.strip()])] = add_unit(value, unit.group(1) if unit else "")
        description = []
    return values


def add_unit(value, unit):
    """Only to a bare number or several of them, and only where it has one."""
    if unit in ("", "-"):
        return value
    try:
        for number in value.split(","):
            float(number)
    except ValueError:
        return value
    return f"{value} {unit}"
