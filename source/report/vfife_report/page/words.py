# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""A case in words: titles, sentences and rows made from the parameters in force."""
from pathlib import Path

from ..data.labels import GEOMETRY_NAMES, VALUES, label
from ..data.naming import GEAR, PINION, describe_pair, describe_web, is_open, list_unused, name_driven
from ..data.parameters import read_given
from ..data.unused import sweeps_speeds

# As given: nothing where they are proposed.
BLANK_ROWS = (
    ("teeth of pinion and gear", PINION + "Blank/number of teeth", GEAR + "Blank/number of teeth"),
    ("hand of pinion and gear", PINION + "Blank/hand of spiral", GEAR + "Blank/hand of spiral"),
    ("mean cone distance", GEAR + "Blank/mean cone distance"),
    ("face width", GEAR + "Blank/face width"),
    ("backlash", "Gear pair/Mounting/backlash"))
ROWS = (("operating speed of the pinion", "Operation/speed"),
        ("torque on the {driven}", "Operation/torque"),
        ("torque on the pinion", "Operation/pinion torque"),
        ("mesh cycles", "Operation/mesh cycles"),
        ("start", "Dynamics/start"),
        ("bore of the {driven}", "Operation/bore rotation"),
        ("mass proportional damping", "Dynamics/mass proportional damping"),
        ("speed controller of the {driven} (driven speed damping)", "Dynamics/driven speed damping"),
        ("contact points, contact surface", "Contact/discretization", "Contact/surface"),
        ("friction coefficient", "Contact/friction coefficient"),
        ("rotation of an element, element type", "Dynamics/corotational frame", "Dynamics/element type"))
ZERO_IS_SAID = ["Contact/friction coefficient"]  # no friction, where readers expect some
# Groups of the summary, and what readers call an entry of each.
FINDINGS = (("input conflicts", "input conflict"), ("warnings", "warning"))
RECORD_ONLY = "Its peak to peak values hold for this record only; a longer record gives other values."
ERRORS = ("Gear pair/Mounting/", "Gear pair/Errors/")
DESIGNED = ("Gear pair/Mounting/shaft angle", "Gear pair/Mounting/backlash")  # of the table of the geometry


def describe_damping(parameters):
    """The rate in force: a ratio at a frequency stands in for it where both are given."""
    ratio, frequency = (parameters.get(f"Dynamics/damping {what}", "0") for what in ("ratio", "frequency"))
    if is_open(ratio) or is_open(frequency):
        return parameters["Dynamics/mass proportional damping"]
    return f"{ratio} at {frequency}"


def describe_torque(parameters):
    """As it is given: on the driven member or on the pinion."""
    on_pinion = parameters.get("Operation/pinion torque", "0")
    return f"{parameters['Operation/torque']} on the {name_driven(parameters)}" if is_open(on_pinion) else f"{on_pinion} on the pinion"


def describe_speeds(parameters):
    """Lowest and highest speed of studies that meet any speed between two, else None."""
    section = {"waves": "Waves", "reduced": "Reduced"}.get(parameters.get("Study/kind"))
    between = [parameters.get(f"{section}/{end} speed") for end in ("lowest", "highest")]
    return between if all(between) and (section == "Waves" or sweeps_speeds(parameters)) else None


def make_title(run):
    """What a run or study is, in one line; the folder's name where it is no gear pair."""
    parameters = run.parameters
    kind = parameters.get("Study/kind", "run")
    parts = [describe_pair(parameters), describe_web(parameters)]
    unused = list_unused(parameters)
    between = describe_speeds(parameters)
    if between or ("Operation/speed" in parameters and "Operation/speed" not in unused):
        parts.append(f"pinion from {between[0]} to {between[1]}" if between else f"pinion at {parameters['Operation/speed']}")
        if "Operation/torque" not in unused:
            parts.append(describe_torque(parameters))
    title = ", ".join(part for part in parts if part) or parameters.get("Compare/title") or run.path.resolve().name
    return title if kind == "run" else f"{title}: {kind}"


def list_case_rows(run):
    """Name and value of what defines the case, as far as it is known."""
    parameters = run.parameters
    if run.summary.get("parameter file"):
        yield "parameter file", Path(run.summary["parameter file"]).name
    # What was derived is in the table of the geometry.
    given = not run.geometry and parameters.get("Gear pair/Proposal/pinion teeth", "0") == "0"
    unused = list_unused(parameters)
    for name, *keys in (BLANK_ROWS if given else ()) + ROWS:
        values = [describe_damping(parameters) if key == "Dynamics/mass proportional damping" else label(VALUES, parameters[key])
                  for key in keys if key in parameters]
        if values and (keys == ZERO_IS_SAID or not all(is_open(value) for value in values)) and not unused.issuperset(keys):
            yield name.format(driven=name_driven(parameters)), ", ".join(values)
    yield from list_sweep_rows(parameters)
    yield from list_error_rows(run)
    mesh = parameters.get("Gear pair/mesh")
    if mesh and mesh != "auto":
        yield "mesh", "by members (numbers of elements in their sections Mesh)" if mesh == "by members" else mesh
    web = describe_web(parameters)
    if web.startswith("web"):
        body = GEAR + "Body/"
        direction = parameters[body + "web direction"]
        yield "web", (f"conical, {parameters[body + 'web thickness']} thick, at {parameters[body + 'web inclination']} to the gear axis, "
                      f"joined to the rim at the {parameters[body + 'web attachment']}" + f", {direction}" * (direction != "auto"))
        yield "rim thickness", parameters[body + "rim thickness"]
    elif web:
        yield "gear body", web
    for name in dict.fromkeys(key.split("/")[0] for key in parameters if key.startswith("Material ")):
        values = (parameters[f"{name}/{what}"] for what in ("Young's modulus", "Poisson's ratio",
                                                           "density"))
        yield name, "E {}, nu {}, {}".format(*values)
    for body in run.bodies():
        yield body["name"], (f"{body['cells']} elements, {body['nodes']} nodes, "
                             f"{body['mass']['value']:.4g} {body['mass']['unit']}")


def list_sweep_rows(parameters):
    """For a reduced pair at many speeds, instead of its speed and its mesh cycles."""
    if not sweeps_speeds(parameters):
        return
    between = describe_speeds(parameters)
    yield "speeds of the pinion", f"{parameters['Reduced/speeds']} from {between[0]} to {between[1]}, {parameters['Reduced/sweep']}"
    decay = parameters.get("Reduced/settling decay times", "0")
    least = "" if is_open(decay) else f" (at least {decay} decay times)"
    yield "mesh cycles per speed", f"{parameters['Reduced/settling mesh cycles']}{least} to settle, {parameters['Reduced/recorded mesh cycles']} recorded"


def list_error_rows(run):
    """Mounting errors and errors of manufacture that are given."""
    for path, value in read_given(run.path).items():
        if path.startswith(ERRORS) and path not in DESIGNED:
            yield path.removeprefix("Gear pair/").replace("/", ", "), value


def list_model_rows(run):
    """What, name, kind and other entries of what a model is made of, as far as they differ from the defaults."""
    given = read_given(run.path)
    for what, word in (("Body", "mesh"), ("Constraint", "kind"), ("Load", "kind"), ("Contact", "kind"), ("Probe", None)):
        start = f"Model/{what} "
        for name in dict.fromkeys(key[len(start):].partition("/")[0] for key in run.parameters if key.startswith(start)):
            entries = {key[len(start) + len(name) + 1:]: value for key, value in given.items() if key.startswith(f"{start}{name}/")}
            entries.pop(word, None)
            yield [what.lower(), name, run.parameters[f"{start}{name}/{word}"] if word else "",
                   "; ".join(f"{entry} {value}" for entry, value in entries.items())]


def list_geometry_rows(geometry):
    """Quantity, unit, pinion and gear of a folder's geometry; of the pair itself in the first column."""
    for name, one in geometry["pair"].items():
        yield [label(GEOMETRY_NAMES, name), one["unit"], one["value"], ""]
    pinion, gear = geometry["pinion"], geometry["gear"]
    for name, one in pinion.items():
        other = gear.get(name)
        if isinstance(one, dict) and isinstance(other, dict):
            yield [label(GEOMETRY_NAMES, name), one["unit"], one["value"], other["value"]]
        else:
            yield [name, "", one, other]


def list_sentences(run):
    """What was computed, in a few sentences."""
    parameters, summary = run.parameters, run.summary
    frequency = run.value("mesh frequency")
    pair = describe_pair(parameters)
    if pair and frequency:
        time = summary["run"]["time"]["value"]
        yield (f"The pinion of the {pair[0].lower()}{pair[1:]} rotates at {parameters['Operation/speed']}. The load is "
               f"{describe_torques(run)}. The mesh frequency is {frequency:.0f} Hz. The run covers {time * frequency:.3g} mesh "
               f"cycles ({1e3 * time:.4g} ms) and starts from {describe_start(parameters)}.")
    elif pair and sweeps_speeds(parameters) and run.value("speeds"):
        yield (f"The pinion of the {pair[0].lower()}{pair[1:]} rotates at {run.value('speeds'):.0f} speeds from "
               f"{run.value('lowest speed'):.5g} to {run.value('highest speed'):.5g} rpm. Each speed starts from the motion at the "
               f"previous speed. The load is {describe_torques(run)}.")
    elif pair and run.changes_speed():
        speed, time = run.history["speed"], summary["run"]["time"]["value"]
        yield (f"The driver speed of the {pair[0].lower()}{pair[1:]} changes from {speed[0]:.0f} to {speed[-1]:.0f} rpm within "
               f"{1e3 * time:.4g} ms. The run starts from {describe_start(parameters)} and has no steady part.")
    if "steady part" in summary:
        # The ripple has a table of its own.
        text, of_ripple = summary["steady part"]["explanation"], summary["steady part"].get("ripple", {}).get("explanation")
        if of_ripple and text.endswith(of_ripple):
            text = text.removesuffix(of_ripple).rstrip(" .;")
        yield text[0].upper() + text[1:] + "."


def describe_torques(run):
    """Torques of both members, the given one alone in files of versions that do not state both."""
    torques = [(run.value(f"{member} torque"), member) for member in ("pinion", "gear")]
    if any(torque is None for torque, _ in torques):
        return describe_torque(run.parameters)
    return " and ".join(f"{torque:.4g} N m on the {member}" for torque, member in torques)


def describe_start(parameters):
    start = parameters.get("Dynamics/start", "")
    if start == "static equilibrium":
        return "equilibrium under centrifugal force and full torque"
    if start == "steady torsional vibration":
        return "the estimated steady torsional vibration"
    if start == "ramp":
        return f"flanks in contact; the torque increases over {parameters['Operation/ramp']} mesh cycles"
    return f"the start \"{start}\""
