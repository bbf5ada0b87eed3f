// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_pictures_h
#define vfife_output_pictures_h

namespace vfife
{
  class Log;
  class OutputFolder;

  /**
   * Draws plots and pictures of the run whose results are in @p folder, into its subfolder
   * "pictures", and writes report.html, by make_report.py of share/vfife/report (in a build tree:
   * source/report). It is run by the first Python, of PATH and /usr/bin, that has numpy,
   * matplotlib, Jinja2 and meshio. Works on the writing rank only and waits for the script. Nothing
   * is thrown: where pictures cannot be drawn, a line of @p log says why.
   */
  void draw_pictures(const OutputFolder &folder, Log &log);
} // namespace vfife

#endif
