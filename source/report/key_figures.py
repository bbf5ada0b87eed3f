# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The numbers of a run that reports show and compare: name, value, unit. Means, peak to peak and
standard deviations are the program's own (summary.json), the others are computed here."""
import numpy as np

from passages import find_engagement, find_passage, is_loaded
from periodicity import measure_periodicity

JUDGED = ("dte", "rim dte", "contact force total")


def read_statistics(run, column):
    """Mean, peak to peak, standard deviation and unit of a column over the steady part; None."""
    return run.summary.get("steady part", {}).get("columns", {}).get(column)


def measure_column(run, column):
    """Periodicity over the steady part; None where it cannot be measured."""
    if run.history is None or column not in run.history or not run.samples_per_mesh():
        return None
    rows = run.steady_rows(run.history)
    return measure_periodicity(run.history[column][rows], run.samples_per_mesh())


def list_history_figures(run):
    for column in JUDGED:
        statistics = read_statistics(run, column)
        if not statistics:
            continue
        unit = statistics["unit"]
        yield f"{column}, mean", statistics["mean"], unit
        yield f"{column}, peak to peak", statistics["peak to peak"], unit
        yield f"{column}, standard deviation", statistics["standard deviation"], unit
        periodicity = measure_column(run, column)
        if periodicity:
            yield f"{column}, trend a tooth mesh", periodicity.trend, unit
            yield f"{column}, change from mesh to mesh (rms)", periodicity.change, unit
            yield f"{column}, periodic share of the variance", 100 * periodicity.periodic_share, "%"


def list_tooth_figures(run):
    if run.teeth is None or "pinion tooth" not in run.teeth or run.history is None:
        return
    one = find_engagement(run.teeth, run.history["time"][0], run.history["time"][-1])
    if one is None:
        return
    loaded = one.rows[is_loaded(run.teeth, one.rows)]
    for name in ("force", "mean pressure", "hertz pressure"):
        if name in run.teeth:
            value = run.teeth[name][loaded].max()
            yield f"one tooth, largest {name}", value, run.teeth.units[name]
    if "mean pressure" in run.teeth:
        half = run.teeth["force"][loaded] > 0.5 * run.teeth["force"][loaded].max()
        yield ("one tooth, median of the mean pressure above half the force",
               np.median(run.teeth["mean pressure"][loaded[half]]), "MPa")
    frequency = run.figure("mesh frequency")
    if frequency and one.whole:
        time = run.teeth["time"][one.rows]
        yield "one tooth, in contact for", (time[-1] - time[0]) * frequency, "tooth meshes"


def list_probe_figures(run):
    for name, passage in find_passages(run):
        yield f"{name}, peak von Mises stress", passage.peak, "MPa"
        yield f"{name}, steady von Mises stress", passage.steady, "MPa"
        if passage.whole:
            yield f"{name}, duration of the passage", 1e3 * passage.duration, "ms"


def find_passages(run):
    """Name and passage of each probe that has one."""
    if run.probes is None:
        return
    for name in dict.fromkeys(run.probes["probe"]):
        rows = run.probes["probe"] == name
        passage = find_passage(run.probes["time"][rows], run.probes["von mises"][rows])
        if passage:
            yield name, passage


def list_model_figures(run):
    """Of a model without a gear pair: what contact and probes reach over the run, by magnitude."""
    if run.history is None or "dte" in run.history:
        return
    for column, values in run.history.columns.items():
        of, _, component = column.rpartition(" ")
        if not np.any(np.isfinite(values)) or np.nanmax(np.abs(values)) == 0:
            continue
        if of.endswith(" displacement"):
            yield f"{of}, largest {component}", np.nanmax(np.abs(values)), run.history.units[column]
        elif column == "contact force total" or column.endswith(" von mises"):
            yield f"{column}, largest", np.nanmax(np.abs(values)), run.history.units[column]


def list_key_figures(run):
    """All of them, as far as the run has the files."""
    yield from list_history_figures(run)
    yield from list_model_figures(run)
    yield from list_tooth_figures(run)
    yield from list_probe_figures(run)
