// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_model_node_field_h
#define vfife_model_node_field_h

#include <vfife/base/types.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace vfife
{
  /**
   * A vector at each local node of a rank, and a number beside it: records of four doubles, which
   * kernels of all instruction sets load and store whole. The number is the inverse mass in a field
   * of positions and the mass in one of velocities; elsewhere it is zero and means nothing.
   */
  class NodeField
  {
  public:
    NodeField() = default;

    /** Zero at @p n_nodes nodes. */
    explicit NodeField(const std::size_t n_nodes)
      : records_(width * n_nodes, 0.)
    {
    }

    std::size_t n_nodes() const
    {
      return records_.size() / width;
    }

    bool empty() const
    {
      return records_.empty();
    }

    Vector3 value(const std::size_t node) const
    {
      return Eigen::Map<const Vector3>(records_.data() + width * node);
    }

    void set(const std::size_t node, const Vector3 &value)
    {
      Eigen::Map<Vector3>(records_.data() + width * node) = value;
    }

    void add(const std::size_t node, const Vector3 &value)
    {
      Eigen::Map<Vector3>(records_.data() + width * node) += value;
    }

    /** The number beside the vector. */
    double number(const std::size_t node) const
    {
      return records_[width * node + 3];
    }

    void set_number(const std::size_t node, const double number)
    {
      records_[width * node + 3] = number;
    }

    /** Vectors and numbers of all nodes. */
    void set_zero()
    {
      std::fill(records_.begin(), records_.end(), 0.);
    }

    /** Node by node; both fields have the same nodes. */
    NodeField &operator+=(const NodeField &other)
    {
      for (std::size_t i = 0; i < records_.size(); ++i)
        records_[i] += other.records_[i];
      return *this;
    }

    friend NodeField operator-(const NodeField &a, NodeField b)
    {
      for (std::size_t i = 0; i < b.records_.size(); ++i)
        b.records_[i] = a.records_[i] - b.records_[i];
      return b;
    }

    /** For kernels: the records, [x y z number] a node. */
    double *data()
    {
      return records_.data();
    }

    const double *data() const
    {
      return records_.data();
    }

  private:
    static constexpr std::size_t width = 4;

    std::vector<double> records_;
  };
} // namespace vfife

#endif
