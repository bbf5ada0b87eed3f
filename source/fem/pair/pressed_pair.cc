// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/contact/contact.h>
#include <vfife/fem/pair/pressed_pair.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/model.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <sstream>

// Positions and all that the contact module sees are in the fixed frame, the bodies turned by
// rotations_.
namespace vfife
{
  namespace
  {
    /** Of the secant towards the first touch. */
    constexpr unsigned int touch_steps = 60;
  } // namespace

  /** One surface of a contact pair, its nodes' places among those of the rows, their motion. */
  struct PressedPair::Surface
  {
    static constexpr unsigned int no_place = static_cast<unsigned int>(-1);

    unsigned int              body;
    const FacetSurface       &facets;
    std::vector<unsigned int> place; ///< of the surface's nodes, or no_place
    std::vector<double>       mass, positions, velocities, forces;
    std::vector<double>       held; ///< displacements without rows, axes of time zero

    Surface(const Model &model, const unsigned int b, const std::string &name)
      : body(b)
      , facets(model.bodies[b].mesh().surfaces.at(name))
      , place(facets.nodes.size(), no_place)
      , positions(3 * facets.nodes.size(), 0.)
      , velocities(3 * facets.nodes.size(), 0.)
      , forces(3 * facets.nodes.size(), 0.)
      , held(3 * facets.nodes.size(), 0.)
    {
      for (const unsigned int node : facets.nodes)
        mass.push_back(model.bodies[b].node_masses()[node]);
    }
  };

  struct PressedPair::Pair
  {
    Surface slave, master;
    Contact contact;

    Pair(const ContactPair &pair, const Model &model)
      : slave(model, pair.slave_body, pair.slave_surface)
      , master(model, pair.master_body, pair.master_surface)
      , contact(slave.facets, master.facets, pair.options)
    {
      contact.set_penalty(pair.options.penalty.value,
                          contact.node_springs().mass_per_area(slave.mass, master.mass));
      if (!pair.stiffness.empty())
        contact.set_stiffness(pair.stiffness);
      // Newton's method is one of springs along the normals.
      contact.set_friction_mode(FrictionMode::none);
    }

    const std::vector<unsigned int> &active(const Surface &surface) const
    {
      return &surface == &slave ? contact.active_slave_nodes() : contact.active_master_nodes();
    }
    SurfaceMotion motion(const Surface &surface, const RigidMotion &body) const
    {
      return {surface.positions.data(), surface.velocities.data(), body};
    }
    /** Undeformed flanks may be apart by this and touch under load [mm]. */
    double margin() const
    {
      return contact.search_skin() + contact.depth_limit();
    }
  };

  PressedPair::PressedPair(const Model &model)
    : model_(model)
    , rotations_(model.bodies.size(), Matrix3::Identity())
  {
    if (model.transmissions.empty() || model.contacts.empty())
      throw InputError("the equilibrium of a loaded pair requires a gear pair with contact");
    for (const ContactPair &pair : model.contacts)
      pairs_.push_back(std::make_unique<Pair>(pair, model));
  }

  PressedPair::~PressedPair() = default;

  void PressedPair::set_position(const double driver_turn)
  {
    const Transmission &t = *model_.only_transmission();
    driver_turn_          = driver_turn;
    rotations_[t.driver] =
      rotation_about(model_.bodies[t.driver].axis.direction, t.driver_sense * driver_turn);
    set_turn(0.);
  }

  double PressedPair::arm() const
  {
    return model_.only_transmission()->arm;
  }

  std::vector<double> PressedPair::kinematic_turns() const
  {
    const Transmission &t = *model_.only_transmission();
    std::vector<double> turns(model_.bodies.size(), 0.);
    turns[t.driver] = t.driver_sense * driver_turn_;
    turns[t.driven] = t.driven_sense * t.ratio() * driver_turn_;
    return turns;
  }

  void PressedPair::set_turn(const double turn)
  {
    const Transmission &t = *model_.only_transmission();
    rotations_[t.driven]  = rotation_about(model_.bodies[t.driven].axis.direction,
                                          t.driven_sense * t.ratio() * driver_turn_ + turn);
  }

  Vector3 PressedPair::place(const unsigned int body, const Vector3 &x) const
  {
    const Vector3 &c = model_.bodies[body].axis.point;
    return c + rotations_[body] * (x - c);
  }

  RigidMotion PressedPair::body_motion(const unsigned int body) const
  {
    const Body &b = model_.bodies[body];
    return {rotations_[body] * b.placement.rotation, place(body, b.placement.translation)};
  }

  void PressedPair::find_candidates(const double later_turn)
  {
    const double         turn      = driver_turn_;
    std::vector<Matrix3> rotations = rotations_;
    set_position(later_turn);
    std::vector<RigidMotion> later;
    for (unsigned int b = 0; b < rotations.size(); ++b)
      later.push_back(body_motion(b));
    rotations_   = std::move(rotations);
    driver_turn_ = turn;
    for (const auto &pair : pairs_)
      pair->contact.find_candidates(body_motion(pair->slave.body),
                                    body_motion(pair->master.body),
                                    later[pair->slave.body],
                                    later[pair->master.body],
                                    pair->margin());
  }

  std::vector<std::pair<unsigned int, unsigned int>> PressedPair::candidates() const
  {
    std::vector<std::pair<unsigned int, unsigned int>> nodes;
    for (const auto &pair : pairs_)
      for (const Surface *surface : {&pair->slave, &pair->master})
        for (const unsigned int i : pair->active(*surface))
          nodes.emplace_back(surface->body, surface->facets.nodes[i]);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  const std::vector<std::pair<unsigned int, unsigned int>> &PressedPair::candidate_teeth() const
  {
    return pairs_.front()->contact.candidate_pairs();
  }

  void PressedPair::set_nodes(const std::vector<Node> &nodes)
  {
    nodes_ = nodes;
    std::vector<std::pair<unsigned int, unsigned int>> of_rows;
    for (const Node &node : nodes)
      of_rows.emplace_back(node.body, node.node);
    const auto places = places_of(of_rows);
    for (const auto &pair : pairs_)
      for (Surface *surface : {&pair->slave, &pair->master})
        for (std::size_t i = 0; i < surface->place.size(); ++i)
          surface->place[i] = places[surface->body][surface->facets.nodes[i]];
  }

  std::vector<std::vector<unsigned int>>
  PressedPair::places_of(const std::vector<std::pair<unsigned int, unsigned int>> &nodes) const
  {
    std::vector<std::vector<unsigned int>> places(model_.bodies.size());
    for (unsigned int b = 0; b < places.size(); ++b)
      places[b].assign(model_.bodies[b].n_nodes(), Surface::no_place);
    for (std::size_t i = 0; i < nodes.size(); ++i)
      places[nodes[i].first][nodes[i].second] = i;
    return places;
  }

  void PressedPair::hold(const Eigen::VectorXd &displacements)
  {
    const auto places = places_of(candidates());
    for (const auto &pair : pairs_)
      for (Surface *surface : {&pair->slave, &pair->master})
        for (const unsigned int i : pair->active(*surface))
          Eigen::Map<Vector3>(surface->held.data() + 3 * i) =
            displacements.segment<3>(3 * places[surface->body][surface->facets.nodes[i]]);
  }

  std::vector<std::pair<unsigned int, unsigned int>>
  PressedPair::find_near(const double turn, const double later_turn, const double reach)
  {
    std::vector<std::pair<unsigned int, unsigned int>> nodes;
    const auto                                         add_near = [&]() {
      set_turn(turn);
      for (const auto &pair : pairs_)
        {
          move(*pair, Eigen::VectorXd());
          const Surface &s = pair->slave, &m = pair->master;
          const auto     near = pair->contact.find_near_nodes(pair->motion(s, body_motion(s.body)),
                                                          pair->motion(m, body_motion(m.body)),
                                                          reach);
          for (const unsigned int i : near.first)
            nodes.emplace_back(s.body, s.facets.nodes[i]);
          for (const unsigned int i : near.second)
            nodes.emplace_back(m.body, m.facets.nodes[i]);
        }
    };
    const double now = driver_turn_;
    add_near();
    set_position(later_turn);
    add_near();
    set_position(now);
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    return nodes;
  }

  void PressedPair::move(Pair &pair, const Eigen::VectorXd &u)
  {
    for (Surface *surface : {&pair.slave, &pair.master})
      {
        const Body &body = model_.bodies[surface->body];
        for (const unsigned int i : pair.active(*surface))
          {
            const unsigned int k = surface->place[i];
            const Vector3      X = body.placement(body.node_positions()[surface->facets.nodes[i]]);
            const Vector3      moved =
              u.size() == 0 || k == Surface::no_place
                     ? Vector3(Eigen::Map<const Vector3>(surface->held.data() + 3 * i))
                     : Vector3(nodes_[k].axes * u.segment<3>(3 * k));
            Eigen::Map<Vector3>(surface->positions.data() + 3 * i) =
              place(surface->body, X + moved);
            std::fill_n(surface->forces.data() + 3 * i, 3, 0.);
          }
      }
  }

  PressedForces PressedPair::evaluate(const PressedBodies   &bodies,
                                      const Eigen::VectorXd &u,
                                      const double           turn,
                                      const bool             touching)
  {
    set_turn(turn);
    PressedForces sum;
    sum.force = Eigen::VectorXd::Zero(u.size());
    if (touching)
      add_contact(u, sum);
    sum.contact_force = sum.force.norm();
    sum.energy        = sum.contact_energy;
    sum.torque        = sum.contact_torque;
    bodies.add_forces(u, sum);
    return sum;
  }

  void PressedPair::add_contact(const Eigen::VectorXd &u, PressedForces &sum)
  {
    const unsigned int driven = model_.only_transmission()->driven;
    for (const auto &pair : pairs_)
      {
        // x = c + R (X + u - c) of both flanks; the contact module works in the fixed frame, and
        // its forces are turned back into the axes of the rows. At rest: velocities and time step
        // are zero.
        move(*pair, u);
        Surface &s = pair->slave, &m = pair->master;
        pair->contact.add_forces(pair->motion(s, body_motion(s.body)),
                                 pair->motion(m, body_motion(m.body)),
                                 0.,
                                 s.forces.data(),
                                 m.forces.data());
        for (const GroupPairResult &result : pair->contact.results())
          sum.contact_energy += result.energy;
        for (const Surface *surface : {&s, &m})
          {
            const Axis &axis   = model_.bodies[surface->body].axis;
            double      torque = 0;
            for (const unsigned int i : pair->active(*surface))
              {
                const Eigen::Map<const Vector3> f(surface->forces.data() + 3 * i),
                  x(surface->positions.data() + 3 * i);
                const unsigned int k = surface->place[i];
                if (k == Surface::no_place)
                  {
                    if (f.squaredNorm() > 0)
                      throw StrayContact();
                    continue;
                  }
                sum.force.segment<3>(3 * k) +=
                  nodes_[k].axes.transpose() * (rotations_[surface->body].transpose() * f);
                torque += axis.direction.dot((x - axis.point).cross(f));
              }
            (surface->body == driven ? sum.contact_torque : sum.driver_torque) += torque;
          }
      }
  }

  double PressedPair::find_touch(const Eigen::VectorXd &u, const double sense)
  {
    // The load turns the driven body towards the driver: a turn d closes the gap by arm d, nearly,
    // whatever the flanks are. Steps with this slope end at the touch.
    Pair  &pair = *pairs_.front();
    double turn = 0;
    for (unsigned int i = 0; i < touch_steps; ++i)
      {
        set_turn(turn);
        move(pair, u);
        const Surface &s = pair.slave, &m = pair.master;
        const double   gap = pair.contact
                             .smallest_gap(pair.motion(s, body_motion(s.body)),
                                           pair.motion(m, body_motion(m.body)),
                                           pair.contact.depth_limit())
                             .gap;
        // Nothing of one flank is within reach of the other any more.
        if (!std::isfinite(gap))
          break;
        if (std::abs(gap) < touch_tolerance)
          return turn;
        turn += sense * gap / arm();
      }
    fail("the flanks are not in contact within the search range: mounting errors separate them, or "
         "the torque rotates them past each other",
         "");
  }

  PressedState PressedPair::press_rigid(const PressedBodies   &bodies,
                                        const Eigen::VectorXd &base,
                                        const double           load,
                                        PressedState           guess)
  {
    // A first guess with some points under pressure: as deep as rigid bodies would need it.
    guess.touching              = true;
    guess.unit                  = 0;
    const Eigen::VectorXd u     = base + guess.deflection;
    const double          sense = load < 0 ? -1. : 1.;
    const double          touch = find_touch(u, sense);
    double                depth = 1e-5; // [mm]
    for (; depth < pairs_.front()->contact.depth_limit(); depth *= 2.)
      {
        // Twice as deep each time, until the contact has at least the torque: Newton's method comes
        // back from there, where all points that will carry are pressed.
        guess.turn   = touch + sense * depth / arm();
        guess.acting = evaluate(bodies, u, guess.turn, true);
        if (-sense * guess.acting.contact_torque >= std::abs(load))
          return guess;
      }
    fail("the undeformed flanks cannot transmit the torque", "");
  }

  std::vector<PressedPair::Spring> PressedPair::find_springs() const
  {
    const unsigned int driven = model_.only_transmission()->driven;
    const Axis        &axis   = model_.bodies[driven].axis;
    // Of each point under pressure: h changes by d . (dx_s - dy), d on the slave's node weights and
    // -d on the master's (at most 4 + 4 nodes), turned back into the axes of the rows; and by the
    // turn of the driven body by b = sum of weight d . (a x (x - c)) over its nodes.
    std::vector<Spring> springs;
    for (const auto &pair : pairs_)
      for (const ContactSpring &point : pair->contact.springs())
        {
          Spring &spring   = springs.emplace_back();
          spring.stiffness = point.stiffness;

          const auto add = [&](const Surface                     &surface,
                               const std::array<unsigned int, 4> &corners,
                               const std::array<double, 4>       &weights,
                               const double                       sign,
                               const unsigned int                 first) {
            for (unsigned int k = 0; k < 4; ++k)
              {
                const Vector3                   f = sign * weights[k] * point.direction;
                const Eigen::Map<const Vector3> x(surface.positions.data() + 3 * corners[k]);
                const unsigned int              at = surface.place[corners[k]];
                spring.nodes[first + k]            = {at,
                                                      nodes_[at].axes.transpose() *
                                                        (rotations_[surface.body].transpose() * f)};
                if (surface.body == driven)
                  spring.by_turn += f.dot(axis.direction.cross(x - axis.point));
              }
          };
          const Surface &slave  = point.swapped ? pair->master : pair->slave;
          const Surface &master = point.swapped ? pair->slave : pair->master;
          add(slave, point.slave_nodes, point.slave_weights, 1., 0);
          add(master, point.master_nodes, point.master_weights, -1., 4);
        }
    return springs;
  }

  std::vector<ToothContact> PressedPair::teeth() const
  {
    std::vector<ToothContact> teeth;
    for (unsigned int p = 0; p < pairs_.size(); ++p)
      for (const GroupPairResult &group : pairs_[p]->contact.results())
        if (group.normal_force > 0)
          teeth.push_back(make_tooth_contact(model_, p, group));
    return teeth;
  }

  std::vector<NodalForce> PressedPair::contact_forces() const
  {
    // A node may belong to both sides' flanks, and has the sum of their forces.
    std::map<std::pair<unsigned int, unsigned int>, Vector3> sums;
    for (const auto &pair : pairs_)
      for (const Surface *surface : {&pair->slave, &pair->master})
        for (const unsigned int i : pair->active(*surface))
          sums.try_emplace({surface->body, surface->facets.nodes[i]}, Vector3::Zero())
            .first->second += Eigen::Map<const Vector3>(surface->forces.data() + 3 * i);
    std::vector<NodalForce> forces;
    for (const auto &[node, force] : sums)
      forces.push_back({node.first, node.second, force});
    return forces;
  }

  double PressedPair::depth_limit() const
  {
    double limit = std::numeric_limits<double>::infinity();
    for (const auto &pair : pairs_)
      limit = std::min(limit, pair->contact.depth_limit());
    return limit;
  }

  std::pair<double, double> PressedPair::find_excursion(const Eigen::VectorXd &u) const
  {
    std::pair<double, double> largest{0., 0.};
    double                    share = 0;
    for (const auto &pair : pairs_)
      {
        Vector3 apart = Vector3::Zero();
        for (const Surface *surface : {&pair->slave, &pair->master})
          {
            Vector3 sum = Vector3::Zero();
            for (const unsigned int i : pair->active(*surface))
              {
                const unsigned int k = surface->place[i];
                sum += nodes_[k].axes * u.segment<3>(3 * k);
              }
            if (!pair->active(*surface).empty())
              apart += (surface == &pair->slave ? 1. : -1.) / pair->active(*surface).size() *
                       (rotations_[surface->body] * sum);
          }
        const double limit = pair->contact.depth_limit();
        if (apart.norm() > share * limit)
          {
            share   = apart.norm() / limit;
            largest = {apart.norm(), limit};
          }
      }
    return largest;
  }

  void PressedPair::fail(const std::string &what, const std::string &history) const
  {
    std::ostringstream text;
    text << "equilibrium of the pair at the position " << driver_turn_ * 180. / pi
         << " deg of the driver: " << what;
    if (!history.empty())
      text << "; residuals:" << history;
    throw NumericalError(text.str());
  }

  std::string describe_excess(const double apart, const double limit)
  {
    if (apart <= limit)
      return "";
    std::ostringstream text;
    text << "bearings displace the flanks by " << apart
         << " mm relative to each other, more than the search range of contact (" << limit
         << " mm, Contact/contact depth limit). Use stiffer bearings or a smaller torque";
    return text.str();
  }
} // namespace vfife
