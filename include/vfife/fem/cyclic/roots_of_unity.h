// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_cyclic_roots_of_unity_h
#define vfife_fem_cyclic_roots_of_unity_h

#include <vfife/base/types.h>

#include <complex>
#include <vector>

namespace vfife
{
  /** Phases exp(2 pi i h k/N) of harmonic h after k sectors of N. A table: they are needed for
   * every row, harmonic and sector. */
  class RootsOfUnity
  {
  public:
    explicit RootsOfUnity(const unsigned int n)
    {
      for (unsigned int k = 0; k < n; ++k)
        roots_.push_back(std::polar(1., 2. * pi * k / n));
    }

    std::complex<double> operator()(const unsigned int harmonic, const int sectors) const
    {
      const long long n = roots_.size(), k = static_cast<long long>(harmonic) * sectors % n;
      return roots_[k < 0 ? k + n : k];
    }

  private:
    std::vector<std::complex<double>> roots_;
  };
} // namespace vfife

#endif
