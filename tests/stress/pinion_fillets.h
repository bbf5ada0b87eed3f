// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_stress_pinion_fillets_h
#define vfife_tests_stress_pinion_fillets_h

#include "../gear/paper_pair.h"
#include "../mesh/paper_members.h"
#include "../model_parts.h"
#include "../tests.h"

#include <vfife/mesh/gear/gear_body.h>
#include <vfife/mesh/node_set_names.h>
#include <vfife/model/model.h>
#include <vfife/output/measures/root_stress.h>

/** Largest stresses of a fillet [MPa]. */
struct RootStresses
{
  double tension = 0, compression = 0;
};

/** The paper's pinion, held by its bore. */
inline vfife::Model make_held_pinion(const vfife::GearBodyOptions &options)
{
  vfife::Model model = model_of(
    vfife::Body("pinion", vfife::make_gear_body(paper::pinion(), options), vfife::Material()));
  model.constraints.push_back(
    {"bore", vfife::ConstraintKind::held, 0, model.bodies[0].node_set(vfife::node_set::bore)});
  return model;
}

/** 100 MPa on the whole concave flank of tooth 0. */
inline vfife::Load press_flank(const vfife::Body &body)
{
  vfife::Load load = pressure_on({}, 100.);
  for (const unsigned int node : body.mesh().surfaces.at(vfife::surface_name::concave).nodes)
    if (body.structure().sector_of(node) == 0)
      load.nodes.push_back(node);
  return load;
}

/** Both fillets of all teeth of the body 0. */
inline std::deque<vfife::MemberFillet> list_fillets(const vfife::Body &body)
{
  std::deque<vfife::MemberFillet> fillets;
  for (const char *side : {vfife::surface_name::concave, vfife::surface_name::convex})
    fillets.push_back({0, vfife::Fillet(body, side)});
  return fillets;
}

/** Of both fillets of tooth 0. */
inline RootStresses find_largest(const std::deque<vfife::MemberFillet> &fillets,
                                 const vfife::FilletStrains            &strains)
{
  using namespace vfife;
  RootStresses found;
  for (const MemberFillet &member : fillets)
    for (unsigned int column = 0; column < member.fillet.n_columns(); ++column)
      for (unsigned int row = Fillet::first_row; row < member.fillet.end_row(); ++row)
        {
          const PrincipalStresses stress =
            compute_principal_stresses(compute_surface_stress(strains.facet(member, column, row, 0),
                                                              member.fillet.material()));
          raise_to(found.tension, stress.first);
          found.compression = -largest_of(-found.compression, -stress.third);
        }
  return found;
}

#endif
