// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_edges_under_load_h
#define vfife_study_cases_edges_under_load_h

#include <vfife/base/text/json.h>
#include <vfife/output/files/figures.h>

#include <array>
#include <optional>
#include <string>

namespace vfife
{
  struct ContactAnalysis;
  class Log;
  class OutputFolder;
  class Table;

  /**
   * Tooth pairs that carry where their flanks do not touch without load: outside the path of
   * contact it is an edge that meets the other flank (doc/theory/contact.md, Edge contact). Hertz's
   * pressure holds inside the flanks only.
   */
  class EdgesUnderLoad
  {
  public:
    /** @p analysis of the drive side, which is loaded; the driver has @p driver_teeth, of which the
     * next one has the number before. */
    EdgesUnderLoad(const ContactAnalysis &analysis, unsigned int driver_teeth);

    /** Positions of the driver in [0, 1) of a pitch where a tooth pair has just left its path of
     * contact or is about to enter it: an edge has its largest force there. */
    std::array<double, 2> positions() const;

    /**
     * Looks at tooth pairs of the drive side: rows of teeth.csv or loaded_teeth.csv.
     * @param teeth    columns "side", "pinion tooth", "force" [N] and @p place
     * @param place    column that is in proportion to the driver's rotation, 0 where tooth pair 0
     *                 is at its mean contact
     * @param per_mesh what it is in a mesh cycle
     */
    void observe(const Table &teeth, const std::string &place, double per_mesh);

    /** Whether an edge has more than a hundredth of the largest force of a tooth pair. */
    bool found() const;

    /** One sentence for log and report. */
    std::string explain() const;

    /** For tables of several analyses. */
    NamedFigures list_figures() const;

    /** {"edge contact": , "explanation": , figures} */
    Json json() const;

  private:
    struct Border
    {
      std::string name;
      double      place = 0; ///< where the path ends [pitches]
      double      force = 0; ///< largest of a pair beyond it [N]
    };

    bool is_loaded(const Border &border) const;

    unsigned int          driver_teeth_;
    std::array<Border, 2> borders_; ///< at the start and at the end of the path
    double                largest_ = 0;
  };

  /**
   * Looks at tooth pairs in contact, as EdgesUnderLoad::observe(), and writes edge_contact.json and
   * a line of the log, a warning where edges are in contact; returns
   * EdgesUnderLoad::list_figures(). Without
   * @p edges nothing.
   */
  NamedFigures write_edge_contact(std::optional<EdgesUnderLoad> edges,
                                  const Table                  &teeth,
                                  const std::string            &place,
                                  double                        per_mesh,
                                  const OutputFolder           &folder,
                                  Log                          &log);
} // namespace vfife

#endif
