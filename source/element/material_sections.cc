// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/element/material_sections.h>

#include <algorithm>

namespace vfife
{
  namespace
  {
    std::string material_section(const std::string &name)
    {
      return "Material " + name;
    }

    bool is_among(const std::vector<std::string> &names, const std::string &name)
    {
      return std::find(names.begin(), names.end(), name) != names.end();
    }
  } // namespace

  void MaterialSections::declare(dealii::ParameterHandler       &prm,
                                 const ParameterFile            &file,
                                 const std::vector<std::string> &names)
  {
    materials_.clear();
    materials_.reserve(names.size()); // entries are bound by address
    allowed_ = {Material().name};
    std::vector<std::string> declared;
    for (const std::string &name : names)
      if (!is_among(declared, name))
        {
          declared.push_back(name);
          materials_.emplace_back();
          materials_.back().name = name;
          declare_section(prm, material_section(name), materials_.back());
          if (file.contains(material_section(name)) && !is_among(allowed_, name))
            allowed_.push_back(name);
        }
  }

  void MaterialSections::check() const
  {
    for (const Material &material : materials_)
      material.check(material_section(material.name));
  }

  const Material &MaterialSections::find(const std::string &name, const std::string &entry) const
  {
    if (is_among(allowed_, name))
      for (const Material &material : materials_)
        if (material.name == name)
          return material;
    throw InputError(entry,
                     "expected a material, got \"" + name + "\" without a section \"" +
                       material_section(name) + "\" (materials: " + list_of(allowed_) + ")" +
                       did_you_mean(name, allowed_));
  }
} // namespace vfife
