// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/nearest_name.h>
#include <vfife/base/text/table.h>
#include <vfife/mesh/files/mesh_export.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/output/output_options.h>
#include <vfife/output/pictures.h>
#include <vfife/study/cases/body_figures.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/study_kinds.h>

#include <algorithm>

namespace vfife
{
  namespace
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
      /** Throws InputError where a format has one material per body, and a body has several. */
      void check_materials(const std::string &section, const Model &model) const;
    };

    ExportedBody exported(const Body &body)
    {
      // Mesh and material constants, in t and mm: what another program needs for the same body.
      ExportedBody result;
      result.name           = body.name();
      result.mesh           = &body.mesh();
      result.material       = body.materials().front().name;
      result.density        = body.materials().front().density;
      result.youngs_modulus = body.materials().front().youngs_modulus;
      result.poissons_ratio = body.materials().front().poissons_ratio;
      return result;
    }

    class MeshStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        pair_case_ = make_pair_case(file);
        pair_case_->declare(prm, file);
        export_.declare(prm);
        output_.declare(prm);
      }

      void check() const override
      {
        pair_case_->check_bodies();
        export_.check("Export");
        output_.check("Output");
      }

      void inspect(Communicator &, Log &log) override
      {
        export_.check_materials("Export", pair_case_->make_model(log));
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      void write_flank_points(const OutputFolder &folder) const;

      std::unique_ptr<PairCase> pair_case_;
      ExportOptions             export_;
      OutputOptions             output_;
    };
  } // namespace

  void ExportOptions::declare(dealii::ParameterHandler &prm)
  {
    const Subsection section(prm, "Export");
    declare_names(prm,
                  "formats",
                  formats,
                  "Formats of mesh files: " + list_of(export_formats()) + "; may be empty");
    declare_switch(prm, "pair", pair, "Both bodies in one file, mounted in the fixed frame");
    declare_switch(prm, "bodies", bodies, "One file per body, in its body frame");
    declare_integer(prm,
                    "flank points lengthwise",
                    lengthwise,
                    "Number of exact flank points from toe to heel in flank_points_BODY.csv; 0: "
                    "none",
                    0,
                    10000);
    declare_integer(prm,
                    "flank points profile",
                    profile,
                    "Number of exact flank points from the start of the flank to the tip",
                    0,
                    10000);
  }

  void ExportOptions::check(const std::string &section) const
  {
    const auto known = export_formats();
    for (const std::string &format : formats)
      if (std::find(known.begin(), known.end(), format) == known.end())
        throw InputError(section + "/formats",
                         "expected a format, got \"" + format + "\"; allowed: " + list_of(known) +
                           did_you_mean(format, known) + "; CalculiX and Abaqus read inp");
    if ((lengthwise != 0 || profile != 0) && (lengthwise < 2 || profile < 2))
      throw InputError(
        section + "/flank points lengthwise",
        "flank points need at least 2 lengthwise and 2 along the profile (or 0 and 0 for none)");
  }

  void ExportOptions::check_materials(const std::string &section, const Model &model) const
  {
    if (std::find(formats.begin(), formats.end(), "inp") == formats.end())
      return;
    for (const Body &body : model.bodies)
      if (body.materials().size() > 1)
        throw InputError(section + "/formats",
                         "expected vtu or msh for bodies of several materials, got inp, whose "
                         "files have one material per body");
  }

  void MeshStudy::run(OutputFolder &folder, Log &log)
  {
    log.set_verbosity(output_.verbosity);
    const Model model = pair_case_->make_model(log);
    export_.check_materials("Export", model);
    // All ranks have made the same meshes: one writes them. Nothing below is collective.
    if (!folder.is_writer())
      return;
    // The table of figures is written last: its file says that the study has come to its end.
    const Table figures = body_figures_table(pair_case_->measure_bodies(model));
    write_csv(folder, "meridian.csv", pair_case_->meridian_table());

    const auto write = [&](const std::string &name, const std::vector<ExportedBody> &bodies) {
      for (const std::string &format : export_.formats)
        {
          folder.write_file(name + "." + format,
                            [&](std::ostream &out) { write_meshes(out, format, bodies); });
          log.line("wrote ", folder.file(name + "." + format));
        }
    };
    std::vector<ExportedBody> pair;
    for (const Body &body : model.bodies)
      {
        if (export_.bodies)
          write(body.name(), {exported(body)});
        // In its own file a body lies in its body frame, in that of the pair it is mounted.
        pair.push_back(exported(body));
        pair.back().placement = body.placement;
      }
    if (export_.pair)
      write("pair", pair);

    if (export_.lengthwise > 0)
      write_flank_points(folder);
    write_tables(folder, "mesh", figures);
    if (output_.pictures)
      draw_pictures(folder, log);
  }

  void MeshStudy::write_flank_points(const OutputFolder &folder) const
  {
    // Points of the true flanks: what other meshes can be compared with.
    for (const unsigned int member : {0u, 1u})
      write_csv(folder,
                std::string("flank_points_") + (member == 0 ? "pinion" : "gear") + ".csv",
                pair_case_->flank_points(member, export_.lengthwise, export_.profile));
  }

  std::unique_ptr<StudyKind> make_mesh_study()
  {
    return std::make_unique<MeshStudy>();
  }
} // namespace vfife
