// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/case_sections.h>
#include <vfife/base/errors.h>
#include <vfife/base/parameters/former_names.h>

#include <algorithm>
#include <map>
#include <sstream>

namespace vfife
{
  namespace
  {
    enum class CaseKind
    {
      any,
      pair,
      model
    };

    /** An entry of the previous version. */
    struct FormerName
    {
      std::string                        sections; ///< "*" is any section, "Body *" any body
      std::string                        name;
      std::string                        present_name; ///< "Section/name" in another section
      std::map<std::string, std::string> words;        ///< values by their former words
      CaseKind                           only = CaseKind::any;
    };

    const std::vector<FormerName> former_names = {
      {"Output", "history every", "samples per mesh cycle", {}, CaseKind::pair},
      {"Output", "history every", "steps per sample", {}, CaseKind::model},
      {"Output", "fields every", "field output interval", {}},
      {"Output", "checkpoint every", "checkpoint interval", {}},
      {"Output", "pictures", "report", {}},
      {"Sweep", "pictures", "report", {}},
      {"Compare", "pictures", "report", {}},
      {"Lumped", "pictures", "report", {}},
      {"Output", "tracked orders", "tracked mesh harmonics", {}},
      {"Output", "stress waves", "stress wave diameters", {}},
      {"Operation", "tooth meshes", "mesh cycles", {}},
      {"Operation", "most tooth meshes", "maximum mesh cycles", {}},
      {"Operation",
       "hub",
       "bore rotation",
       {{"rigid hub", "rigid"}, {"free rotation", "per node"}}},
      {"Operation", "allowed contact pressure", "contact stress limit", {}},
      {"Dynamics", "start", "start", {{"steady swing", "steady torsional vibration"}}},
      {"Fillets", "teeth", "teeth", {{"in mesh", "in contact"}}},
      {"Lumped", "arm", "lever arm", {}},
      {"Dynamics", "damping", "mass proportional damping", {}},
      {"Dynamics", "mesh damping", "driven speed damping", {}},
      {"Dynamics", "damping rate", "damping reference", {}},
      {"Dynamics", "step bound", "time step estimate", {{"assembly", "global"}}},
      {"Dynamics", "safety", "time step factor", {}},
      {"Dynamics",
       "stiffness",
       "element type",
       {{"full", "full integration"}, {"one point", "reduced integration"}}},
      {"Dynamics", "frame", "corotational frame", {}},
      {"Dynamics", "largest number of steps", "maximum number of steps", {}},
      {"Dynamics/Relaxation", "largest number of steps", "maximum number of steps", {}},
      {"Dynamics", "largest added mass", "maximum added mass", {}},
      {"Dynamics", "start", "start", {{"static preload", "static equilibrium"}}},
      {"Fem", "element", "element type", {{"full", "full integration"}}},
      {"Fem", "largest nodal diameter", "maximum nodal diameter", {}},
      {"Fem", "mesh orders", "mesh harmonics", {}},
      {"Contact", "discretization", "discretization", {{"surface points", "Gauss points"}}},
      {"Model/Contact *", "discretization", "discretization", {{"surface points", "Gauss points"}}},
      {"Contact", "search skin", "search tolerance", {}},
      {"Model/Contact *", "search skin", "search tolerance", {}},
      {"Contact", "depth limit", "contact depth limit", {}},
      {"Model/Contact *", "depth limit", "contact depth limit", {}},
      {"Contact", "penetration limit", "abort penetration ratio", {}},
      {"Model/Contact *", "penetration limit", "abort penetration ratio", {}},
      {"Gear pair/Errors/*/Concave flank", "pressure angle", "profile slope", {}},
      {"Gear pair/Errors/*/Convex flank", "pressure angle", "profile slope", {}},
      {"Gear pair/Errors/*/Concave flank", "spiral angle", "lengthwise slope", {}},
      {"Gear pair/Errors/*/Convex flank", "spiral angle", "lengthwise slope", {}},
      {"Gear pair/Errors/*", "eccentricity", "radial runout amplitude", {}},
      {"Gear pair/Errors/*", "eccentricity direction", "radial runout direction", {}},
      {"Gear pair/Errors/*", "wobble", "axial runout amplitude", {}},
      {"Gear pair/Errors/*", "wobble direction", "axial runout direction", {}},
      {"Gear pair/Proposal", "lag at half a pitch", "transmission error at half pitch", {}},
      {"Gear pair/Proposal", "path angle", "path direction", {}},
      {"Gear pair/Proposal", "ellipse length", "contact ellipse ratio", {}},
      {"Gear pair/*/Body", "web", "body type", {{"none", "rim only"}, {"conical", "conical web"}}},
      {"Gear pair/*/Body", "web angle", "web inclination", {}},
      {"Gear pair/*/Body", "web direction", "web direction", {{"as it fits", "auto"}}},
      {"Gear pair/*/Mesh", "cells lengthwise", "elements along face width", {}},
      {"Gear pair/*/Mesh", "cells across tooth", "elements across tooth", {}},
      {"Gear pair/*/Mesh", "flank rows", "elements along profile", {}},
      {"Gear pair/*/Mesh", "rim rows", "elements through rim", {}},
      {"Gear pair/*/Mesh", "web layers", "elements through web", {}},
      {"Gear pair/*/Mesh", "web rows", "elements along web", {}},
      {"Gear pair/*/Mesh", "fillet rows", "elements along web fillet", {}},
      {"Gear pair/*/Mesh", "hub rows", "elements through hub", {}},
      {"Gear pair/*/Mesh", "hub side cells", "elements beside web", {}},
      {"Gear pair/*/Shaft", "axial cell size", "axial element size", {}},
      {"Model/Body *", "axial cell size", "axial element size", {}},
      {"Gear pair/*/Shaft", "radial cell size", "radial element size", {}},
      {"Model/Body *", "radial cell size", "radial element size", {}},
      {"Model/Body *", "cells x", "elements x", {}},
      {"Model/Body *", "cells y", "elements y", {}},
      {"Model/Body *", "cells z", "elements z", {}},
      {"Model/Body *", "core cells", "core elements", {}},
      {"Model/Body *", "radial cells", "radial elements", {}},
      {"Model/Body *", "axial cells", "axial elements", {}},
      {"Model/Body *", "cells around", "elements around", {}},
      {"Model/Body *", "cells along length", "elements along length", {}},
      {"Model/Body *", "cells across width", "elements across width", {}},
      {"Model/Body *", "cells over height", "elements over height", {}},
      {"Model/Body *", "bearing", "rotating", {}},
      {"Model/Body *", "speed", "rotational speed", {}},
      {"Gear pair/*/Shaft/Bearing *", "holds", "axial load direction", {}},
      {"Model/Constraint *", "holds", "axial load direction", {}},
      {"Waves", "diameters", "nodal diameters", {}},
      {"Waves", "wave orders", "modes per diameter", {}},
      {"Waves", "driven", "simulate response", {}},
      {"Waves", "offsets", "speed offsets", {}},
      {"Waves", "decay times", "settling decay times", {}},
      {"Reduced", "counted meshes", "recorded mesh cycles", {}},
      {"Reduced", "settling meshes", "settling mesh cycles", {}},
      {"Reduced", "steps per mesh", "steps per mesh cycle", {}},
      {"Reduced", "reach", "residual flexibility reach", {}},
      {"Lumped", "mesh", "mesh stiffness source", {}},
      {"Lumped", "measured meshes", "recorded mesh cycles", {}},
      {"Lumped", "settling meshes", "settling mesh cycles", {}},
      {"Lumped", "samples", "samples per mesh cycle", {}},
      {"Lumped", "speed damping", "driven speed damping", {}},
      {"Loaded contact", "first tooth mesh", "first position", {}},
      {"Tooth contact analysis", "tooth meshes", "mesh cycles", {}},
      {"Tooth contact analysis", "driving member", "Operation/driving member", {}},
      {"Tooth contact analysis", "direction of rotation", "Operation/direction of rotation", {}},
      {"Sweep", "beside", "reference folders", {}},
      {"Sweep", "error by", "numerical parameters", {}},
      {"Sweep", "combination", "combination", {{"product", "grid"}}},
      {"Sweep/Parameter *", "sizes", "relative element sizes", {}},
      {"Compare", "slow", "quasi-static speed limit", {}},
      {"Linear static/Adaptive refinement", "most steps", "maximum steps", {}}};

    const std::map<std::string, std::string> removed_entries = {
      {"penalty from step", "remove it: penalty is auto, or a number of N/mm^3"},
      {"penalty fraction", "remove it: penalty is auto, or a number of N/mm^3"},
      {"regularization velocity", "remove it: friction sticks elastically"}};

    bool is_section(const std::string &section, const std::string &pattern)
    {
      if (pattern == "*" || pattern == section)
        return true;
      const std::size_t n = pattern.size() - 1;
      return pattern.size() > 2 && pattern.compare(n - 1, 2, " *") == 0 &&
             section.compare(0, n, pattern, 0, n) == 0;
    }

    bool is_in(const std::vector<std::string> &sections, const std::string &pattern)
    {
      std::istringstream text(pattern);
      std::string        part;
      std::size_t        i = 0;
      for (; std::getline(text, part, '/'); ++i)
        if (i == sections.size() || !is_section(sections[i], part))
          return false;
      return i == sections.size();
    }

    std::string file_of(const ParameterStatement &statement)
    {
      return statement.from_command_line ? ""
                                         : statement.place.substr(0, statement.place.rfind(':'));
    }

    /** Throws where the file of the renamed @p statement has the entry by its present name too. */
    void refuse_both_names(const std::string                     &former,
                           const ParameterStatement              &statement,
                           const std::vector<ParameterStatement> &statements)
    {
      for (const ParameterStatement &other : statements)
        if (&other != &statement && other.path() == statement.path() && !file_of(other).empty() &&
            file_of(other) == file_of(statement))
          throw InputError(statement.place + ": \"" + former + "\" is the former name of \"" +
                           statement.name + "\", which is set in " + other.place);
    }

    const FormerName *find_former(const ParameterStatement &statement, const CaseKind kind)
    {
      for (const FormerName &former : former_names)
        if (former.name == statement.name &&
            (former.only == CaseKind::any || former.only == kind) &&
            is_in(statement.sections, former.sections))
          return &former;
      return nullptr;
    }
  } // namespace

  std::vector<std::string> replace_former_names(std::vector<ParameterStatement> &statements)
  {
    const auto contains = [&statements](const std::string &section) {
      return std::any_of(statements.begin(),
                         statements.end(),
                         [&section](const ParameterStatement &statement) {
                           return statement.top_section() == section;
                         });
    };
    const CaseKind           kind = describes_model(contains) ? CaseKind::model : CaseKind::pair;
    std::vector<std::string> replaced;
    for (ParameterStatement &statement : statements)
      {
        const FormerName *const former =
          statement.opens_section ? nullptr : find_former(statement, kind);
        if (former == nullptr)
          continue;
        const auto        word    = former->words.find(statement.value);
        const bool        renamed = former->present_name != statement.name;
        const std::string before =
          renamed ? statement.name : statement.name + " = " + statement.value;
        if (!renamed && word == former->words.end())
          continue;
        const std::size_t slash = former->present_name.find('/');
        if (slash != std::string::npos)
          statement.sections = {former->present_name.substr(0, slash)};
        statement.name = former->present_name.substr(slash + 1); // npos + 1 is 0
        if (renamed)
          refuse_both_names(former->name, statement, statements);
        if (word != former->words.end())
          statement.value = word->second;
        replaced.push_back(statement.place + ": \"" + before + "\" is now \"" +
                           former->present_name +
                           (word != former->words.end() ? " = " + statement.value : "") + "\"");
      }
    return replaced;
  }

  std::string find_instead_of(const std::string &name)
  {
    const auto found = removed_entries.find(name);
    return found == removed_entries.end() ? "" : found->second;
  }
} // namespace vfife
