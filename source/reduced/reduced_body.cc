// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "matrix_stream.h"

#include <vfife/reduced/reduced_body.h>

#include <cstdlib>
#include <stdexcept>

namespace vfife
{
  Eigen::VectorXcd ReducedBody::Harmonic::forces_of(const AxialLoad &load) const
  {
    if (number > 0)
      return Eigen::VectorXcd::Zero(n_modes());
    return load.torque * torque + load.acceleration * euler;
  }

  unsigned int ReducedBody::n_modes() const
  {
    unsigned int n = 0;
    for (const Harmonic &harmonic : harmonics)
      n += harmonic.n_modes();
    return n;
  }

  unsigned int ReducedBody::find_reading(const std::string &name) const
  {
    for (unsigned int i = 0; i < readings.size(); ++i)
      if (readings[i].name == name)
        return i;
    throw std::logic_error("a reduced body has no reading \"" + name + "\"");
  }

  const Eigen::MatrixXd *ReducedBody::find_residual(const int distance) const
  {
    const int n = n_sectors;
    if (static_cast<unsigned int>(std::abs(distance)) > reach)
      return nullptr;
    // Half a turn away lies one sector in both senses.
    return &residual[2 * distance == -n ? 2 * reach : distance + reach];
  }

  void serialize(ReducedBody::Harmonic &harmonic, ByteStream &stream)
  {
    stream.pass(harmonic.number);
    pass_matrix(harmonic.eigenvalues, stream);
    pass_matrix(harmonic.coriolis, stream);
    pass_matrix(harmonic.spin_stiffness, stream);
    pass_matrix(harmonic.shapes, stream);
    pass_matrix(harmonic.torque, stream);
    pass_matrix(harmonic.euler, stream);
  }
} // namespace vfife
