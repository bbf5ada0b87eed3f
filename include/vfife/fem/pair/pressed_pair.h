// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_pair_pressed_pair_h
#define vfife_fem_pair_pressed_pair_h

#include <vfife/contact/contact_results.h>
#include <vfife/fem/pair/pressed_bodies.h>
#include <vfife/fem/pair/pressed_state.h>
#include <vfife/model/state.h>
#include <vfife/model/tooth_contact.h>

#include <array>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  struct Model;

  /**
   * The contact of a gear pair between elastic bodies whose answers to forces are known, with the
   * rotation of the driven body as the last unknown (doc/theory/fem.md, Static with contact): the
   * penalty contact of the explicit solver acts on the moved flanks, without friction and damping.
   * Rows of nodes are along axes of their own.
   */
  class PressedPair
  {
  public:
    /** A node that may touch; columns of @p axes: those of its rows, in the axes of time zero. */
    struct Node
    {
      unsigned int body = 0, node = 0;
      Matrix3      axes = Matrix3::Identity();
    };
    /** A contact point as a spring: rows' nodes and directions along their axes. */
    struct Spring
    {
      std::array<std::pair<unsigned int, Vector3>, 8> nodes;
      double                                          stiffness = 0; ///< [N/mm]
      double by_turn = 0; ///< change of the gap with the turn of the driven body [mm/rad]
    };

    /** Throws InputError where the model is no gear pair with contact. The model must outlive the
     * object. */
    explicit PressedPair(const Model &model);
    ~PressedPair();

    /** Gap at the first touch [mm]: 1e-5 arcsec at 100 mm. */
    static constexpr double touch_tolerance = 5e-9;

    /** The driver has turned by this since time zero in the drive direction [rad]; the driven body
     * follows by its kinematic turn. */
    void   set_position(double driver_turn);
    double driver_turn() const
    {
      return driver_turn_;
    }
    /** Of the driven body beyond its kinematic turn. */
    void set_turn(double turn);

    /** Of the transmission: a turn of the driven body is counted as a way at it [mm]. */
    double                      arm() const;
    const std::vector<Matrix3> &rotations() const
    {
      return rotations_;
    }
    /** Kinematic turns of the bodies about their axes since time zero [rad]. */
    std::vector<double> kinematic_turns() const;
    /** Body frame to fixed frame at the position. */
    RigidMotion body_motion(unsigned int body) const;
    /** Placement of a body: at @p x in the axes of time zero, turned. */
    Vector3 place(unsigned int body, const Vector3 &x) const;

    /** Finds what may touch, on the way of rigid bodies to @p later_turn of the driver too. */
    void find_candidates(double later_turn);
    void find_candidates()
    {
      find_candidates(driver_turn_);
    }
    /** Nodes of bodies that may touch since find_candidates(), (body, node) sorted. */
    std::vector<std::pair<unsigned int, unsigned int>> candidates() const;
    /** Groups of the first contact pair that may touch since find_candidates(): (slave's,
     * master's), sorted. */
    const std::vector<std::pair<unsigned int, unsigned int>> &candidate_teeth() const;
    /** From now on rows 3 i + c are of these nodes. Candidates that are not among them move with
     * their bodies, displaced by hold(); where contact acts on one, evaluate() throws StrayContact.
     */
    void set_nodes(const std::vector<Node> &nodes);
    /** Displacements of candidates() without rows (3 each, axes of time zero) [mm]. */
    void hold(const Eigen::VectorXd &displacements);
    /** Those candidates, displaced by hold(), whose flanks are nearer to each other than @p reach
     * [mm], now with the turn @p turn, or then with the driver at @p later_turn; sorted. */
    std::vector<std::pair<unsigned int, unsigned int>>
    find_near(double turn, double later_turn, double reach);

    /** A vector along the axes of a node's rows, turned with its body. */
    Vector3 to_fixed_frame(std::size_t node, const Vector3 &along_rows) const
    {
      return rotations_[nodes_[node].body] * (nodes_[node].axes * along_rows);
    }

    /** What acts when the rows are displaced by @p u and the driven body by @p turn. */
    PressedForces
    evaluate(const PressedBodies &bodies, const Eigen::VectorXd &u, double turn, bool touching);

    /** Turn at which the flanks of the first contact pair just touch, displaced by @p u; a load of
     * the @p sense closes them. Throws NumericalError where there is none. */
    double find_touch(const Eigen::VectorXd &u, double sense);

    /** A first guess that presses: as deep as rigid flanks would need it. Throws NumericalError. */
    PressedState press_rigid(const PressedBodies   &bodies,
                             const Eigen::VectorXd &base,
                             double                 load,
                             PressedState           guess);

    /** The springs of the contact where it was last evaluated. */
    std::vector<Spring> find_springs() const;

    /** Tooth pairs in contact where it was last evaluated. */
    std::vector<ToothContact> teeth() const;

    /** Forces of the contact on nodes where it was last evaluated, of those that may touch. */
    std::vector<NodalForce> contact_forces() const;

    /** The deepest penetration that is taken for contact, the farthest that it is looked for [mm].
     */
    double depth_limit() const;

    /** Of the nodes that may touch: distance between the bodies' mean displacements [mm], and the
     * farthest that contact is looked for. */
    std::pair<double, double> find_excursion(const Eigen::VectorXd &u) const;

    [[noreturn]] void fail(const std::string &what, const std::string &history) const;

  private:
    struct Surface;
    struct Pair;

    /** By body and node: the place among @p nodes, or Surface::no_place. */
    std::vector<std::vector<unsigned int>>
    places_of(const std::vector<std::pair<unsigned int, unsigned int>> &nodes) const;
    /** @p u: empty: of all that has been held. */
    void move(Pair &pair, const Eigen::VectorXd &u);
    void add_contact(const Eigen::VectorXd &u, PressedForces &sum);

    const Model                       &model_;
    std::vector<std::unique_ptr<Pair>> pairs_;
    std::vector<Node>                  nodes_;
    std::vector<Matrix3>               rotations_; ///< of the bodies since time zero
    double                             driver_turn_ = 0;
  };

  /** What to say where bearings let flanks move by @p apart against each other, farther than
   * contact is looked for, @p limit [mm]; empty: they do not. */
  std::string describe_excess(double apart, double limit);
} // namespace vfife

#endif
