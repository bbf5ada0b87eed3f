# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The quantities of a run that reports show and compare (its key figures): name, value, unit. Means, peak
to peak and standard deviations are the program's own (summary.json), the others are computed here."""
import numpy as np

from ..data.columns import CONTACT_FORCE, JUDGED, TRANSMISSION_ERROR
from ..data.labels import label_quantity
from ..data.table import write_persons
from .passages import find_passages, find_run_engagement
from .periodicity import measure_column
from .pressures import find_allowed_pressure, find_largest_pressure


ROUNDING = 1e-9  # of the largest, below which a component is none
OF_THE_RIPPLE = ("peak to peak", "peak to peak of the record", "standard deviation")


def remark(run, name):
    """What has to be known of a quantity of that name: figures of a ripple that is not steady are those of the record."""
    if not name.endswith(OF_THE_RIPPLE):
        return ""
    remarks = ["ripple still transient"] if run.is_ripple_steady() is False else []
    share = run.value("transmission error near the cut-off")
    if share and name.startswith(TRANSMISSION_ERROR):
        remarks.append(f"includes {share:.3g} arcsec of mesh order {run.value('mesh order near the cut-off'):.0f}, above half the cut-off")
    return "; ".join(remarks)


def list_history_quantities(run):
    for column in JUDGED:
        statistics = run.statistics(column)
        if not statistics:
            continue
        unit = statistics["unit"]
        yield f"{column}, mean", statistics["mean"], unit
        yield f"{column}, peak to peak of the record", statistics["peak to peak"], unit
        yield f"{column}, standard deviation", statistics["standard deviation"], unit
        periodicity = measure_column(run, column)
        if periodicity:
            yield f"{column}, peak to peak of the mean mesh cycle", periodicity.ripple, unit
            yield f"{column}, drift per mesh cycle", periodicity.trend, unit
            yield f"{column}, change between mesh cycles (rms)", periodicity.change, unit
            yield f"{column}, share of the variance at mesh harmonics", 100 * periodicity.periodic_share, "%"


def list_tooth_quantities(run):
    if run.teeth is None or "pinion tooth" not in run.teeth or run.history is None:
        return
    one = find_run_engagement(run)
    if one is None:
        return
    yield "largest force of a tooth pair", run.teeth["force"].max(), run.teeth.units["force"]
    pressure, allowed = find_largest_pressure(run), find_allowed_pressure(run)
    if pressure is not None:
        yield "largest contact pressure (Hertz, inside the flanks)", pressure, "MPa"
        if allowed:
            yield "contact stress limit (input)", allowed, "MPa"
    frequency = run.value("mesh frequency")
    if frequency and one.whole:
        time = run.teeth["time"][one.rows]
        yield "one tooth, contact duration", (time[-1] - time[0]) * frequency, "mesh cycles"


def list_probe_quantities(run):
    for name, one in run.summary.get("figures", {}).items():
        if "largest von Mises stress" in name:
            yield label_quantity(name), one["value"], one["unit"]
    for name, record, passage in find_passages(run):
        for quantity, words in (("largest of the record", "peak von Mises stress"), ("least of the record", "least von Mises stress"),
                                ("largest per revolution", "largest von Mises stress of one rotation"),
                                ("median per revolution", "median von Mises stress of one rotation")):
            yield f"{name}, {words}", record[quantity]["value"], "MPa"
        if passage.whole:
            yield f"{name}, duration of the stress cycle in the gear mesh", 1e3 * passage.duration, "ms"


def list_model_quantities(run):
    """Of a model without a gear pair: what contact and probes reach over the run, by magnitude."""
    if run.history is None or TRANSMISSION_ERROR in run.history:
        return
    for column, values in run.history.columns.items():
        of, _, component = column.rpartition(" ")
        if not np.any(np.isfinite(values)) or np.nanmax(np.abs(values)) == 0:
            continue
        if of.endswith(" displacement"):
            largest = np.nanmax(np.abs(values))
            # What symmetry makes zero is left at rounding errors.
            if largest > ROUNDING * max(np.nanmax(np.abs(run.history[name])) for name in run.history.columns
                                        if name.rpartition(" ")[0] == of):
                yield f"{of}, largest {component}", largest, run.history.units[column]
        elif column == CONTACT_FORCE or column.endswith(" von mises"):
            yield f"{write_persons(column)}, largest", np.nanmax(np.abs(values)), run.history.units[column]


def list_reactions(run):
    """Constraint and its force and moment in an equilibrium, rounding errors as zero."""
    if run.history is None or not run.is_equilibrium():
        return
    names = [column.removesuffix(" reaction force x") for column in run.history.columns if column.endswith(" reaction force x")]
    values = np.array([[[run.history[f"{name} reaction {what} {axis}"][-1] for axis in "xyz"] for what in ("force", "moment")]
                       for name in names])
    for name, own in zip(names, values):
        own = np.where(np.abs(own) > ROUNDING * np.abs(values).max(axis=(0, 2))[:, None], own, 0)
        yield [name, *own.ravel()]


def list_quantities(run):
    """All of them, as far as the run has the files."""
    for name, one in run.stated.items():
        yield write_persons(name), one["value"], one["unit"]
    yield from list_history_quantities(run)
    yield from list_model_quantities(run)
    yield from list_tooth_quantities(run)
    yield from list_probe_quantities(run)
