// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "robotlink/base/Clock.h"

namespace robotlink {
class Session;
}

namespace widgets {

class ReplayControl;

/// Moves what all views show from instant to instant: it steps open logs, so that the programs run on them as
/// when they are played, or looks back in what is kept of live robots. The destructor returns to what was
/// shown before. GUI thread; session and control must outlive it.
class ExportClock {
 public:
  ExportClock(robotlink::Session& session, ReplayControl& replay);
  ~ExportClock();
  ExportClock(const ExportClock&) = delete;
  ExportClock& operator=(const ExportClock&) = delete;

  /// Asks for an instant, which should not be before the last one: logs are slow when played backward.
  void show(robotlink::Instant time);
  /// Whether the views show it when they are ticked next.
  bool hasArrived() const;
  /// The reason why it never will; empty: nothing is wrong.
  std::string problem() const;

 private:
  struct Reply;
  void request(robotlink::Instant time);

  robotlink::Session& session_;
  ReplayControl& replay_;
  const bool isLog_;
  /// The instant that was shown before; `before_` is unset if that was live.
  std::optional<robotlink::Instant> before_;
  /// The answer of the log to the last request, shared with its handler.
  std::shared_ptr<Reply> reply_;
  /// The number of platforms that had been opened at the beginning.
  std::uint64_t generation_ = 0;
};

}  // namespace widgets
