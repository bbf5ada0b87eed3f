// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/command_line.h>
#include <vfife/base/types.h>

#include <iostream>

/** Uses a header and the library of an installed vfife. */
int main()
{
  const vfife::Vector3 x =
    vfife::rotation_about(vfife::Vector3::UnitZ(), vfife::pi / 2.) * vfife::Vector3::UnitX();
  std::cout << vfife::version_text();
  return (x - vfife::Vector3::UnitY()).norm() < 1e-15 ? 0 : 1;
}
