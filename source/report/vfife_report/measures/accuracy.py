# Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
"""Accuracy of results in words: errors of the reference pair by the degree of the elements, and named reasons where an error is
not known."""

# Loaded analyses of the reference pair on coarse to fine meshes by the elements' degree: mean transmission error, its peak to peak,
# root stress (doc/verification/gear-pair.md).
MEAN_ERROR = {1: "magnitude 1 to 5 % too small on meshes of the reference pair", 2: "magnitude 0.3 to 1.2 % too small on meshes of the reference pair",
              3: "within 0.2 % on meshes of the reference pair"}
# Runs and reduced pairs, whose penalty is calibrated to quadratic elements (Elements at speed).
CALIBRATED_ERROR = ("magnitude about 1.4 % too small on all meshes of the reference pair; Contact/penalty elements = cubic reduces this to "
                    "0.2 %, a finer mesh does not")
CUBIC_CALIBRATED_ERROR = "magnitude about 0.2 % too small on the coarse mesh of the reference pair"
FREQUENCY_ERROR = {1: "1 to 3 % too high on the coarse gear of the reference pair", 2: "0.3 to 0.9 % too high on the coarse gear of the "
                   "reference pair", 3: "within 0.01 % on the coarse gear of the reference pair"}
FREQUENCY_EXCESS = {1: (1., 3.), 2: (0.3, 0.9), 3: (0., 0.01)}  # the same [%]
RIPPLE_ERROR = {1: "2 to 40 % too large on meshes of the reference pair", 2: "up to 23 % too large on meshes of the reference pair",
                3: "within 2 % on meshes of the reference pair"}
SUBMODEL_ERROR = {1: "below 2 % with 40,320 elements of the reference pair, up to 7 % too large with 19,380",
                  2: "below 2 % on meshes of the reference pair", 3: "below 2 % on meshes of the reference pair"}
ELEMENT_ERROR = {1: "not converged: one third to two thirds of the true value", 2: "not converged: 20 to 24 % below a finer mesh of the "
                 "reference pair", 3: "not converged: 8 to 10 % below a finer mesh of the reference pair"}
INSIDE = "from force and curvatures, valid inside the flanks; not valid for tip, toe and heel edge contact"
# Pressure on the own grid inside the flanks (doc/verification/contact.md).
GRID_ERROR = "within 2.5 % with 12 elements lengthwise, up to 21 % too large with 4 to 6, for the reference pair"
# Unloaded contact has no elements (doc/verification/geometry.md).
NO_MESH = "computed on the generated flanks, without mesh"
LAG_ERROR = "without mesh; within 0.01 arcsec for the reference pair"
EDGE_ERROR = "without mesh; within 0.02 arcsec in the verification"
# Predicted peaks beside computed ones of the reference pair with 1 % damping, by nodal diameters (doc/verification/waves.md).
LINEAR_ERRORS = {2: "linear theory: within 1.4 % of the computed peaks of the reference pair with 1 % damping",
                 3: "linear theory: within 0.6 % of the computed peaks of the reference pair with 1 % damping"}
LINEAR_ONLY = "linear theory; no error estimate: set Waves/simulate response"
NO_ESTIMATE = "no error estimate: compare two meshes"
ONE_MESH = "unknown with one mesh: compare two meshes"
AT_CORNERS = "largest of the nodes outside flanks and fillets; not converged at a sharp corner or edge"
GIVEN_DAMPING = "depends on the given damping"

PAIR_PAGE = "doc/verification/gear-pair.md"
MESH_PAGE = "doc/how-to/choose-the-mesh.md"
VARIANTS_PAGE = "doc/how-to/variants-and-error-bars.md"
DAMPING_PAGE = "doc/how-to/choose-damping.md"
LIMITS_PAGE = "doc/reference/limits.md"


def find_degree(run):
    """Degree of the elements of an analysis by conventional finite elements; others have 8-node elements."""
    return int(run.value("degree of the finite elements") or 1)


def describe_root(run, degree):
    """Error of root stresses, by submodels or by the pair's own elements of a degree."""
    return (SUBMODEL_ERROR if run.parameters.get("Fillets/source") == "submodel" else ELEMENT_ERROR)[degree]
