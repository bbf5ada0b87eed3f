// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_system_fem_space_h
#define vfife_fem_system_fem_space_h

#include <vfife/fem/system/fem_space_options.h>
#include <vfife/model/model.h>

#include <deal.II/grid/tria.h>

#include <map>
#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  class RefinedMesh;

  /** Points of a space and their weights [-]. */
  using PointWeights = std::vector<std::pair<unsigned int, double>>;

  /** Sum of the weights times the values at the points, which @p u has for all points (3 per
   * point). */
  Vector3 compute_mean(const PointWeights &weights, const std::vector<double> &u);

  /**
   * Displacements of some bodies of a model, in the fixed frame as at time zero: a
   * dealii::DoFHandler of degree 1, 2 or 3 for each body. A point has three components; points of a
   * body are its nodes in their order, then those on edges, faces and in cells. The places of the
   * points are the geometry, a field of the displacement's own space: rigid motions and constant
   * strains are exact on curved elements too. Elements are in the order of the body's, those that
   * an element is divided into one after the other. Equal on all ranks.
   */
  class FemSpace
  {
  public:
    struct Part
    {
      unsigned int body; ///< of the model
      unsigned int first_point, n_points;
      unsigned int n_nodes; ///< own points that are nodes of the body
      unsigned int first_element, n_elements;
    };

    /** Throws InputError for meshes with hanging nodes of their own and for names of refinements
     * that no body of the model has, NumericalError with body, element and place where an element
     * is folded. */
    FemSpace(const Model                     &model,
             const std::vector<unsigned int> &bodies,
             const FemSpaceOptions           &options);
    FemSpace(const Model &model, const std::vector<unsigned int> &bodies, FemElement element)
      : FemSpace(model, bodies, FemSpaceOptions{element, FemGeometry::straight})
    {
    }

    /**
     * Sector 0 of one cyclic body: its nodes, the nodes of sector 1 that its elements use, then
     * points between nodes; see images(). Throws InputError when the body's sectors are not rotated
     * copies of each other, or its axis is not theirs.
     */
    static FemSpace
    sector_of(const Model &model, unsigned int body, const FemSpaceOptions &options);

    const FemSpaceOptions &options() const
    {
      return options_;
    }
    FemElement element() const
    {
      return options_.element;
    }
    /** Of the displacements along an edge. */
    unsigned int degree() const
    {
      return degree_of(options_.element);
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
    /** The points of face @p f of an element, seen from outside row by row, each row along the side
     * from corner 0 to 1 of BoundaryFace. */
    std::vector<unsigned int> face_points(unsigned int e, unsigned int f) const;
    /** The same of all elements' faces on face @p f of the body's element @p element. */
    std::vector<std::vector<unsigned int>>
    points_on_face(const Part &part, unsigned int element, unsigned int f) const;

    /** Elements of the body that the part has, whole or divided. */
    unsigned int n_body_elements(const Part &part) const;
    /** Whether some of them are divided. */
    bool is_refined(const Part &part) const
    {
      return n_body_elements(part) < part.n_elements;
    }
    /** Of an element: the active cell of its part's mesh. */
    dealii::Triangulation<3>::cell_iterator cell(unsigned int e) const;
    /** The body's element that element @p e is, or a part of. */
    unsigned int body_element(const unsigned int e) const
    {
      return parents_[e];
    }
    /** The point at a corner of an element (deal.II's order). */
    unsigned int corner(unsigned int e, unsigned int v) const;

    /** Points in the middle of coarser edges and faces: each moves as the mean of others with
     * weights (point, weight), none of which hangs. */
    const std::map<unsigned int, PointWeights> &hanging() const
    {
      return hanging_;
    }
    /** Moves forces at these points (3 a point) to those that move them. */
    void move_to_masters(std::vector<double> &forces) const;

    ElementNodes element_nodes(unsigned int e) const;
    /** Body::stress_free_nodes() of all points. */
    ElementNodes stress_free_nodes(unsigned int e) const;

    const Part     &part_of_element(unsigned int e) const;
    const Part     &part_of_point(unsigned int p) const;
    const Material &material(const unsigned int e) const
    {
      const Part &part = part_of_element(e);
      return model_->bodies[part.body].material(parents_[e]);
    }

    /** The part of that body of the model, or nullptr. */
    const Part *find_part(unsigned int body) const;

    /**
     * The points of a set of the body's nodes: the nodes and all points on boundary edges and faces
     * whose corners are in the set; of a sector, no images.
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
    FemSpace(const Model &model, const FemSpaceOptions &options);
    void add_part(unsigned int                              body,
                  const std::shared_ptr<const RefinedMesh> &mesh,
                  const RefinedMesh                        &whole,
                  const std::vector<Vector3>               &nodes,
                  unsigned int                              n_nodes);
    /** Of the last part; the first @p n_given points have their places. */
    void place_points(const RefinedMesh &whole, unsigned int n_given);
    void add_images_between();
    void check_folds(const Part &part) const;

    const Model                                       *model_;
    FemSpaceOptions                                    options_;
    std::vector<LocalRefinement>                       refinements_;
    unsigned int                                       n_local_;
    std::vector<Part>                                  parts_;
    std::vector<Vector3>                               points_;
    std::vector<std::shared_ptr<const RefinedMesh>>    meshes_; ///< of the parts
    std::vector<unsigned int>                          element_points_, parents_;
    std::vector<std::vector<unsigned int>>             point_of_vertex_; ///< of the parts' meshes
    std::map<unsigned int, PointWeights>               hanging_;
    std::vector<std::pair<unsigned int, unsigned int>> images_;
    double                                             sector_angle_ = 0;
  };

  /** Numbers of all bodies of a model. */
  std::vector<unsigned int> all_bodies(const Model &model);

  /** Throws InputError, naming @p what, where a body of equal sectors has one of @p nodes without
   * its copies in all sectors. */
  void require_all_copies(const Body                      &body,
                          const std::vector<unsigned int> &nodes,
                          const std::string               &what);
} // namespace vfife

#endif
