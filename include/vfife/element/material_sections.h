// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_element_material_sections_h
#define vfife_element_material_sections_h

#include <vfife/element/material.h>

#include <string>
#include <vector>

namespace vfife
{
  class ParameterFile;

  /** The sections "Material NAME" that bodies name. */
  class MaterialSections
  {
  public:
    /** One section for each of @p names, which may repeat. Entries are bound by address: the object
     * must stay until the file is read. */
    void declare(dealii::ParameterHandler       &prm,
                 const ParameterFile            &file,
                 const std::vector<std::string> &names);

    /** Throws InputError when a value is not possible. */
    void check() const;

    /** The material that @p entry names. Throws InputError where the file has no such section;
     * the default material needs none. */
    const Material &find(const std::string &name, const std::string &entry) const;

  private:
    std::vector<Material>    materials_;
    std::vector<std::string> allowed_; ///< names that may be given
  };
} // namespace vfife

#endif
