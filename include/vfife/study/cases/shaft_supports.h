// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_cases_shaft_supports_h
#define vfife_study_cases_shaft_supports_h

#include <vfife/base/parameter_handler.h>
#include <vfife/model/options/bearing_options.h>

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  struct Model;
  struct ShaftSection;

  /** A part of a shaft's surface, from one place along the axis to another (body frame) [mm]. */
  struct ShaftRing
  {
    double from = 0, to = 0;

    void declare(dealii::ParameterHandler &prm, const std::string &what);
  };

  /** What holds, drives and loads the shaft of a gear body: bearings, and the end where the machine
   * acts. */
  class ShaftSupports
  {
  public:
    /** The entries of the section Shaft that say which sections it has, then what these are: passes
     * before declare(). */
    void declare_bearing_names(dealii::ParameterHandler &prm);
    void declare_kinds(dealii::ParameterHandler &prm);
    /** Everything, in the section Shaft entered. Bound by address. */
    void declare(dealii::ParameterHandler &prm);

    /** Throws InputError (entries under @p section) for seats that do not lie on one of the @p
     * sections of the shaft, and for laws that contradict themselves. Without sections there may be
     * no bearings. */
    void check(const std::string &section, const std::vector<ShaftSection> &sections) const;

    /** Places along the axis at which rings begin and end. */
    std::vector<double> levels() const;

    /**
     * Adds the bearings of body @p body, which is on its shaft, and what acts at the shaft's end:
     * the coupling of a driver, or the torque @p value about the axis on a driven body [N mm].
     */
    void add_driver(Model                           &model,
                    unsigned int                     body,
                    const std::string               &section,
                    const std::vector<ShaftSection> &sections) const;
    void add_driven(Model                           &model,
                    unsigned int                     body,
                    const std::string               &section,
                    const std::vector<ShaftSection> &sections,
                    double                           value) const;

  private:
    struct Seat
    {
      bool              rolls = false;
      ShaftRing         ring;
      AnyBearingOptions law;

      void declare_kind(dealii::ParameterHandler &prm);
    };
    static std::string section_of(const std::string &section, const std::string &bearing);
    void               add_bearings(Model                           &model,
                                    unsigned int                     body,
                                    const std::string               &section,
                                    const std::vector<ShaftSection> &sections) const;

    std::vector<std::string>                  names_;
    std::vector<std::pair<std::string, Seat>> seats_;
    ShaftRing                                 end_;
    CouplingOptions                           coupling_;
  };
} // namespace vfife

#endif
