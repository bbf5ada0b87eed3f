# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What an unloaded tooth contact analysis says in figures (tca.json, doc/theory/gear.md): both sides beside each other, and
what is left of the teeth."""
from ..data.files import read_json
from ..data.shapes import CONTACT_ANALYSIS

SIDES = ("drive", "coast")
SIDES_HEADER = ["", "unit", *SIDES]
# Groups of figures of a side, what they are called in a row, and which of them (none: all) are shown.
_GROUPS = (("mean contact on the generated pinion flank", "mean contact on the pinion", ("L", "h")),
           ("mean contact on the generated gear flank", "mean contact on the gear", ("L", "h")),
           ("ellipse at the mean contact", "ellipse", ("semi-axis a", "semi-axis b", "major axis to the lengthwise direction")),
           ("path", "path of contact", ()), ("beyond the start", "before the path", ()), ("beyond the end", "beyond the path", ()),
           ("lag over pitches", "lag of the gear over pitches", ()), ("transfer point", "transfer point", ()))
_PLACES = ("toe", "middle", "heel")
FORMS_HEADER = ["teeth", "unit", *(f"{member}, {place}" for member in ("pinion", "gear") for place in _PLACES)]


def read_contact_analysis(run):
    """Empty without one."""
    path = run.path / "tca.json"
    return read_json(path, CONTACT_ANALYSIS) if path.is_file() else {}


def list_sides(analysis):
    """Rows with the header SIDES_HEADER; a quantity that a side has not is None."""
    for group, called, shown in _GROUPS:
        found = [analysis.get(side, {}).get(group, {}) for side in SIDES]
        for name in dict.fromkeys(name for one in found for name in one if not shown or name in shown):
            if all(is_quantity(one.get(name, {"value": None})) for one in found):
                unit = next(one[name]["unit"] for one in found if name in one)
                yield [f"{called}: {name}", unit, *(one[name]["value"] if name in one else None for one in found)]
            elif name == "border":
                yield [f"{called}: {name}", "", *(one.get(name) for one in found)]


def list_forms(analysis):
    """Rows with the header FORMS_HEADER: thickness, tip lands, clearances of the teeth at three sections."""
    teeth = analysis["teeth"]
    sections = [teeth[member][place] for member in ("pinion", "gear") for place in _PLACES]
    for name, one in sections[0].items():
        yield [name, one["unit"], *(section[name]["value"] for section in sections)]


def is_quantity(one):
    return isinstance(one, dict) and "value" in one
