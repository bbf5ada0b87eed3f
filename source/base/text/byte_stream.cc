// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/text/byte_stream.h>

#include <cstring>

namespace vfife
{
  ByteStream::ByteStream(std::string bytes, std::string name)
    : reads_(true)
    , bytes_(std::move(bytes))
    , name_(std::move(name))
  {
  }

  void ByteStream::pass(bool &value)
  {
    // Another byte than 0 and 1 would be no bool.
    char byte = value ? 1 : 0;
    pass_bytes(&byte, 1);
    require(byte == 0 || byte == 1, "a byte is neither 0 nor 1");
    value = byte == 1;
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
      throw InputError(name_ + " are truncated or were written by another version of vfife");
  }

  void ByteStream::require(const bool condition, const std::string &wrong) const
  {
    if (reads_ && !condition)
      throw InputError(name_ + " are damaged or were written by another version of vfife (byte " +
                       std::to_string(next_) + " of " + std::to_string(bytes_.size()) +
                       "): " + wrong);
  }

  void ByteStream::finish() const
  {
    if (!has_parts_)
      return require(next_ == bytes_.size(), "bytes are left after the last value");
    // Parts that nobody has asked for may be left over, but nothing else.
    std::string bytes;
    find_part("", bytes);
  }

  bool ByteStream::find_part(const std::string &name, std::string &bytes) const
  {
    // From the beginning: the order of the questions need not be that of the parts.
    has_parts_ = true;
    ByteStream all(bytes_, name_);
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
    throw InputError(name_ + " have no part \"" + name +
                     "\": they were written by another version of vfife");
  }

  void ByteStream::refuse_newer() const
  {
    throw InputError(name_ + " were written by a newer version of vfife than this one");
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
