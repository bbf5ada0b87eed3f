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

  namespace
  {
    /** A length as MPI takes it. */
    int to_count(const std::size_t n_bytes)
    {
      if (n_bytes > static_cast<std::size_t>(std::numeric_limits<int>::max()))
        throw NumericalError("a message to one rank exceeds 2 GB");
      return static_cast<int>(n_bytes);
    }
  } // namespace

  Communicator::Communicator(const MPI_Comm comm)
    : comm_(comm)
    // A process by itself needs no MPI_Init(): programs on the library may be without.
    , rank_(comm == MPI_COMM_SELF ? 0 : mpi::this_mpi_process(comm))
    , size_(comm == MPI_COMM_SELF ? 1 : mpi::n_mpi_processes(comm))
  {
  }

  // On a single rank nothing is sent: results are those of a program without MPI, to the last bit.
  bool Communicator::reduces(const std::size_t n_bytes) const
  {
    if (size_ == 1)
      return false;
    ++traffic_.reductions;
    traffic_.reduction_bytes += n_bytes;
    return true;
  }

  double Communicator::sum(const double value) const
  {
    return reduces(sizeof(value)) ? mpi::sum(value, comm_) : value;
  }

  double Communicator::min(const double value) const
  {
    return reduces(sizeof(value)) ? mpi::min(value, comm_) : value;
  }

  double Communicator::max(const double value) const
  {
    return reduces(sizeof(value)) ? mpi::max(value, comm_) : value;
  }

  unsigned int Communicator::sum(const unsigned int value) const
  {
    return reduces(sizeof(value)) ? mpi::sum(value, comm_) : value;
  }

  unsigned int Communicator::min(const unsigned int value) const
  {
    return reduces(sizeof(value)) ? mpi::min(value, comm_) : value;
  }

  unsigned int Communicator::max(const unsigned int value) const
  {
    return reduces(sizeof(value)) ? mpi::max(value, comm_) : value;
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
    if (!values.empty() && reduces(values.size() * sizeof(double)))
      mpi::sum(values, comm_, values);
  }

  void Communicator::max(std::vector<double> &values) const
  {
    if (!values.empty() && reduces(values.size() * sizeof(double)))
      mpi::max(values, comm_, values);
  }

  void Communicator::sum(double *values, const unsigned int n) const
  {
    if (reduces(n * sizeof(double)))
      mpi::sum(dealii::ArrayView<const double>(values, n),
               comm_,
               dealii::ArrayView<double>(values, n));
  }

  std::vector<std::string> Communicator::all_gather(const std::string &text) const
  {
    return reduces(text.size()) ? mpi::all_gather(comm_, text) : std::vector<std::string>(1, text);
  }

  std::string Communicator::broadcast(const std::string &text, const unsigned int root) const
  {
    return reduces(rank_ == root ? text.size() : 0) ? mpi::broadcast(comm_, text, root) : text;
  }

  void Communicator::barrier() const
  {
    if (reduces(0))
      MPI_Barrier(comm_);
  }

  MPI_Request Communicator::start_sending(const void        *data,
                                          const std::size_t  n_bytes,
                                          const unsigned int rank,
                                          const int          tag) const
  {
    ++traffic_.messages;
    traffic_.message_bytes += n_bytes;
    MPI_Request request;
    MPI_Isend(data, to_count(n_bytes), MPI_BYTE, static_cast<int>(rank), tag, comm_, &request);
    return request;
  }

  MPI_Request Communicator::start_receiving(void              *data,
                                            const std::size_t  n_bytes,
                                            const unsigned int rank,
                                            const int          tag) const
  {
    MPI_Request request;
    MPI_Irecv(data, to_count(n_bytes), MPI_BYTE, static_cast<int>(rank), tag, comm_, &request);
    return request;
  }

  std::vector<char> Communicator::receive(const unsigned int rank, const int tag) const
  {
    MPI_Status status;
    MPI_Probe(static_cast<int>(rank), tag, comm_, &status);
    int n_bytes = 0;
    MPI_Get_count(&status, MPI_BYTE, &n_bytes);
    std::vector<char> bytes(n_bytes);
    MPI_Recv(bytes.data(), n_bytes, MPI_BYTE, static_cast<int>(rank), tag, comm_, &status);
    return bytes;
  }

  void Communicator::wait(std::vector<MPI_Request> &requests)
  {
    if (!requests.empty())
      MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  }

  std::vector<char> Communicator::gather_bytes(const void *data, const std::size_t n_bytes) const
  {
    const char *const begin = static_cast<const char *>(data);
    if (size_ == 1)
      return n_bytes == 0 ? std::vector<char>() : std::vector<char>(begin, begin + n_bytes);

    // Where the bytes of each rank begin: the lengths before it, summed.
    const std::uint64_t        n_mine = n_bytes;
    std::vector<std::uint64_t> lengths(size_);
    reduces(sizeof(n_mine));
    MPI_Allgather(&n_mine, 1, MPI_UINT64_T, lengths.data(), 1, MPI_UINT64_T, comm_);
    // MPI counts with int: refuse on all ranks together what would overflow
    std::uint64_t    total = 0;
    std::vector<int> counts, offsets;
    for (const std::uint64_t length : lengths)
      {
        offsets.push_back(static_cast<int>(total));
        counts.push_back(static_cast<int>(length));
        total += length;
        if (total > static_cast<std::uint64_t>(std::numeric_limits<int>::max()))
          throw NumericalError("the data gathered from all ranks exceed 2 GB");
      }
    reduces(n_bytes);
    std::vector<char> all(total);
    MPI_Allgatherv(
      begin, counts[rank_], MPI_CHAR, all.data(), counts.data(), offsets.data(), MPI_CHAR, comm_);
    return all;
  }

  void Communicator::copy_bytes(const std::vector<char> &bytes, void *target)
  {
    if (!bytes.empty())
      std::memcpy(target, bytes.data(), bytes.size());
  }
} // namespace vfife
