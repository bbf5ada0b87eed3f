// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_discretization_h
#define vfife_fem_system_discretization_h

#include <vfife/fem/system/fem_element.h>
#include <vfife/model/model.h>

#include <vector>

namespace vfife
{
  /**
   * Points and elements of some bodies of a model, placed in the fixed frame as at time zero. The
   * first points of a body are its nodes in their order; the quadratic element adds the middles of
   * edges, faces and cells, each at its place on the trilinear geometry. Equal on all ranks.
   */
  class Discretization
  {
  public:
    struct Part
    {
      unsigned int body; ///< of the model
      unsigned int first_point, n_points;
      unsigned int first_element, n_elements;
    };

    /** Throws InputError for meshes with hanging nodes. */
    Discretization(const Model &model, const std::vector<unsigned int> &bodies, FemElement element);

    /**
     * Sector 0 of one cyclic body (quadratic: not made, throws InputError): its own nodes, then the
     * nodes of sector 1 that its elements use; see images(). Throws InputError when the body's
     * sectors are not rotated copies of each other, or its axis is not theirs.
     */
    static Discretization sector_of(const Model &model, unsigned int body, FemElement element);

    FemElement element() const
    {
      return element_;
    }
    const Model &model() const
    {
      return *model_;
    }
    const std::vector<Part> &parts() const
    {
      return parts_;
    }

    /** Fixed frame [mm]. */
    const std::vector<Vector3> &points() const
    {
      return points_;
    }
    unsigned int n_points() const
    {
      return points_.size();
    }
    unsigned int n_elements() const
    {
      return element_points_.size() / n_local_;
    }
    unsigned int points_per_element() const
    {
      return n_local_;
    }

    const unsigned int *element_points(const unsigned int e) const
    {
      return element_points_.data() + static_cast<std::size_t>(n_local_) * e;
    }
    ElementNodes element_nodes(unsigned int e) const;
    /** Body::stress_free_nodes() of all points. */
    ElementNodes stress_free_nodes(unsigned int e) const;

    const Part     &part_of_element(unsigned int e) const;
    const Part     &part_of_point(unsigned int p) const;
    const Material &material(const unsigned int e) const
    {
      const Part &part = part_of_element(e);
      return model_->bodies[part.body].material(e - part.first_element);
    }

    /** The part of that body of the model, or nullptr. */
    const Part *find_part(unsigned int body) const;

    /**
     * The points of a set of the body's nodes: the nodes and, of the quadratic element, the middles
     * of boundary edges and faces whose corners all are in the set; of a sector, its own nodes.
     */
    std::vector<unsigned int> points_of(const Part                      &part,
                                        const std::vector<unsigned int> &nodes) const;

    /** Points of a sector that are turned copies of another one: (copy, original). */
    const std::vector<std::pair<unsigned int, unsigned int>> &images() const
    {
      return images_;
    }
    /** Of the sector, 2 pi over their number [rad]; 0 for whole bodies. */
    double sector_angle() const
    {
      return sector_angle_;
    }

    /** Values of the element's points gathered from @p u (3 a point). */
    Eigen::VectorXd gather(unsigned int e, const std::vector<double> &u) const;
    /** The same from stress_free_nodes(): only these displacements strain the element. */
    Eigen::VectorXd gather_from_stress_free(unsigned int e, const std::vector<double> &u) const;

  private:
    Discretization(const Model &model, FemElement element);
    void add_body(unsigned int body);
    void add_middles(const Body &body, const Part &part);

    const Model                                       *model_;
    FemElement                                         element_;
    unsigned int                                       n_local_;
    std::vector<Part>                                  parts_;
    std::vector<Vector3>                               points_;
    std::vector<unsigned int>                          element_points_;
    std::vector<std::pair<unsigned int, unsigned int>> images_;
    double                                             sector_angle_ = 0;
  };

  /** Throws InputError, naming @p what, where a body of equal sectors has one of @p nodes without
   * its copies in all sectors. */
  void require_all_copies(const Body                      &body,
                          const std::vector<unsigned int> &nodes,
                          const std::string               &what);
} // namespace vfife

#endif
