// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_complex_h
#define vfife_base_complex_h

#include <complex>

namespace vfife
{
  using Complex = std::complex<double>;

  constexpr Complex imaginary_unit(0., 1.);
} // namespace vfife

#endif
