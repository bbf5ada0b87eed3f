# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Main results of the kinds of study beside loaded gear pairs: name, value, unit and accuracy each."""
import numpy as np

from ..data.files import read_json
from ..data.naming import describe_pair
from ..data.shapes import LUMPED
from ..data.table import read_table
from .accuracy import (AT_CORNERS, EDGE_ERROR, FREQUENCY_ERROR, GIVEN_DAMPING, LAG_ERROR, LINEAR_ERRORS, LINEAR_ONLY, NO_ESTIMATE, NO_MESH,
                       find_degree)
from .contact_analysis import read_contact_analysis
from .quantities import list_quantities
from .speed_peaks import find_response, list_peaks

RIGID = 1e-4  # of the highest frequency of a table, below which a mode is a rigid motion
TWINS = 1e-4  # relative difference of the frequencies of one wave and the same wave turned
OF_GIVEN_STIFFNESS = "without mesh; depends on the given stiffness and damping"
TE_RIPPLE = "transmission error, peak to peak"


def list_contact_results(run):
    """Unloaded contact of the side that is in contact."""
    side = read_contact_analysis(run)["working"]["side"]

    def find(name):
        one = run.stated.get(f"{side} side, {name}", {"value": None, "unit": ""})
        return one["value"], one["unit"]

    yield "transmission error without load, peak to peak", *find("peak to peak"), LAG_ERROR
    yield "contact ratio", *find("contact ratio"), NO_MESH
    approaches = [one for name, one in run.stated.items()
                  if name.startswith(f"{side} side, approach before") and one["value"] is not None]
    if approaches:
        least = min(approaches, key=lambda one: one["value"])
        yield "smallest approach before edge contact", least["value"], least["unit"], EDGE_ERROR
    yield "mean contact on the gear, L", *find("mean contact L"), NO_MESH
    yield "mean contact on the gear, h", *find("mean contact h"), NO_MESH


def list_vibrations(table, rows):
    """Rows of modes.csv that are vibrations: no rigid motions, and of two that are one wave and the same wave turned, the first."""
    frequency, diameter = table["frequency"], table["nodal diameter"]
    chosen = []
    for row in rows:
        if frequency[row] < RIGID * frequency[rows].max():
            continue
        if chosen and diameter[row] == diameter[chosen[-1]] and frequency[row] - frequency[chosen[-1]] < TWINS * frequency[row]:
            continue
        chosen.append(row)
    return chosen


def list_frequencies(run):
    """The lowest vibrations of the first body at the first speed."""
    table = read_table(run.path / "modes.csv")
    if table is None:
        return
    mine = (table["body"] == table["body"][0]) & (table["speed"] == table["speed"][0])
    error = FREQUENCY_ERROR[find_degree(run)] if describe_pair(run.parameters) else NO_ESTIMATE
    for k in list_vibrations(table, np.flatnonzero(mine)):
        diameters = table["nodal diameter"][k]
        name = f"frequency {table['mode'][k]:.0f} of {table['body'][k]}"
        yield (f"{name}, {diameters:.0f} nodal diameter{'s' * (diameters != 1)}" if diameters >= 0 else name,
               float(table["frequency"][k]), "Hz", error)


def list_torsional_resonance(run):
    """The resonance in contact with the largest moment of those that are mostly a rotation of the gear."""
    met = read_table(run.path / "waves_in_contact.csv")
    if met is None:
        return
    rows = np.flatnonzero(met["share of the rotation"] > met["share of the wave"])
    if len(rows):
        top = rows[np.argmax(met["amplitude of the moment"][rows])]
        yield f"resonance speed, torsional mode, mesh order {met['mesh order'][top]:.0f}", abs(float(met["speed"][top])), "rpm", LINEAR_ONLY


def name_wave(lines, row):
    diameters, wave = lines["nodal diameter"][row], str(lines["wave"][row])
    solver = f", by {lines['solver'][row]}" if "solver" in lines and len(set(lines["solver"])) > 1 else ""
    return (f"wave of {diameters:.0f} diameter{'s' * (diameters != 1)}{'' if wave == '-' else ', ' + wave}, mesh order "
            f"{lines['mesh order'][row]:.0f}{solver}")


def list_wave_results(run):
    """Resonance speeds of the torsional mode and of the waves with the largest amplitudes; then width, amplitude and stress of the
    largest wave."""
    yield from list_torsional_resonance(run)
    lines = read_table(run.path / "waves_lines.csv")
    if lines is None:
        return
    computed = np.isfinite(lines["peak speed"])
    size = np.where(computed, lines["amplitude"], lines["predicted amplitude"])
    order = np.argsort(-np.nan_to_num(size), kind="stable")
    for k in order:
        predicted = abs(float(lines["speed in contact"][k]))
        if computed[k]:
            yield (f"resonance speed, {name_wave(lines, k)}", abs(float(lines["peak speed"][k])), "rpm",
                   f"fitted peak; {predicted:.0f} rpm by linear theory; {NO_ESTIMATE}")
        else:
            yield (f"resonance speed, {name_wave(lines, k)}", predicted, "rpm",
                   LINEAR_ERRORS.get(min(int(lines["nodal diameter"][k]), 3), LINEAR_ONLY))
    largest = order[0]
    width, amplitude = ("width", "amplitude") if computed[largest] else ("predicted width", "predicted amplitude")
    method = f"; {lines['predicted amplitude'][largest]:.3g} um by linear theory" if computed[largest] else "; linear theory"
    for name, value, unit, remark in (("half-power width", 100 * lines[width][largest], "% of the speed", ""),
                                      ("amplitude of the rim", lines[amplitude][largest], lines.units[amplitude], method),
                                      ("stress amplification", lines["stress amplification"][largest], "-", "; upper bound")):
        yield f"{name}, {name_wave(lines, largest)}", float(value), unit, GIVEN_DAMPING + remark


def list_lumped_results(run):
    """Largest response over speed, response at the operating speed, first natural frequency."""
    results = read_json(run.path / "lumped.json", LUMPED)
    sweep, response = results.get("sweep", {}), results["response"]
    table = find_response(run)
    if table is not None:
        accuracy = f"{OF_GIVEN_STIFFNESS}; {describe_spacing(table)}"
        for name, words in (("largest peak to peak dte", f"largest {TE_RIPPLE}{name_speed(sweep.get('at the speed'))}"),
                            ("largest difference of both directions", "transmission error, largest difference of both directions of speed")):
            if name in sweep:
                yield words, sweep[name]["value"], sweep[name]["unit"], accuracy
    for mode in results["modes"][:1]:
        yield "natural frequency of the first mode", mode["frequency [Hz]"], "Hz", OF_GIVEN_STIFFNESS
    for name, words in (("mean dte", "transmission error, mean"), ("peak to peak dte", TE_RIPPLE),
                        ("peak to peak force", "gear mesh force, peak to peak")):
        if name in response:
            yield words + name_speed(response.get("speed")), response[name]["value"], response[name]["unit"], OF_GIVEN_STIFFNESS


def name_speed(speed):
    """", at 2150 rpm" for a quantity; nothing where there is none."""
    return f", at {speed['value']:.5g} {speed['unit']}" if speed and speed["value"] is not None else ""


def describe_spacing(table):
    """Distance of the speeds of a response, in words."""
    speeds = np.unique(np.round(table["speed"][np.isfinite(table["speed"])], 6))
    return f"speeds are {np.diff(speeds).max():.3g} rpm apart" if len(speeds) > 1 else "one speed"


def list_speed_results(run):
    """The largest responses of a reduced pair over speed."""
    table = find_response(run)
    if table is None:
        return
    accuracy = f"{describe_spacing(table)}; {NO_ESTIMATE}"
    for name, place, value, unit, speed in list_peaks(run):
        words = {"peak to peak dte": f"largest {TE_RIPPLE}", "largest force": "largest contact force", "amplification":
                 "largest stress amplification"}.get(name, name)
        yield f"{words}{', ' * bool(place)}{place}, at {speed:.5g} rpm", value, unit, accuracy


def list_order_results(run):
    """Largest amplitudes of the mesh orders of a run whose speed changes."""
    orders = run.orders
    for name in ("dte amplitude", "contact force total amplitude"):
        for order in np.unique(orders["mesh order"])[:2]:
            rows = np.flatnonzero((orders["mesh order"] == order) & np.isfinite(orders[name]))
            if len(rows):
                top = rows[np.argmax(orders[name][rows])]
                yield (f"{name} of mesh order {order:.0f}, largest, at {abs(orders['speed'][top]):.5g} rpm", float(orders[name][top]),
                       orders.units[name], f"depends on the rate of the speed change; {NO_ESTIMATE}")


def list_mesh_results(run):
    """Elements, and mass beside the mass of the generated body."""
    meshes = run.meshes
    for k, body in enumerate(meshes["body"]):
        yield f"elements of {body}", int(meshes["elements"][k]), "-", "exact"
        if "mass difference" in meshes:
            yield (f"mass of {body}", float(meshes["mass"][k]), meshes.units["mass"],
                   f"differs by {meshes['mass difference'][k]:.2g} % from the generated body")
    yield "least scaled Jacobian", float(meshes["least scaled jacobian"].min()), "-", "exact"


def list_refined(run):
    """The named result of an adaptive refinement, with its last change; nothing without refinement."""
    refined = read_table(run.path / "adaptive_refinement.csv")
    if refined is not None and refined.n_rows > 1:
        name, _, unit = str(refined["result"][-1]).partition(" [")
        yield (name, float(refined["value"][-1]), unit.rstrip("]"),
               f"changes by {abs(refined['change'][-1]):.2g} % in the last refinement")


def list_model_results(run):
    """Of a model: the result of an adaptive refinement, largest values of the whole model, values of the probes."""
    yield from list_refined(run)
    stated = run.summary.get("figures", {})
    for name in ("largest displacement", "largest von mises", "strain energy"):
        if name in stated:
            yield (name.replace("mises", "Mises stress"), stated[name]["value"], stated[name]["unit"],
                   f"{AT_CORNERS}; {NO_ESTIMATE}" if name == "largest von mises" else NO_ESTIMATE)
    yield from ((*one, NO_ESTIMATE) for one in list_quantities(run))
