// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/former_result_names.h>

#include <optional>

namespace vfife
{
  namespace
  {
    using Names = std::vector<FormerResultName>;

    /** Columns, and words in cells. */
    Names list_table_names()
    {
      Names names = {
        {"history.csv", "taken by the driven speed damping", "removed by the driven speed damping"},
        {"teeth.csv", "slave group", "slave facet group"},
        {"teeth.csv", "master group", "master facet group"},
        {"root_sections.csv", "tension after the mesh", "tension after the mean contact"},
        {"root_sections.csv", "compression after the mesh", "compression after the mean contact"},
        {"coupled_modes.csv", "share of the static turn", "share of the static rotation"},
        {"coupled_modes.csv", "turning", "rotating"},
        {"coupled_modes.csv", "standing", "fixed"},
        {"waves_in_contact.csv", "share of the turn", "share of the rotation"},
        {"waves_in_contact.csv", "amplitude of the turn", "amplitude of the rotation"},
        {"resonance.csv", "time apart", "time without contact"},
        {"wave_response.csv", "standing wave *", "stationary wave *"},
        {"wave_response.csv", "running wave *", "travelling wave *"},
        {"waves_response.csv", "running wave", "travelling wave"},
        {"differences.csv", "told apart", "significant"},
        {"differences.csv", "order told", "sign significant"},
        {"differences.csv", "not told apart", "not significant"}};
      for (const char *file :
           {"root_stress.csv", "gauges.csv", "loaded_probes.csv", "pressure.csv"})
        names.push_back({file, "after the mesh", "position after the mean contact"});
      for (const char *file : {"sweep.csv", "error_bars.csv", "differences.csv"})
        {
          names.push_back({file, "swing frequency", "torsional mode frequency"});
          names.push_back({file, "* largest of a turn", "* largest per revolution"});
          names.push_back({file, "* median of a turn", "* median per revolution"});
        }
      return names;
    }

    Names list_json_names()
    {
      return {{"summary.json", "swing frequency, estimated", "torsional mode frequency, estimated"},
              {"summary.json", "inertia of the swing", "inertia of the torsional mode"},
              {"summary.json", "swing period", "torsional mode period"},
              {"summary.json", "effective arm", "effective lever arm"},
              {"summary.json",
               "least arm on the path of contact",
               "least lever arm on the path of contact"},
              {"summary.json",
               "largest arm on the path of contact",
               "largest lever arm on the path of contact"},
              {"summary.json", "torque over effective arm*", "torque over effective lever arm*"},
              {"summary.json",
               "penalty springs, in teeth and rest",
               "penalty compliance, in teeth and rest"},
              {"summary.json", "largest of a turn", "largest per revolution"},
              {"summary.json", "median of a turn", "median per revolution"},
              {"summary.json", "after the mesh", "position after the mean contact"},
              {"summary.json", "passes the mesh", "time at the mean contact"},
              {"summary.json",
               "taken by the driven speed damping",
               "removed by the driven speed damping"},
              {"summary.json",
               "taken by the driven speed damping from the swing",
               "removed by the driven speed damping from the torsional mode"},
              {"summary.json", "spin drift", "drift of rotation speed"},
              {"summary.json", "contradictions", "input conflicts"},
              {"lumped.json",
               "inertia of the swing, at the gear",
               "inertia of the torsional mode, at the gear"},
              {"lumped.json", "arm", "lever arm"},
              {"lumped.json", "backlash, turn of the gear", "backlash angle of the gear"},
              {"lumped.json", "time apart", "time without contact"},
              {"tca.json", "play of the gear", "backlash angle of the gear"},
              {"tca.json", "regularity at the fillet", "undercut indicator at the fillet"},
              {"tca.json", "hand-over", "transfer point"},
              {"tca.json", "hands over", "has a transfer point"},
              {"tca.json", "hands over inside the flanks", "transfer point inside the flanks"},
              {"tca.json", "edge takes over at", "edge contact starts at"},
              {"tca.json", "approach before it carries", "approach before edge contact"},
              {"edge_contact.json", "edges carry", "edge contact"}};
    }

    /** The name with @p from replaced by @p to; nothing where it is another name. */
    std::optional<std::string>
    replace(const std::string &name, const std::string &from, const std::string &to)
    {
      const std::size_t star = from.find('*');
      if (star == std::string::npos)
        return name == from ? std::optional<std::string>(to) : std::nullopt;
      // What stands for the star is between its two sides, one of which is empty.
      const std::string before = from.substr(0, star), after = from.substr(star + 1);
      if (name.size() < before.size() + after.size() ||
          name.compare(0, before.size(), before) != 0 ||
          name.compare(name.size() - after.size(), after.size(), after) != 0)
        return std::nullopt;
      std::string replaced = to;
      return replaced.replace(
        to.find('*'), 1, name.substr(before.size(), name.size() - before.size() - after.size()));
    }
  } // namespace

  const std::vector<FormerResultName> &list_former_result_names()
  {
    static const Names names = [] {
      Names       all  = list_table_names();
      const Names json = list_json_names();
      all.insert(all.end(), json.begin(), json.end());
      return all;
    }();
    return names;
  }

  std::string present_result_name(const std::string &file, const std::string &name)
  {
    for (const FormerResultName &one : list_former_result_names())
      if (one.file == file)
        if (const auto present = replace(name, one.former, one.present))
          return *present;
    return name;
  }

  std::string former_result_name(const std::string &name)
  {
    for (const FormerResultName &one : list_former_result_names())
      if (const auto former = replace(name, one.present, one.former))
        return *former;
    return "";
  }
} // namespace vfife
