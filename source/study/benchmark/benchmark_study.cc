// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/parameters/parameters.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/mesh/body_mesh.h>
#include <vfife/mesh/mesh_size.h>
#include <vfife/mesh/primitives/primitives.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/table_writer.h>
#include <vfife/study/benchmark/contact_benchmark.h>
#include <vfife/study/benchmark/operator_benchmark.h>
#include <vfife/study/benchmark/rank_benchmark.h>
#include <vfife/study/cases/case_kinds.h>
#include <vfife/study/cases/pair_case.h>
#include <vfife/study/study_kinds.h>

#include <deal.II/base/parameter_handler.h>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <sstream>

namespace vfife
{
  namespace
  {
    struct BenchmarkOptions
    {
      unsigned int repeats = 7;  ///< measurements of each variant, medians are reported
      unsigned int steps   = 3;  ///< time steps a measurement
      unsigned int cells   = 52; ///< of the general mesh along each side
      unsigned int plain_elements =
        20000; ///< part of a mesh on which the plain implementation is measured

      void declare(dealii::ParameterHandler &prm);
    };

    /** A block of @p cells^3 elements of which no two are equal: every node is moved by up to a
     * tenth of a side, by numbers that never repeat. */
    std::unique_ptr<BodyMesh> make_general_mesh(const unsigned int cells)
    {
      const auto block = make_block(Vector3(cells, cells, cells), {{cells, cells, cells}});
      // Sines of multiples that have no common period: cells stay convex, and no two are congruent.
      double n = 0.;
      return make_moved(*block, "general mesh", [&n](const Vector3 &x) -> Vector3 {
        n += 1.;
        return x + 0.1 * Vector3(std::sin(1.7 * n), std::sin(2.3 * n + 1.), std::sin(3.1 * n + 2.));
      });
    }

    /** That block as a body that turns at 100 rad/s: damping and update then have all their
     * terms. */
    Model make_general_model(const unsigned int cells)
    {
      Model model;
      model.add_body(Body("general mesh", make_general_mesh(cells), Material()));
      model.bodies.front().turns_on_axis = true;
      model.bodies.front().rate          = 100.;
      return model;
    }

    /** Seconds of an element and step of the gear pair with incompatible modes in the polar frame,
     * by the fastest instruction set. */
    double find_element_time(const Table &table, const std::string &layout)
    {
      double rate = 0;
      for (std::size_t row = 0; row < table.n_rows(); ++row)
        if (const auto is =
              [&](const char *column, const std::string &word) {
                return table.column(column).texts[row] == word;
              };
            is("mesh", "gear pair") && is("layout", layout) && is("frame", "polar") &&
            is("stiffness", word_of(StiffnessKind::incompatible_modes, stiffness_choices())))
          rate = std::max(rate, table.numbers("element-steps")[row]);
      return 1e-6 / rate;
    }

    CoreTimes find_core_times(const Table &operators, const Table &contact)
    {
      CoreTimes core;
      core.shared = find_element_time(operators, "shared");
      core.own    = find_element_time(operators, "own");
      for (std::size_t row = 0; row < contact.n_rows(); ++row)
        {
          const std::string &part = contact.column("part").texts[row];
          const double       time = 1e-6 * contact.numbers("time")[row];
          if (part == "contact: broad search")
            core.contact_all += time;
          else if (part == "contact: wide search" || part == "contact: motion of the groups" ||
                   part == "contact: projection" || part == "contact: forces" ||
                   part == "contact: nodes to and fro")
            core.contact_shared += time;
        }
      return core;
    }

    /** The table as the files have it, in columns. */
    void log_table(const Table &table, Log &log)
    {
      log.line(table.csv_header());
      for (std::size_t row = 0; row < table.n_rows(); ++row)
        {
          std::ostringstream line;
          line << std::fixed << std::setprecision(1);
          for (const Table::Column &column : table.columns())
            if (column.is_text)
              line << std::left
                   << std::setw(column.name == "stiffness" ? 19
                                : column.name == "part"    ? 30
                                                           : 13)
                   << column.texts[row];
            else
              line << std::right << std::setw(8) << column.numbers[row];
          log.line(line.str());
        }
    }

    class BenchmarkStudy : public StudyKind
    {
    public:
      void declare(dealii::ParameterHandler &prm, const ParameterFile &file) override
      {
        pair_case_ = make_pair_case(file);
        pair_case_->declare(prm, file);
        benchmark_.declare(prm);
        contact_.declare(prm);
        ranks_.declare(prm);
      }

      void check() const override
      {
        pair_case_->check_bodies();
        check_mesh_size("Benchmark/cells", std::pow(benchmark_.cells, 3.));
      }

      void inspect(Communicator &, Log &log) override
      {
        pair_case_->make_model(log);
      }

      void run(OutputFolder &folder, Log &log) override;

    private:
      std::unique_ptr<PairCase> pair_case_;
      BenchmarkOptions          benchmark_;
      ContactBenchmarkOptions   contact_;
      RankBenchmarkOptions      ranks_;
    };
  } // namespace

  void BenchmarkOptions::declare(dealii::ParameterHandler &prm)
  {
    const Subsection section(prm, "Benchmark");
    declare_integer(prm,
                    "repeats",
                    repeats,
                    "Number of measurements of each variant; medians are reported",
                    1,
                    10000);
    declare_integer(prm, "steps", steps, "Time steps per measurement", 1);
    declare_integer(prm, "cells", cells, "Elements of the general mesh along each side", 2, 500);
    declare_integer(prm,
                    "plain elements",
                    plain_elements,
                    "Number of elements for the reference implementation (5 kB each)",
                    1,
                    10000000);
  }

  void ContactBenchmarkOptions::declare(dealii::ParameterHandler &prm)
  {
    const Subsection section(prm, "Benchmark");
    declare_quantity(prm,
                     "closing",
                     closing,
                     "mm",
                     "Penetration of the flanks in the contact measurement of the pair",
                     Range::positive());
    declare_integer(
      prm, "contact steps", steps, "Time steps per measurement of the pair's contact", 1);
  }

  void BenchmarkStudy::run(OutputFolder &folder, Log &log)
  {
    // Each rank measures alone; what the ranks share is the memory.
    const Communicator  alone(MPI_COMM_SELF);
    const Model         pair    = pair_case_->make_model(log);
    const Model         general = make_general_model(benchmark_.cells);
    const unsigned int  n       = benchmark_.plain_elements;
    const StiffnessKind modes = StiffnessKind::incompatible_modes, full = StiffnessKind::full,
                        one_point = StiffnessKind::one_point;
    const PlainElements plain_modes(pair.bodies.back(), modes, n),
      plain_full(pair.bodies.back(), full, n), plain_one(pair.bodies.back(), one_point, n),
      plain_general(general.bodies.back(), modes, n);

    // Constants shared by congruent elements, of each element, and those with hourglass blocks in
    // single precision. Own ones cost the same on every mesh but for the order of nodes, so not all
    // products are run.
    OperatorLayout shared, own, single;
    own.share_constants     = false;
    single                  = own;
    single.single_hourglass = true;

    std::vector<std::unique_ptr<BenchmarkCase>> cases;
    const auto                                  add = [&](const std::string    &mesh,
                         const Model          &model,
                         const StiffnessKind   stiffness,
                         const OperatorLayout &layout,
                         const PlainElements  &plain) {
      cases.push_back(
        std::make_unique<BenchmarkCase>(mesh, model, stiffness, layout, plain, alone));
      log.line(mesh, ", constants ", cases.back()->layout, ", ready");
    };
    add("gear pair", pair, modes, shared, plain_modes);
    add("gear pair", pair, full, shared, plain_full);
    add("gear pair", pair, one_point, shared, plain_one);
    add("gear pair", pair, modes, own, plain_modes);
    add("gear pair", pair, modes, single, plain_modes);
    add("general mesh", general, modes, own, plain_general);

    log.line("gear pair: ",
             pair.n_elements(),
             " elements, ",
             pair.n_nodes(),
             " nodes; general mesh: ",
             general.n_elements(),
             ", ",
             general.n_nodes());
    const Table table = compare_operators(cases, benchmark_.repeats, benchmark_.steps);
    log_table(table, log);
    // The memory of all variants is given back before the contact is measured.
    cases.clear();
    const Table cost = measure_contact_cost(pair, contact_, benchmark_.repeats, alone, log);
    log_table(cost, log);
    const Table messages = measure_messages(folder.communicator());
    log_table(messages, log);
    const Table ranks = reckon_ranks(pair, ranks_, find_core_times(table, cost));
    log_table(ranks, log);
    if (!folder.is_writer())
      return;
    write_tables(folder, "messages", messages);
    write_tables(folder, "ranks", ranks);
    write_tables(folder, "benchmark", table);
    write_tables(folder, "contact_cost", cost);
  }

  std::unique_ptr<StudyKind> make_benchmark_study()
  {
    return std::make_unique<BenchmarkStudy>();
  }
} // namespace vfife
