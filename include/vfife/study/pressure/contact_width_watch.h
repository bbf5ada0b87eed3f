// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_pressure_contact_width_watch_h
#define vfife_study_pressure_contact_width_watch_h

#include <vfife/model/observer.h>
#include <vfife/model/state.h>

#include <vector>

namespace vfife
{
  class Log;
  class OutputFolder;
  struct Model;

  /** Looks how wide the contacts of a general model are at their largest force. Where facets are so
   * wide that the approach is off by more than 3 % (find_approach_error()), it warns at the end
   * with the size of the error. Contacts that fill a whole surface have any width. */
  class ContactWidthWatch : public Observer
  {
  public:
    /** Looks every @p steps_between steps; made as all observers of a run, of its folder. */
    ContactWidthWatch(const OutputFolder &folder,
                      const Model        &model,
                      std::uint64_t       steps_between,
                      Log                &log);

    bool        due(const State &state) const override;
    void        observe(const Model &model, const State &state) override;
    std::string part_name() const override;
    void        serialize(ByteStream &stream) override;
    void        finish(const Model &model, const State &state) override;

  private:
    struct Contact
    {
      double force = 0, area = 0, width = 0; ///< [N], [mm^2], [mm]
    };

    std::uint64_t        steps_between_;
    Log                 &log_;
    std::vector<Contact> largest_; ///< each at its largest normal force
    /** Widths of their facets [mm]; 0 after a restart, which knows the mean of the slave's alone.
     */
    std::vector<double> facets_;
  };
} // namespace vfife

#endif
