// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "logplayer/file/LogFile.h"

namespace logplayer {

/// The streams that the programs of a log's robots compute when they run on it and that the log itself lacks.
/// An interface, since logs know no programs. One thread.
class Computation {
 public:
  /// Called after each instant of the log, in order of time, with what was computed since the last call: with
  /// times of the log, not later than `reached`. The computation ends with the error that it returns.
  using Visit = std::function<robotlink::Result<void>(robotlink::Instant reached,
                                                      std::vector<robotlink::StreamMessage> messages)>;

  virtual ~Computation() = default;
  /// The full paths of the streams that can be computed.
  virtual std::vector<std::string> streams() const = 0;
  /// Runs the programs over the whole log, as fast as possible, and has these streams visited. Returns what
  /// went wrong meanwhile, one sentence each. Fails if a program cannot continue, or as `visit` does. To be
  /// called once.
  virtual robotlink::Result<std::vector<std::string>> run(const std::set<std::string>& streams,
                                                          const Visit& visit) = 0;
};

/// Makes the programs of a log. Fails if they cannot be made.
using MakeComputation =
    std::function<robotlink::Result<std::unique_ptr<Computation>>(const std::shared_ptr<LogFile>& log)>;

/// The way in which streams that a log lacks are searched.
struct ComputedStreams {
  /// Called if an expression names such streams; empty: only what is in the log can be searched.
  MakeComputation make = {};
  /// Called before the programs run, with the streams that they compute; may be empty.
  std::function<void(const std::set<std::string>& streams)> begins = {};
};

}  // namespace logplayer
