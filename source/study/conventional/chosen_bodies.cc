// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/fem/fem_options.h>
#include <vfife/model/model.h>
#include <vfife/study/conventional/chosen_bodies.h>

#include <algorithm>

namespace vfife
{
  std::vector<unsigned int> find_chosen_bodies(const FemOptions &options, const Model &model)
  {
    std::vector<std::string>  names;
    std::vector<unsigned int> bodies;
    for (const Body &body : model.bodies)
      names.push_back(body.name());
    // In the order in which they are asked for, all of them if none is.
    for (const std::string &wanted : options.bodies.empty() ? names : options.bodies)
      {
        const auto found = std::find(names.begin(), names.end(), wanted);
        if (found == names.end())
          throw InputError("Fem/bodies",
                           "expected a body, got \"" + wanted + "\"" + did_you_mean(wanted, names) +
                             " (bodies: " + list_of(names) + ")");
        bodies.push_back(found - names.begin());
      }
    return bodies;
  }

  void log_housing(const Model &model, const std::vector<unsigned int> &bodies, Log &log)
  {
    if (model.housing.size() == 0)
      return;
    std::vector<std::string> held;
    for (const Bearing &bearing : model.bearings)
      if (std::find(bodies.begin(), bodies.end(), bearing.body) == bodies.end())
        held.push_back(bearing.name);
    if (held.empty())
      log.line("the housing joins all bearings");
    else
      log.line(
        "the housing joins the bearings of this body; the bearings of other bodies are fixed: ",
        list_of(held));
  }
} // namespace vfife
