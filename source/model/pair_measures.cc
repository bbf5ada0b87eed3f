// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/model.h>
#include <vfife/model/pair_measures.h>
#include <vfife/model/state.h>

#include <algorithm>

namespace vfife
{
  MemberOfPair find_member(const Transmission &pair, const unsigned int body)
  {
    if (body == pair.driven)
      return {pair.driven_teeth, pair.driven_sense, pair.driven_bore};
    return {pair.driver_teeth, pair.driver_sense, pair.driver_bore};
  }

  double torque_on(const Model &model, const unsigned int body, const std::optional<double> &time)
  {
    double sum = 0;
    for (const Torque &torque : model.torques)
      if (torque.body == body)
        sum += torque.value * (time ? torque.history.value(*time) : 1.);
    return sum;
  }

  double load_torque(const Model &model)
  {
    // Torques act + about the body's axis; a load has the sign against its rotation.
    const Transmission *const t = model.only_transmission();
    return t ? -t->driven_sense * torque_on(model, t->driven) : 0.;
  }

  void
  set_teeth(std::vector<ToothContact> teeth, const std::size_t n_contacts, Measurements &measured)
  {
    measured.contact_force = measured.contact_torque = measured.largest_penetration = 0;
    measured.teeth_in_contact                                                       = teeth.size();
    measured.contact_forces.assign(n_contacts, Vector3::Zero());
    for (const ToothContact &tooth : teeth)
      {
        measured.contact_forces[tooth.contact] += tooth.force;
        measured.contact_force += tooth.force.norm();
        measured.contact_torque += tooth.torque;
        measured.largest_penetration = std::max(measured.largest_penetration, tooth.penetration);
      }
    measured.teeth = std::move(teeth);
  }

  void complete_angles(const Transmission &t, const double turn, Measurements &measured)
  {
    // DTE = theta_g - (z_p/z_g) theta_p, each theta = start + kinematic turn + lead: the kinematic
    // turns cancel; start and leads of the gear's bore or rim and of the driver's bore remain.
    const double start  = t.driven_start - t.ratio() * (t.driver_start + measured.driver_angle);
    const double driven = t.driven_start + t.ratio() * turn;
    measured.transmission_error     = start + measured.driven_angle;
    measured.rim_transmission_error = start + measured.rim_angle;
    measured.driver_angle           = t.driver_start + turn + measured.driver_angle;
    measured.driven_angle           = driven + measured.driven_angle;
    measured.rim_angle              = driven + measured.rim_angle;
  }
} // namespace vfife
