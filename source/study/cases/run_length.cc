// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/model/transmission.h>
#include <vfife/study/cases/run_length.h>

#include <cmath>

namespace vfife
{
  double find_end(const Transmission *pair, const double time, const double sample)
  {
    const double end = sample * std::ceil(time / sample * (1. - 1e-9));
    return pair == nullptr || std::abs(end - time) <= 1e-9 * time ? time : end;
  }

  unsigned int count_meshes(const Transmission &pair, const double time)
  {
    return static_cast<unsigned int>(pair.meshes(time) + 1e-6);
  }
} // namespace vfife
