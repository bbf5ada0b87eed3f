// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_partition_h
#define vfife_model_partition_h

#include <cstddef>
#include <cstdint>
#include <vector>

namespace vfife
{
  /** Local nodes one after the other, for a loop over a range: all of them, or the owned ones. */
  class NodeRange
  {
  public:
    class Iterator
    {
    public:
      Iterator(const std::uint32_t node, const std::uint32_t last, const std::uint8_t *owned)
        : node_(node)
        , last_(last)
        , owned_(owned)
      {
        skip();
      }

      std::uint32_t operator*() const
      {
        return node_;
      }

      Iterator &operator++()
      {
        ++node_;
        skip();
        return *this;
      }

      bool operator!=(const Iterator &other) const
      {
        return node_ != other.node_;
      }

    private:
      void skip()
      {
        while (owned_ != nullptr && node_ < last_ && owned_[node_] == 0)
          ++node_;
      }

      std::uint32_t       node_, last_;
      const std::uint8_t *owned_;
    };

    /** Nodes [@p first, @p last); of these the ones where @p owned is 1, unless it is nullptr. */
    NodeRange(const std::uint32_t first, const std::uint32_t last, const std::uint8_t *owned)
      : first_(first)
      , last_(last)
      , owned_(owned)
    {
    }

    Iterator begin() const
    {
      return {first_, last_, owned_};
    }

    Iterator end() const
    {
      return {last_, last_, owned_};
    }

  private:
    std::uint32_t       first_, last_;
    const std::uint8_t *owned_;
  };

  /** Which nodes and elements this rank holds. Local nodes are grouped by body. */
  struct Partition
  {
    std::vector<std::uint32_t> global_node;      ///< local node -> node of the model
    std::vector<std::uint32_t> local_node;       ///< node of the model -> local node, or absent
    std::vector<std::uint8_t>  owned;            ///< 1 where this rank counts the node in sums
    std::vector<std::uint32_t> first_local_node; ///< per body, and one past the last
    std::vector<std::uint32_t> elements;         ///< elements of the model, sorted

    static constexpr std::uint32_t absent = static_cast<std::uint32_t>(-1);

    std::size_t n_local() const
    {
      return global_node.size();
    }

    /** All local nodes. */
    NodeRange nodes() const
    {
      return {0, static_cast<std::uint32_t>(n_local()), nullptr};
    }

    /** The local nodes of a body. */
    NodeRange nodes(const std::size_t body) const
    {
      return {first_local_node[body], first_local_node[body + 1], nullptr};
    }

    /** Those that this rank counts in sums. */
    NodeRange owned_nodes() const
    {
      return {0, static_cast<std::uint32_t>(n_local()), owned.data()};
    }

    /** Those of a body that this rank counts in sums. */
    NodeRange owned_nodes(const std::size_t body) const
    {
      return {first_local_node[body], first_local_node[body + 1], owned.data()};
    }

    /** The local node of a node of the model where this rank counts it in sums, else absent. */
    std::uint32_t find_owned(const std::size_t node) const
    {
      const std::uint32_t local = local_node[node];
      return local != absent && owned[local] != 0 ? local : absent;
    }
  };
} // namespace vfife

#endif
