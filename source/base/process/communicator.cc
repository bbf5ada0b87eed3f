// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>

#include <deal.II/base/array_view.h>
#include <deal.II/base/mpi.h>

#include <cstring>
#include <limits>

namespace vfife
{
  namespace mpi = dealii::Utilities::MPI;

  Communicator::Communicator(const MPI_Comm comm)
    : comm_(comm)
    , rank_(mpi::this_mpi_process(comm))
    , size_(mpi::n_mpi_processes(comm))
  {
  }

  // On a single rank nothing is sent: results are those of a program without MPI, to the last bit.
  double Communicator::sum(const double value) const
  {
    return size_ == 1 ? value : mpi::sum(value, comm_);
  }

  double Communicator::min(const double value) const
  {
    return size_ == 1 ? value : mpi::min(value, comm_);
  }

  double Communicator::max(const double value) const
  {
    return size_ == 1 ? value : mpi::max(value, comm_);
  }

  unsigned long long Communicator::sum(const unsigned long long value) const
  {
    return size_ == 1 ? value : mpi::sum(value, comm_);
  }

  unsigned int Communicator::sum(const unsigned int value) const
  {
    return size_ == 1 ? value : mpi::sum(value, comm_);
  }

  unsigned int Communicator::min(const unsigned int value) const
  {
    return size_ == 1 ? value : mpi::min(value, comm_);
  }

  unsigned int Communicator::max(const unsigned int value) const
  {
    return size_ == 1 ? value : mpi::max(value, comm_);
  }

  bool Communicator::any(const bool condition) const
  {
    return max(condition ? 1u : 0u) == 1u;
  }

  bool Communicator::all(const bool condition) const
  {
    return min(condition ? 1u : 0u) == 1u;
  }

  void Communicator::sum(std::vector<double> &values) const
  {
    if (size_ > 1)
      mpi::sum(values, comm_, values);
  }

  void Communicator::min(std::vector<double> &values) const
  {
    if (size_ > 1)
      mpi::min(values, comm_, values);
  }

  void Communicator::max(std::vector<double> &values) const
  {
    if (size_ > 1)
      mpi::max(values, comm_, values);
  }

  void Communicator::sum(double *values, const unsigned int n) const
  {
    if (size_ > 1)
      mpi::sum(dealii::ArrayView<const double>(values, n),
               comm_,
               dealii::ArrayView<double>(values, n));
  }

  std::vector<std::string> Communicator::all_gather(const std::string &text) const
  {
    return size_ == 1 ? std::vector<std::string>(1, text) : mpi::all_gather(comm_, text);
  }

  std::string Communicator::broadcast(const std::string &text, const unsigned int root) const
  {
    return size_ == 1 ? text : mpi::broadcast(comm_, text, root);
  }

  void Communicator::barrier() const
  {
    if (size_ > 1)
      MPI_Barrier(comm_);
  }

  std::vector<char> Communicator::gather_bytes(const void *data, const std::size_t n_bytes) const
  {
    const char *const begin = static_cast<const char *>(data);
    if (size_ == 1)
      return n_bytes == 0 ? std::vector<char>() : std::vector<char>(begin, begin + n_bytes);

    // MPI counts with int: refuse on all ranks together what would overflow
    const double total = sum(static_cast<double>(n_bytes));
    if (total > std::numeric_limits<int>::max())
      throw NumericalError("more than 2 GB are to be gathered from all ranks");

    // Where the bytes of each rank begin: the lengths before it, summed.
    const int        n_mine = static_cast<int>(n_bytes);
    std::vector<int> counts(size_), offsets(size_, 0);
    MPI_Allgather(&n_mine, 1, MPI_INT, counts.data(), 1, MPI_INT, comm_);
    for (unsigned int r = 1; r < size_; ++r)
      offsets[r] = offsets[r - 1] + counts[r - 1];
    std::vector<char> all(static_cast<std::size_t>(offsets.back() + counts.back()));
    MPI_Allgatherv(
      begin, n_mine, MPI_CHAR, all.data(), counts.data(), offsets.data(), MPI_CHAR, comm_);
    return all;
  }

  void Communicator::copy_bytes(const std::vector<char> &bytes, void *target)
  {
    if (!bytes.empty())
      std::memcpy(target, bytes.data(), bytes.size());
  }
} // namespace vfife
