// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_fem_epetra_matrix_h
#define vfife_fem_epetra_matrix_h

// Trilinos as the iterative and eigenvalue solvers use it; seen by their sources only.
#include <vfife/base/process/communicator.h>
#include <vfife/fem/system/assembly.h>

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wall"
#pragma GCC diagnostic ignored "-Wextra"
#include <Epetra_CrsMatrix.h>
#include <Epetra_Map.h>
#include <Epetra_MpiComm.h>
#include <Epetra_MultiVector.h>
#pragma GCC diagnostic pop

#include <memory>

namespace vfife
{
  inline Epetra_Map make_map(const SparsePattern &pattern, const Communicator &communicator)
  {
    return Epetra_Map(pattern.n, pattern.n_rows(), 0, Epetra_MpiComm(communicator.mpi()));
  }

  /** A copy of the matrix without its zeros (diagonal kept). */
  inline std::unique_ptr<Epetra_CrsMatrix> make_epetra_matrix(const Epetra_Map    &map,
                                                              const SparsePattern &pattern,
                                                              const SparseValues  &values)
  {
    // Rows are counted before they are filled: memory is taken once. The pattern is that of
    // all matrices of an assembly, so that each has zeros of its own; multigrid would take
    // them for couplings.
    std::vector<int> lengths(pattern.n_rows(), 0);
    const auto       is_kept = [&](const int row, const std::size_t k) {
      return values[k] != 0 || pattern.columns[k] == pattern.first_row + row;
    };
    for (int i = 0; i < pattern.n_rows(); ++i)
      for (std::size_t k = pattern.begin[i]; k < pattern.begin[i + 1]; ++k)
        lengths[i] += is_kept(i, k);

    auto             matrix = std::make_unique<Epetra_CrsMatrix>(Copy, map, lengths.data(), true);
    std::vector<int> columns;
    std::vector<double> row;
    for (int i = 0; i < pattern.n_rows(); ++i)
      {
        columns.clear();
        row.clear();
        for (std::size_t k = pattern.begin[i]; k < pattern.begin[i + 1]; ++k)
          if (is_kept(i, k))
            {
              columns.push_back(pattern.columns[k]);
              row.push_back(values[k]);
            }
        matrix->InsertGlobalValues(pattern.first_row + i, row.size(), row.data(), columns.data());
      }
    matrix->FillComplete();
    return matrix;
  }

  /** The owned parts of @p vectors as columns. */
  inline Epetra_MultiVector make_multi_vector(const Epetra_Map               &map,
                                              const std::vector<OwnedVector> &vectors)
  {
    Epetra_MultiVector columns(map, vectors.size());
    for (std::size_t k = 0; k < vectors.size(); ++k)
      std::copy(vectors[k].begin(), vectors[k].end(), columns[k]);
    return columns;
  }
} // namespace vfife

#endif
