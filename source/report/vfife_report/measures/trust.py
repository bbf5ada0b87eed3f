# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""How far results can be trusted: result, whether it is steady in time, whether it has converged with the mesh, page with the
reason."""
from ..data.naming import describe_pair
from ..data.table import read_table
from .accuracy import (DAMPING_PAGE, EDGE_ERROR, FREQUENCY_ERROR, GRID_ERROR, LAG_ERROR, LIMITS_PAGE, MEAN_ERROR, MESH_PAGE, ONE_MESH,
                       PAIR_PAGE, RIPPLE_ERROR, VARIANTS_PAGE, describe_root, find_degree)
from .kind_results import list_refined
from .kinds import find_kind
from .main_results import describe_mean
from .study_results import list_asked_ranges

TRUST_HEADER = ["result", "steady in time", "mesh convergence", "page"]
YES, NO, NOT_JUDGED = "yes", "no", "not judged"
RIPPLE = {True: YES, False: NO, None: NOT_JUDGED}
DAMPING = "depend on the given damping"
CORNERS = ["stress at sharp corners and edges", "", "no: unbounded", LIMITS_PAGE]


def trust_run(run):
    ripple = RIPPLE[run.is_ripple_steady()]
    yield ["mean transmission error, mean forces", YES if run.is_steady() else NO, describe_mean(run), PAIR_PAGE]
    yield ["peak to peak of transmission error and forces", ripple, ONE_MESH, MESH_PAGE]
    yield ["resonance peaks", ripple, DAMPING, DAMPING_PAGE]
    yield from trust_stresses(run, 1)


def trust_loaded(run):
    degree = find_degree(run)
    yield ["mean transmission error, load sharing", "", MEAN_ERROR[degree], PAIR_PAGE]
    yield ["peak to peak of the transmission error", "", RIPPLE_ERROR[degree], PAIR_PAGE]
    yield from trust_stresses(run, degree)


def trust_stresses(run, degree):
    """Pressures and stresses of a pair with elements of a degree."""
    yield ["contact pressure (Hertz)", "", "inside the flanks it follows from force and curvatures; at edges it is not valid",
           "doc/how-to/contact-pressure.md"]
    if run.has_file("pressure.csv"):
        yield ["contact pressure on the own grid", "", f"inside the flanks {GRID_ERROR}; at edges unbounded", "doc/verification/contact.md"]
    recorded = run.has_file("root_stress.csv") or any("root" in name for name in (*run.stated, *run.summary.get("figures", {})))
    yield ["root stress", "", describe_root(run, degree) if recorded else "not recorded: set Fillets/teeth = in contact",
           "doc/how-to/root-stress.md"]
    yield ["stress of web, rim and hub", "", "converged away from sharp corners, where it is unbounded", LIMITS_PAGE]


def trust_unloaded(run):
    yield ["unloaded contact inside the flanks", "", LAG_ERROR, "doc/verification/geometry.md"]
    yield ["edge contact", "", EDGE_ERROR, "doc/verification/geometry.md"]
    yield ["contact under load", "", "not computed by this kind", "doc/getting-started/choose-an-analysis.md"]


def trust_waves(run):
    lines = read_table(run.path / "waves_lines.csv")
    computed = lines is not None and (lines["peak speed"] == lines["peak speed"]).any()
    settled = f"{run.parameters.get('Waves/settling decay times', 'given')} decay times to settle" if computed else ""
    yield ["resonance speeds", settled, ONE_MESH, MESH_PAGE]
    yield ["widths and amplitudes", settled, DAMPING, DAMPING_PAGE]
    yield ["waves of two nodal diameters", "", "linear theory is not accurate", "doc/verification/waves.md"]
    if computed:
        yield ["stress amplification", "", "upper bound for the given damping, torque and probes", "doc/reference/kinds.md"]


def trust_modes(run):
    from_pair = describe_pair(run.parameters)
    yield ["natural frequencies", "", FREQUENCY_ERROR[find_degree(run)] if from_pair else ONE_MESH, MESH_PAGE if from_pair else VARIANTS_PAGE]
    table = read_table(run.path / "modes.csv")
    if table is not None and "residual" in table:
        yield ["eigenvalues of this mesh", "", f"largest residual {table['residual'].max():.1g}", "doc/theory/fem.md"]
    if from_pair:
        yield ["resonance speeds", "", "for the free bodies; the contact shifts them", "doc/how-to/find-resonances.md"]


def trust_lumped(run):
    yield ["response", f"not judged; {run.parameters.get('Lumped/settling mesh cycles', 'given')} mesh cycles to settle",
           "without mesh; depends on the given stiffness, error and damping",
           "doc/theory/lumped.md"]


def trust_speeds(run):
    yield ["response at each speed", f"not judged; {run.parameters.get('Reduced/settling mesh cycles', 'given')} mesh cycles to settle",
           ONE_MESH, MESH_PAGE]
    yield ["resonance peaks", "", "depend on the given damping and on the spacing of the speeds", DAMPING_PAGE]


def trust_orders(run):
    yield ["amplitudes of mesh orders", "no steady part; they depend on the rate of the speed change", ONE_MESH, MESH_PAGE]
    yield ["resonance peaks", "", DAMPING, DAMPING_PAGE]


def trust_mesh(run):
    yield ["volume, mass and inertia", "", "differences from the generated bodies are in the table", "doc/verification/geometry.md"]


def trust_model(run):
    if not run.summary:
        return
    steady = {"run": NOT_JUDGED, "static": "equilibrium to the given tolerance"}.get(run.summary.get("study"), "")
    for name, _, _, change in list_refined(run):
        yield [name, "", change, "doc/reference/kinds.md"]
    yield ["displacements, forces and stresses", steady, ONE_MESH, VARIANTS_PAGE]
    yield CORNERS


TRUST_OF = {"pair run": trust_run, "loaded analysis": trust_loaded, "contact analysis": trust_unloaded, "waves": trust_waves,
            "modes": trust_modes, "lumped model": trust_lumped, "speeds": trust_speeds, "orders": trust_orders, "mesh": trust_mesh,
            "model": trust_model}


def list_trust(run):
    return list(TRUST_OF[find_kind(run)](run))


def list_study_trust(study):
    """The same for a folder of runs: error bars, steadiness of the variants, differences."""
    bars = study.error_bars.quantities if study.error_bars else []
    shown = [one for one in bars if len(one.variants) == 1 or not one.is_constant()]
    for one in shown:
        unknown = sum(error != error for error in one.errors)
        yield [one.name, "", f"{unknown} of {len(one.errors)} errors unknown" if unknown else "error bar of each variant", VARIANTS_PAGE]
    if shown:
        return
    judged = [v.run for v in study.variants if v.run.steady_part()]
    for name, *_, accuracy in list_asked_ranges(study):
        yield [name, "", accuracy, VARIANTS_PAGE]
    steady = f"{sum(run.is_steady() for run in judged)} of {len(judged)} runs" if judged else ""
    if study.folder.has_file("comparison.json"):
        yield ["agreement of the cases", steady, "cases with equal meshes have the same mesh error", "doc/how-to/compare-methods.md"]
        return
    if judged:
        yield ["means of the variants", steady, ONE_MESH, VARIANTS_PAGE]
        yield ["peak to peak of the variants", f"{sum(run.is_ripple_steady() is True for run in judged)} of {len(judged)} runs", ONE_MESH,
               VARIANTS_PAGE]
    yield ["differences between variants", "", "no error bars", VARIANTS_PAGE]
