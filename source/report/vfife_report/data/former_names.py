# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Names in result files of the previous version: columns, members of .json files, words in cells. The program has them of the
same former_names.json: file, former and present name. "*" at the begin or at the end stands for anything else."""
import json
from pathlib import Path

FORMER_NAMES = {}  # by file
for _file, _former, _present in json.loads(Path(__file__).with_suffix(".json").read_text(encoding="utf-8")):
    FORMER_NAMES.setdefault(_file, {})[_former] = _present


def replace_name(name, former, present):
    """None where it is another name."""
    before, star, after = former.partition("*")
    if not star:
        return present if name == former else None
    if len(name) < len(before) + len(after) or not (name.startswith(before) and name.endswith(after)):
        return None
    return present.replace("*", name[len(before):len(name) - len(after)])


def present_name(file, name):
    """The present name of one in results of the file, "history.csv", which is mostly the same; without a file that of any."""
    for names in [FORMER_NAMES.get(file, {})] if file else FORMER_NAMES.values():
        for former, present in names.items():
            found = replace_name(name, former, present)
            if found is not None:
                return found
    return name


class Named(dict):
    """Values by names that a file has, former ones replaced. They are found by both names; parts of a place, "energy/error",
    have names each."""

    def __init__(self, file, members=()):
        super().__init__((present_name(file, name), value) for name, value in members)
        self.file = file

    def __missing__(self, name):
        present = self.find(name)
        if present == name:
            raise KeyError(name)
        return self[present]

    def __contains__(self, name):
        return super().__contains__(name) or super().__contains__(self.find(name))

    def get(self, name, default=None):
        return self[name] if name in self else default

    def find(self, name):
        return "/".join(present_name(self.file, part) for part in name.split("/")) if isinstance(name, str) else name
