# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters of the report of one run, each of what the run has files for."""
import numpy as np

from ..data.columns import JUDGED
from ..data.labels import COMPUTATION, ENERGIES, PARTS_OF_ERROR, label
from ..data.naming import is_open
from ..data.needs import has_pair, has_probes, has_rim_over_meshes
from ..measures.checks import list_checks
from ..measures.passages import DURATION_LEVEL_IN_WORDS, find_passages
from ..measures.periodicity import measure_column
from ..measures.quantities import list_quantities, list_reactions, remark
from ..measures.run_lines import (HARMONICS_CAPTION, HARMONICS_HEADER, LINES_CAPTION, LINES_HEADER, describe_resolution,
                                  list_harmonics, list_other_lines)
from ..measures.sidebands import SIDEBANDS_HEADER, list_sidebands
from ..measures.waves import list_wave_lines
from .chapter import Chapter
from .parts import EXACT, Cells, Paragraph, list_values
from .result_chapters import TRUST
from .words import FINDINGS, RECORD_ONLY, list_case_rows, list_geometry_rows, list_model_rows

SOLVED = 1e-5  # of the largest: what equations of an equilibrium are solved to


def tell_case(run, plots):
    yield Cells(["", "value used"], list(list_case_rows(run)))
    if run.geometry:
        yield Cells(["geometry", "unit", "pinion", "gear"], list(list_geometry_rows(run.geometry)),
                    "Input values and values derived from them. The first rows are for the pair as a whole.", digits=EXACT)
    yield Cells(["part of the model", "name", "kind", "parameters"], list(list_model_rows(run)),
                "The last column lists the parameters that differ from their defaults (doc/parameter_reference.md).")
    # A comparison's case is that of each of its cases.
    if run.parameters and run.parameters.get("Study/kind") != "compare":
        yield Paragraph("The file parameters.prm in the results folder lists all parameters.", "soft")


def tell_quantities(run, plots):
    rows = [[name, value, unit, remark(run, name)] for name, value, unit in list_quantities(run)]
    marked = any(row[-1] for row in rows)
    if run.is_ripple_steady() is False:
        yield Paragraph(f"The ripple is still transient. {RECORD_ONLY}", "alarm")
    defined = "doc/reference/report.md defines the quantities."
    if any("rim, largest von Mises stress" in name for name, *_ in rows):
        defined = f"Stresses of web, rim and hub exclude flanks and fillets. {defined}"
    yield Cells(["quantity", "value", "unit"] + ["remark"] * marked, [row if marked else row[:-1] for row in rows],
                defined if run.history is None or run.is_equilibrium() else f"{describe_part(run)} {defined}")
    yield Cells(["constraint", "force x [N]", "force y [N]", "force z [N]", "moment x [N mm]", "moment y [N mm]",
                 "moment z [N mm]"], list(list_reactions(run)), "Reactions of constraints and bearings on the bodies.")


def describe_part(run):
    """The times that quantities cover, in sentences."""
    whole = "Largest values cover the whole run."
    if not run.steady_part():
        return whole
    return (f"Means and peak to peak values cover the steady part. {whole}" if run.is_steady() else
            f"Means and peak to peak values cover the last third, because no steady part was found. {whole}")


def is_preloaded(run):
    return run.parameters.get("Dynamics/start", "static equilibrium") in ("static equilibrium", "steady torsional vibration")


def tell_transmission_error(run, plots):
    yield from plots
    if plots:
        yield Cells(["part", "value", "unit"], list_values(run.summary.get("transmission error", {}), PARTS_OF_ERROR),
                    "Parts of the transmission error in the initial equilibrium. The run adds inertia forces of the deformation, which the "
                    "bodies rotate through, so its first value differs from the total." if is_preloaded(run) else
                    "Parts of the transmission error in the equilibrium under full torque. The run reaches this torque after its start.")


def tell_contact(run, plots):
    if run.edge_contact:
        text = run.edge_contact["explanation"]
        yield Paragraph(text[0].upper() + text[1:] + ".", "alarm" if run.edge_contact["edge contact"] else "")
    yield from plots


def tell_spectra(run, plots):
    if not plots:
        return
    yield from plots
    yield Cells(["history"] + HARMONICS_HEADER, list_harmonics(run, 5), HARMONICS_CAPTION)
    yield Cells(["history"] + LINES_HEADER, list_other_lines(run), LINES_CAPTION)
    yield Cells(SIDEBANDS_HEADER, list(list_sidebands(run)),
                "Sidebands one shaft rotation below and above the mesh harmonics (Hann window).")
    frequency = run.value("torsional mode frequency, estimated")
    yield Paragraph((f"The estimated natural frequency of the torsional mode is {frequency:.0f} Hz. " if frequency else "")
                    + describe_resolution(run), "soft")
    found = [(column, measure_column(run, column)) for column in JUDGED]
    yield Cells(["history", "unit", "mesh cycles", "peak to peak of the mean mesh cycle", "residual standard deviation",
                 "cycle-to-cycle change, rms", "largest cycle-to-cycle change", "drift per mesh cycle",
                 "share of the variance at mesh harmonics [%]"],
                [[column, run.history.units[column], p.meshes, p.ripple, p.remainder, p.change,
                  p.largest_change, p.trend, 100 * p.periodic_share] for column, p in found if p],
                "Repetition of the mesh cycles. The mean mesh cycle is the average of all mesh cycles, that is the periodic part. The residual "
                "is the curve minus the mean mesh cycle. Changes are between successive mesh cycles.")


def tell_probes(run, plots):
    yield from plots
    if run.probes is not None and not has_probes(run):
        shown = [name for name in run.probes.columns if name not in ("time", "probe")]
        yield Cells(["quantity at the probe", *run.probes["probe"]],
                    [[run.probes.label(name), *map(float, suppress_rounding(run.probes, name))] for name in shown])
        return
    yield Cells(["probe", "peak [MPa]", "time of the peak [ms]", "least [MPa]", "median [MPa]", "stress in contact",
                 "duration [ms]", "passage in the record"],
                [[name, record["largest of the record"]["value"], 1e3 * record["at"]["value"], record["least of the record"]["value"],
                  record["median per revolution"]["value"], "decrease" if p.is_dip else "increase",
                  1e3 * p.duration if p.whole else None,
                  "complete" if p.whole else "cut off"]
                 for name, record, p in find_passages(run)],
                "Peak and least value cover the whole record. The median is that of one rotation. The duration is the time in which the "
                f"deviation from the median exceeds {DURATION_LEVEL_IN_WORDS} of the largest."
                + " Node A is at the foot of the web: at a sharp corner its stress depends on the mesh." * has_sharp_foot(run))
    for probe in run.summary.get("probes", {}).values():
        yield Paragraph(probe["explanation"] + ".")


def has_sharp_foot(run):
    """Whether a probe is at node A of a web without a fillet at the hub."""
    return (run.probes is not None and any(name.startswith("node A") for name in run.probes["probe"])
            and is_open(run.parameters.get("Gear pair/Gear/Body/hub fillet radius", "0")))


def suppress_rounding(table, name):
    """A column with zeros for what the solution of an equilibrium leaves beside the columns of its unit."""
    largest = max(np.abs(table[other]).max() for other in table.columns if table.units[other] == table.units[name])
    return np.where(np.abs(table[name]) > SOLVED * largest, table[name], 0)


def tell_rim(run, plots):
    yield from plots
    yield Cells(["nodal diameters", "travelling wave", "frequency [Hz]", "amplitude [um]"],
                list(list_wave_lines(run)) if has_rim_over_meshes(run) else [],
                "Strongest lines of the axial vibration. Frequencies and directions are in the rotating frame of the gear: forward waves travel "
                "with the rotation.")
    if has_rim_over_meshes(run):
        yield Paragraph(describe_resolution(run), "soft")


def tell_energy(run, plots):
    yield from plots
    if run.is_equilibrium():
        return
    rows = list_values(run.summary.get("energy", {}), ENERGIES)
    # A model without a gear pair has few of the parts.
    yield Cells(["energy balance", "value", "unit"], rows if has_pair(run) else [row for row in rows if row[1]])
    yield Cells(["damped body", "net torque [N m]", "power [W]", "change of the rotation speed [rpm]"],
                [[a["body"]] + [a[name]["value"] for name in ("net torque", "power", "drift of rotation speed")]
                 for a in run.summary.get("damping audit", []) if a["net torque"]["value"] or a["power"]["value"]],
                "Net torque about the axis and power of the damping forces on each body. The rotation speed is the mean of the whole mass, so "
                "its change from start to end includes the torsional vibration.")


def tell_checks(run, plots):
    rows = list(list_checks(run))
    if not rows:
        return
    yield Cells(["check", "value", "condition", "verdict"], rows)
    for kind, word in FINDINGS:
        for text in run.summary.get(kind, []):
            yield Paragraph(f"{word.capitalize()}: {text}", "alarm")


def tell_computation(run, plots):
    statistics = run.summary.get("run")
    if not statistics:
        return
    # Studies without steps in time have neither them nor a rate.
    rows = [[label(COMPUTATION, name), value["value"], value["unit"]] for name, value in statistics.items()
            if isinstance(value, dict) and "unit" in value and value["value"]]
    rows += [[label(COMPUTATION, name), value, ""] for name, value in statistics.items() if isinstance(value, int) and value]
    yield Cells(["", "value", "unit"], rows)
    yield Cells(["part of the computing time", "time", "unit"], list_values(statistics.get("timers", {}), COMPUTATION))
    origin = [run.summary.get(name, "") for name in ("version", "revision")]
    kernels = f", kernels for {statistics['instruction set']}" if "instruction set" in statistics else ""
    yield Paragraph(f"Program version {origin[0]}, revision {origin[1]}{kernels}.", "soft")


# Pictures and what belongs to them come before tables.
PICTURE_CHAPTERS = (
    Chapter("Transmission error", tell_transmission_error),
    Chapter("Contact", tell_contact),
    Chapter("Spectra and periodicity", tell_spectra),
    Chapter("Variable speed"),
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
