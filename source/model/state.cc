// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/state.h>

namespace vfife
{
  ProbeValue make_probe_value(const Vector3                       &displacement,
                              const Stress                        &stress,
                              const std::initializer_list<Matrix3> turns)
  {
    ProbeValue         value;
    Eigen::Map<Stress> turned(value.stress.data());
    value.displacement = displacement;
    value.von_mises    = von_mises(stress);
    turned             = stress;
    for (const Matrix3 &axes : turns)
      turned = turn_stress(turned, axes);
    return value;
  }

  std::vector<ProbeQuantity> list_probe_quantities(const column::Axes &axes)
  {
    using Of   = const ProbeValue &;
    using Kind = ProbeQuantityKind;
    std::vector<ProbeQuantity> quantities;
    for (unsigned int c = 0; c < 3; ++c)
      quantities.push_back(
        {Kind::displacement, column::displacements(axes)[c], "mm", [c](Of value) {
           return value.displacement[c];
         }});
    quantities.push_back({Kind::equivalent_stress, column::von_mises, "MPa", [](Of value) {
                            return value.von_mises;
                          }});
    for (unsigned int c = 0; c < 6; ++c)
      quantities.push_back({Kind::stress, column::stresses(axes)[c], "MPa", [c](Of value) {
                              return value.stress[c];
                            }});
    return quantities;
  }
} // namespace vfife
