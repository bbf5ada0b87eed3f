// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_multigrid_h
#define vfife_fem_multigrid_h

#include "epetra_matrix.h"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <Teuchos_ParameterList.hpp>
#include <ml_MultiLevelPreconditioner.h>
#pragma GCC diagnostic pop

namespace vfife
{
  /** Smoothed aggregation; keeps the near kernel alive, which ML only points to. */
  struct Multigrid
  {
    Multigrid(const Epetra_CrsMatrix &matrix, const std::vector<OwnedVector> &near_kernel)
      : kernel(make_multi_vector(matrix.RowMap(), near_kernel))
    {
      Teuchos::ParameterList list;
      ML_Epetra::SetDefaults("SA", list);
      list.set("ML output", 0);
      // Padded unknowns: the three of a point go to one aggregate. Couplings below the threshold do
      // not join points.
      list.set("PDE equations", 3);
      list.set("aggregation: threshold", 1e-3);
      // A polynomial of degree three on the upper nine tenths of the spectrum, symmetric as
      // conjugate gradients ask for.
      list.set("smoother: type", "Chebyshev");
      list.set("smoother: sweeps", 3);
      list.set("smoother: Chebyshev alpha", 10.);
      list.set("coarse: type", "Amesos-KLU");
      list.set("coarse: max size", 1000);
      // The coarse spaces hold what is given here, and nothing else.
      list.set("null space: type", "pre-computed");
      list.set("null space: dimension", kernel.NumVectors());
      list.set("null space: vectors", kernel.Values());
      list.set("null space: add default vectors", false);
      operators = std::make_unique<ML_Epetra::MultiLevelPreconditioner>(matrix, list);
    }

    Epetra_MultiVector                                   kernel;
    std::unique_ptr<ML_Epetra::MultiLevelPreconditioner> operators;
  };
} // namespace vfife

#endif
