// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_study_gear_mesh_study_h
#define vfife_study_gear_mesh_study_h

#include <vfife/study/study_kind.h>

#include <memory>
#include <string>
#include <vector>

namespace vfife
{
  /** Section Export: which files a study of kind `mesh` writes. */
  struct ExportOptions
  {
    std::vector<std::string> formats    = {"vtu"};
    bool                     pair       = true; ///< both bodies in one file, mounted
    bool                     bodies     = true; ///< each body in its own frame
    unsigned int             lengthwise = 0;    ///< flank points from toe to heel; 0: no file
    unsigned int             profile    = 0;    ///< flank points from start to tip

    void declare(dealii::ParameterHandler &prm);
    void check(const std::string &section) const;
  };

  /** Study kind `mesh`: builds the bodies of a gear pair, reports their quality, mass and inertia
   * (mesh.csv, mesh.json) and exports them. Speed and torque are not needed. */
  std::unique_ptr<StudyKind> make_mesh_study();
} // namespace vfife

#endif
