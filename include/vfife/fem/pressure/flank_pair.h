// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pressure_flank_pair_h
#define vfife_fem_pressure_flank_pair_h

#include <vfife/fem/pressure/grid_contact.h>
#include <vfife/fem/statics/facet_parts.h>
#include <vfife/fem/statics/node_averages.h>
#include <vfife/model/model.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

namespace vfife
{
  /** Pressures of two teeth on their own grid. */
  struct ToothPressure
  {
    unsigned int slave_group = 0, master_group = 0;
    GridPressure grid; ///< its moment: torque on the driven body [N mm]
    /** Middles of the cells in the body frames of slave and master, at rest [mm]. */
    std::array<std::vector<Vector3>, 2> places;
  };

  class Compliance;

  /** By point of the space, the place among those at which a Compliance keeps displacements; or
   * ElasticFlank::no_place. */
  struct PointPlaces
  {
    std::vector<unsigned int> nodes;   ///< of Compliance::watched()
    std::vector<unsigned int> surface; ///< of Compliance::surface_points()

    explicit PointPlaces(const Compliance &compliance);
  };

  /** Both surfaces of the first contact pair of a gear pair where they have come to, and what lies
   * near them. Sides: 0 slave, 1 master. */
  class FlankPair
  {
  public:
    /** @p depth: of the layers near the flanks, at least [mm]. The space must outlive the
     * object. */
    FlankPair(const FemSpace &space, double depth);
    FlankPair(const FlankPair &)            = delete;
    FlankPair &operator=(const FlankPair &) = delete;

    const ContactPair &definition() const
    {
      return definition_;
    }
    unsigned int body(const unsigned int side) const
    {
      return bodies_[side];
    }
    const FacetSurface &facets(const unsigned int side) const
    {
      return *facets_[side];
    }
    SurfaceGeometry &surface(const unsigned int side)
    {
      return surfaces_[side];
    }
    /** Of its body since time zero. */
    const Matrix3 &rotation(const unsigned int side) const
    {
      return rotations_[side];
    }

    /** A side is now where its nodes have the @p positions (3 each) [mm] and its body the mean
     * @p motion, body frame to fixed frame. */
    void place(unsigned int side, std::vector<double> positions, const RigidMotion &motion);

    /** Displacements of all points (3 each) with which the nodes have come to their positions, in
     * axes that turn with the bodies [mm]: they are less bilinear than those of the facets. */
    void bend(std::vector<double> displacements);

    /** At a point, for the normal out of the master there: how fast the gap closes as the load
     * turns the driven body [mm]. */
    double torque_arm(const Vector3 &position, const Vector3 &normal) const;

    /** Two teeth; @p depth_limit: deepest penetration that is taken for contact [mm]. */
    FacingSurfaces facing(unsigned int slave_group, unsigned int master_group, double depth_limit);

    /** Nodes of a tooth's flank as those of the surface, sorted. */
    std::vector<unsigned int> nodes_of(unsigned int side, unsigned int group) const;

    /** The node of the tooth @p copied that is turned to that of the surface @p node, of the tooth
     * @p group: teeth are copies of each other. */
    unsigned int
    copy_of(unsigned int side, unsigned int node, unsigned int group, unsigned int copied) const;

    /** A tooth's flank, whose flexibility is that of the tooth @p copied, turned. Throws InputError
     * for bodies with one element across a tooth. */
    ElasticFlank make_flank(unsigned int       side,
                            unsigned int       group,
                            unsigned int       copied,
                            const PointPlaces &places);

    /** What lies near a tooth's flank. Throws as make_flank(). */
    const NearLayer &near_layer(unsigned int side, unsigned int group);

    /** Of the space, at a node of the surface. */
    unsigned int point_of(unsigned int side, unsigned int node) const;

    /** By which nodes of the surfaces move and take forces. */
    const NodeAverages &averages() const
    {
      return averages_;
    }

    /** What has been found on the grid of two teeth, with the places of its cells. */
    ToothPressure
    describe(unsigned int slave_group, unsigned int master_group, GridPressure grid) const;

  private:
    /** Middles of cells in the body frame of a side's body, at rest [mm]. */
    std::vector<Vector3> places_of(unsigned int side, const std::vector<ContactCell> &cells) const;
    /** Sides of the elements' faces on a tooth's flank that lie on edges of the body, by points. */
    PointPairs edges_of(unsigned int side, unsigned int group) const;
    /** Of a facet of the tooth @p group, or of the same one of the tooth @p copied: points of the
     * space. */
    FacetParts::Corners corners_of(unsigned int side,
                                   unsigned int facet,
                                   unsigned int group,
                                   unsigned int copied) const;
    /** Parts of a facet of the tooth @p group with their places and those of the tooth copied. */
    std::vector<FlankPart> make_parts(unsigned int        side,
                                      unsigned int        facet,
                                      unsigned int        copied,
                                      const PointPlaces  &places,
                                      const ElasticFlank &flank) const;
    /** FlankPart::bulges, of the parts of a facet with the @p nodes (points of the space). */
    void find_bulges(unsigned int                            side,
                     const FacetParts::Corners              &nodes,
                     const std::vector<FacetParts::Corners> &points,
                     std::vector<FlankPart>                 &parts) const;

    const FemSpace                                            &space_;
    NodeAverages                                               averages_;
    FacetParts                                                 facet_parts_;
    const ContactPair                                         &definition_;
    double                                                     depth_;
    std::array<unsigned int, 2>                                bodies_;
    std::array<const FacetSurface *, 2>                        facets_;
    std::array<Material, 2>                                    materials_; ///< under the flanks
    std::array<SurfaceGeometry, 2>                             surfaces_;
    std::array<std::vector<double>, 2>                         positions_;
    std::vector<double>                                        displacements_; ///< bend()
    std::array<Matrix3, 2>                                     rotations_;
    std::vector<BondedLayer>                                   held_; ///< by the sides
    std::map<std::pair<unsigned int, unsigned int>, NearLayer> near_; ///< by side and tooth
  };
} // namespace vfife

#endif
