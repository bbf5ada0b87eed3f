# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The parameters in force of a run: parameters.prm as the program writes it."""
import re

UNIT = re.compile(r"\[([^\[\]]+)\]$")


def read_parameters(path):
    """Values as texts by "Section/Sub/name". A bare number gets the unit that ends its description."""
    values, sections, description = {}, [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        line = line.strip()
        if line.startswith("#"):
            description.append(line[1:].strip())
            continue
        words = line.split(None, 1)
        if words and words[0] == "subsection":
            sections.append(words[1])
        elif line == "end":
            sections.pop()
        elif words and words[0] == "set":
            name, _, value = words[1].partition("=")
            value = value.partition("# default:")[0].strip()
            values["/".join(sections + [name.strip()])] = add_unit(value, " ".join(description))
        description = []
    return values


def add_unit(value, description):
    unit = UNIT.search(description)
    if not unit or unit.group(1) == "-":
        return value
    try:
        float(value)
    except ValueError:
        return value
    return f"{value} {unit.group(1)}"
