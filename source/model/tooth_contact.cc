// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/tooth_contact.h>

namespace vfife
{
  ToothContact
  make_tooth_contact(const Model &model, const unsigned int contact, const GroupPairResult &result)
  {
    // The master of a gear pair is the driven member; its torque counts positive in the drive
    // direction.
    const Axis               &axis  = model.bodies[model.contacts[contact].master_body].axis;
    const Transmission *const t     = model.only_transmission();
    const double              sense = t ? t->driven_sense : 1.;
    ToothContact              tooth;
    tooth.contact      = contact;
    tooth.slave_group  = result.slave_group;
    tooth.master_group = result.master_group;
    tooth.force        = result.force;
    // Reaction on the master, about a point of its axis.
    tooth.torque = -sense * axis.direction.dot(result.moment - axis.point.cross(result.force));
    tooth.normal_force     = result.normal_force;
    tooth.area             = result.area;
    tooth.largest_pressure = result.largest_pressure;
    tooth.penetration      = result.largest_penetration;
    return tooth;
  }
} // namespace vfife
