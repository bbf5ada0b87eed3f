# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""What a case is called by its parameters, and how the runs of a study are told apart."""
from .unused import list_unused_entries

GEAR = "Gear pair/Gear/"
PINION = "Gear pair/Pinion/"
NOT_OF_THE_CASE = ("Study/", "Output/")
LONGEST_NAME = 60  # letters of a variant, above which its folder names it
# How long is computed changes no physics.
LENGTHS = ("Operation/mesh cycles", "Dynamics/end time", "Dynamics/maximum number of steps")


def describe_web(parameters):
    """"web 5 mm at 70 deg", "no web"; empty for what is no gear pair."""
    kind = parameters.get(GEAR + "Body/body type")
    if kind is None:
        return ""
    if kind == "rim only":
        return "no web"
    if kind == "solid":
        return "solid body"
    return (f"web {parameters[GEAR + 'Body/web thickness']} at "
            f"{parameters[GEAR + 'Body/web inclination']}")


def describe_pair(parameters):
    pinion = parameters.get(PINION + "Blank/number of teeth")
    gear = parameters.get(GEAR + "Blank/number of teeth")
    if pinion in (None, "0"):
        pinion = parameters.get("Gear pair/Proposal/pinion teeth")
        gear = parameters.get("Gear pair/Proposal/gear teeth")
    return f"Spiral bevel gear pair {pinion}/{gear}" if pinion else ""


def name_driven(parameters):
    """The member of a pair on which the torque of the load acts."""
    return "pinion" if parameters.get("Operation/driving member") == "gear" else "gear"


def list_unused(parameters):
    """Paths of entries that say nothing of the case: its study does not use them."""
    return list_unused_entries(parameters, bool(describe_pair(parameters)))


def find_differences(runs):
    """Names of the parameters in which runs differ, apart from folders and output. A run that does not
    know an entry, as one of an older version, or does not use it does not differ in it: what makes a section
    appear is an entry of its own."""
    names = dict.fromkeys(name for run in runs for name in run.parameters)
    unused = [list_unused(run.parameters) for run in runs]
    return [name for name in names if not name.startswith(NOT_OF_THE_CASE)
            and len({normalize(run.parameters[name]) for run, others in zip(runs, unused)
                     if name in run.parameters and name not in others}) > 1]


def normalize(value):
    """Numbers that are written differently are equal: 5.0 mm and 5 mm."""
    words = (value or "").split()
    try:
        return (float(words[0]), *words[1:])
    except (ValueError, IndexError):
        return tuple(words)


def is_open(value):
    """Whether an entry has no number: a word in its place, or 0 in files of earlier versions."""
    return value in ("auto", "none", "not given") or normalize(value)[:1] == (0.0,)


def name_variants(runs):
    """A short name for each run: what differs, else the folder."""
    differences = find_differences(runs)
    differences = [name for name in differences if name not in LENGTHS] or differences
    names = []
    for run in runs:
        webs = describe_web(run.parameters)
        if differences and all(name.startswith((GEAR + "Body/body type", GEAR + "Body/web")) for name in differences):
            names.append(webs)
        elif 0 < len(differences) <= 2 and not any(list_unused(other.parameters).intersection(differences) for other in runs):
            names.append(", ".join(f"{name.split('/')[-1]} {run.parameters.get(name, 'absent')}"
                                   for name in differences))
        else:
            names.append(run.path.resolve().name)
    short = len(set(names)) == len(names) and max(map(len, names), default=0) <= LONGEST_NAME
    return names if short else [run.path.resolve().name for run in runs]
