// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/expression.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/number_text.h>
#include <vfife/element/material_sections.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/model/body.h>
#include <vfife/model/options/body_materials.h>

#include <boost/algorithm/string/predicate.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>
#include <utility>

namespace vfife
{
  namespace
  {
    const char *const region_entry = "/region materials", *const temperature_entry = "/temperature";

    /** Elements are linear elastic: beyond this a temperature is hardly meant. */
    constexpr double largest_initial_strain = 0.1;

    /** "REGION: MATERIAL" at its last colon; a part is empty where it is missing. */
    std::pair<std::string, std::string> split_region_material(const std::string &pair)
    {
      const std::size_t colon = std::min(pair.rfind(':'), pair.size());
      return {trimmed(pair.substr(0, colon)),
              trimmed(pair.substr(std::min(colon + 1, pair.size())))};
    }

    /** "40 * x" of "40 * x K". */
    std::string without_kelvin(const std::string &formula)
    {
      return boost::ends_with(formula, " K") ? formula.substr(0, formula.size() - 2) : formula;
    }
  } // namespace

  void BodyMaterials::declare(dealii::ParameterHandler &prm, const std::string &regions)
  {
    declare_text(prm, "material", material, "Name of a section \"Material NAME\"");
    declare_names(prm,
                  "region materials",
                  of_regions,
                  "Materials of single regions (" + regions +
                    "), as REGION: MATERIAL, separated by commas; MATERIAL names a section "
                    "\"Material NAME\"; other regions have the body's material");
    declare_text(prm,
                 "temperature",
                 temperature,
                 "Temperature above the stress-free temperature: formula of x, y, z [mm] in "
                 "the undeformed body frame, evaluated at each element's centre [K]");
  }

  void BodyMaterials::check(const std::string &section, const std::string &region_of_body) const
  {
    if (has_word(temperature, "t"))
      throw InputError(section + temperature_entry,
                       "expected a formula of x, y, z, got t in \"" + temperature +
                         "\". A temperature does not depend on time. Remove t.");
    for (const std::string &pair : of_regions)
      {
        const auto [region, name] = split_region_material(pair);
        if (region.empty() || name.empty())
          throw InputError(section + region_entry,
                           "expected REGION: MATERIAL, got \"" + pair + "\"");
        if (region == region_of_body)
          throw InputError(section + region_entry,
                           "the material of the " + region +
                             " is the entry material. Set it there");
      }
  }

  std::vector<std::string> BodyMaterials::names() const
  {
    std::vector<std::string> names = {material};
    for (const std::string &pair : of_regions)
      {
        const std::string name = split_region_material(pair).second;
        if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end())
          names.push_back(name);
      }
    return names;
  }

  std::vector<Material> BodyMaterials::find(const MaterialSections &sections,
                                            const std::string      &section) const
  {
    std::vector<Material> materials;
    for (const std::string &name : names())
      materials.push_back(
        sections.find(name, section + (name == material ? "/material" : region_entry)));
    return materials;
  }

  void BodyMaterials::assign(BodyMesh &mesh, const std::string &section) const
  {
    if (of_regions.empty())
      return;
    const std::string                    entry = section + region_entry;
    const std::vector<std::string>       names = this->names();
    std::map<unsigned int, std::uint8_t> of_region;
    for (const std::string &pair : of_regions)
      {
        const auto [region, name] = split_region_material(pair);
        std::vector<std::string> known;
        bool                     found = false;
        for (const auto &[id, other] : mesh.regions)
          {
            known.push_back(other);
            if (mesh.names_without_case ? !boost::iequals(other, region) : other != region)
              continue;
            found = true;
            if (!of_region.emplace(id, std::find(names.begin(), names.end(), name) - names.begin())
                   .second)
              throw InputError(entry, "region \"" + region + "\" has two materials");
          }
        if (!found)
          throw InputError(entry,
                           "expected a region of the mesh, got \"" + region + "\"" +
                             did_you_mean(region, known) + "; the mesh has " +
                             list_of(known, true));
      }
    std::vector<std::uint8_t> materials;
    std::set<unsigned int>    empty; // regions that the mesh could have, such as a web
    for (const auto &region : of_region)
      empty.insert(region.first);
    for (const auto &cell : mesh.triangulation.active_cell_iterators())
      {
        const auto found = of_region.find(cell->material_id());
        materials.push_back(found == of_region.end() ? 0 : found->second);
        empty.erase(cell->material_id());
      }
    for (const auto &[id, region] : mesh.regions)
      if (empty.count(id) != 0)
        throw InputError(entry,
                         "expected a region with elements, got \"" + region +
                           "\", which has none in this body. Remove it.");
    mesh.structure.set_materials(std::move(materials));
  }

  void BodyMaterials::give_temperature(Body &body, const std::string &section) const
  {
    const std::string entry = section + temperature_entry;
    if (temperature == "0")
      return;
    for_entry(entry, [&] {
      const Expression    formula(without_kelvin(temperature), entry);
      std::vector<double> strains;
      for (unsigned int e = 0; e < body.n_elements(); ++e)
        {
          const double rise = formula(compute_centroid(body.element_nodes(e)), 0.);
          strains.push_back(body.material(e).expansion * rise);
          if (!(std::abs(strains.back()) < largest_initial_strain))
            throw InputError(entry,
                             "expected a temperature that expands the material by less than " +
                               number_text(100. * largest_initial_strain) + " %, got " +
                               number_text(rise) + " K at element " + std::to_string(e));
        }
      if (std::any_of(strains.begin(), strains.end(), [](const double s) { return s != 0.; }))
        body.add_initial_strains(strains);
    });
  }
} // namespace vfife
