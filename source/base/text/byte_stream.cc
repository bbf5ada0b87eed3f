// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/byte_stream.h>

#include <cstring>

namespace vfife
{
  ByteStream::ByteStream(std::string bytes)
    : reads_(true)
    , bytes_(std::move(bytes))
  {
  }

  void ByteStream::pass(std::string &value)
  {
    // Length and bytes; when reading the text gets its length first.
    value_size(value, 1);
    pass_bytes(value.data(), value.size());
  }

  void ByteStream::check_room(const std::size_t n, const std::size_t least) const
  {
    // Asked before a vector is resized: a wrong count must not ask for all memory.
    if (n > (bytes_.size() - next_) / least)
      throw InputError("stored data end too early: they are of another version of vfife");
  }

  bool ByteStream::find_part(const std::string &name, std::string &bytes) const
  {
    // From the beginning: the order of the questions need not be that of the parts.
    ByteStream all(bytes_);
    while (all.next_ < all.bytes_.size())
      {
        std::string found;
        all.pass(found, bytes);
        if (found == name)
          return true;
      }
    return false;
  }

  void ByteStream::add_part(std::string name, std::string bytes)
  {
    pass(name, bytes);
  }

  void ByteStream::refuse_without(const std::string &name) const
  {
    throw InputError("stored data have no part \"" + name +
                     "\": they are of another version of vfife");
  }

  void ByteStream::refuse_newer() const
  {
    throw InputError("stored data are of a newer version of vfife than this one");
  }

  void ByteStream::pass_bytes(void *value, const std::size_t n)
  {
    if (n == 0)
      return;
    if (reads_)
      {
        check_room(n, 1);
        std::memcpy(value, bytes_.data() + next_, n);
        next_ += n;
      }
    else
      bytes_.append(static_cast<const char *>(value), n);
  }
} // namespace vfife
