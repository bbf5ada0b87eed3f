// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include "matrix_stream.h"

#include <vfife/reduced/reduced_body.h>

namespace vfife
{
  unsigned int ReducedBody::n_modes() const
  {
    unsigned int n = 0;
    for (const Harmonic &harmonic : harmonics)
      n += harmonic.n_modes();
    return n;
  }

  int ReducedBody::find_reading(const std::string &name) const
  {
    for (std::size_t i = 0; i < readings.size(); ++i)
      if (readings[i].name == name)
        return i;
    return -1;
  }

  const Eigen::MatrixXd *ReducedBody::find_residual(const unsigned int sector,
                                                    const unsigned int loaded) const
  {
    const int N = n_sectors;
    int       d = (static_cast<int>(sector) - static_cast<int>(loaded) + N) % N;
    d           = d > N / 2 ? d - N : d;
    return std::abs(d) <= static_cast<int>(reach) ? &residual[d + reach] : nullptr;
  }

  void serialize(ReducedBody::Harmonic &harmonic, ByteStream &stream)
  {
    stream.pass(harmonic.number);
    pass_matrix(harmonic.eigenvalues, stream);
    pass_matrix(harmonic.coriolis, stream);
    pass_matrix(harmonic.spin_stiffness, stream);
    pass_matrix(harmonic.shapes, stream);
    pass_matrix(harmonic.torque, stream);
  }
} // namespace vfife
