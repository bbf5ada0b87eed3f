# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The results that a kind of study is for, five at most, each with its accuracy."""
from itertools import islice

from ..data.columns import CONTACT_FORCE, TRANSMISSION_ERROR
from .accuracy import AT_CORNERS, CALIBRATED_ERROR, CUBIC_CALIBRATED_ERROR, GRID_ERROR, INSIDE, MEAN_ERROR, RIPPLE_ERROR, describe_root, find_degree
from .kind_results import (list_contact_results, list_frequencies, list_lumped_results, list_mesh_results, list_model_results,
                           list_order_results, list_speed_results, list_wave_results)
from .kinds import find_kind
from .periodicity import measure_column
from .pressures import find_largest_pressure

MOST_RESULTS = 5
REFERENCE_ERROR = "mean transmission error at rest, quadratic elements"
CUBIC_REFERENCE = "mean transmission error at rest, cubic elements"


def describe_ripple(run, quantity, column):
    """For a run: whether it is steady in time, the value of the mean mesh cycle, and the noise of the contact points."""
    words = {True: "steady", False: "do not quote: still transient", None: "not judged: less than two mesh cycles"}[run.is_ripple_steady()]
    part = run.summary.get("figures", {}).get(f"{quantity} by the contact points")
    periodic = measure_column(run, column)
    return (words + (f"; the mean mesh cycle has {periodic.ripple:.3g} {run.history.units[column]}" if periodic else "")
            + "; error by the finite element mesh: compare two meshes"
            + (f"; numerical noise by contact points {part['value']:.2g} {part['unit']}" if part else ""))


def find_largest(run, *names):
    """The largest of these figures and its unit; none where none is stated."""
    quantities = {**run.summary.get("figures", {}), **run.stated}
    found = [quantities[name] for name in names if name in quantities]
    return (max(one["value"] for one in found), found[0]["unit"]) if found else (None, "")


def list_root_tension(run, degree):
    yield "root tension, largest of pinion and gear", *find_largest(run, "pinion root tension", "gear root tension"), describe_root(run, degree)


def describe_mean(run):
    """For a run or a reduced pair: the penalty may give 8-node elements the mean of quadratic ones."""
    degree = find_degree(run)
    if degree > 1:
        return MEAN_ERROR[degree]
    if CUBIC_REFERENCE in run.summary.get("figures", {}):
        return CUBIC_CALIBRATED_ERROR
    return CALIBRATED_ERROR if REFERENCE_ERROR in run.summary.get("figures", {}) else MEAN_ERROR[1]


def list_run_results(run):
    error, force = run.statistics(TRANSMISSION_ERROR), run.statistics(CONTACT_FORCE)
    yield "transmission error, mean", error["mean"], error["unit"], describe_mean(run)
    yield ("transmission error, peak to peak of the record", error["peak to peak"], error["unit"],
           describe_ripple(run, "transmission error", TRANSMISSION_ERROR))
    if force:
        yield ("sum of the contact forces, peak to peak of the record", force["peak to peak"], force["unit"],
               describe_ripple(run, "contact force", CONTACT_FORCE))
    yield "contact pressure (Hertz), largest", find_largest_pressure(run), "MPa", INSIDE
    yield from list_root_tension(run, find_degree(run))
    stresses = {name: one["value"] for name, one in run.summary.get("figures", {}).items() if name.endswith("largest von Mises stress")}
    if stresses:
        name = max(stresses, key=stresses.get)
        yield name, stresses[name], "MPa", AT_CORNERS


def list_loaded_results(run):
    degree = find_degree(run)
    yield "transmission error, mean", *find_largest(run, "transmission error mean"), MEAN_ERROR[degree]
    yield "transmission error, peak to peak", *find_largest(run, "transmission error peak to peak"), RIPPLE_ERROR[degree]
    yield "force of a tooth pair, largest", *find_largest(run, "largest force of a tooth pair"), "possibly larger between the positions"
    if "largest pressure inside on its own grid" in run.stated:
        yield "contact pressure, largest inside the flanks", *find_largest(run, "largest pressure inside on its own grid"), GRID_ERROR
    else:
        yield "contact pressure (Hertz), largest", find_largest_pressure(run), "MPa", INSIDE
    yield from list_root_tension(run, degree)


RESULTS_OF = {"pair run": list_run_results, "loaded analysis": list_loaded_results, "contact analysis": list_contact_results,
              "waves": list_wave_results, "modes": list_frequencies, "lumped model": list_lumped_results, "speeds": list_speed_results,
              "orders": list_order_results, "mesh": list_mesh_results, "model": list_model_results}


def list_main_results(run):
    """Name, value, unit and accuracy."""
    found = RESULTS_OF[find_kind(run)](run)
    return [list(one) for one in islice((one for one in found if one[1] is not None and one[1] == one[1]), MOST_RESULTS)]
