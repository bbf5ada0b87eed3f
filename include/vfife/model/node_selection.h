// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_node_selection_h
#define vfife_model_node_selection_h

#include <vfife/base/parameter_handler.h>
#include <vfife/model/body.h>
#include <vfife/model/load.h>

#include <string>
#include <vector>

namespace vfife
{
  /** Nodes of a body as a user names them: sets of the mesh, and a condition on their places. */
  struct NodeSelection
  {
    std::string              body;
    std::vector<std::string> sets; ///< united; "all": every node
    std::string where; ///< formula of x, y, z [mm] of the undeformed body frame, or empty

    /** Declares "body", "nodes" and "where" in the section entered. */
    void declare(dealii::ParameterHandler &prm);

    /** Index of the body in @p bodies; throws InputError (entries under @p section). */
    unsigned int find_body(const std::vector<Body> &bodies,
                           const std::string       &section,
                           const std::string       &entry = "body") const;

    /** The nodes, sorted; throws InputError where there are none. */
    std::vector<unsigned int> find_nodes(const Body &body, const std::string &section) const;

    /**
     * The faces on which something acts at the selected @p nodes: of sets that are surfaces their
     * facets, of those that are not the faces of the boundary between their nodes; "where" must
     * hold at all nodes of a face. Nothing where no set is a surface. Throws InputError for a
     * surface of a file that is none of the boundary.
     */
    SelectedFaces find_faces(const Body                      &body,
                             const std::vector<unsigned int> &nodes,
                             const std::string               &section) const;
  };
} // namespace vfife

#endif
