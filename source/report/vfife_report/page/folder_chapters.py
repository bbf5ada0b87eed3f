# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters that every folder can have: comparison ledger, tooth contact analysis, loaded tooth contact,
pressures, natural frequencies, lumped model."""
import numpy as np

from ..data.files import read_json
from ..data.shapes import LUMPED
from ..data.table import read_table
from ..measures.contact_analysis import FORMS_HEADER, SIDES, SIDES_HEADER, list_forms, list_sides, read_contact_analysis
from ..measures.ledger import HEADER, VERDICTS, list_ledger_rows, list_reasons, read_ledger
from ..measures.speed_peaks import list_exceedances, list_peaks
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
    agreeing, differing, open_ones = (sum(row["verdict"] == verdict for row in rows) for verdict in VERDICTS)
    yield Paragraph(f"Of {len(rows)} comparisons within their tolerance: {agreeing}; beyond it: {differing}; not judged: {open_ones}.",
                    "alarm" if differing else "")
    yield from plots
    yield Cells(HEADER, list(list_ledger_rows(rows)),
                "Difference: value less reference, and over the reference's magnitude. Below each row what it is compared with, "
                "and why.", list_reasons(rows), EXACT, {"difference", "%", "tolerance"})


def tell_lumped_model(run, plots):
    yield from plots
    if not run.has_file("lumped.csv"):
        return
    results = read_json(run.path / "lumped.json", LUMPED)
    for part, caption in (("model", "The model."), ("response", "Response at the speed of operation.")):
        yield Cells(["", "value", "unit"], [[name, one["value"], one["unit"]]
                                            for name, one in results[part].items()], caption)
    yield Cells(["natural frequency [Hz]", "damping ratio [-]", "met by mesh order 1 at [rpm]",
                 "by 2", "by 3"],
                [[mode["frequency [Hz]"], mode["damping ratio [-]"]]
                 + mode["critical pinion speeds of mesh orders 1, 2, 3 [rpm]"]
                 for mode in results["modes"]], "Natural frequencies about the loaded state.", digits=EXACT)


def tell_bearings(run, plots):
    yield from plots
    yield Cells(["misalignment at the start", "value", "unit"], list_values(run.summary.get("misalignment", {})))
    if run.bearings is None:
        return
    shown = ("radial force", "force z", "radial displacement")
    yield Cells(["bearing, means"] + [run.bearings.label(name) for name in shown],
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
    yield Paragraph(f"The {working['driving member']} drives {working['direction of rotation']}: the {working['side']} side works.")
    thickness = analysis.get("marking compound thickness")
    if thickness:
        yield Paragraph(f"Ellipses are those of a marking compound of {thickness['value']:.3g} {thickness['unit']}; edges are "
                        "followed for half a pitch at most.")
    for side in SIDES:
        if side not in analysis:
            yield Paragraph(f"On the {side} side the flanks have no contact inside their borders for the given mounting; only "
                            "edge contact is possible.", "alarm")
        elif not analysis[side]["hands over"]:
            yield Paragraph(f"On the {side} side contact is interrupted before the next tooth pair engages.", "alarm")
        elif not analysis[side]["hands over inside the flanks"]:
            yield Paragraph(f"On the {side} side the path of contact ends before the next tooth pair engages; there an edge is in contact.",
                            "alarm")
    yield Cells(["teeth that differ", "value", "unit"], list_values(analysis.get("unequal teeth", {})),
                "Transmission error without load of teeth with their errors, one after the other; all other figures are of the errors "
                "that all teeth share.")
    yield Cells(SIDES_HEADER, list_sides(analysis), "Both sides of the teeth: contact without load, the gear's lag, and where edges "
                "would carry (doc/theory/gear.md, Unloaded tooth contact). Approach: turn of the gear by bending until the edge carries; negative "
                "where it carries without load.", digits=EXACT)
    yield Cells(FORMS_HEADER, list_forms(analysis), "What is left of the teeth at toe, middle and heel. Root clearance: as designed; "
                "the distance of tips from the other member's fillets has the mounting errors in it.")


def tell_loaded_contact(run, plots):
    yield from plots
    positions = read_table(run.path / "loaded_contact.csv")
    if positions is not None:
        yield Paragraph(f"{positions.n_rows} position{'s' * (positions.n_rows > 1)} over a mesh cycle: what lies between them is "
                        "seen by none, so that peak to peak and largest values grow with their number (Loaded contact/positions).", "soft")
    table = read_table(run.path / "coupled_modes.csv")
    if table is not None:
        yield tell_rows(table, ("axes", "frequency", "share of the static turn", "energy in the gear",
                                "nodal diameter of the gear", "share of the diameter"), range(table.n_rows),
                        "Natural vibrations of the loaded pair in contact at the reference position: in the axes that turn with the "
                        "bodies, and of those that stand in space, as the load does. Modes that take part in the static turn show in the "
                        "transmission error.")


def tell_grid_pressure(run, plots):
    yield from plots
    table = read_table(run.path / "pressure.csv")
    if table is None:
        return
    text = "Tooth pairs by position: pressures, whether the largest is one of an edge, and how wide and long the contact is."
    if table.n_rows > SHOWN_PRESSURES:
        text += f" {SHOWN_PRESSURES} of {table.n_rows} rows of pressure.csv."
    yield tell_rows(table, ("position", "pinion tooth", "gear tooth", "after the mesh", "force", "largest pressure inside",
                            "largest pressure", "on edge", "contact width", "contact length"),
                    range(min(table.n_rows, SHOWN_PRESSURES)), text)


def tell_root_stress(run, plots):
    table = read_table(run.path / "fillet_envelope.csv")
    if table is not None:
        yield Cells(["body", "fillet", "tension [MPa]", "compression [MPa]", "range [MPa]", "face [mm]", "profile [mm]"],
                    list_root_stresses(table),
                    "Largest first and least third principal stress on the surface, and the largest range that one facet sees, "
                    "with its place: along the face from the toe, up the profile from the root land. Of the surface itself: von Mises "
                    "stresses of a fillet's elements, which lie inside, are smaller.")
    yield from plots


def tell_frequencies(run, plots):
    table = read_table(run.path / "modes.csv")
    if table is not None:
        if np.any(table["speed"]) and run.parameters.get("Fem/coriolis") in ("no", "false"):
            yield Paragraph("Coriolis forces are left out (Fem/coriolis): waves that run forward and backward have the same frequency "
                            "here, and stand.")
        shown = [k for k in range(table.n_rows) if table["mode"][k] <= SHOWN_MODES]
        text = "Lowest natural frequencies of each body at each speed, in axes that turn with it."
        if len(shown) < table.n_rows:
            text += f" {SHOWN_MODES} each of {table.n_rows} rows of modes.csv."
        names = ["body", "speed", "mode", "frequency"]
        if np.any(table["nodal diameter"][shown] >= 0):
            names += ["nodal diameter", "nodal circles", "direction"]
        # At rest both observers see the same, and without Coriolis forces waves have no direction for the one at rest.
        if any(whirl in ("forward", "backward") for whirl in table["whirl"][shown]):
            names += ["fixed frequency", "whirl"]
            text += " Fixed frequency and whirl: as an observer at rest sees them."
        cells = tell_rows(table, names, shown, text)
        # The program's -1 stands for shapes without diameters or circles; - for no direction.
        cells.rows = [[None if name in ("nodal diameter", "nodal circles") and value < 0 else "" if value == "-" else value
                       for name, value in zip(names, row)] for row in cells.rows]
        yield cells
    yield from plots
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
    text = ("Speeds at which orders meet vibrations of each body by itself. Column speed: of that body. Frequency: in axes that turn "
            "with it.")
    if of_pair:
        text += (" The contact moves these speeds; those of the pair in contact, with the swing, are found by Study/kind = waves.")
    if len(shown) == SHOWN_RESONANCES:
        text += f" The lowest {SHOWN_RESONANCES} of resonances.csv."
    yield tell_rows(table, names, shown, text)


def tell_response(run, plots):
    yield from plots
    if not plots or not run.has_file("wave_response.csv"):
        return
    yield Cells(["figure", "place", "largest", "unit", "at [rpm]"], list_peaks(run), "Largest over all speeds.", digits=EXACT)
    yield Cells(["quantity", "from [rpm]", "to [rpm]", "largest amplification", "at [rpm]"], list_exceedances(run),
                "Speeds at which contact force over its mean or a stress over that without vibration is larger than allowed "
                "(Reduced/allowed amplification).", digits=EXACT)


def tell_waves(run, plots):
    yield from plots
    lines = read_table(run.path / "waves_lines.csv")
    if lines is None:
        return
    # Versions that drove reduced pairs alone did not say so.
    named = ("wave", "nodal diameter", "mesh order", *(["solver"] if "solver" in lines else []))
    yield tell_rows(lines, (*named, "frequency", "speed", "speed in contact", "peak speed"), range(lines.n_rows),
                    "Pinion speeds at which mesh orders meet waves: by the modes of the free gear, in contact by linear theory, and "
                    "where the driven wave is largest. Frequency: in axes that turn with the gear.")
    yield tell_shares(lines, named, (("predicted width", "predicted width [% of the speed]"), ("width", "width [% of the speed]"),
                                     ("damping ratio", "damping ratio [%]"), ("damping ratio of the width", "by the width [%]"),
                                     ("damping ratio of the build-up", "by the build-up [%]")),
                      "Half-power width of the resonance; damping ratio of the wave as it is given, by the measured width and by the "
                      "measured build-up.")
    yield Cells([*named, "predicted amplitude [um]", "amplitude [um]", "stress amplification"],
                [[cell(lines[name][k]) for name in (*named, "predicted amplitude", "amplitude", "stress amplification")]
                 for k in range(lines.n_rows)],
                "Amplitude of the rim, and largest stress at a probe over that without waves, at the peak.")
    yield from tell_meetings(run)
    beyond = list(list_peaks_beyond(lines, read_table(run.path / "waves_response.csv")))
    if beyond:
        yield Paragraph(f"Peaks beyond the speeds that were driven: {', '.join(beyond)}. Their speed, width and amplitude are "
                        "continued by the fit, not seen; Waves/speed offsets may reach further.", "alarm")
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
    swing = table["share of the turn"] > table["share of the wave"]
    text = ("Pinion speeds at which mesh orders meet free vibrations of the pair in contact, by linear theory. Wave: the free gear's "
            "that has most of the energy; swing: the turn of the gear on the contact has more.")
    if len(strongest) < table.n_rows:
        text += f" The {SHOWN_RESONANCES} with the largest moment of the contact, of {table.n_rows} in waves_in_contact.csv."
    yield Cells(["speed [rpm]", "mesh order", "vibration", "nodal diameter", "order", "width [% of the speed]",
                 "share of the wave [%]", "share of the turn [%]", "amplitude of the moment [N m]"],
                [[float(table["speed"][k]), float(table["mesh order"][k]), "swing" if swing[k] else name_vibration(table, k),
                  float(table["nodal diameter"][k]), float(table["order"][k]), 100 * float(table["width"][k]),
                  100 * float(table["share of the wave"][k]), 100 * float(table["share of the turn"][k]), float(moment[k])]
                 for k in strongest], text, digits=EXACT, short=frozenset((
                     "width [% of the speed]", "share of the wave [%]", "share of the turn [%]", "amplitude of the moment [N m]")))


def name_vibration(table, row):
    return "all sectors alike" if table["nodal diameter"][row] == 0 else str(table["wave"][row])


def tell_meshes(run, plots):
    yield from plots
    if run.meshes is None:
        return
    names = [name for name in run.meshes.columns if name != "body"]
    yield Cells(["of the mesh", *run.meshes["body"]], [[run.meshes.label(name), *map(float, run.meshes[name])] for name in names],
                "True: of the surfaces that the mesh has been made for; differences in per cent of them.", digits=EXACT)


LEDGER = Chapter("Comparison ledger", tell_ledger)
TABLE_CHAPTERS = (
    Chapter("Meshes", tell_meshes),
    Chapter("Unloaded tooth contact", tell_unloaded_contact),
    Chapter("Loaded tooth contact by finite elements", tell_loaded_contact),
    Chapter("Pressures on their own grids", tell_grid_pressure),
    Chapter("Root stress", tell_root_stress),
    Chapter("Bearings", tell_bearings),
    Chapter("Natural frequencies", tell_frequencies),
    Chapter("Response over speed", tell_response),
    Chapter("Travelling waves", tell_waves),
    Chapter("Lumped model", tell_lumped_model))
