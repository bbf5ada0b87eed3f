# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters of the report of one run, each of what the run has files for."""
import numpy as np

from ..data.columns import JUDGED
from ..data.needs import has_pair, has_probes, has_rim_over_meshes
from ..measures.checks import list_checks
from ..measures.passages import DURATION_LEVEL_IN_WORDS, find_passages
from ..measures.lines import HIGHEST_LINE_ORDER
from ..measures.periodicity import measure_column
from ..measures.quantities import list_quantities, list_reactions, remark
from ..measures.run_lines import (HARMONICS_HEADER, LINES_HEADER, describe_resolution, list_harmonics,
                                  list_other_lines)
from ..measures.sidebands import SIDEBANDS_HEADER, list_sidebands
from ..measures.waves import list_wave_lines
from .chapter import Chapter
from .parts import EXACT, Cells, Paragraph, list_values
from .result_chapters import TRUST
from .words import list_case_rows, list_geometry_rows, list_model_rows

SOLVED = 1e-5  # of the largest: what equations of an equilibrium are solved to


def tell_case(run, plots):
    yield Cells(["", "value used"], list(list_case_rows(run)))
    if run.geometry:
        yield Cells(["geometry", "unit", "pinion", "gear"], list(list_geometry_rows(run.geometry)),
                    "Given, derived or proposed; in the first rows of the pair.", digits=EXACT)
    yield Cells(["of the model", "name", "kind", "given"], list(list_model_rows(run)), "Given: entries that differ from their "
                "defaults (doc/parameter_reference.md).")
    # A comparison's case is that of each of its cases.
    if run.parameters and run.parameters.get("Study/kind") != "compare":
        yield Paragraph("All parameters that were used: parameters.prm in the run's folder, where 0 stands for a size that was "
                        "derived.", "soft")


def tell_quantities(run, plots):
    rows = [[name, value, unit, remark(run, name)] for name, value, unit in list_quantities(run)]
    marked = any(row[-1] for row in rows)
    nearest = run.summary.get("nearest wave")
    if nearest:
        yield Paragraph(f"Nearest wave in contact to the speed of operation, mesh orders 1 to 3: {nearest}.")
    if run.is_ripple_steady() is False:
        yield Paragraph("The ripple is not steady: its figures are those of this record, and half of it gives others.", "alarm")
    yield Cells(["quantity", "value", "unit"] + ["remark"] * marked, [row if marked else row[:-1] for row in rows],
                "Definitions in doc/reference/report.md." if run.history is None or run.is_equilibrium() else
                f"{describe_part(run)} values of the whole run; definitions in doc/reference/report.md.")
    yield Cells(["constraint", "force x [N]", "force y [N]", "force z [N]", "moment x [N mm]", "moment y [N mm]",
                 "moment z [N mm]"], list(list_reactions(run)), "Reactions: what constraints and bearings exert on the bodies.")


def describe_part(run):
    """Of what figures are, as the beginning of a sentence."""
    if not run.steady_part():
        return "Largest"
    return "Of the steady part, largest" if run.is_steady() else "Of the last third, as no steady part was found, largest"


def is_preloaded(run):
    return run.parameters.get("Dynamics/start", "static equilibrium") == "static equilibrium"


def tell_transmission_error(run, plots):
    yield from plots
    if plots:
        yield Cells(["part", "value", "unit"], list_values(run.summary.get("transmission error", {})),
                    "Parts of the transmission error in the equilibrium before the start." if is_preloaded(run) else
                    "Parts of the transmission error in the equilibrium under all the torque, to which this start comes later only.")


def tell_contact(run, plots):
    if run.edge_contact:
        text = run.edge_contact["explanation"]
        yield Paragraph(text[0].upper() + text[1:] + ".", "alarm" if run.edge_contact["edges carry"] else "")
    yield from plots


def tell_spectra(run, plots):
    if not plots:
        return
    yield from plots
    yield Cells(["history"] + HARMONICS_HEADER, list_harmonics(run, 5),
                "Largest harmonics of the gear mesh, from the mean mesh cycle.")
    yield Cells(["history"] + LINES_HEADER, list_other_lines(run),
                f"Strongest lines of what does not repeat with the mesh, up to order {HIGHEST_LINE_ORDER} "
                "(Hann's window).")
    yield Cells(SIDEBANDS_HEADER, list(list_sidebands(run)),
                "One rotation below and above the harmonics of the mesh (Hann's window).")
    yield Paragraph(describe_resolution(run), "soft")
    found = [(column, measure_column(run, column)) for column in JUDGED]
    yield Cells(["history", "unit", "meshes", "ripple", "rest", "change, rms", "change, largest",
                 "trend a mesh", "periodic [%]"],
                [[column, run.history.units[column], p.meshes, p.ripple, p.remainder, p.change,
                  p.largest_change, p.trend, 100 * p.periodic_share] for column, p in found if p],
                "How far mesh cycles differ: ripple (peak to peak) of the mean mesh, standard deviation "
                "of the rest, change from one mesh to the next.")


def tell_probes(run, plots):
    yield from plots
    if run.probes is not None and not has_probes(run):
        shown = [name for name in run.probes.columns if name not in ("time", "probe")]
        yield Cells(["at the probe", *run.probes["probe"]],
                    [[run.probes.label(name), *map(float, suppress_rounding(run.probes, name))] for name in shown])
        return
    yield Cells(["probe", "peak [MPa]", "at [ms]", "least [MPa]", "steady [MPa]", "passage", "duration [ms]", "record"],
                [[name, p.peak, 1e3 * p.peak_time, p.least, p.steady, "dip" if p.is_dip else "rise",
                  1e3 * p.duration if p.whole else None,
                  "whole passage" if p.whole else "begins or ends within it"]
                 for name, p in find_passages(run)],
                "Peak and least: of the whole record. The passage through the mesh is where the stress is farthest from the "
                "steady stress, the median of a whole turn (without copies in all sectors: of the record outside the passage): "
                "a rise above it or a dip below it; duration: "
                f"farther than {DURATION_LEVEL_IN_WORDS} of that.")
    for probe in run.summary.get("probes", {}).values():
        yield Paragraph(probe["explanation"] + ".")


def suppress_rounding(table, name):
    """A column with zeros for what the solution of an equilibrium leaves beside the columns of its unit."""
    largest = max(np.abs(table[other]).max() for other in table.columns if table.units[other] == table.units[name])
    return np.where(np.abs(table[name]) > SOLVED * largest, table[name], 0)


def tell_rim(run, plots):
    yield from plots
    yield Cells(["nodal diameters", "travels", "frequency [Hz]", "amplitude [um]"],
                list(list_wave_lines(run)) if has_rim_over_meshes(run) else [],
                "Strongest lines of the axial waves, frequencies in the turning gear.")
    if has_rim_over_meshes(run):
        yield Paragraph(describe_resolution(run), "soft")


def tell_energy(run, plots):
    yield from plots
    if run.is_equilibrium():
        return
    rows = list_values(run.summary.get("energy", {}))
    # A model without a gear pair has few of the parts.
    yield Cells(["energy ledger", "value", "unit"], rows if has_pair(run) else [row for row in rows if row[1]])
    yield Cells(["damping of", "net torque [N m]", "power [W]", "spin of the last instant less that of the first [rpm]"],
                [[a["body"]] + [a[name]["value"] for name in ("net torque", "power", "spin drift")]
                 for a in run.summary.get("damping audit", []) if a["net torque"]["value"] or a["power"]["value"]],
                "Damping exerts no torque about the axis where the net torque is none. Spin: of all the body's mass, also of a driven "
                "one, with the torsional vibration of that instant.")


def tell_checks(run, plots):
    rows = list(list_checks(run))
    if not rows:
        return
    yield Cells(["check", "value", "asked for", "verdict"], rows)
    for kind in ("contradictions", "warnings"):
        for text in run.summary.get(kind, []):
            yield Paragraph(f"{kind[:-1].capitalize()}: {text}", "alarm")


def tell_computation(run, plots):
    statistics = run.summary.get("run")
    if not statistics:
        return
    # Studies without steps in time have neither them nor a rate.
    rows = [[name, value["value"], value["unit"]] for name, value in statistics.items()
            if isinstance(value, dict) and "unit" in value and value["value"]]
    rows += [[name, value, ""] for name, value in statistics.items() if isinstance(value, int) and value]
    yield Cells(["", "value", "unit"], rows)
    yield Cells(["section", "time", "unit"], list_values(statistics.get("timers", {})))
    origin = [run.summary.get(name, "") for name in ("version", "revision")]
    kernels = f"; kernels for {statistics['instruction set']}" if "instruction set" in statistics else ""
    yield Paragraph(f"Program version {origin[0]}, revision {origin[1]}{kernels}.", "soft")


# Pictures and what belongs to them come before tables.
PICTURE_CHAPTERS = (
    Chapter("Transmission error", tell_transmission_error),
    Chapter("Contact", tell_contact),
    Chapter("Spectra and periodicity", tell_spectra),
    Chapter("Over the speed"),
    Chapter("Stress at the probes", tell_probes),
    Chapter("Motion of the probes"),
    Chapter("Motion of the rim", tell_rim),
    Chapter("Sections"))
CASE_CHAPTERS = (
    Chapter("Key figures", tell_quantities),
    Chapter("The case", tell_case),
    Chapter("Energy and damping", tell_energy),
    Chapter("Checks", tell_checks),
    TRUST,
    Chapter("The computation", tell_computation))
