// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/column_names.h>

namespace vfife
{
  namespace column
  {
    std::array<std::string, 3> displacements(const Axes &axes)
    {
      std::array<std::string, 3> names;
      for (unsigned int c = 0; c < 3; ++c)
        names[c] = std::string(displacement) + " " + axes[c];
      return names;
    }

    std::array<std::string, 6> stresses(const Axes &axes)
    {
      std::array<std::string, 6> names;
      for (unsigned int c = 0; c < 3; ++c)
        {
          // Order of the components in all results: 11, 22, 33, 12, 23, 31.
          names[c]     = std::string(stress) + " " + axes[c];
          names[c + 3] = names[c] + " " + axes[(c + 1) % 3];
        }
      return names;
    }

    std::string angle_of(const std::string &body)
    {
      return body + " angle";
    }

    std::string tooth_of(const std::string &body)
    {
      return body + " tooth";
    }

    std::string contact_torque_on(const std::string &body)
    {
      return "contact torque on the " + body;
    }
  } // namespace column
} // namespace vfife
