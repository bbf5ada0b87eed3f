// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/fem/system/fem_space_options.h>

namespace vfife
{
  const Choices<FemGeometry> &fem_geometry_choices()
  {
    static const Choices<FemGeometry> choices = {{"straight", FemGeometry::straight},
                                                 {"curved", FemGeometry::curved}};
    return choices;
  }

  std::vector<LocalRefinement> read_local_refinements(const std::vector<std::string> &texts)
  {
    constexpr unsigned int       most = 5;
    std::vector<LocalRefinement> refinements;
    for (const std::string &text : texts)
      {
        const std::size_t blank = text.find_last_of(' ');
        const std::string times = blank == std::string::npos ? "" : text.substr(blank + 1);
        if (times.size() != 1 || times[0] < '1' || times[0] > '0' + int(most))
          throw InputError("expected a name and 1 to " + std::to_string(most) +
                           " times, such as fillets 2, got \"" + text + "\"");
        refinements.push_back(
          {text.substr(0, text.find_last_not_of(' ', blank) + 1), unsigned(times[0] - '0')});
      }
    return refinements;
  }
} // namespace vfife
