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
