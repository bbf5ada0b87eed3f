// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_model_sections_h
#define vfife_tests_model_sections_h

#include <array>
#include <sstream>
#include <string>

/** Parts of a section Model, as a user writes them. Entries @p more end with a line's end. */
namespace model_text
{
  using Sizes  = std::array<double, 3>;
  using Counts = std::array<unsigned int, 3>;

  inline std::string section(const std::string &title, const std::string &entries)
  {
    return "subsection " + title + "\n" + entries + "end\n";
  }

  /** From the origin: [mm] and cells along x, y and z. */
  inline std::string block(const std::string &name,
                           const Sizes       &size,
                           const Counts      &cells,
                           const std::string &more = "")
  {
    std::ostringstream text;
    text << "set mesh = block\n";
    for (unsigned int d = 0; d < 3; ++d)
      text << "set size "
           << "xyz"[d] << " = " << size[d] << " mm\n";
    for (unsigned int d = 0; d < 3; ++d)
      text << "set cells "
           << "xyz"[d] << " = " << cells[d] << "\n";
    return section("Body " + name, text.str() + more);
  }

  /** Inner and outer radius and height [mm]; cells along the radius, around and along the axis. */
  inline std::string ring(const std::string &name,
                          const Sizes       &size,
                          const Counts      &cells,
                          const std::string &more = "")
  {
    std::ostringstream text;
    text << "set mesh = ring\nset inner radius = " << size[0]
         << " mm\nset outer radius = " << size[1] << " mm\nset height = " << size[2]
         << " mm\nset radial elements = " << cells[0] << "\nset elements around = " << cells[1]
         << "\nset axial elements = " << cells[2] << "\n";
    return section("Body " + name, text.str() + more);
  }

  /** At the node next to "x, y, z" [mm], along "x, y, z" or "r, theta, z". */
  inline std::string
  probe(const std::string &name, const std::string &point, const std::string &axes = "x, y, z")
  {
    return section("Probe " + name, "set point = " + point + "\nset axes = " + axes + "\n");
  }
} // namespace model_text

/** A section Output that writes its histories every so many steps and nothing else. */
inline std::string quiet_output(const unsigned int history_every)
{
  return "subsection Output\n set steps per sample = " + std::to_string(history_every) +
         "\n set report = no\n set checkpoint interval = 0\n set verbosity = quiet\nend\n";
}

#endif
