// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Vectors and operators as Anasazi sees them, by Anasazi's own tests; products of a sparse matrix.
#include "../ranks.h"
#include "../tests.h"

#include <vfife/fem/solvers/column_traits.h>
#include <vfife/fem/solvers/sparse_matrix.h>
#include <vfife/fem/system/system_matrices.h>
#include <vfife/mesh/primitives/primitives.h>

#include <AnasaziBasicOutputManager.hpp>
#include <AnasaziMVOPTester.hpp>

using namespace vfife;

void traits(const Communicator &communicator, const std::size_t n_rows, const SparseMatrix &K)
{
  const auto out    = Teuchos::rcp(new Anasazi::BasicOutputManager<double>(Anasazi::Warnings));
  const auto x      = Teuchos::rcp(new vfife::Columns(communicator, n_rows, 3));
  const auto matrix = Teuchos::rcpFromRef<const ColumnOperator>(K);
  check("Anasazi's test of vectors", Anasazi::TestMultiVecTraits<double, vfife::Columns>(out, x));
  check("Anasazi's test of operators",
        Anasazi::TestOperatorTraits<double, vfife::Columns, ColumnOperator>(out, x, matrix));

  // Vectors that are not one behind the other, one of them twice.
  Anasazi::MultiVecTraits<double, vfife::Columns>::MvRandom(*x);
  vfife::Columns  view = x->view({2, 0, 2});
  Eigen::MatrixXd copy;
  check("a view has the vectors named, in their order",
        view.matrix(copy).col(0) == (*x)[2] && view.matrix(copy).col(1) == (*x)[0]);
  const Eigen::MatrixXd all = x->products(*x), some = view.products(*x);
  check("its products are the same ones",
        some.row(0) == some.row(2) && (some.row(0) - all.row(2)).norm() < 1e-14 * all.norm());
  view[1] *= 2.;
  check("a view shares the memory", std::abs(x->dot(*x)[0] - 4 * all(0, 0)) < 1e-13 * all(0, 0));
}

int main(int argc, char **argv)
{
  const TestRanks     ranks(argc, argv);
  const Communicator &world = ranks.world, &alone = ranks.alone;

  Model model;
  model.add_body(Body("wheel", make_ring(20., 40., 6., {{3, 12, 2}}), {}));
  model.constraints.push_back(
    {"hub", ConstraintKind::rigid_hub, 0, model.bodies[0].node_set("inner")});
  const FemSpace      d(model, {0}, FemElement::incompatible_modes);
  std::vector<double> u;
  for (unsigned int i = 0; i < 3 * d.n_points(); ++i)
    u.push_back(std::sin(12.9898 * (i + 1)));

  // Forces of the elements, without the matrix; then by the matrix of one rank and of all.
  std::vector<std::vector<double>> images;
  for (const Communicator *const ranks : {&alone, &world})
    {
      const FemSystem      system(d, {}, *ranks);
      const SystemMatrices matrices(system, MassKind::consistent, StrainMeasure::biot);
      const SparseMatrix   K(matrices.stiffness(constant_rate(0.)));
      const OwnedVector    q     = system.restrict_field(u);
      const auto           field = system.expand(q);
      if (ranks == &alone)
        images.push_back(system.expand(system.vector([&](const unsigned int e) -> Eigen::VectorXd {
          return compute_fem_stiffness(d.element_nodes(e), d.material(e), d.element()) *
                 d.gather(e, field);
        })));
      images.push_back(system.expand(K.apply(q)));
      if (ranks == &world)
        traits(world, q.size(), K);
    }
  // Round-off of sums of some hundred terms.
  check_below("product against forces of elements",
              relative_difference(images[0], images[1]),
              1e-13);
  check_below("product on all ranks against one rank",
              relative_difference(images[1], images[2]),
              1e-14);
  return 0;
}
