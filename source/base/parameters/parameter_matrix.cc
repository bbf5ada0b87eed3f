// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/errors.h>
#include <vfife/base/parameters/parameter_matrix.h>
#include <vfife/base/text/number_text.h>
#include <vfife/base/text/text_lines.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <fstream>
#include <sstream>
#include <vector>

namespace vfife
{
  namespace
  {
    /** Far more than matrices of a few bearings have. */
    constexpr double largest_size = 6000;

    /** Lines of numbers, without comments and empty ones. */
    class MatrixFile
    {
    public:
      explicit MatrixFile(const std::string &path)
        : name_("the matrix \"" + path + "\"")
        , file_(path)
        , lines_(file_)
      {
        if (!file_)
          throw InputError(name_ + " cannot be opened");
      }

      /** The first line, in words of lower case: its letters may have any. */
      std::vector<std::string> header()
      {
        std::string line;
        next_line(line);
        std::transform(line.begin(), line.end(), line.begin(), [](const unsigned char c) {
          return static_cast<char>(std::tolower(c));
        });
        std::vector<std::string> words;
        std::istringstream       stream(line);
        for (std::string word; stream >> word;)
          words.push_back(word);
        return words;
      }

      std::vector<double> next(const std::size_t n)
      {
        std::vector<double> numbers;
        for (std::string line; numbers.empty() && next_line(line);)
          {
            if (!line.empty() && line[0] == '%')
              continue;
            std::istringstream stream(line);
            for (std::string word; stream >> word;)
              {
                const std::optional<double> number = plain_number(word);
                if (!number)
                  refuse("expected a number, got \"" + word + "\"");
                numbers.push_back(*number);
              }
          }
        if (numbers.size() != n)
          refuse(numbers.empty()
                   ? "the file ends before the last entry"
                   : std::to_string(numbers.size()) + " numbers, expected " + std::to_string(n));
        return numbers;
      }

      bool has_more()
      {
        for (std::string line; next_line(line);)
          if (!trimmed(line).empty() && line[0] != '%')
            return true;
        return false;
      }

      [[noreturn]] void refuse(const std::string &what) const
      {
        throw InputError(name_ + ", line " + std::to_string(lines_.number()) + ": " + what);
      }

    private:
      bool next_line(std::string &line)
      {
        try
          {
            return lines_.next(line);
          }
        catch (const InputError &error)
          {
            refuse(error.what());
          }
      }

      std::string   name_;
      std::ifstream file_;
      TextLines     lines_;
    };

    /** A number of rows, columns or entries, or the place of one. */
    Eigen::Index whole(const double number, const double least, const double most, MatrixFile &file)
    {
      if (!(number >= least && number <= most) || number != std::floor(number))
        file.refuse("expected a whole number from " + number_text(least) + " to " +
                    number_text(most) + ", got " + number_text(number));
      return static_cast<Eigen::Index>(number);
    }
  } // namespace

  Eigen::MatrixXd read_parameter_matrix(const std::string &path)
  {
    MatrixFile file(path);
    const auto words = file.header();
    const bool known = words.size() == 5 && words[0] == "%%matrixmarket" && words[1] == "matrix" &&
                       (words[2] == "coordinate" || words[2] == "array") &&
                       (words[3] == "real" || words[3] == "integer") &&
                       (words[4] == "general" || words[4] == "symmetric");
    if (!known)
      file.refuse(
        "expected \"%%MatrixMarket matrix coordinate real symmetric\" (or array, general)");
    const bool by_place = words[2] == "coordinate", is_symmetric = words[4] == "symmetric";

    const std::vector<double> sizes = file.next(by_place ? 3 : 2);
    const Eigen::Index        rows  = whole(sizes[0], 1, largest_size, file),
                       columns      = whole(sizes[1], 1, largest_size, file);
    if (is_symmetric && rows != columns)
      file.refuse("a symmetric matrix must have as many columns as rows");
    Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(rows, columns);
    const auto      set    = [&](const Eigen::Index i, const Eigen::Index j, const double value) {
      if (is_symmetric && j > i)
        file.refuse("a symmetric matrix must not have entries above its diagonal");
      matrix(i, j) = value;
      if (is_symmetric)
        matrix(j, i) = value;
    };
    if (by_place)
      {
        const Eigen::Index n =
          whole(sizes[2], 0, static_cast<double>(rows) * static_cast<double>(columns), file);
        for (Eigen::Index k = 0; k < n; ++k)
          {
            const std::vector<double> entry = file.next(3);
            set(whole(entry[0], 1, rows, file) - 1,
                whole(entry[1], 1, columns, file) - 1,
                entry[2]);
          }
      }
    else
      for (Eigen::Index j = 0; j < columns; ++j)
        for (Eigen::Index i = is_symmetric ? j : 0; i < rows; ++i)
          set(i, j, file.next(1).front());
    if (file.has_more())
      file.refuse("the file has more entries than its header states");
    return matrix;
  }
} // namespace vfife
