// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_output_ring_askew_h
#define vfife_tests_output_ring_askew_h

#include "../model_parts.h"

#include <vfife/mesh/primitives/primitives.h>

/** A ring of 24 sectors that turns about an axis askew. */
inline vfife::Body ring_askew(const std::string &name, const vfife::Material &material)
{
  vfife::Body ring(name, vfife::make_ring(20, 30, 5, {{2, 24, 2}}), material);
  place_on_axis(ring, vfife::Vector3(1, 2, 3), vfife::Vector3(1, 2, 2));
  return ring;
}

/** That ring turning, whose outer surface may touch a block: [mm], [rad/s]. */
inline vfife::Model
ring_and_block(const vfife::Material &material, const double rate, const double block_size = 4)
{
  vfife::Model model;
  vfife::Body  ring = ring_askew("ring", material);
  ring.rate         = rate;
  model.add_body(std::move(ring));
  model.add_body(vfife::Body("block",
                             vfife::make_block(vfife::Vector3(block_size, 3, 2), {{4, 3, 2}}),
                             material));
  model.contacts.push_back(contact_of("", {0, "outer"}, {1, "x-"}));
  return model;
}

#endif
