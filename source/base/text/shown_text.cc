// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/shown_text.h>

#include <cstdio>

namespace vfife
{
  namespace
  {
    /** Bytes of the character that begins at @p first; 0 where none does. The Unicode Standard,
     * table 3-7 (well-formed UTF-8 byte sequences). */
    std::size_t character_size(const std::string &text, const std::size_t first)
    {
      const auto byte = [&](const std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
      };
      const unsigned int lead = byte(first);
      if (lead < 0x80)
        return 1;
      const std::size_t size = lead >= 0xC2 && lead <= 0xDF   ? 2
                               : lead >= 0xE0 && lead <= 0xEF ? 3
                               : lead >= 0xF0 && lead <= 0xF4 ? 4
                                                              : 0;
      // What would be a shorter character, a surrogate, or beyond U+10FFFF.
      const unsigned int least = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
      const unsigned int most  = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
      for (std::size_t i = 1; i < size; ++i)
        if (byte(first + i) < (i == 1 ? least : 0x80u) || byte(first + i) > (i == 1 ? most : 0xBFu))
          return 0;
      return size;
    }

    bool is_control(const char letter)
    {
      const auto byte = static_cast<unsigned char>(letter);
      return (byte < 0x20 && letter != '\t') || byte == 0x7F;
    }
  } // namespace

  std::string shown(const std::string &text, const std::size_t longest)
  {
    std::string result;
    for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t size = character_size(text, i);
        if (result.size() + size > longest)
          return result + "...";
        result += size == 0 || is_control(text[i]) ? "?" : text.substr(i, size);
        i += size == 0 ? 1 : size;
      }
    return result;
  }

  std::string find_bad_bytes(const std::string &text)
  {
    for (std::size_t i = 0; i < text.size();)
      {
        const std::size_t size = character_size(text, i);
        if (size == 0 || is_control(text[i]))
          {
            char byte[8];
            std::snprintf(byte, sizeof(byte), "0x%02X", static_cast<unsigned char>(text[i]));
            return "byte " + std::string(byte) + " in column " + std::to_string(i + 1) +
                   (size == 0 ? " is not UTF-8 text" : " is a control character");
          }
        i += size;
      }
    return "";
  }
} // namespace vfife
