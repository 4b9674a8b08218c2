// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <vector>

#include "app/core/program/HostedProgram.h"
#include "app/core/program/ProgramExecutor.h"

namespace robotlink {
class Platform;
}

namespace app {

class RobotHost;

/// The time that a module may take, in real time, before it counts as not returning.
inline constexpr std::chrono::milliseconds kModulePatience{2000};

/// Programs with modules that had not returned when their executors were ended, and these executors: nothing
/// can end such a module, so both exist until it returns. What the modules use (platforms, clocks) must
/// outlive this object, whose destructor waits for them.
class LeftOverPrograms {
 public:
  LeftOverPrograms();
  ~LeftOverPrograms();
  LeftOverPrograms(const LeftOverPrograms&) = delete;
  LeftOverPrograms& operator=(const LeftOverPrograms&) = delete;

  /// Whether robots get other platforms, too, so that those of programs that have not returned are taken
  /// over.
  enum class Platforms : bool { kStay, kReplaced };
  /// Ends an executor, which may be null. Of these robots, the programs that have not returned by then are
  /// taken over; the others stay.
  void end(std::unique_ptr<ProgramExecutor> executor, const std::vector<RobotHost*>& robots,
           Platforms platforms = Platforms::kStay);
  /// Destroys what has returned meanwhile.
  void forgetEnded();
  /// Whether all have returned. Any thread, while none of the others is called.
  bool haveEnded() const;

 private:
  struct LeftOver;
  std::vector<LeftOver> all_;
};

}  // namespace app
