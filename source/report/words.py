# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""A case in words: titles, sentences and rows made from the parameters in force."""

GEAR = "Gear pair/Gear/"
PINION = "Gear pair/Pinion/"
NOT_OF_THE_CASE = ("Study/", "Output/")

ROWS = (("teeth of pinion and gear", PINION + "Blank/number of teeth", GEAR + "Blank/number of teeth"),
        ("hand of pinion and gear", PINION + "Blank/hand of spiral", GEAR + "Blank/hand of spiral"),
        ("mean cone distance", GEAR + "Blank/mean cone distance"),
        ("face width", GEAR + "Blank/face width"),
        ("backlash", "Gear pair/Mounting/backlash"),
        ("speed of the pinion", "Operation/speed"),
        ("torque on the gear", "Operation/torque"),
        ("tooth meshes", "Operation/tooth meshes"),
        ("start", "Dynamics/start"),
        ("bore of the gear", "Operation/hub"),
        ("damping, mesh damping", "Dynamics/damping", "Dynamics/mesh damping"),
        ("contact: discretization, surface", "Contact/discretization", "Contact/surface"),
        ("friction coefficient", "Contact/friction coefficient"),
        ("element frame, stiffness", "Dynamics/frame", "Dynamics/stiffness"))


def describe_web(parameters):
    """"web 5 mm at 70 deg", "no web"; empty for what is no gear pair."""
    kind = parameters.get(GEAR + "Body/web")
    if kind is None:
        return ""
    if kind == "none":
        return "no web"
    if kind == "solid":
        return "solid body"
    return (f"web {parameters[GEAR + 'Body/web thickness']} at "
            f"{parameters[GEAR + 'Body/web angle']}")


def describe_pair(parameters):
    pinion = parameters.get(PINION + "Blank/number of teeth")
    gear = parameters.get(GEAR + "Blank/number of teeth")
    if pinion in (None, "0"):
        pinion = parameters.get("Gear pair/Proposal/pinion teeth")
        gear = parameters.get("Gear pair/Proposal/gear teeth")
    return f"Spiral bevel gear pair {pinion}/{gear}" if pinion else ""


def make_title(run):
    """What a run or study is, in one line; the folder's name where it is no gear pair."""
    parameters = run.parameters
    parts = [describe_pair(parameters), describe_web(parameters)]
    if "Operation/speed" in parameters:
        parts += [parameters["Operation/speed"], parameters["Operation/torque"]]
    title = ", ".join(part for part in parts if part) or run.path.resolve().name
    kind = parameters.get("Study/kind", "run")
    return title if kind == "run" else f"{title}: {kind}"


def list_case_rows(run):
    """Name and value of what defines the case, as far as it is known."""
    parameters = run.parameters
    for name, *keys in ROWS:
        values = [parameters[key] for key in keys if key in parameters]
        if values and any(value != "0" for value in values):
            yield name, ", ".join(values)
    web = describe_web(parameters)
    if web.startswith("web"):
        body = GEAR + "Body/"
        yield "web", (f"{web} to the axis, from the {parameters[body + 'web attachment']} "
                      f"{parameters[body + 'web direction']}")
        yield "rim thickness", parameters[body + "rim thickness"]
    elif web:
        yield "gear body", web
    for name in dict.fromkeys(key.split("/")[0] for key in parameters if key.startswith("Material ")):
        values = (parameters[f"{name}/{what}"] for what in ("Young's modulus", "Poisson's ratio",
                                                           "density"))
        yield name, "E {}, nu {}, {}".format(*values)
    for body in run.summary.get("mesh", {}).get("bodies", []):
        yield body["name"], (f"{body['cells']} elements, {body['nodes']} nodes, "
                             f"{body['mass']['value']:.4g} {body['mass']['unit']}")


def list_sentences(run):
    """What was computed, in a few sentences."""
    parameters, summary = run.parameters, run.summary
    frequency = run.figure("mesh frequency")
    pair = describe_pair(parameters)
    if pair and frequency:
        time = summary["run"]["time"]["value"]
        yield (f"The {pair[0].lower()}{pair[1:]} turns at {parameters['Operation/speed']} of the pinion, the "
               f"gear resists with {parameters['Operation/torque']}. Teeth mesh at {frequency:.0f} Hz; "
               f"the run covers {time * frequency:.3g} tooth meshes ({1e3 * time:.4g} ms) from "
               f"{describe_start(parameters)}.")
    if "steady part" in summary:
        text = summary["steady part"]["explanation"]
        yield text[0].upper() + text[1:] + "."


def describe_start(parameters):
    start = parameters.get("Dynamics/start", "")
    if start == "static preload":
        return "equilibrium under centrifugal force and full torque"
    if start == "ramp":
        return f"touching flanks, the torque growing over {parameters['Operation/ramp']} tooth meshes"
    return f"the start \"{start}\""


# How long is computed changes no physics.
LENGTHS = ("Operation/tooth meshes", "Dynamics/end time", "Dynamics/largest number of steps")


def find_differences(runs):
    """Names of the parameters in which runs differ, apart from folders and output. A run that does not
    know an entry, as one of an older version, does not differ in it: what makes a section appear is an
    entry of its own."""
    names = dict.fromkeys(name for run in runs for name in run.parameters)
    return [name for name in names if not name.startswith(NOT_OF_THE_CASE)
            and len({normalize(run.parameters[name]) for run in runs if name in run.parameters}) > 1]


def normalize(value):
    """Numbers that are written differently are equal: 5.0 mm and 5 mm."""
    words = (value or "").split()
    try:
        return (float(words[0]), *words[1:])
    except (ValueError, IndexError):
        return tuple(words)


def name_variants(runs):
    """A short name for each run: what differs, else the folder."""
    differences = find_differences(runs)
    differences = [name for name in differences if name not in LENGTHS] or differences
    names = []
    for run in runs:
        webs = describe_web(run.parameters)
        if differences and all(name.startswith(GEAR + "Body/web") for name in differences):
            names.append(webs)
        elif 0 < len(differences) <= 2:
            names.append(", ".join(f"{name.split('/')[-1]} {run.parameters.get(name, 'absent')}"
                                   for name in differences))
        else:
            names.append(run.path.resolve().name)
    return names if len(set(names)) == len(names) else [run.path.resolve().name for run in runs]
