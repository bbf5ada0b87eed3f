// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/study/compare/comparison.h>

#include <nlohmann/json.hpp>

#include <cmath>

namespace vfife
{
  namespace
  {
    /** Numbers that are not finite are written as null. */
    Json number(const double value)
    {
      return std::isfinite(value) ? Json(value) : Json();
    }
  } // namespace

  double ComparisonRow::difference() const
  {
    return value - reference;
  }

  std::string ComparisonRow::verdict() const
  {
    // |value - reference| <= tolerance; comparisons with NaN would say "differs".
    if (!tolerance || !std::isfinite(difference()))
      return "not judged";
    return std::abs(difference()) <= *tolerance ? "agrees" : "differs";
  }

  Json comparison_json(const std::string              &title,
                       const ComparedCases            &cases,
                       const std::vector<std::string> &remarks,
                       const ComparisonRows           &rows)
  {
    Json list = Json::array();
    for (const ComparisonRow &row : rows)
      list.push_back({{"quantity", row.quantity},
                      {"unit", row.unit},
                      {"value", number(row.value)},
                      {"reference", number(row.reference)},
                      {"reference kind", row.reference_kind},
                      {"difference", number(row.difference())},
                      {"tolerance", row.tolerance ? number(*row.tolerance) : Json()},
                      {"verdict", row.verdict()},
                      {"reason", row.reason}});
    Json compared = Json::array();
    for (const ComparedCase &one : cases)
      compared.push_back({{"name", one.name}, {"kind", one.kind}, {"folder", one.folder}});
    return {{"title", title}, {"cases", compared}, {"remarks", remarks}, {"rows", list}};
  }

  Table comparison_table(const ComparisonRows &rows)
  {
    Table table{{"quantity"}, {"unit"}};
    // Rows differ in their unit: it is a cell of its own, and the columns' unit says so.
    table.add_column("value", "unit");
    table.add_column("reference", "unit");
    table.add_text_column("reference kind");
    table.add_column("difference", "unit");
    table.add_column("tolerance", "unit");
    table.add_text_column("verdict");
    table.add_text_column("reason");
    for (const ComparisonRow &row : rows)
      table.add_row({row.quantity,
                     row.unit,
                     row.value,
                     row.reference,
                     row.reference_kind,
                     row.difference(),
                     row.tolerance.value_or(not_known),
                     row.verdict(),
                     row.reason});
    return table;
  }

  void ComparisonTolerances::declare(dealii::ParameterHandler &prm)
  {
    const auto fraction = [&prm](const char *name, double &value, const char *meaning) {
      declare_number(prm, name, value, meaning, Range::not_negative());
    };
    fraction("frequency tolerance",
             frequency,
             "Tolerance of frequencies, relative to the reference");
    fraction("transmission error tolerance",
             error,
             "Tolerance of transmission errors of a slow pair, relative to the static mean");
    fraction("force tolerance",
             force,
             "Tolerance of contact forces and torques, relative to the reference");
    fraction("displacement tolerance",
             displacement,
             "Tolerance of static displacements at probes, relative to the reference");
    fraction("stress tolerance",
             stress,
             "Tolerance of static stresses at probes, relative to the reference");
    fraction("reduced transmission error tolerance",
             reduced_error,
             "Tolerance of the mean transmission error against the reduced pair, relative "
             "to the latter");
    fraction("reduced ripple tolerance",
             reduced_ripple,
             "Tolerance of curves over the mesh cycle against the reduced pair, relative "
             "to their peak to peak");
    fraction("reduced order tolerance",
             reduced_order,
             "Tolerance of mesh order amplitudes against the reduced pair, relative to the latter");
    declare_quantity(prm,
                     "quasi-static speed limit",
                     slow,
                     "rpm",
                     "Pinion speed up to which a run is compared with the static pair",
                     Range::not_negative());
  }
} // namespace vfife
