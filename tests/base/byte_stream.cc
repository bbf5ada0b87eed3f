// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
// Values of all kinds come back from bytes; too few bytes are refused.
#include "../refusal.h"
#include "../tests.h"

#include <vfife/base/errors.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/table.h>

using namespace vfife;

namespace
{
  struct Values
  {
    double                                      number = 0;
    bool                                        answer = false;
    std::string                                 text;
    Vector3                                     vector = Vector3::Zero();
    RigidMotion                                 motion;
    std::vector<std::vector<Vector3>>           lists;
    std::vector<std::pair<std::string, double>> pairs;

    void serialize(ByteStream &stream)
    {
      stream.pass(number, answer, text, vector, motion, lists, pairs);
    }
  };

  template <typename Function>
  void refuse(const Function &function)
  {
    print_refusal([&] { function(); });
  }
} // namespace

int main()
{
  Values values;
  values.number                = 1. / 3;
  values.answer                = true;
  values.text                  = std::string("a\0b", 3);
  values.vector                = Vector3(1, 2, 3);
  values.motion.rotation       = rotation_about(Vector3::UnitX(), 1);
  values.motion.translation[1] = 7;
  values.lists                 = {{}, {Vector3(4, 5, 6), Vector3(7, 8, 9)}};
  values.pairs                 = {{"x", 1}, {"", 2}};
  ByteStream written;
  values.serialize(written);
  ByteStream stored(written.bytes());
  Values     again;
  again.serialize(stored);
  check("directions", !written.reads() && stored.reads());
  check("numbers and texts",
        again.number == values.number && again.answer && again.text == values.text);
  check("vectors and motions",
        again.vector == values.vector && again.motion.rotation == values.motion.rotation &&
          again.motion.translation == values.motion.translation);
  check("lists", again.lists == values.lists && again.pairs == values.pairs);

  Table table;
  table.add_column("length", "mm");
  table.add_text_column("name");
  table.add_row({1.5, "one"});
  table.add_row({2.5, "two"});
  ByteStream rows;
  table.serialize_rows(rows);
  const std::string last = table.csv_row(1);
  table.clear_rows();
  ByteStream stored_rows(rows.bytes());
  table.serialize_rows(stored_rows);
  check("rows of a table", table.n_rows() == 2 && table.csv_row(1) == last);

  refuse([&] {
    ByteStream part(written.bytes().substr(0, written.bytes().size() - 1));
    again.serialize(part);
  });
  refuse([&] {
    Table other;
    other.add_column("length", "m");
    ByteStream from(rows.bytes());
    other.serialize_rows(from);
  });
}
