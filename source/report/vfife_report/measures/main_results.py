# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""The results that a kind of study is for, five at most, and how far each can be trusted."""
from itertools import islice

from ..data.columns import CONTACT_FORCE, TRANSMISSION_ERROR
from ..data.table import read_table
from .pressures import find_largest_pressure
from .quantities import list_quantities

MOST_RESULTS = 5
# Errors of loaded analyses of the reference pair on coarse to fine meshes by the elements' degree: mean transmission error, its
# peak to peak, root stress (doc/verification/gear-pair.md).
MEAN_ERROR = {1: "1 to 5 % too small on meshes of the reference pair", 2: "up to 1 % too small on meshes of the reference pair",
              3: "within 0.2 % on meshes of the reference pair"}
FREQUENCY_ERROR = {1: "1 to 3 % too high on the coarse gear of the reference pair", 2: "0.3 to 0.9 % too high on it", 3: "within 0.01 % on it"}
RIPPLE_ERROR = {1: "2 to 40 % too large on meshes of the reference pair", 2: "up to 23 % too large on meshes of the reference pair",
                3: "within 2 % on meshes of the reference pair"}
ROOT_ERROR = {1: "not converged: one third to two thirds of the true value", 2: "not converged: 20 to 24 % below a finer mesh of the reference pair",
              3: "not converged: 8 to 10 % below a finer mesh of the reference pair"}
REFERENCE_ERROR = "mean transmission error at rest, quadratic elements"
INSIDE = "valid inside the flanks, not at edges"


def find_degree(run):
    """Of the elements' displacements; runs have 8-node elements."""
    if is_pair_run(run):
        return 1
    return {"quadratic": 2, "cubic": 3}.get(run.parameters.get("Fem/element type"), 1)


def is_loaded_analysis(run):
    return "transmission error mean" in run.stated


def is_pair_run(run):
    """A run or reduced pair at one speed."""
    return run.statistics(TRANSMISSION_ERROR) is not None and run.value("mesh frequency") is not None


def describe_ripple(run, quantity):
    """Of a run: whether it is steady in time, and the part of the contact points."""
    words = {True: "steady in time", False: "not steady in time", None: "not judged in time"}[run.is_ripple_steady()]
    part = run.summary.get("figures", {}).get(f"{quantity} by the contact points")
    return f"{words}, one mesh" + (f"; the contact points cause {part['value']:.2g} {part['unit']}" if part else "")


def describe_mean(run):
    """Of a run: its penalty may give it the mean of quadratic elements."""
    return MEAN_ERROR[2 if REFERENCE_ERROR in run.summary.get("figures", {}) else 1]


def list_run_results(run):
    error, force = run.statistics(TRANSMISSION_ERROR), run.statistics(CONTACT_FORCE)
    yield "transmission error, mean", error["mean"], error["unit"], describe_mean(run)
    yield "transmission error, peak to peak", error["peak to peak"], error["unit"], describe_ripple(run, "transmission error")
    if force:
        yield "contact force, peak to peak", force["peak to peak"], force["unit"], describe_ripple(run, "contact force")
    yield "contact pressure (Hertz), largest", find_largest_pressure(run), "MPa", INSIDE
    stresses = {name: one["value"] for name, one in run.summary.get("figures", {}).items() if name.endswith("largest von Mises stress")}
    if stresses:
        name = max(stresses, key=stresses.get)
        yield name, stresses[name], "MPa", "no limit where it lies at a sharp corner"


def list_loaded_results(run):
    degree = find_degree(run)

    def find(*names):
        found = [run.stated[name] for name in names if name in run.stated]
        return (max(one["value"] for one in found), found[0]["unit"]) if found else (None, "")

    yield "transmission error, mean", *find("transmission error mean"), MEAN_ERROR[degree]
    yield "transmission error, peak to peak", *find("transmission error peak to peak"), RIPPLE_ERROR[degree]
    yield "force of a tooth pair, largest", *find("largest force of a tooth pair"), "larger between the positions"
    if "largest pressure inside on its own grid" in run.stated:
        yield "contact pressure, largest inside the flanks", *find("largest pressure inside on its own grid"), "independent of mesh and penalty"
    else:
        yield "contact pressure (Hertz), largest", find_largest_pressure(run), "MPa", INSIDE
    yield "root tension, largest of pinion and gear", *find("pinion root tension", "gear root tension"), ROOT_ERROR[degree]


def list_frequencies(run):
    """The lowest natural frequencies of the first body at the first speed."""
    table = read_table(run.path / "modes.csv")
    for k in range(table.n_rows):
        if table["body"][k] == table["body"][0] and table["speed"][k] == table["speed"][0]:
            yield f"frequency {table['mode'][k]:.0f} of {table['body'][k]}", float(table["frequency"][k]), "Hz", FREQUENCY_ERROR[find_degree(run)]


def list_main_results(run):
    """Name, value, unit and accuracy."""
    if is_pair_run(run):
        found = list_run_results(run)
    elif is_loaded_analysis(run):
        found = list_loaded_results(run)
    elif run.has_file("modes.csv"):
        found = list_frequencies(run)
    else:
        found = ((*one, "") for one in list_quantities(run))
    return [list(one) for one in islice((one for one in found if one[1] is not None), MOST_RESULTS)]


def list_trust(run):
    """Result, whether it is steady in time, whether it has converged with the mesh, page with the reason."""
    degree = find_degree(run)
    if is_pair_run(run):
        ripple = {True: "yes", False: "no", None: "not judged"}[run.is_ripple_steady()]
        yield ["mean transmission error, mean forces", "yes" if run.is_steady() else "no", describe_mean(run), "doc/verification/gear-pair.md"]
        yield ["ripple of transmission error and forces", ripple, "unknown with one mesh; compare two values of Gear pair/mesh",
               "doc/how-to/choose-the-mesh.md"]
        yield ["resonance peaks", ripple, "depend on the damping that is given", "doc/how-to/choose-damping.md"]
    elif is_loaded_analysis(run):
        yield ["mean transmission error, load sharing", "", MEAN_ERROR[degree], "doc/verification/gear-pair.md"]
        yield ["peak to peak of the transmission error", "", RIPPLE_ERROR[degree], "doc/verification/gear-pair.md"]
    else:
        return
    yield ["contact pressure", "", "Hertz's pressure and the own grid's do not depend on the mesh; at edges none has a limit",
           "doc/how-to/contact-pressure.md"]
    yield ["root stress", "", ROOT_ERROR[degree], "doc/how-to/root-stress.md"]
    yield ["stress of web, rim and hub", "", "converged away from sharp corners, which have no limit", "doc/reference/limits.md"]
