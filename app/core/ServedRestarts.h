// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <utility>

#include "app/core/deploy/RunningPrograms.h"
#include "app/core/platform/PlatformFeed.h"
#include "robotlink/base/BoundedQueue.h"

namespace robotlink {
class Session;
}

namespace app {

class PlatformThread;

/// Restarts programs of served robots, so that they read the deployed files, and knows which ones they have
/// read. A robot stands still until its new program commands it; what users chose for it stays, including
/// STOP.
///
/// One thread, that of Session::tick(), unless it says otherwise. Session and platform must outlive it.
class ServedRestarts {
 public:
  /// Called with the reason why it was not done; empty if it was.
  using Done = std::function<void(const std::string& why)>;

  ServedRestarts(robotlink::Session& session, PlatformThread& platform);
  ~ServedRestarts();
  ServedRestarts(const ServedRestarts&) = delete;
  ServedRestarts& operator=(const ServedRestarts&) = delete;

  /// Starts the program of a robot again; with the file of a layout in that one, which concerns all robots of
  /// the platform. Any thread.
  void ask(const std::string& robot, const std::filesystem::path& layout, Done done);
  /// The programs that run now.
  void setLoaded(const LoadedPlatform& loaded);
  /// Fulfills the requests.
  void tick();
  RunningPrograms& programs() { return *programs_; }
  /// Whether programs run in another layout since the last call.
  bool takeChanged() { return std::exchange(hasChanged_, false); }

 private:
  struct Asked {
    std::string robot;
    std::filesystem::path layout;
    Done done;
  };
  using Loaded = tl::expected<LoadedPlatform, robotlink::Errors>;
  struct Outcome {
    Loaded loaded;
    Done done;
  };

  void begin(Asked asked);
  void finish(const Outcome& outcome);

  robotlink::Session& session_;
  PlatformThread& platform_;
  std::uint64_t listener_;
  /// The following three are shared with handlers in other threads.
  const std::shared_ptr<RunningPrograms> programs_ = std::make_shared<RunningPrograms>();
  robotlink::BoundedQueue<Asked> asked_{100};
  const std::shared_ptr<robotlink::BoundedQueue<Outcome>> outcomes_;
  bool hasChanged_ = false;
};

}  // namespace app
