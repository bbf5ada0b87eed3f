// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_mesh_gear_sector_gear_web_builder_h
#define vfife_mesh_gear_sector_gear_web_builder_h

#include <vfife/mesh/gear/gear_body_options.h>
#include <vfife/mesh/gear/gear_section.h>
#include <vfife/mesh/gear/sector/gear_sector_cells.h>

#include <vector>

namespace vfife
{
  /**
   * Adds the conical web of a body and its hub to its sector (doc/theory/mesh.md): layers between
   * the web's faces from the rim to the hub, lines along the axis from there to the bore. Options,
   * web, the sections of the teeth and cells must outlive it.
   */
  class GearWebBuilder
  {
  public:
    GearWebBuilder(const GearBodyOptions          &options,
                   const ConicalWeb               &web,
                   const std::vector<GearSection> &sections,
                   GearSectorCells                &cells);

    /** Cells and sets; once. @p foot: nodes of the rim where the web starts, a line for each side
     * of its layers. Returns the nodes of the bore, lines of nodes by rising z. Throws
     * NumericalError for an inverted cell. */
    NodeLayer add(const NodeLayer &foot);

    /** Arcs of the fillets that the web has, by the names of their sets. */
    const WebFillets &fillets() const
    {
      return fillets_;
    }

  private:
    void      add_faces(const NodeLayer &nodes);
    NodeLayer make_nodes(double u, unsigned int columns);
    void      add_coarsening_row(const NodeLayer &rim_side, const NodeLayer &hub_side, double u);
    /** Returns the nodes of the bore. */
    NodeLayer add_hub(const NodeLayer &web_end);

    /** Depth of the web's last row of nodes under the outside of the hub, at a fraction of the way
     * through the web [mm]. */
    double  foot_dip(double x) const;
    Vector3 point(double u, unsigned int layer, double angle) const;
    /** Angle of equally wide columns of a layer of the web, which loses the rim's spiral on the way
     * to the hub. */
    double angle_at(double u, unsigned int layer, double fraction) const;
    /** Fractions u of the web's rows, from rim to hub; the row that coarsens ends at the place @p
     * coarsening (0: none). */
    std::vector<double> make_stations(unsigned int &coarsening) const;

    const GearBodyOptions          &options_;
    const ConicalWeb               &web_;
    const std::vector<GearSection> &sections_;
    GearSectorCells                &cells_;
    WebFillets                      fillets_; ///< found with the web's faces
  };
} // namespace vfife

#endif
