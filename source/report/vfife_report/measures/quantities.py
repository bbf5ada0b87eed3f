# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The quantities of a run that reports show and compare (its key figures): name, value, unit. Means, peak
to peak and standard deviations are the program's own (summary.json), the others are computed here."""
import numpy as np

from ..data.columns import CONTACT_FORCE, JUDGED, TRANSMISSION_ERROR
from .passages import find_passages, find_run_engagement, is_loaded
from .periodicity import measure_column


def list_history_quantities(run):
    for column in JUDGED:
        statistics = run.statistics(column)
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


def list_tooth_quantities(run):
    if run.teeth is None or "pinion tooth" not in run.teeth or run.history is None:
        return
    one = find_run_engagement(run)
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
    frequency = run.value("mesh frequency")
    if frequency and one.whole:
        time = run.teeth["time"][one.rows]
        yield "one tooth, in contact for", (time[-1] - time[0]) * frequency, "tooth meshes"


def list_probe_quantities(run):
    for name, passage in find_passages(run):
        yield f"{name}, peak von Mises stress", passage.peak, "MPa"
        # A record of a part of a turn has a median of its own: that of all sectors is no matter of it.
        turn = run.summary.get("probes", {}).get(name)
        if turn:
            yield f"{name}, largest von Mises stress of a turn", turn["largest of a turn"]["value"], "MPa"
            yield f"{name}, median von Mises stress of a turn", turn["median of a turn"]["value"], "MPa"
        else:
            yield f"{name}, steady von Mises stress", passage.steady, "MPa"
        if passage.whole:
            yield f"{name}, duration of the passage", 1e3 * passage.duration, "ms"


def list_model_quantities(run):
    """Of a model without a gear pair: what contact and probes reach over the run, by magnitude."""
    if run.history is None or TRANSMISSION_ERROR in run.history:
        return
    for column, values in run.history.columns.items():
        of, _, component = column.rpartition(" ")
        if not np.any(np.isfinite(values)) or np.nanmax(np.abs(values)) == 0:
            continue
        if of.endswith(" displacement"):
            yield f"{of}, largest {component}", np.nanmax(np.abs(values)), run.history.units[column]
        elif column == CONTACT_FORCE or column.endswith(" von mises"):
            yield f"{column}, largest", np.nanmax(np.abs(values)), run.history.units[column]


def list_quantities(run):
    """All of them, as far as the run has the files."""
    yield from list_history_quantities(run)
    yield from list_model_quantities(run)
    yield from list_tooth_quantities(run)
    yield from list_probe_quantities(run)
