// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/text/nearest_name.h>

#include <algorithm>
#include <cctype>

namespace vfife
{
  namespace
  {
    std::string lower_case(std::string word)
    {
      for (char &letter : word)
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
      return word;
    }
  } // namespace

  unsigned int edit_distance(const std::string &first, const std::string &second)
  {
    const std::string a = lower_case(first), b = lower_case(second);

    // rows of the table of distances between the beginnings of both words
    std::vector<unsigned int> before_last(b.size() + 1), last(b.size() + 1), row(b.size() + 1);
    // row[j] in turn i: distance between the first i letters of a and the
    // first j of b. For i = 0 it is j.
    for (unsigned int j = 0; j <= b.size(); ++j)
      row[j] = j;
    for (unsigned int i = 1; i <= a.size(); ++i)
      {
        before_last.swap(last);
        last.swap(row);
        row[0] = i;
        for (unsigned int j = 1; j <= b.size(); ++j)
          {
            // A letter of a too much, one of b too much, or the last letters replaced (free if they
            // are equal); then neighbours swapped.
            row[j] = std::min(
              {last[j] + 1, row[j - 1] + 1, last[j - 1] + (a[i - 1] == b[j - 1] ? 0u : 1u)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
              row[j] = std::min(row[j], before_last[j - 2] + 1);
          }
      }
    return row[b.size()];
  }

  std::string nearest_name(const std::string &word, const std::vector<std::string> &candidates)
  {
    // A third of the letters may be wrong, one of them in short words too.
    std::string nearest;
    // One more than the most letters that may differ.
    unsigned int smallest = std::max<unsigned int>(1, word.size() / 3) + 1;
    for (const std::string &candidate : candidates)
      {
        const unsigned int distance = edit_distance(word, candidate);
        // The first of several that are equally near.
        if (distance < smallest)
          {
            smallest = distance;
            nearest  = candidate;
          }
      }
    if (!nearest.empty())
      return nearest;

    // containment says something only from three letters on
    const std::string small_word = lower_case(word);
    for (const std::string &candidate : candidates)
      {
        const std::string small_candidate = lower_case(candidate);
        if (std::min(word.size(), candidate.size()) >= 3 &&
            (small_candidate.find(small_word) != std::string::npos ||
             small_word.find(small_candidate) != std::string::npos))
          return candidate;
      }
    return "";
  }

  std::string did_you_mean(const std::string &word, const std::vector<std::string> &candidates)
  {
    const std::string nearest = nearest_name(word, candidates);
    return nearest.empty() ? "" : "; did you mean \"" + nearest + "\"?";
  }

  std::string list_of(const std::vector<std::string> &names, const bool quoted)
  {
    const std::string mark = quoted ? "\"" : "";
    std::string       list;
    for (const std::string &name : names)
      list += (list.empty() ? "" : ", ") + mark + name + mark;
    return list;
  }
} // namespace vfife
