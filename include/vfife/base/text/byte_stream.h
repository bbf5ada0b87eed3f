// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_base_text_byte_stream_h
#define vfife_base_text_byte_stream_h

#include <vfife/base/types.h>

#include <cstddef>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace vfife
{
  /**
   * Values as bytes, in one order for both directions: the same function of a class that passes its
   * members collects them in a new stream, and sets them from a stream of collected bytes. Bytes
   * are those of this kind of machine; equal values have equal bytes.
   */
  class ByteStream
  {
  public:
    /** Collects. */
    ByteStream() = default;

    /** Gives back what was collected as bytes(); messages call them @p name. */
    explicit ByteStream(std::string bytes, std::string name = "stored data");

    /** Whether pass() sets the values. */
    bool reads() const
    {
      return reads_;
    }

    /** What has been collected, or is given back. */
    const std::string &bytes() const
    {
      return bytes_;
    }

    /** Collects or sets all @p values in turn. Throws InputError when there are not enough bytes.
     */
    template <typename First, typename Second, typename... More>
    void pass(First &first, Second &second, More &...more)
    {
      pass(first);
      pass(second, more...);
    }

    template <typename Value>
    std::enable_if_t<std::is_trivially_copyable<Value>::value> pass(Value &value)
    {
      clear_padding(value);
      pass_bytes(&value, sizeof(Value));
    }

    void pass(Vector3 &value)
    {
      pass_bytes(value.data(), 3 * sizeof(double));
    }

    void pass(RigidMotion &value)
    {
      pass_bytes(value.rotation.data(), 9 * sizeof(double));
      pass(value.translation);
    }

    template <typename First, typename Second>
    void pass(std::pair<First, Second> &value)
    {
      pass(value.first, value.second);
    }

    void pass(bool &value);
    void pass(std::string &value);

    template <typename Value>
    void pass(std::vector<Value> &values)
    {
      value_size(values, std::is_trivially_copyable<Value>::value ? sizeof(Value) : 1);
      if constexpr (std::is_trivially_copyable<Value>::value)
        {
          for (Value &value : values)
            clear_padding(value);
          pass_bytes(values.data(), values.size() * sizeof(Value));
        }
      else
        for (Value &value : values)
          pass(value);
    }

    /**
     * Passes a struct of plain numbers to which later versions add members at the end: with its
     * size, so that members that were not there yet stay what they are.
     */
    template <typename Value>
    void pass_record(Value &value)
    {
      static_assert(std::is_trivially_copyable<Value>::value, "plain numbers only");
      std::size_t size = sizeof(Value);
      pass(size);
      if (size > sizeof(Value))
        refuse_newer();
      clear_padding(value);
      pass_bytes(&value, size);
    }

    /** Passes such structs of any number, with their size once. */
    template <typename Value>
    void pass_records(std::vector<Value> &values)
    {
      static_assert(std::is_trivially_copyable<Value>::value, "plain numbers only");
      std::size_t size = sizeof(Value);
      pass(size);
      require(size > 0, "records without bytes");
      if (size > sizeof(Value))
        refuse_newer();
      value_size(values, size);
      for (Value &value : values)
        {
          clear_padding(value);
          pass_bytes(&value, size);
        }
    }

    /**
     * Passes a part by its name: @p pass is called with a stream of that part alone. A stream
     * consists of parts or of values, not of both; parts are found in any order, parts that nobody
     * asks for are passed over. Returns false, without calling @p pass, where the part is not among
     * what was stored: it is younger than that.
     */
    template <typename Pass>
    bool pass_part(const std::string &name, const Pass &pass)
    {
      if (reads_)
        {
          std::string bytes;
          if (!find_part(name, bytes))
            return false;
          ByteStream part(std::move(bytes), name_);
          pass(part);
          part.finish();
          return true;
        }
      ByteStream part;
      pass(part);
      add_part(name, part.bytes());
      return true;
    }

    /** The same for a part that must be there: throws InputError where it is not. */
    template <typename Pass>
    void pass_required_part(const std::string &name, const Pass &pass)
    {
      if (!pass_part(name, pass))
        refuse_without(name);
    }

    /** Passes values whose number is known when reading too: throws InputError for another one. */
    template <typename Value>
    void pass_known(std::vector<Value> &values)
    {
      std::size_t n = values.size();
      pass(n);
      require(n == values.size(),
              std::to_string(n) + " values, expected " + std::to_string(values.size()));
      for (Value &value : values)
        pass(value);
    }

    /** When reading, throws InputError unless @p condition; @p wrong: what stands there instead. */
    void require(bool condition, const std::string &wrong) const;

    /** Throws InputError unless all values have been given back; parts may be left over. */
    void finish() const;

  private:
    bool              find_part(const std::string &name, std::string &bytes) const;
    void              add_part(std::string name, std::string bytes);
    [[noreturn]] void refuse_without(const std::string &name) const;
    [[noreturn]] void refuse_newer() const;

    /** Sets the bytes between members to zero, where the compiler can (GCC from 11
     * on). */
    template <typename Value>
    static void clear_padding([[maybe_unused]] Value &value)
    {
#ifdef __has_builtin
#  if __has_builtin(__builtin_clear_padding)
      __builtin_clear_padding(&value);
#  endif
#endif
    }

    /** Passes the number of values, each of @p least bytes or more, and makes room for them. */
    template <typename Values>
    void value_size(Values &values, const std::size_t least)
    {
      std::size_t n = values.size();
      pass_bytes(&n, sizeof(n));
      if (reads_)
        {
          check_room(n, least);
          values.resize(n);
        }
    }

    void pass_bytes(void *value, std::size_t n);
    void check_room(std::size_t n, std::size_t least) const;

    bool         reads_ = false;
    std::string  bytes_, name_;
    std::size_t  next_      = 0;     ///< when reading
    mutable bool has_parts_ = false; ///< when reading
  };
} // namespace vfife

#endif
