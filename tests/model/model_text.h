// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_tests_model_model_text_h
#define vfife_tests_model_model_text_h

#include "../model_sections.h"
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/parameters/parameter_file.h>
#include <vfife/model/options/model_options.h>

#include <deal.II/base/parameter_handler.h>

#include <fstream>

/** The model of a parameter file with this text; InputError with place and entry. */
inline vfife::Model make_model(const std::string &text)
{
  std::ofstream("case.prm") << text;
  const vfife::ParameterFile file("case.prm");
  vfife::ModelOptions        options;
  dealii::ParameterHandler   prm;
  options.declare(prm, file);
  file.read(prm);
  try
    {
      options.check();
      return options.make_model();
    }
  catch (const vfife::InputError &error)
    {
      throw vfife::InputError(file.explain(error));
    }
}

/** Prints what a user reads. */
inline void refuse(const std::string &text)
{
  print_refusal([&] { make_model(text); });
}

/** A section Model of a bar of 10 x 4 x 2 cells of 1 mm and a ring in a bearing, with @p parts (one
 * a line: "constraints foot") named and their sections behind. */
inline std::string bar_and_ring(const std::string &names, const std::string &sections)
{
  return "subsection Model\n  set bodies = bar, ring\n" + names + "\n" +
         model_text::block("bar", {{10, 4, 2}}, {{10, 4, 2}}) +
         model_text::ring("ring",
                          {{20, 30, 5}},
                          {{2, 24, 1}},
                          "set rotating = yes\nset rotational speed = 100 rad/s\n") +
         sections + "end\n";
}

#endif
