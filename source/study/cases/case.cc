// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/figure_text.h>
#include <vfife/bearing/bearing_law.h>
#include <vfife/study/cases/case.h>

#include <algorithm>
#include <array>

namespace vfife
{
  namespace
  {
    std::string vector_text(const Vector3 &vector, const char *unit)
    {
      return sentence_of(4, vector[0], ", ", vector[1], ", ", vector[2], " ", unit);
    }

    std::string
    nodes_of(const Model &model, const unsigned int body, const std::vector<unsigned int> &nodes)
    {
      return sentence_of(4,
                         nodes.size(),
                         nodes.size() == 1 ? " node of " : " nodes of ",
                         model.bodies[body].name());
    }

    std::string over_time(const ParameterHistory &history)
    {
      return history.text() == "1" ? "" : ", over time by " + history.text();
    }

    /** "x 0, theta 5 deg" */
    std::string led_directions(const Constraint &constraint)
    {
      const std::array<const char *, 3> names = constraint.cylindrical
                                                  ? std::array<const char *, 3>{{"r", "theta", "z"}}
                                                  : std::array<const char *, 3>{{"x", "y", "z"}};
      std::string                       all;
      for (unsigned int c = 0; c < 3; ++c)
        if (constraint.prescribed[c])
          {
            const bool is_angle = constraint.cylindrical && c == 1;
            all += sentence_of(4,
                               all.empty() ? "" : ", ",
                               names[c],
                               " ",
                               constraint.displacement[c] / (is_angle ? degree : 1.),
                               is_angle ? " deg" : " mm");
          }
      return all;
    }

    std::string describe(const Constraint &constraint)
    {
      switch (constraint.kind)
        {
        case ConstraintKind::held:
          return "fixed";
        case ConstraintKind::prescribed_rotation:
          return constraint.angle
                   ? sentence_of(4, "rotated by ", *constraint.angle / degree, " deg")
                   : "rotated at the body's speed";
        case ConstraintKind::free_rotation:
          return "fixed along r and z; nodes rotate independently";
        case ConstraintKind::rigid_hub:
          return "fixed along r and z; nodes rotate together";
        case ConstraintKind::directions:
          return "displacement " + led_directions(constraint);
        }
      return "";
    }

    std::string describe(const Load &load)
    {
      switch (load.kind)
        {
        case LoadKind::force:
          return "force " + vector_text(load.vector, "N");
        case LoadKind::moment:
          return "moment " + vector_text(load.vector, "N mm");
        case LoadKind::pressure:
          return sentence_of(4, "pressure ", load.pressure, " MPa");
        case LoadKind::acceleration:
          return "acceleration " + vector_text(load.vector, "mm/s^2");
        case LoadKind::spring:
          return "springs to the ground, " + vector_text(load.vector, "N/mm");
        }
      return "";
    }

    /** Of displacements along and tilts about the bearing's axes; what couples them is named. */
    std::string describe(const Matrix5 &matrix, const std::array<const char *, 2> &units)
    {
      const Vector5     d     = matrix.diagonal();
      const bool        mixed = !matrix.isApprox(Matrix5(d.asDiagonal()));
      const std::string along =
        sentence_of(4, "x ", d[0], ", y ", d[1], ", z ", d[2], " ", units[0]);
      return along +
             sentence_of(4, ", tilts ", d[3], ", ", d[4], " ", units[1], mixed ? ", coupled" : "");
    }

    void log_bearings(const Model &model, Log &log)
    {
      for (const Bearing &bearing : model.bearings)
        {
          const bool is_straight = bearing.law->curve_range() == 0;
          log.line("bearing ",
                   bearing.name,
                   ": ",
                   nodes_of(model, bearing.body, bearing.nodes),
                   ", stiffness ",
                   is_straight ? "" : "without load ",
                   describe(bearing.law->linearized().stiffness, {{"N/mm", "N mm/rad"}}),
                   bearing.law->damping().isZero(0.)
                     ? ", no damping"
                     : ", damping " + describe(bearing.law->damping(), {{"N s/mm", "N mm s/rad"}}));
        }
      for (const Coupling &coupling : model.couplings)
        log.line("coupling ",
                 coupling.name,
                 ": ",
                 nodes_of(model, coupling.body, coupling.nodes),
                 ", stiffness ",
                 coupling.stiffness,
                 " N mm/rad, damping ",
                 coupling.damping,
                 " N mm s/rad");
      if (model.housing.size() > 0)
        log.line("housing: stiffness of ", model.housing.rows(), " displacements of the bearings");
    }
  } // namespace

  void Case::check_bodies() const
  {
    check();
  }

  void Case::set_defaults(DynamicsOptions &, OutputOptions &) const
  {
  }

  void Case::declare_run(dealii::ParameterHandler &)
  {
  }

  std::vector<unsigned int> Case::list_lengths(const DynamicsOptions &) const
  {
    return {};
  }

  void Case::set_length(unsigned int)
  {
  }

  bool Case::may_be_made_longer() const
  {
    return true;
  }

  double Case::ramp_time() const
  {
    return 0.;
  }

  const PairCase *Case::pair() const
  {
    return nullptr;
  }

  std::vector<std::string> Case::report_checks(const RunPlan &, Log &) const
  {
    return {};
  }

  std::string Case::find_cause() const
  {
    return {};
  }

  void report_conflict(const std::string &sentence, std::vector<std::string> &found, Log &log)
  {
    if (sentence.empty())
      return;
    found.push_back(sentence);
    log.line("warning: input conflict: ", sentence);
  }

  void log_parts(const Model &model, Log &log)
  {
    for (const Constraint &one : model.constraints)
      log.line("constraint ",
               one.name,
               ": ",
               nodes_of(model, one.body, one.nodes),
               ", ",
               describe(one),
               over_time(one.history));
    log_bearings(model, log);
    for (const Torque &torque : model.torques)
      log.line("torque ",
               torque.name,
               ": ",
               nodes_of(model, torque.body, torque.nodes),
               ", ",
               1e-3 * torque.value,
               " N m about the axis",
               over_time(torque.history));
    for (const Load &load : model.loads)
      log.line(load.kind == LoadKind::spring ? "spring " : "load ",
               load.name,
               ": ",
               nodes_of(model, load.body, load.nodes),
               ", ",
               describe(load),
               over_time(load.history));
    for (const RigidWall &wall : model.walls)
      log.line("wall ", wall.name, ": ", nodes_of(model, wall.body, wall.nodes));
    for (const ContactPair &pair : model.contacts)
      log.line("contact ",
               pair.side,
               ": ",
               pair.slave_surface,
               " of ",
               model.bodies[pair.slave_body].name(),
               " on ",
               pair.master_surface,
               " of ",
               model.bodies[pair.master_body].name());
  }

  void warn_of_materials(const Model &model, Log &log)
  {
    // Bodies of one material say the same, which the log writes once; but it counts.
    std::vector<std::string> seen;
    for (const Body &body : model.bodies)
      for (const Material &material : body.materials())
        {
          if (std::find(seen.begin(), seen.end(), material.name) != seen.end())
            continue;
          seen.push_back(material.name);
          for (const std::string &doubt : material.find_doubts())
            log.warning(doubt);
        }
  }
} // namespace vfife
