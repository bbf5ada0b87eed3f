// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_reduced_reduction_source_h
#define vfife_reduced_reduction_source_h

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace vfife
{
  class ByteStream;
  struct Model;
  struct ReductionOptions;

  /** What a reduced body depends on but for speed, cut-off and reach, as few numbers by which one
   * body is told from another. */
  class ReductionSource
  {
  public:
    ReductionSource() = default;
    /** As reduce_body() is given them. */
    ReductionSource(const Model &model, unsigned int body, const ReductionOptions &options);

    /** What differs first (a noun), or nothing. */
    std::string find_difference(const ReductionSource &other) const;

    void serialize(ByteStream &stream);

  private:
    /** Names and checksums: CRC-32 of all that the part consists of. */
    std::vector<std::pair<std::string, std::uint32_t>> parts_;
    std::vector<double>                                axis_; ///< in the body frame
  };
} // namespace vfife

#endif
