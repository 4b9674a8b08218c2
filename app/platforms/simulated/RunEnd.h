// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace app {

class SimulatedRun;

/// Ends a run, whatever its modules do: a run with modules that never return is abandoned (Abandoned.h),
/// together with what its listeners use. One thread, that of the run.
class RunEnd {
 public:
  /// `used` is what the listeners and the recorder of the run are, or refer to; it may be null.
  explicit RunEnd(std::unique_ptr<SimulatedRun> run, std::shared_ptr<void> used = nullptr);
  ~RunEnd();
  RunEnd(const RunEnd&) = delete;
  RunEnd& operator=(const RunEnd&) = delete;

  SimulatedRun& run() const { return *run_; }

 private:
  std::shared_ptr<void> used_;
  /// The run; declared after what it uses.
  std::unique_ptr<SimulatedRun> run_;
};

}  // namespace app
