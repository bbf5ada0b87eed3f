// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>

#include <cstring>
#include <limits>

namespace vfife
{
  namespace
  {
    // The result is on all ranks; one rank alone has nothing to exchange.
    template <typename T>
    T reduce(T                   value,
             const MPI_Datatype  type,
             const MPI_Op        operation,
             const Communicator &communicator)
    {
      if (communicator.size() > 1)
        MPI_Allreduce(MPI_IN_PLACE, &value, 1, type, operation, communicator.mpi());
      return value;
    }

    void reduce(double             *values,
                const std::size_t   n,
                const MPI_Op        operation,
                const Communicator &communicator)
    {
      if (communicator.size() > 1 && n > 0)
        MPI_Allreduce(
          MPI_IN_PLACE, values, static_cast<int>(n), MPI_DOUBLE, operation, communicator.mpi());
    }
  } // namespace

  Communicator::Communicator(const MPI_Comm comm)
    : comm_(comm)
  {
    int rank = 0, size = 1;
    MPI_Comm_rank(comm, &rank);
    MPI_Comm_size(comm, &size);
    rank_ = static_cast<unsigned int>(rank);
    size_ = static_cast<unsigned int>(size);
  }

  double Communicator::sum(const double value) const
  {
    return reduce(value, MPI_DOUBLE, MPI_SUM, *this);
  }

  double Communicator::min(const double value) const
  {
    return reduce(value, MPI_DOUBLE, MPI_MIN, *this);
  }

  double Communicator::max(const double value) const
  {
    return reduce(value, MPI_DOUBLE, MPI_MAX, *this);
  }

  unsigned long long Communicator::sum(const unsigned long long value) const
  {
    return reduce(value, MPI_UNSIGNED_LONG_LONG, MPI_SUM, *this);
  }

  unsigned int Communicator::sum(const unsigned int value) const
  {
    return reduce(value, MPI_UNSIGNED, MPI_SUM, *this);
  }

  unsigned int Communicator::min(const unsigned int value) const
  {
    return reduce(value, MPI_UNSIGNED, MPI_MIN, *this);
  }

  unsigned int Communicator::max(const unsigned int value) const
  {
    return reduce(value, MPI_UNSIGNED, MPI_MAX, *this);
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
    reduce(values.data(), values.size(), MPI_SUM, *this);
  }

  void Communicator::min(std::vector<double> &values) const
  {
    reduce(values.data(), values.size(), MPI_MIN, *this);
  }

  void Communicator::max(std::vector<double> &values) const
  {
    reduce(values.data(), values.size(), MPI_MAX, *this);
  }

  void Communicator::sum(double *values, const unsigned int n) const
  {
    reduce(values, n, MPI_SUM, *this);
  }

  std::vector<std::string> Communicator::all_gather(const std::string &text) const
  {
    // All letters in one row, cut by the lengths.
    const std::vector<unsigned int> lengths = all_gather(static_cast<unsigned int>(text.size()));
    const std::vector<char>         letters = gather_bytes(text.data(), text.size());
    std::vector<std::string>        texts;
    std::size_t                     begin = 0;
    for (const unsigned int length : lengths)
      {
        texts.emplace_back(letters.data() + begin, length);
        begin += length;
      }
    return texts;
  }

  std::string Communicator::broadcast(const std::string &text, const unsigned int root) const
  {
    if (size_ == 1)
      return text;
    // The length first: the other ranks do not know it.
    unsigned int length = text.size();
    MPI_Bcast(&length, 1, MPI_UNSIGNED, static_cast<int>(root), comm_);
    std::string result = text;
    result.resize(length);
    MPI_Bcast(result.data(), static_cast<int>(length), MPI_CHAR, static_cast<int>(root), comm_);
    return result;
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
