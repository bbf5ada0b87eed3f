// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_options_model_options_h
#define vfife_model_options_model_options_h

#include <vfife/element/material_sections.h>
#include <vfife/model/options/body_options.h>
#include <vfife/model/options/constraint_options.h>
#include <vfife/model/options/contact_pair_options.h>
#include <vfife/model/options/load_options.h>

#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class Log;
  class ParameterFile;

  /** Section Probe NAME: the node nearest to a place. */
  struct ProbeOptions
  {
    NodeSelection selection;
    Vector3       point      = Vector3::Zero(); ///< undeformed body frame [mm]
    bool          fixed_axes = true;

    void declare(dealii::ParameterHandler &prm);
    void add_to(Model &model, const std::string &name, const std::string &section) const;
  };

  /**
   * Section Model, and the sections Material NAME that its bodies name: general models. The names
   * of bodies, constraints, loads, contacts and probes are read first, then what decides about
   * their entries (meshes, kinds), then everything strictly.
   */
  class ModelOptions
  {
  public:
    /** Declares all entries. Bound by address: the object must stay until the file is read. */
    void declare(dealii::ParameterHandler &prm, const ParameterFile &file);

    void check() const;

    /** Meshes the bodies and puts the model together; throws InputError. */
    Model make_model() const;

    /** Says of each probe of a @p model of make_model() whose point is no node's which node it is.
     */
    void log_probes(const Model &model, Log &log) const;

  private:
    /** Options by name; addresses do not change after the names are known. */
    template <typename Options>
    using Named = std::vector<std::pair<std::string, Options>>;

    void declare_names_of_parts(dealii::ParameterHandler &prm);
    void declare_kinds(dealii::ParameterHandler &prm);
    void declare_materials(dealii::ParameterHandler &prm, const ParameterFile &file);

    std::vector<std::string> body_names_, constraint_names_, load_names_, contact_names_,
      probe_names_;
    Named<BodyOptions>        bodies_;
    Named<ConstraintOptions>  constraints_;
    Named<LoadOptions>        loads_;
    Named<ContactPairOptions> contacts_;
    Named<ProbeOptions>       probes_;
    MaterialSections          materials_;
  };
} // namespace vfife

#endif
