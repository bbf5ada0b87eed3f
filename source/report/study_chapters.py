# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters of the report of a study: all variants on shared axes and in shared tables."""
import csv

import comparisons
import sweep_chapters
from key_figures import JUDGED, list_key_figures, measure_column, read_statistics
from line_tables import (HARMONICS_HEADER, LINES_HEADER, describe_resolution, list_harmonics,
                         list_other_lines)
from words import find_differences

CAPTIONS = {
    "dte.svg": "Dynamic transmission error of all variants: means over a tooth mesh for the whole "
               "run, and the last tooth meshes as they are.",
    "contact_force.svg": "Total contact force of all variants, in the same way.",
    "dte_spectra.svg": "Spectra of the transmission error, whole tooth meshes of the steady part.",
    "force_spectra.svg": "Spectra of the contact force.",
    "tooth_stress.svg": "Contact stress of one tooth pair from its first to its last touch.",
    "probes.svg": "Von Mises stress at the probes, time from the peak.",
    "rim_content.svg": "Motion of the rim by nodal diameters: the pattern that stands in space with "
                       "the load, and what moves besides.",
}


def draw_all(folder, variants):
    """Name of the file, what must be there, function that makes the figure."""
    yield from sweep_chapters.draw_all(folder, variants)
    pairs = [v for v in variants if v.run.history is not None and "dte" in v.run.history
             and v.run.samples_per_mesh()]
    for name, column in (("dte", "dte"), ("contact_force", "contact force total")):
        yield f"{name}.svg", pairs, lambda c=column: comparisons.draw_histories(pairs, c)
    for name, column in (("dte", "dte"), ("force", "contact force total")):
        yield f"{name}_spectra.svg", pairs, lambda c=column: comparisons.draw_spectra(pairs, c)
    teeth = [v for v in pairs if v.run.teeth is not None and "hertz pressure" in v.run.teeth]
    yield "tooth_stress.svg", teeth, lambda: comparisons.draw_tooth_stress(teeth)
    probes = [v for v in pairs if v.run.probes is not None]
    yield "probes.svg", probes, lambda: comparisons.draw_probes(probes)
    rims = [v for v in pairs if v.run.rim is not None]
    yield "rim_content.svg", rims, lambda: comparisons.draw_rim_content(rims)


def add_variants(page, folder, variants, figures):
    page.section("The variants")
    names = find_differences([v.run for v in variants])[:6]
    rows = []
    for variant in variants:
        summary = variant.run.summary
        status = summary.get("failure") or summary.get("status", "no summary")
        rows.append([variant.name, variant.run.path.name]
                    + [read_parameter(variant.run, name) for name in names] + [status])
    page.table(["variant", "folder"] + [name.split("/")[-1] for name in names] + ["status"], rows)
    page.paragraph("A variant's own report is made by make_report.py with its folder.", "soft")


def read_parameter(run, name):
    """Empty where it is of no meaning: thickness and angle of a web that is not there."""
    body, _, word = name.rpartition("/")
    if word.startswith("web ") and run.parameters.get(f"{body}/web") != "conical":
        return ""
    return run.parameters.get(name, "")


def add_means(page, folder, variants, figures):
    rows = []
    for column in JUDGED:
        for variant in variants:
            statistics = read_statistics(variant.run, column)
            if statistics:
                periodicity = measure_column(variant.run, column)
                rows.append([column, variant.name, statistics["mean"], statistics["peak to peak"],
                             statistics["standard deviation"],
                             periodicity.trend if periodicity else None, statistics["unit"]])
    if rows:
        page.section("Means and ripple")
        page.table(["history", "variant", "mean", "peak to peak", "standard deviation",
                    "trend a tooth mesh", "unit"], rows, "Over the steady part of each run.")


def add_periodicity(page, folder, variants, figures):
    rows = []
    for column in JUDGED:
        for variant in variants:
            p = measure_column(variant.run, column)
            if p:
                rows.append([column, variant.name, p.meshes, p.ripple, p.change, p.largest_change,
                             100 * p.periodic_share, variant.run.history.units[column]])
    if rows:
        page.section("Periodicity")
        page.paragraph("Consecutive tooth meshes laid over each other: how much of the history "
                       "repeats with the mesh, and how far one mesh differs from the next.")
        page.table(["history", "variant", "meshes", "ripple of the mean mesh",
                    "change, rms", "change, largest", "periodic [%]", "unit"], rows)


def add_lines(page, folder, variants, figures):
    pairs = [v for v in variants if v.run.history is not None and list_harmonics(v.run, 1)]
    rows = [[row[0], v.name] + row[1:] for v in pairs for row in list_harmonics(v.run, 3)]
    if not rows:
        return
    page.section("Lines")
    page.table(["history", "variant"] + HARMONICS_HEADER, sorted(rows, key=lambda row: row[0]),
               "Harmonics of the tooth mesh, of the mean mesh.")
    rows = [[row[0], v.name] + row[1:] for v in pairs for row in list_other_lines(v.run, 3, 2)]
    page.table(["history", "variant"] + LINES_HEADER, sorted(rows, key=lambda row: row[0]),
               "Strongest lines of what does not repeat with the mesh (Hann's window).")
    for variant in pairs:
        page.paragraph(f"{variant.name}: {describe_resolution(variant.run)}", "soft")


def add_figures(title, names):
    def add(page, folder, variants, figures):
        present = [name for name in names if name in figures]
        if present:
            page.section(title)
        for name in present:
            path = folder / "pictures" / name
            page.picture(path, CAPTIONS[name], f"pictures/{path.with_suffix('.csv').name}")
    return add


def add_numbers(page, folder, variants, figures):
    """All key figures of all variants, also as key_figures.csv."""
    columns = [dict((name, (value, unit)) for name, value, unit in list_key_figures(v.run))
               for v in variants]
    names = dict.fromkeys(name for column in columns for name in column)
    if not names:
        return
    rows = []
    for name in names:
        unit = next(column[name][1] for column in columns if name in column)
        rows.append([name] + [column[name][0] if name in column else None for column in columns]
                    + [unit])
    header = ["quantity"] + [v.name for v in variants] + ["unit"]
    page.section("All key figures")
    page.table(header, rows, "Definitions in doc/report.md. Data: key_figures.csv.")
    with open(folder / "key_figures.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([["" if cell is None else cell for cell in row] for row in rows])


def add_computation(page, folder, variants, figures):
    rows = []
    for variant in variants:
        run = variant.run.summary.get("run")
        if run:
            rows.append([variant.name, variant.run.summary["mesh"]["cells"], run["steps"],
                         run["run time"]["value"], 1e-6 * run["element-steps per second"]["value"],
                         run["ranks"]])
    if rows:
        page.section("The computations")
        page.table(["variant", "elements", "steps", "time of the steps [s]",
                    "million element-steps a second", "ranks"], rows)


CHAPTERS = (add_variants, sweep_chapters.add_sweep, add_means,
            add_figures("Transmission error", ["dte.svg", "dte_spectra.svg"]),
            add_figures("Contact force", ["contact_force.svg", "force_spectra.svg"]),
            add_periodicity, add_lines,
            add_figures("Stresses", ["tooth_stress.svg", "probes.svg"]),
            add_figures("Motion of the rim", ["rim_content.svg"]),
            add_numbers, add_computation)
