// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_options_contact_pair_options_h
#define vfife_model_options_contact_pair_options_h

#include <vfife/model/model.h>
#include <vfife/model/node_selection.h>

namespace vfife
{
  /** Section Contact NAME: two bodies, or a body and a rigid wall. */
  struct ContactPairOptions
  {
    enum class Kind
    {
      bodies,
      wall
    };

    ContactPairOptions();

    Kind kind = Kind::bodies;

    std::string    slave_body, slave_surface, master_body, master_surface;
    ContactOptions contact;

    NodeSelection selection; ///< that a wall holds back
    RigidWall     wall;

    void declare_kind(dealii::ParameterHandler &prm);
    /** Declares the entries of the kind. Bound by address. */
    void declare(dealii::ParameterHandler &prm);
    void check(const std::string &section) const;
    void add_to(Model &model, const std::string &name, const std::string &section) const;
  };
} // namespace vfife

#endif
