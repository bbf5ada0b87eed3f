# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Names in result files of the previous version: columns, members of .json files, words in cells. They are those of the
program (doc/columns.json). "*" at the begin or at the end stands for anything else: the name of a probe, a number."""

FORMER_NAMES = {
    "history.csv": {
        "taken by the driven speed damping": "removed by the driven speed damping",
    },
    "teeth.csv": {
        "slave group": "slave facet group",
        "master group": "master facet group",
    },
    "root_sections.csv": {
        "tension after the mesh": "tension after the mean contact",
        "compression after the mesh": "compression after the mean contact",
    },
    "coupled_modes.csv": {
        "share of the static turn": "share of the static rotation",
        "turning": "rotating",
        "standing": "fixed",
    },
    "waves_in_contact.csv": {
        "share of the turn": "share of the rotation",
        "amplitude of the turn": "amplitude of the rotation",
    },
    "resonance.csv": {
        "time apart": "time without contact",
    },
    "wave_response.csv": {
        "standing wave *": "stationary wave *",
        "running wave *": "travelling wave *",
    },
    "waves_response.csv": {
        "running wave": "travelling wave",
    },
    "differences.csv": {
        "told apart": "significant",
        "order told": "sign significant",
        "not told apart": "not significant",
        "swing frequency": "torsional mode frequency",
        "* largest of a turn": "* largest per revolution",
        "* median of a turn": "* median per revolution",
    },
    "sweep.csv": {
        "swing frequency": "torsional mode frequency",
        "* largest of a turn": "* largest per revolution",
        "* median of a turn": "* median per revolution",
    },
    "root_stress.csv": {
        "after the mesh": "position after the mean contact",
    },
    "gauges.csv": {
        "after the mesh": "position after the mean contact",
    },
    "loaded_probes.csv": {
        "after the mesh": "position after the mean contact",
    },
    "pressure.csv": {
        "after the mesh": "position after the mean contact",
    },
    "error_bars.csv": {
        "swing frequency": "torsional mode frequency",
        "* largest of a turn": "* largest per revolution",
        "* median of a turn": "* median per revolution",
    },
    "summary.json": {
        "swing frequency, estimated": "torsional mode frequency, estimated",
        "inertia of the swing": "inertia of the torsional mode",
        "swing period": "torsional mode period",
        "effective arm": "effective lever arm",
        "least arm on the path of contact": "least lever arm on the path of contact",
        "largest arm on the path of contact": "largest lever arm on the path of contact",
        "torque over effective arm*": "torque over effective lever arm*",
        "penalty springs, in teeth and rest": "penalty compliance, in teeth and rest",
        "largest of a turn": "largest per revolution",
        "median of a turn": "median per revolution",
        "after the mesh": "position after the mean contact",
        "passes the mesh": "time at the mean contact",
        "taken by the driven speed damping": "removed by the driven speed damping",
        "taken by the driven speed damping from the swing": "removed by the driven speed damping from the torsional mode",
        "spin drift": "drift of rotation speed",
        "contradictions": "input conflicts",
    },
    "lumped.json": {
        "inertia of the swing, at the gear": "inertia of the torsional mode, at the gear",
        "arm": "lever arm",
        "backlash, turn of the gear": "backlash angle of the gear",
        "time apart": "time without contact",
    },
    "tca.json": {
        "play of the gear": "backlash angle of the gear",
        "regularity at the fillet": "undercut indicator at the fillet",
        "hand-over": "transfer point",
        "hands over": "has a transfer point",
        "hands over inside the flanks": "transfer point inside the flanks",
        "edge takes over at": "edge contact starts at",
        "approach before it carries": "approach before edge contact",
    },
    "edge_contact.json": {
        "edges carry": "edge contact",
    },
}


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
