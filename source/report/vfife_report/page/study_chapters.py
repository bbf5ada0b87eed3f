# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Chapters of the report of a study: all variants on shared axes and in shared tables."""
import csv

from ..data.columns import JUDGED
from ..data.naming import find_differences, list_unused
from ..measures.periodicity import measure_column
from ..measures.quantities import list_quantities
from ..measures.run_lines import (HARMONICS_CAPTION, HARMONICS_HEADER, LINES_CAPTION, LINES_HEADER, describe_resolution,
                                  list_harmonics, list_other_lines)
from ..measures.speed_peaks import (EXCEEDANCES_CAPTION, EXCEEDANCES_HEADER, PEAKS_CAPTION, PEAKS_HEADER, list_exceedances,
                                    list_peaks)
from .chapter import Chapter
from .error_chapter import tell_error_bars
from .parts import EXACT, Cells, Paragraph
from .result_chapters import STUDY_TRUST
from .sweep_chapter import tell_sweep, title_sweep
from .words import FINDINGS, RECORD_ONLY, list_geometry_rows

SHOWN_DIFFERENCES = 6
RIPPLE_WORDS = {True: "steady", False: "still transient", None: "not judged"}


def tell_variants(study, plots):
    runs = [v.run for v in study.variants]
    names = find_differences(runs)[:SHOWN_DIFFERENCES]
    rows = []
    for variant in study.variants:
        summary = variant.run.summary
        status = summary.get("failure") or summary.get("status", "finished" if variant.run.stated else "no summary")
        rows.append([variant.name, variant.run.path.name]
                    + [read_parameter(variant.run, name) for name in names] + [status])
    yield Cells(["variant", "folder"] + [name.split("/")[-1] for name in names] + ["status"], rows)
    alike, different = split_geometry(study)
    yield Cells(["geometry of all variants", "unit", "pinion", "gear"], alike,
                "Input values and values derived from them. The first rows are for the pair as a whole.", digits=EXACT)
    yield Cells(["geometry", "variant", "unit", "pinion", "gear"], different, "Geometry that differs between variants.", digits=EXACT)
    edges = [v.name for v in study.variants if v.run.edge_contact and v.run.edge_contact["edge contact"]]
    if edges:
        yield Paragraph(f"These variants have edge contact: {'; '.join(edges)}. The report of each variant states the forces.", "alarm")
    yield from tell_findings(study)
    made = all((run.path / "report.html").is_file() for run in runs)
    yield Paragraph("Each variant has its own report, report.html in its folder." if made else
                    "To write the report of a variant, run make_report.py with its folder.", "soft")


def tell_findings(study):
    """Input conflicts and warnings of all variants, each with those that have it."""
    for kind, word in FINDINGS:
        found = {}
        for variant in study.variants:
            for text in variant.run.summary.get(kind, []):
                found.setdefault(text, []).append(variant.name)
        yield Cells([word, "variants"], [[text, "all" if len(names) == len(study.variants) else "; ".join(names)]
                                         for text, names in found.items()])


def split_geometry(study):
    """Rows of the geometry that all variants share, and rows with the variant of the others."""
    tables = [(v.name, {tuple(row[:2]): row for row in list_geometry_rows(v.run.geometry)}) for v in study.variants if v.run.geometry]
    alike, different = [], []
    for key in dict.fromkeys(key for _, rows in tables for key in rows):
        found = [(name, rows[key]) for name, rows in tables if key in rows]
        if len(found) == len(study.variants) and all(row == found[0][1] for _, row in found):
            alike.append(found[0][1])
        else:
            different += [[row[0], name, *row[1:]] for name, row in found]
    return alike, different


def tell_unsteady(study):
    """The times that quantities of variants cover without a steady part, or with a ripple that is not steady."""
    runs = [(v.name, v.run) for v in study.variants if v.run.steady_part()]
    unsteady = [name for name, run in runs if not run.is_steady()]
    if unsteady:
        yield Paragraph(f"These variants have no steady part: {'; '.join(unsteady)}. Their values are for the last third.", "alarm")
    changing = [name for name, run in runs if run.is_ripple_steady() is False]
    if changing:
        yield Paragraph(f"The ripple of these variants is still transient: {'; '.join(changing)}. {RECORD_ONLY}", "alarm")


def read_parameter(run, name):
    """Empty where it is of no meaning: thickness and angle of a web that is not there, entries that the study does not use."""
    body, _, word = name.rpartition("/")
    if word.startswith("web ") and run.parameters.get(f"{body}/body type") != "conical web":
        return ""
    if name in list_unused(run.parameters):
        return ""
    return run.parameters.get(name, "")


def list_measured(study):
    """Column, variant and periodicity (or None) of what is judged."""
    return [(column, variant, measure_column(variant.run, column))
            for column in JUDGED for variant in study.variants]


def tell_responses(study, plots):
    yield from plots
    if not plots:
        return
    peaks = [[variant.name, *peak] for variant in study.responses for peak in list_peaks(variant.run)]
    yield Cells(["variant", *PEAKS_HEADER],
                sorted(peaks, key=lambda row: list(dict.fromkeys(peak[1] for peak in peaks)).index(row[1])),
                PEAKS_CAPTION, digits=EXACT)
    yield Cells(["variant", *EXCEEDANCES_HEADER],
                [[variant.name, *row] for variant in study.responses for row in list_exceedances(variant.run)],
                EXCEEDANCES_CAPTION, digits=EXACT)


def tell_means(study, plots):
    yield from tell_unsteady(study)
    rows = []
    for column, variant, periodicity in list_measured(study):
        statistics = variant.run.statistics(column)
        if statistics:
            rows.append([column, variant.name, statistics["mean"], statistics["peak to peak"],
                         statistics["standard deviation"],
                         periodicity.trend if periodicity else None, statistics["unit"],
                         "steady part" if variant.run.is_steady() else "last third",
                         RIPPLE_WORDS[variant.run.is_ripple_steady()]])
    yield Cells(["history", "variant", "mean", "peak to peak of the record", "standard deviation",
                 "drift per mesh cycle", "unit", "part", "ripple"], rows, digits=EXACT)


def tell_periodicity(study, plots):
    rows = [[column, variant.name, p.meshes, p.ripple, p.change, p.largest_change,
             100 * p.periodic_share, variant.run.history.units[column]]
            for column, variant, p in list_measured(study) if p]
    if rows:
        yield Paragraph("The table compares successive mesh cycles. The share at mesh harmonics is the part of the variance that repeats every "
                        "mesh cycle.")
        yield Cells(["history", "variant", "mesh cycles", "peak to peak of the mean mesh cycle",
                     "cycle-to-cycle change, rms", "largest cycle-to-cycle change", "share of the variance at mesh harmonics [%]", "unit"], rows)


def tell_lines(study, plots):
    pairs = [v for v in study.variants if v.run.history is not None and list_harmonics(v.run, 1)]
    rows = [[row[0], v.name] + row[1:] for v in pairs for row in list_harmonics(v.run, 3)]
    if not rows:
        return
    yield Cells(["history", "variant"] + HARMONICS_HEADER, sorted(rows, key=lambda row: row[0]),
                HARMONICS_CAPTION)
    rows = [[row[0], v.name] + row[1:] for v in pairs for row in list_other_lines(v.run, 3, 2)]
    yield Cells(["history", "variant"] + LINES_HEADER, sorted(rows, key=lambda row: row[0]), LINES_CAPTION)
    for variant in pairs:
        yield Paragraph(f"{variant.name}: {describe_resolution(variant.run)}", "soft")


def tell_quantities(study, plots):
    """All key figures of all variants, also as key_figures.csv."""
    columns = [dict((name, (value, unit)) for name, value, unit in list_quantities(v.run))
               for v in study.variants]
    names = dict.fromkeys(name for column in columns for name in column)
    if not names:
        return
    rows = []
    for name in names:
        unit = next(column[name][1] for column in columns if name in column)
        rows.append([name] + [column[name][0] if name in column else None for column in columns]
                    + [unit])
    header = ["quantity"] + [v.name for v in study.variants] + ["unit"]
    with open(study.path / "key_figures.csv", "w", encoding="utf-8", newline="") as file:
        writer = csv.writer(file, lineterminator="\n")
        writer.writerow(header)
        writer.writerows([["" if cell is None else cell for cell in row] for row in rows])
    yield from tell_unsteady(study)
    yield Cells(header, rows, "doc/reference/report.md defines the quantities. Data: key_figures.csv.", digits=EXACT)


def tell_computations(study, plots):
    rows = []
    for variant in study.variants:
        run = variant.run.summary.get("run")
        if run and run["steps"]:
            rows.append([variant.name, variant.run.summary["mesh"]["cells"], run["steps"],
                         run["run time"]["value"],
                         1e-6 * run["element-steps per second"]["value"] if "element-steps per second" in run else None,
                         run["ranks"]])
    yield Cells(["variant", "elements", "steps", "time of the steps [s]",
                 "million element-steps per second", "ranks"], rows)


# Pictures and what belongs to them come before tables.
STUDY_CHAPTERS = (
    Chapter("Error bars", tell_error_bars),
    Chapter("Responses over speed", tell_responses),
    Chapter("Over one parameter", tell_sweep, title_sweep),
    Chapter("Transmission error"),
    Chapter("Contact"),
    Chapter("Stresses"),
    Chapter("Motion of the rim"),
    Chapter("The variants", tell_variants),
    Chapter("Means and peak to peak", tell_means),
    Chapter("Periodicity", tell_periodicity),
    Chapter("Lines", tell_lines),
    Chapter("All key figures", tell_quantities))
CLOSING_CHAPTERS = (
    STUDY_TRUST,
    Chapter("The computations", tell_computations))
