// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_process_communicator_h
#define vfife_base_process_communicator_h

// OpenMPI's obsolete C++ bindings are not used and do not compile without warnings
#ifndef OMPI_SKIP_MPICXX
#  define OMPI_SKIP_MPICXX 1
#endif
#include <vfife/base/process/traffic.h>

#include <mpi.h>

#include <string>
#include <type_traits>
#include <vector>

namespace vfife
{
  /**
   * The ranks that work together, passed by reference to whoever needs them. All functions but
   * rank(), size(), mpi(), traffic() and those for messages to single ranks are collective: every
   * rank must call them. With one rank they cost nothing. What is sent is counted.
   */
  class Communicator
  {
  public:
    /** Uses an existing communicator, which must outlive this object. */
    explicit Communicator(MPI_Comm comm);

    unsigned int rank() const
    {
      return rank_;
    }

    unsigned int size() const
    {
      return size_;
    }

    bool is_root() const
    {
      return rank_ == 0;
    }

    MPI_Comm mpi() const
    {
      return comm_;
    }

    double sum(double value) const;
    double min(double value) const;
    double max(double value) const;

    unsigned int sum(unsigned int value) const;
    unsigned int min(unsigned int value) const;
    unsigned int max(unsigned int value) const;

    /** Whether it is true on any rank. */
    bool any(bool condition) const;

    /** Whether it is true on all ranks. */
    bool all(bool condition) const;

    /** Entry by entry over the ranks, in place; same length everywhere. */
    void sum(std::vector<double> &values) const;
    void max(std::vector<double> &values) const;
    void sum(double *values, unsigned int n) const;

    /** The values of all ranks, in order of the ranks; lengths may differ. Any type that can be
     * copied bytewise. */
    template <typename T>
    std::vector<T> all_gather(const std::vector<T> &values) const
    {
      static_assert(std::is_trivially_copyable<T>::value, "values are sent as bytes");
      const std::vector<char> bytes = gather_bytes(values.data(), values.size() * sizeof(T));
      std::vector<T>          all(bytes.size() / sizeof(T));
      copy_bytes(bytes, all.data());
      return all;
    }

    /** One value of each rank. */
    template <typename T>
    std::vector<T> all_gather(const T &value) const
    {
      return all_gather(std::vector<T>(1, value));
    }

    /** One text of each rank. */
    std::vector<std::string> all_gather(const std::string &text) const;

    /** The text of rank @p root on all ranks. */
    std::string broadcast(const std::string &text, unsigned int root = 0) const;

    void barrier() const;

    /**
     * Begins to send @p n_bytes to @p rank, which receives as many with the same @p tag; messages
     * of one tag between two ranks arrive in the order in which they were sent. The bytes must stay
     * until the request is waited for.
     */
    MPI_Request
    start_sending(const void *data, std::size_t n_bytes, unsigned int rank, int tag) const;

    /** Begins to receive what start_sending() sends. */
    MPI_Request start_receiving(void *data, std::size_t n_bytes, unsigned int rank, int tag) const;

    /** Waits for the next message of @p rank with that @p tag and receives it, whatever its length.
     */
    std::vector<char> receive(unsigned int rank, int tag) const;

    static void wait(std::vector<MPI_Request> &requests);

    /** What this rank has sent through this object so far. */
    const Traffic &traffic() const
    {
      return traffic_;
    }

  private:
    /** Whether there is anybody to talk to; if so the operation of all ranks is counted. */
    bool              reduces(std::size_t n_bytes) const;
    std::vector<char> gather_bytes(const void *data, std::size_t n_bytes) const;
    static void       copy_bytes(const std::vector<char> &bytes, void *target);

    MPI_Comm     comm_;
    unsigned int rank_;
    unsigned int size_;
    /** Counting is no part of what the object is to others. */
    mutable Traffic traffic_;
  };
} // namespace vfife

#endif
