// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/core/program/PacedThread.h"
#include "app/core/program/PlatformFeed.h"

namespace logplayer {
class Recorder;
}
namespace robotlink {
class Session;
}

namespace app {

/// Runs one platform at a time, a simulation or logs, in a thread of its own: never on the GUI's thread, and
/// no view slows it. Opening another one ends the one before, once it is known that the other can be run.
///
/// All functions may be called from any thread and return at once; what they ask for is done in their order,
/// between two steps. Session and recorder must outlive it.
class PlatformThread {
 public:
  /// Called in the platform's thread: what runs now, or why what ran before goes on.
  using LoadHandler = std::function<void(const tl::expected<LoadedPlatform, robotlink::Errors>&)>;

  PlatformThread(robotlink::Session& session, logplayer::Recorder& recorder);

  void open(PlatformOpening opening, LoadHandler handler);
  /// Where a robot at the end of a line is not connected, tries it again at once.
  void connectNow();
  /// One more to the logs that are open; what was chosen for those stays.
  void addLog(std::filesystem::path file, robotlink::Duration offset, logplayer::LogFile::Progress progress,
              LoadHandler handler);
  void setLayout(std::filesystem::path file, LoadHandler handler);
  /// Nothing runs then.
  void close(LoadHandler handler);
  /// Requests for robots and for what runs; each is answered once, to the session. Jumps and steps in a log
  /// that are asked for faster than they are done are made one: of jumps the newest counts, steps add up.
  void request(const robotcontrol::Request& request);

 private:
  struct Asked;
  /// What was open last of what keeps choices, for when it is opened again.
  struct Ended {
    std::string adapter;
    std::vector<std::string> sources;
    std::map<std::string, ProgramOverrides> overrides;  // by the robots' names
  };
  void start(std::unique_ptr<PlatformFeed> feed);
  LoadedPlatform describe() const;
  void fulfil(const robotcontrol::Request& request, const std::vector<std::uint64_t>& ids);
  void postOther(PacedThread::Job job);

  robotlink::Session& session_;
  logplayer::Recorder& recorder_;
  std::unique_ptr<PlatformFeed> feed_;  // the platform's thread only; null: nothing runs
  Ended ended_;                         // the platform's thread only

  std::mutex mutex_;                        // protects newest_ and stopSwitch_
  std::shared_ptr<StopSwitch> stopSwitch_;  // of the robot that runs; null: none
  std::shared_ptr<Asked>
      newest_;          // what was asked for last, if it still waits and another request may join it
  PacedThread thread_;  // last: it uses the others
};

}  // namespace app
