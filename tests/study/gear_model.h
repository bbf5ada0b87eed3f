// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_study_gear_model_h
#define vfife_tests_study_gear_model_h

#include <vfife/base/parameters/parameter_file.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/fem/fem_options.h>
#include <vfife/study/cases/gear/gear_case.h>

#include <deal.II/base/parameter_handler.h>

#include <fstream>
#include <sstream>
#include <string>

/** The model that studies make of the gear pair of a file; sections of studies are not read. */
inline vfife::Model make_gear_model(const std::string &path, const vfife::Communicator &world)
{
  const vfife::ParameterFile file(path);
  vfife::GearCase            gears;
  vfife::FemOptions          fem;
  file.read_known([&](dealii::ParameterHandler &prm) {
    gears.declare(prm, file);
    vfife::declare_section(prm, "Fem", fem);
  });
  std::ostringstream nothing;
  vfife::Log         log(nothing, world.is_root(), vfife::Verbosity::quiet);
  return gears.make_model(log);
}

/** The same as make_gear_model() of a file that is written with this @p text: by one rank, before
 * the others read it, and read by all before anyone writes it again. */
inline vfife::Model
make_gear_model(const std::string &path, const std::string &text, const vfife::Communicator &world)
{
  if (world.is_root())
    std::ofstream(path) << text;
  world.barrier();
  vfife::Model model = make_gear_model(path, world);
  world.barrier();
  return model;
}

#endif
