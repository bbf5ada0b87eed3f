# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters that every folder can have: comparison ledger, tooth contact analysis, loaded tooth contact,
pressures, natural frequencies, lumped model."""
from ..data.files import read_json
from ..data.shapes import LUMPED
from ..data.table import read_table
from ..measures.ledger import HEADER, list_ledger_rows, list_reasons, read_ledger
from ..measures.speed_peaks import list_exceedances, list_peaks
from ..plots.bearings import list_bearings
from ..plots.root_stress import list_root_stresses
from .chapter import Chapter
from .parts import EXACT, Cells, Paragraph, list_values

SHOWN_MODES = 12  # of a body at a speed
SHOWN_PRESSURES = 40  # tooth pairs


def tell_ledger(run, plots):
    path = run.path / "comparison.json"
    if not path.is_file():
        return
    title, rows = read_ledger(path)
    yield Paragraph(title)
    differing = sum(row["verdict"] == "differs" for row in rows)
    yield Paragraph(f"{len(rows)} comparisons, {differing} differ by more than their tolerance.",
                    "alarm" if differing else "")
    yield from plots
    yield Cells(HEADER, list(list_ledger_rows(rows)),
                "Difference: value less reference, and over the reference's magnitude. Below each row what it is compared with, "
                "and why.", list_reasons(rows), EXACT)


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


def cell(value):
    return str(value) if isinstance(value, str) else float(value)


def tell_loaded_contact(run, plots):
    yield from plots
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
                    "with its place: along the face from the toe, up the profile from the root land.")
    yield from plots


def tell_frequencies(run, plots):
    table = read_table(run.path / "modes.csv")
    if table is not None:
        shown = [k for k in range(table.n_rows) if table["mode"][k] <= SHOWN_MODES]
        text = "Lowest natural frequencies of each body at each speed, in axes that turn with it."
        if len(shown) < table.n_rows:
            text += f" {SHOWN_MODES} each of {table.n_rows} rows of modes.csv."
        yield tell_rows(table, ("body", "speed", "mode", "frequency", "nodal diameter", "nodal circles", "direction",
                                "fixed frequency", "whirl"), shown, text)
    yield from plots


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
    yield tell_rows(lines, (*named, "speed", "speed in contact", "peak speed", "frequency", "damping ratio",
                            "damping ratio of the width", "damping ratio of the build-up"), range(lines.n_rows),
                    "Where mesh orders meet waves: by the modes of the free gear, in contact by linear theory, and measured; "
                    "damping ratios of the wave, and by the measured width and build-up.")
    yield tell_rows(lines, (*named, "predicted width", "width", "predicted amplitude", "amplitude", "stress amplification"),
                    range(lines.n_rows),
                    "Half-power width over the speed, amplitude of the rim and largest stress at a probe over that without "
                    "waves, at the peak.")
    avoided = read_table(run.path / "speeds_to_avoid.csv")
    if avoided is not None:
        yield tell_rows(avoided, ("from", "to", "stress amplification", "waves"), range(avoided.n_rows),
                        "Pinion speeds to avoid, with margins.")


LEDGER = Chapter("Comparison ledger", tell_ledger)
TABLE_CHAPTERS = (
    Chapter("Unloaded tooth contact"),
    Chapter("Loaded tooth contact by finite elements", tell_loaded_contact),
    Chapter("Pressures on their own grids", tell_grid_pressure),
    Chapter("Root stress", tell_root_stress),
    Chapter("Bearings", tell_bearings),
    Chapter("Natural frequencies", tell_frequencies),
    Chapter("Response over speed", tell_response),
    Chapter("Travelling waves", tell_waves),
    Chapter("Lumped model", tell_lumped_model))
