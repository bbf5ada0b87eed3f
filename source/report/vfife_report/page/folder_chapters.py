# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters that every folder can have: comparison, tooth contact analysis, loaded tooth contact, pressures, natural frequencies,
lumped model."""
import numpy as np

from ..data.files import read_json
from ..data.shapes import LUMPED
from ..data.table import read_table
from ..measures.contact_analysis import FORMS_HEADER, SIDES, SIDES_HEADER, list_forms, list_sides, read_contact_analysis
from ..measures.ledger import HEADER, list_ledger_rows, list_reasons, read_ledger
from ..measures.speed_peaks import (EXCEEDANCES_CAPTION, EXCEEDANCES_HEADER, PEAKS_CAPTION, PEAKS_HEADER, list_exceedances,
                                    list_peaks)
from ..measures.waves import list_peaks_beyond
from ..plots.bearings import list_bearings
from ..plots.root_stress import list_root_stresses
from .chapter import Chapter
from .parts import EXACT, Cells, Paragraph, list_values

SHOWN_MODES = 12  # of a body at a speed
SHOWN_PRESSURES = 40  # tooth pairs
SHOWN_RESONANCES = 60  # speeds


def tell_ledger(run, plots):
    path = run.path / "comparison.json"
    if not path.is_file():
        return
    ledger = read_ledger(path)
    rows = ledger["rows"]
    yield Paragraph(ledger.get("title", ""))
    # Versions before stated neither cases nor remarks.
    yield Cells(["case", "kind", "folder"], [[one["name"], one["kind"], one["folder"]] for one in ledger.get("cases", [])])
    for remark in ledger.get("remarks", []):
        yield Paragraph(remark[0].upper() + remark[1:] + ".", "alarm")
    yield from plots
    yield Cells(HEADER, list(list_ledger_rows(rows)),
                "The difference is value minus reference, also in percent of the reference. The line below each row names the "
                "reference and the reason of the verdict.", list_reasons(rows), EXACT, {"difference", "%", "tolerance"})


def tell_lumped_model(run, plots):
    yield from plots
    if not run.has_file("lumped.csv"):
        return
    results = read_json(run.path / "lumped.json", LUMPED)
    for part, caption in (("model", "Parameters of the model."), ("response", "Response at the operating speed.")):
        yield Cells(["", "value", "unit"], [[name, one["value"], one["unit"]]
                                            for name, one in results[part].items()], caption)
    yield Cells(["natural frequency [Hz]", "damping ratio [-]", "resonant speed of mesh order 1 [rpm]",
                 "of order 2 [rpm]", "of order 3 [rpm]"],
                [[mode["frequency [Hz]"], mode["damping ratio [-]"]]
                 + mode["critical pinion speeds of mesh orders 1, 2, 3 [rpm]"]
                 for mode in results["modes"]], "Natural frequencies about the loaded state.", digits=EXACT)


def tell_bearings(run, plots):
    yield from plots
    yield Cells(["misalignment at the start", "value", "unit"], list_values(run.summary.get("misalignment", {})))
    if run.bearings is None:
        return
    shown = ("radial force", "force z", "radial displacement")
    yield Cells(["mean at the bearing"] + [run.bearings.label(name) for name in shown],
                [[bearing] + [float(run.bearings[name][run.bearings["bearing"] == bearing].mean()) for name in shown]
                 for bearing in list_bearings(run.bearings)])


def tell_rows(table, columns, rows, caption):
    """Some columns of a table as they are named in its file."""
    return Cells([table.label(name) for name in columns],
                 [[cell(table[name][k]) for name in columns] for k in rows], caption, digits=EXACT)


def tell_shares(table, named, columns, caption):
    """Columns that name a row, and shares in per cent, each with its header."""
    return Cells([*(table.label(name) for name in named), *(header for _, header in columns)],
                 [[*(cell(table[name][k]) for name in named), *(100 * float(table[name][k]) for name, _ in columns)]
                  for k in range(table.n_rows)], caption)


def cell(value):
    return str(value) if isinstance(value, str) else float(value)


def tell_unloaded_contact(run, plots):
    yield from plots
    analysis = read_contact_analysis(run)
    if not analysis:
        return
    working = analysis["working"]
    yield Paragraph(f"The {working['driving member']} drives {working['direction of rotation']}, so the {working['side']} side is in contact.")
    thickness = analysis.get("marking compound thickness")
    if thickness:
        yield Paragraph(f"Contact ellipses are for a marking compound of {thickness['value']:.3g} {thickness['unit']}. Edge contact is "
                        "computed for half a pitch at most.")
    for side in SIDES:
        if side not in analysis:
            yield Paragraph(f"On the {side} side the flanks have no contact inside their borders in the given mounting. Only edge contact "
                            "is possible.", "alarm")
        elif not analysis[side]["has a transfer point"]:
            if analysis[side]["path"]["contact ratio"]["value"] < 1:
                yield Paragraph(f"On the {side} side contact is interrupted before the next tooth pair engages.", "alarm")
            else:
                yield Paragraph(f"On the {side} side the flanks have no transfer point. Contact passes to the next tooth pair at an "
                                "edge.", "alarm")
        elif not analysis[side]["transfer point inside the flanks"]:
            yield Paragraph(f"On the {side} side the path of contact ends before the next tooth pair engages. An edge is in contact "
                            "in between.", "alarm")
    yield Cells(["unequal teeth", "value", "unit"], list_values(analysis.get("unequal teeth", {})),
                "Transmission error without load of successive teeth with their own deviations. All other results include only "
                "deviations that all teeth share.")
    yield Cells(SIDES_HEADER, list_sides(analysis), "Contact without load, lag of the gear and edge contact of both tooth sides "
                "(doc/theory/gear.md, Unloaded tooth contact). The approach is the rotation of the gear by deflection until the edge is in "
                "contact. It is negative if the edge is in contact without load.", digits=EXACT)
    yield Cells(FORMS_HEADER, list_forms(analysis), "Tooth geometry at toe, middle and heel. The root clearance is the design value. The "
                "distance of the tips from the mating fillets includes mounting errors.")


def tell_loaded_contact(run, plots):
    yield from plots
    positions = read_table(run.path / "loaded_contact.csv")
    if positions is not None:
        yield Paragraph(f"The analysis has {positions.n_rows} position{'s' * (positions.n_rows > 1)} per mesh cycle. It misses extremes "
                        "between them, so peak to peak and largest values increase with Loaded contact/positions.", "soft")
    table = read_table(run.path / "coupled_modes.csv")
    if table is not None:
        yield tell_rows(table, ("axes", "frequency", "share of the static rotation", "energy in the gear",
                                "nodal diameter of the gear", "share of the diameter"), range(table.n_rows),
                        "Coupled modes of the loaded pair at the reference position. Axes are \"turning\" in the rotating frame and "
                        "\"standing\" in the fixed frame of the load. Modes with a share of the static rotation contribute to the "
                        "transmission error.")


def tell_grid_pressure(run, plots):
    yield from plots
    table = read_table(run.path / "pressure.csv")
    if table is None:
        return
    text = ("Force, pressures and size of the contact of each tooth pair by position. In column \"on edge\" 1 marks a largest pressure at "
            "an edge.")
    if table.n_rows > SHOWN_PRESSURES:
        text += f" The table shows {SHOWN_PRESSURES} of {table.n_rows} rows of pressure.csv."
    yield tell_rows(table, ("position", "pinion tooth", "gear tooth", "position after the mean contact", "force", "largest pressure inside",
                            "largest pressure", "on edge", "contact width", "contact length"),
                    range(min(table.n_rows, SHOWN_PRESSURES)), text)


def tell_root_stress(run, plots):
    yield from plots
    table = read_table(run.path / "fillet_envelope.csv")
    if table is not None:
        yield Cells(["body", "fillet", "tension [MPa]", "compression [MPa]", "range [MPa]", "face [mm]", "profile [mm]"],
                    list_root_stresses(table),
                    "Largest first and least third principal stress on the surface, and the largest range of one facet with its place. "
                    "Face distances start at the toe, profile distances at the root land. Von Mises stresses of the elements below "
                    "the surface are smaller.")


def tell_frequencies(run, plots):
    yield from plots
    table = read_table(run.path / "modes.csv")
    if table is not None:
        if np.any(table["speed"]) and run.parameters.get("Fem/coriolis") in ("no", "false"):
            yield Paragraph("The analysis omits Coriolis forces (Fem/coriolis), so forward and backward waves have the same frequency.")
        shown = [k for k in range(table.n_rows) if table["mode"][k] <= SHOWN_MODES]
        text = "Lowest natural frequencies of each body at each speed, in the rotating frame of the body."
        if len(shown) < table.n_rows:
            text += f" The table shows {SHOWN_MODES} modes per body and speed, {len(shown)} of {table.n_rows} rows of modes.csv."
        names = ["body", "speed", "mode", "frequency"]
        if np.any(table["nodal diameter"][shown] >= 0):
            names += ["nodal diameter", "nodal circles", "direction"]
        # At rest both observers see the same, and without Coriolis forces waves have no direction for the one at rest.
        if any(whirl in ("forward", "backward") for whirl in table["whirl"][shown]):
            names += ["fixed frequency", "whirl"]
            text += " Fixed frequency and whirl are in the fixed frame."
        cells = tell_rows(table, names, shown, text)
        # The program's -1 stands for shapes without diameters or circles; - for no direction.
        cells.rows = [[None if name in ("nodal diameter", "nodal circles") and value < 0 else "" if value == "-" else value
                       for name, value in zip(names, row)] for row in cells.rows]
        yield cells
    yield from tell_resonances(run)


def tell_resonances(run):
    """Of the free bodies, by the speed of the pinion where they are of a pair."""
    table = read_table(run.path / "resonances.csv")
    if table is None or not table.n_rows:
        return
    of_pair = "pinion speed" in table and np.all(np.isfinite(table["pinion speed"]))
    by = "pinion speed" if of_pair else "speed"
    # Earlier versions met mesh orders and the constant load, order 0, only; unbalance has no order.
    shown = [k for k in np.argsort(np.abs(table[by]), kind="stable") if table["mesh order"][k] != 0][:SHOWN_RESONANCES]
    excitation = ["excitation"] if "excitation" in table else []
    names = ["body", "nodal diameter", "order", *excitation, "wave", "mesh order", "speed", "frequency", *(["pinion speed"] if of_pair else [])]
    text = "Resonances of the free bodies. Column speed is the speed of the body. The frequency is in its rotating frame."
    if of_pair:
        text += " The contact shifts these speeds. Study/kind = waves computes the resonances of the pair in contact."
    if len(shown) == SHOWN_RESONANCES:
        text += f" The table shows the lowest {SHOWN_RESONANCES} of resonances.csv."
    yield tell_rows(table, names, shown, text)


def tell_response(run, plots):
    yield from plots
    if not plots or not run.has_file("wave_response.csv"):
        return
    yield Cells(PEAKS_HEADER, list_peaks(run), PEAKS_CAPTION, digits=EXACT)
    yield Cells(EXCEEDANCES_HEADER, list_exceedances(run), EXCEEDANCES_CAPTION, digits=EXACT)


def tell_waves(run, plots):
    yield from plots
    lines = read_table(run.path / "waves_lines.csv")
    if lines is None:
        return
    # Versions that drove reduced pairs alone did not say so.
    named = ("wave", "nodal diameter", "mesh order", *(["solver"] if "solver" in lines else []))
    yield tell_rows(lines, (*named, "frequency", "speed", "speed in contact", "peak speed"), range(lines.n_rows),
                    "Pinion speeds at which mesh orders are resonant with waves: of the free gear, in contact by linear theory, and at the "
                    "computed peak. The frequency is in the rotating frame of the gear.")
    yield tell_shares(lines, named, (("predicted width", "predicted width [% of the speed]"), ("width", "width [% of the speed]"),
                                     ("damping ratio", "damping ratio [%]"), ("damping ratio of the width", "damping ratio by the width [%]"),
                                     ("damping ratio of the build-up", "damping ratio by the build-up [%]")),
                      "Half-power width of the resonance, and damping ratio of the wave: given, by the computed width and by the "
                      "computed build-up.")
    yield Cells([*named, "predicted amplitude [um]", "amplitude [um]", "stress amplification"],
                [[cell(lines[name][k]) for name in (*named, "predicted amplitude", "amplitude", "stress amplification")]
                 for k in range(lines.n_rows)],
                "Amplitude of the rim at the peak, and largest stress of a probe or fillet over the stress without waves.")
    yield from tell_meetings(run)
    beyond = list(list_peaks_beyond(lines, read_table(run.path / "waves_response.csv")))
    if beyond:
        yield Paragraph(f"These peaks lie outside the computed speeds: {', '.join(beyond)}. The fit extrapolates their speed, width and "
                        "amplitude. Set wider Waves/speed offsets.", "alarm")
    avoided = read_table(run.path / "speeds_to_avoid.csv")
    if avoided is not None:
        yield tell_rows(avoided, ("from", "to", "stress amplification", "waves"), range(avoided.n_rows),
                        "Pinion speeds to avoid, with margins.")


def tell_meetings(run):
    """All resonances of the pair in contact."""
    table = read_table(run.path / "waves_in_contact.csv")
    if table is None or not table.n_rows or "mesh frequency" not in table:
        return
    moment = table["amplitude of the moment"]
    strongest = sorted(np.argsort(-moment, kind="stable")[:SHOWN_RESONANCES])
    swing = table["share of the rotation"] > table["share of the wave"]
    text = ("Resonances of the pair in contact by linear theory. The vibration is the wave of the free gear with the most energy, or the "
            "torsional mode if the rotation of the gear has more.")
    if len(strongest) < table.n_rows:
        text += f" The table shows the {SHOWN_RESONANCES} with the largest contact moment, of {table.n_rows} in waves_in_contact.csv."
    yield Cells(["pinion speed [rpm]", "mesh order", "vibration", "nodal diameter", "order", "width [% of the speed]",
                 "share of the wave [%]", "share of the rotation [%]", "amplitude of the moment [N m]"],
                [[float(table["speed"][k]), float(table["mesh order"][k]), "torsional mode" if swing[k] else name_vibration(table, k),
                  float(table["nodal diameter"][k]), float(table["order"][k]), 100 * float(table["width"][k]),
                  100 * float(table["share of the wave"][k]), 100 * float(table["share of the rotation"][k]), float(moment[k])]
                 for k in strongest], text, digits=EXACT, short=frozenset((
                     "width [% of the speed]", "share of the wave [%]", "share of the rotation [%]", "amplitude of the moment [N m]")))


def name_vibration(table, row):
    return "all sectors in phase" if table["nodal diameter"][row] == 0 else str(table["wave"][row])


def tell_meshes(run, plots):
    yield from plots
    if run.meshes is None:
        return
    names = [name for name in run.meshes.columns if name != "body"]
    yield Cells(["property of the mesh", *run.meshes["body"]], [[run.meshes.label(name), *map(float, run.meshes[name])] for name in names],
                "True values are for the generated surfaces. Differences are in percent of the true values.", digits=EXACT)


LEDGER = Chapter("Comparison", tell_ledger)
TABLE_CHAPTERS = (
    Chapter("Meshes", tell_meshes),
    Chapter("Unloaded tooth contact", tell_unloaded_contact),
    Chapter("Loaded tooth contact by finite elements", tell_loaded_contact),
    Chapter("Contact pressure on the own grid", tell_grid_pressure),
    Chapter("Root stress", tell_root_stress),
    Chapter("Bearings", tell_bearings),
    Chapter("Natural frequencies", tell_frequencies),
    Chapter("Response over speed", tell_response),
    Chapter("Travelling waves", tell_waves),
    Chapter("Lumped model", tell_lumped_model))
