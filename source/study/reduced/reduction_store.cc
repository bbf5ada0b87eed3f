// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/process/communicator.h>
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/output/files/output_folder.h>
#include <vfife/output/files/sealed_file.h>
#include <vfife/study/reduced/reduction_store.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>

namespace vfife
{
  namespace
  {
    const SealedFile seal    = {"vfife-reduction", "reduced body", 1};
    const char       entry[] = "Reduced/store";

    /** "Pinion" is kept in pinion.reduction. */
    std::string file_name(std::string name)
    {
      std::transform(name.begin(), name.end(), name.begin(), [](const unsigned char c) {
        return std::isalnum(c) ? static_cast<char>(std::tolower(c)) : '_';
      });
      return name + ".reduction";
    }

    /** What there is less of than is asked for (a sentence's end), or nothing. */
    std::string find_lack(const ReducedBody &body, const ReductionStore::Range &range)
    {
      constexpr double   same = 1. - 1e-9;
      std::ostringstream text;
      if (std::abs(body.rate) < same * std::abs(range.rate))
        text << "is for its speeds up to " << std::abs(body.rate) * 30. / pi << " rpm";
      else if (body.cutoff < same * range.cutoff)
        text << "has modes below " << .5 / pi * body.cutoff << " Hz";
      else if (body.reach < std::min(range.reach, body.n_sectors / 2))
        text << "reaches over " << body.reach << " sectors";
      return text.str();
    }
  } // namespace

  void ReductionStore::require_writable() const
  {
    if (folder_.empty())
      return;
    try
      {
        const OutputFolder folder(folder_, communicator_);
      }
    catch (const std::runtime_error &error)
      {
        throw InputError(entry,
                         "expected a folder that can be written to, got \"" + folder_ +
                           "\": " + error.what() + ". Name another folder.");
      }
  }

  std::optional<ReducedBody> ReductionStore::find(const std::string     &name,
                                                  const ReductionSource &source,
                                                  const Range           &range) const
  {
    if (folder_.empty())
      return {};
    // One rank reads; all get the same bytes or the same complaint.
    const std::string path = folder_ + "/" + file_name(name);
    std::string       bytes, complaint;
    if (communicator_.is_root() && std::filesystem::exists(path))
      complaint = seal.read(path, bytes);
    complaint = communicator_.broadcast(complaint);
    bytes     = communicator_.broadcast(bytes);
    if (!complaint.empty())
      throw InputError(entry, complaint + ". Remove it, or name another folder");
    if (bytes.empty())
      return {};

    ByteStream      stream(bytes, "\"" + path + "\"");
    ReductionSource stored;
    ReducedBody     body;
    stored.serialize(stream);
    const std::string difference = source.find_difference(stored);
    if (!difference.empty())
      throw InputError(entry,
                       "\"" + path + "\" belongs to another body: its " + difference +
                         " differs. Remove it, or name another folder");
    serialize(body, stream);
    stream.finish();
    const std::string lack = find_lack(body, range);
    if (!lack.empty())
      {
        log_.line("\"", path, "\" ", lack, ": the body is reduced again");
        return {};
      }
    return body;
  }

  void
  ReductionStore::keep(const std::string &name, ReductionSource source, ReducedBody &body) const
  {
    if (folder_.empty())
      return;
    const OutputFolder folder(folder_, communicator_);
    if (!folder.is_writer())
      return;
    ByteStream stream;
    source.serialize(stream);
    serialize(body, stream);
    folder.write_file(file_name(name), [&](std::ostream &out) { seal.write(stream.bytes(), out); });
  }
} // namespace vfife
