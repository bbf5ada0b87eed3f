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

  inline std::string study(const std::string &kind)
  {
    return section("Study", "set kind = " + kind + "\n");
  }

  /** Of a loaded tooth contact analysis, with @p more entries. */
  inline std::string loaded_contact(const unsigned int positions, const std::string &more = "")
  {
    return study("loaded tooth contact analysis") +
           section("Loaded contact", "set positions = " + std::to_string(positions) + "\n" + more);
  }

  /** A bar that is pulled does not contract. */
  inline std::string no_contraction()
  {
    return section("Material steel", "set Poisson's ratio = 0\n");
  }

  /** Section Dynamics with the tolerance of equilibria and @p more entries. */
  inline std::string relaxation(const std::string &tolerance, const std::string &more = "")
  {
    return section("Dynamics", more + section("Relaxation", "set tolerance = " + tolerance + "\n"));
  }

  /** Section Dynamics of a run that takes a step, with @p more entries. */
  inline std::string one_step(const std::string &more = "")
  {
    return section("Dynamics", "set end time = 1\nset maximum number of steps = 1\n" + more);
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

/** A section Output that says nothing on the screen. */
inline std::string quiet_output()
{
  return "subsection Output\n set verbosity = quiet\nend\n";
}

/** A section Output that writes its histories every so many steps and nothing else. */
inline std::string quiet_output(const unsigned int history_every)
{
  return "subsection Output\n set steps per sample = " + std::to_string(history_every) +
         "\n set report = no\n set checkpoint interval = 0\n set verbosity = quiet\nend\n";
}

#endif
