# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters of the report of one run. Each appends to the page what the run has files for; `figures`
are the names of its pictures that could be drawn."""
from checks import list_checks
from key_figures import JUDGED, find_passages, list_key_figures, measure_column
from line_tables import (HARMONICS_HEADER, LINES_HEADER, describe_resolution, list_harmonics,
                         list_other_lines)
from sidebands import SIDEBANDS_HEADER, list_sidebands
from waves import list_wave_lines
from words import list_case_rows, list_sentences

CAPTIONS = {
    "dte.svg": "Dynamic transmission error of hub and rim; a lag of the gear is negative.",
    "contact_force.svg": "Contact force: sum, and each tooth pair.",
    "load_sharing.svg": "Share of each tooth pair and its pressures, all pairs laid over each other.",
    "tooth_engagement.svg": "One tooth pair through its engagement. The largest pressure of a point "
                            "depends on mesh and penalty, the mean and Hertz's do not.",
    "contact_pattern.svg": "Contact pattern on the drive flanks over the last tooth mesh, axial "
                           "sections. Data: pattern.csv.",
    "spectra.svg": "Amplitudes over the whole tooth meshes of the steady part, no window.",
    "sidebands.svg": "Transmission error around the first harmonics of the mesh (Hann's window).",
    "probes.svg": "Von Mises stress at the probes.",
    "rim_content.svg": "Displacement of the rim by nodal diameters: the pattern that stands in space "
                       "with the load (0: the mean), and what moves besides.",
    "rim_history.svg": "Axial waves of the rim that do not stand in space.",
    "rim_waves.svg": "Spectra of these waves by direction of travel.",
    "energies.svg": "Energy error and energies.",
    "bodies.png": "The bodies with the elements' edges and von Mises stress.",
    "teeth_in_mesh.png": "Teeth in mesh: section and contact pressure.",
    "meridian_section.png": "Section through the gear's axis and the contact.",
    "deformation.png": "Deformation of the gear in that section.",
}


def add_pictures(page, run, figures, names):
    for name in names:
        if name in figures:
            path = run.path / "pictures" / name
            data = path.with_suffix(".csv")
            page.picture(path, CAPTIONS[name], f"pictures/{data.name}" if data.is_file() else None)


def add_case(page, run, figures):
    if not (run.parameters or run.summary or figures):
        return
    page.section("The case")
    failure = run.summary.get("failure")
    if failure:
        page.paragraph(f"The run failed: {failure}", "alarm")
    for sentence in list_sentences(run):
        page.paragraph(sentence)
    page.table(["", "in force"], list(list_case_rows(run)))
    if run.parameters:
        page.paragraph("All parameters in force: parameters.prm in the run's folder.", "soft")
    add_pictures(page, run, figures, ["bodies.png"])


def add_key_figures(page, run, figures):
    rows = list(list_key_figures(run))
    if rows:
        page.section("Key figures")
        page.table(["quantity", "value", "unit"], rows,
                   "Of the steady part, largest values of the whole run; definitions in doc/report.md.")


def add_transmission_error(page, run, figures):
    if "dte.svg" not in figures:
        return
    page.section("Transmission error")
    add_pictures(page, run, figures, ["dte.svg"])
    page.table(["part", "value", "unit"], list_figures(run.summary.get("transmission error", {})),
               "Parts of the transmission error in the equilibrium before the start.")


def add_contact(page, run, figures):
    if "contact_force.svg" not in figures:
        return
    page.section("Contact")
    add_pictures(page, run, figures, ["contact_force.svg", "tooth_engagement.svg", "load_sharing.svg",
                                      "contact_pattern.svg", "teeth_in_mesh.png"])


def add_spectra(page, run, figures):
    if "spectra.svg" not in figures:
        return
    page.section("Spectra and periodicity")
    add_pictures(page, run, figures, ["spectra.svg", "sidebands.svg"])
    page.table(["history"] + HARMONICS_HEADER, list_harmonics(run, 5),
               "Harmonics of the tooth mesh, of the mean mesh.")
    page.table(["history"] + LINES_HEADER, list_other_lines(run),
               "Strongest lines of what does not repeat with the mesh (Hann's window).")
    page.table(SIDEBANDS_HEADER, list(list_sidebands(run)),
               "One rotation below and above the harmonics of the mesh (Hann's window).")
    page.paragraph(describe_resolution(run), "soft")
    add_periodicity(page, run)


def add_periodicity(page, run):
    rows = []
    for column in JUDGED:
        p = measure_column(run, column)
        if p:
            rows.append([column, run.history.units[column], p.meshes, p.ripple, p.remainder, p.change,
                         p.largest_change, p.trend, 100 * p.periodic_share])
    page.table(["history", "unit", "meshes", "ripple", "rest", "change, rms", "change, largest",
                "trend a mesh", "periodic [%]"], rows,
               "How far tooth meshes differ: ripple (peak to peak) of the mean mesh, standard deviation "
               "of the rest, change from one mesh to the next.")


def add_probes(page, run, figures):
    passages = list(find_passages(run))
    if "probes.svg" not in figures:
        return
    page.section("Stress at the probes")
    add_pictures(page, run, figures, ["probes.svg"])
    page.table(["probe", "peak [MPa]", "at [ms]", "steady [MPa]", "duration [ms]", "record"],
               [[name, p.peak, 1e3 * p.peak_time, p.steady, 1e3 * p.duration if p.whole else None,
                 "whole passage" if p.whole else "passage cut by the record"] for name, p in passages],
               "Passage through the mesh: duration above a tenth of the rise over the steady stress.")


def add_rim(page, run, figures):
    names = ["rim_content.svg", "rim_history.svg", "rim_waves.svg"]
    if any(name in figures for name in names):
        page.section("Motion of the rim")
        add_pictures(page, run, figures, names)
        page.table(["nodal diameters", "travels", "frequency [Hz]", "amplitude [um]"],
                   list(list_wave_lines(run)) if "rim_waves.svg" in figures else [],
                   "Strongest lines of the axial waves, frequencies in the turning gear.")


def add_sections(page, run, figures):
    names = ["meridian_section.png", "deformation.png"]
    if any(name in figures for name in names):
        page.section("Sections")
        add_pictures(page, run, figures, names)


def add_energy(page, run, figures):
    if "energy" not in run.summary:
        return
    page.section("Energy and damping")
    add_pictures(page, run, figures, ["energies.svg"])
    page.table(["energy ledger", "value", "unit"], list_figures(run.summary["energy"]))
    page.table(["damping of", "net torque [N m]", "power [W]", "spin drift [rpm]"],
               [[a["body"]] + [a[name]["value"] for name in ("net torque", "power", "spin drift")]
                for a in run.summary.get("damping audit", [])])


def add_checks(page, run, figures):
    rows = list(list_checks(run))
    if not rows:
        return
    page.section("Checks")
    page.table(["check", "value", "asked for", "verdict"], rows)
    for kind in ("contradictions", "warnings"):
        for text in run.summary.get(kind, []):
            page.paragraph(f"{kind[:-1].capitalize()}: {text}", "alarm")


def add_statistics(page, run, figures):
    statistics = run.summary.get("run")
    if not statistics:
        return
    page.section("The computation")
    rows = [[name, value["value"], value["unit"]] for name, value in statistics.items()
            if isinstance(value, dict) and "unit" in value]
    rows += [[name, value, ""] for name, value in statistics.items() if isinstance(value, int)]
    page.table(["", "value", "unit"], rows)
    page.table(["section", "time", "unit"], list_figures(statistics.get("timers", {})))
    origin = [run.summary.get(name, "") for name in ("version", "revision")]
    page.paragraph(f"Program version {origin[0]}, revision {origin[1]}; kernels for "
                   f"{statistics.get('instruction set', 'unknown instructions')}.", "soft")


def list_figures(figures):
    return [[name, figure["value"], figure["unit"]] for name, figure in figures.items()]


CHAPTERS = (add_case, add_key_figures, add_transmission_error, add_contact, add_spectra, add_probes,
            add_rim, add_sections, add_energy, add_checks, add_statistics)
