// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_options_load_options_h
#define vfife_model_options_load_options_h

#include <vfife/model/model.h>
#include <vfife/model/node_selection.h>

namespace vfife
{
  /** Section Load NAME. */
  struct LoadOptions
  {
    LoadKind         kind = LoadKind::force;
    NodeSelection    selection;
    Vector3          vector   = Vector3::Zero(); ///< force, moment or acceleration
    double           pressure = 0;               ///< [MPa]
    ParameterHistory history;

    void declare_kind(dealii::ParameterHandler &prm);
    /** Declares the entries of the kind. Bound by address. */
    void declare(dealii::ParameterHandler &prm);
    void add_to(Model &model, const std::string &name, const std::string &section) const;
  };
} // namespace vfife

#endif
