// Copyright (C) 2026 by the vfife authors. SPDX-License-Identifier: LGPL-2.1-or-later
#include <vfife/base/process/log.h>
#include <vfife/base/text/byte_stream.h>
#include <vfife/dynamics/watch/contact_watch.h>

namespace vfife
{
  namespace
  {
    /** Chatter must not fill the log: later losses are counted only. */
    constexpr unsigned int most_lines = 20;
  } // namespace

  ContactWatch::ContactWatch(Log &log)
    : log_(log)
  {
  }

  void ContactWatch::reset()
  {
    losses_  = ContactLosses();
    touched_ = false;
  }

  void ContactWatch::observe(const double time, const double dt, const bool touching)
  {
    // A loss: nothing presses any more after a step in which something did.
    if (touched_ && !touching)
      {
        if (losses_.count == 0)
          losses_.first = time;
        ++losses_.count;
        if (losses_.count <= most_lines)
          log_.line("contact is lost at time ",
                    1e3 * time,
                    " ms",
                    losses_.count == most_lines ? "; further losses are counted only" : "");
      }
    // Before the first loss nothing has been lost: a run may begin apart.
    if (!touching && losses_.count > 0)
      losses_.duration += dt;
    touched_ = touching;
  }

  void ContactWatch::serialize(ByteStream &stream)
  {
    stream.pass_record(losses_);
    stream.pass(touched_);
  }

  const ContactLosses &ContactWatch::losses() const
  {
    return losses_;
  }
} // namespace vfife
