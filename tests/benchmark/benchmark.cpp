// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Speed of the explicit operator, of the contact and of messages for a gear pair
// (doc/developer/performance.md): benchmark FILE.prm [measurements of each variant, 7].
#include "../study/gear_model.h"
#include "contact_cost.h"
#include "operator_cost.h"
#include "step_on_ranks.h"

#include <vfife/base/process/failure.h>
#include <vfife/base/process/mpi_session.h>
#include <vfife/mesh/primitives/primitives.h>

#include <cmath>
#include <cstdlib>
#include <iostream>

using namespace vfife;

namespace
{
  constexpr unsigned int n_steps          = 3;     ///< of one measurement
  constexpr unsigned int n_plain_elements = 20000; ///< of the plain implementation, 5 kB each

  /** A block of @p cells^3 elements that all differ: each node is moved by up to a tenth of a side,
   * by numbers that never repeat. */
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

  /** Variants of the operator on the pair and on a general mesh of the same size, measured by each
   * rank alone: ranks share the memory of the machine. */
  Table measure_operators(const Model &pair, const unsigned int repeats, Log &log)
  {
    const Communicator alone(MPI_COMM_SELF);
    const Model        general =
      make_general_model(static_cast<unsigned int>(std::round(std::cbrt(pair.n_elements()))));
    const unsigned int  n     = n_plain_elements;
    const StiffnessKind modes = StiffnessKind::incompatible_modes, full = StiffnessKind::full,
                        one_point = StiffnessKind::one_point;
    const PlainElements plain_modes(pair.bodies.back(), modes, n),
      plain_full(pair.bodies.back(), full, n), plain_one(pair.bodies.back(), one_point, n),
      plain_general(general.bodies.back(), modes, n);

    // Constants shared by congruent elements, of each element, and those with hourglass blocks in
    // single precision. Own constants cost the same on each mesh except for the order of nodes, so
    // some combinations suffice.
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
    return compare_operators(cases, repeats, n_steps);
  }

  void print(const std::string &title, const Table &table, Log &log)
  {
    std::ostringstream rows;
    table.write_csv(rows);
    log.line("\n", title, "\n", rows.str());
  }

  void measure(const std::string &file, const unsigned int repeats, const Communicator &world)
  {
    Log         log(std::cout, world.is_root());
    const Model pair      = make_gear_model(file, world);
    const Table operators = measure_operators(pair, repeats, log);
    print("operator", operators, log);
    const Table contact = measure_contact_cost(pair, repeats, Communicator(MPI_COMM_SELF), log);
    print("contact", contact, log);
    print("messages between the first two ranks", measure_messages(world), log);
    print("step on many ranks, estimated",
          estimate_steps(pair, find_core_times(operators, contact)),
          log);
  }
} // namespace

int main(int argc, char **argv)
{
  const unsigned int repeats = argc > 2 ? std::strtoul(argv[2], nullptr, 10) : 7;
  if (argc < 2 || repeats == 0)
    {
      std::cerr << "usage: benchmark FILE.prm [measurements of each variant, 7]" << std::endl;
      return 1;
    }
  MpiSession session(argc, argv);
  Failure    failure;
  try
    {
      measure(argv[1], repeats, session.world());
    }
  catch (...)
    {
      failure = describe_failure(std::current_exception());
    }
  return session.finish(failure);
}
