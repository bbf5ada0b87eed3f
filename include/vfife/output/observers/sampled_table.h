// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#ifndef vfife_output_observers_sampled_table_h
#define vfife_output_observers_sampled_table_h

#include <vfife/base/text/byte_stream.h>
#include <vfife/base/text/column_names.h>
#include <vfife/base/text/sample_columns.h>
#include <vfife/model/observer.h>
#include <vfife/model/state.h>
#include <vfife/output/files/csv_stream.h>

#include <cstdint>
#include <string>
#include <vector>

namespace vfife
{
  /**
   * A table that gets rows every so many steps of a run: the time, then what a derived class shows
   * of the state, nothing, one sample or several. It grows line by line as a .csv file, and stays
   * in memory on all ranks for later analysis. Checkpoints hold the rows.
   */
  template <typename Sample>
  class SampledTable : public Observer
  {
  public:
    bool due(const State &state) const override
    {
      return state.step % steps_between_ == 0;
    }

    void observe(const Model &model, const State &state) override
    {
      // The last state of a run is shown even off the grid of samples, where it would break the
      // equal intervals.
      if (!due(state))
        return;
      add_rows(model, state);
      file_.append_new_rows(table_);
    }

    std::string part_name() const override
    {
      return name_;
    }

    void serialize(ByteStream &stream) override
    {
      table_.serialize_rows(stream);
      if (stream.reads())
        file_.rewrite(table_);
    }

    void finish(const Model &, const State &) override
    {
      file_.finish(table_);
    }

    const Table &table() const
    {
      return table_;
    }

  protected:
    /**
     * Samples every @p steps_between steps (>= 1) into the file @p name. Throws std::runtime_error
     * when it cannot be opened.
     */
    SampledTable(const OutputFolder          &folder,
                 const std::string           &name,
                 const SampleColumns<Sample> &columns,
                 const std::uint64_t          steps_between)
      : name_(name)
      , steps_between_(steps_between)
      , columns_(columns)
      , table_(columns.make_table(column::time, "s"))
      , file_(folder, name, table_)
    {
    }

    /** One sample of the state. */
    void add_row(const State &state, const Sample &sample)
    {
      table_.add_row(columns_.make_row(state.time, sample));
    }

  private:
    /** Calls add_row() for each sample of a state that is due; on all ranks. */
    virtual void add_rows(const Model &model, const State &state) = 0;

    std::string           name_; ///< of the file
    std::uint64_t         steps_between_;
    SampleColumns<Sample> columns_;
    Table                 table_;
    CsvStream             file_;
  };
} // namespace vfife

#endif
