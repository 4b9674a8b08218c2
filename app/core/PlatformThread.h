// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "app/core/platform/PlatformFeed.h"
#include "robotlink/base/threads/PacedThread.h"

namespace logplayer {
class Recorder;
}
namespace robotlink {
class Session;
}

namespace app {

/// Runs one platform at a time (a simulation, a real robot, or logs) in a thread of its own, so that neither
/// the GUI nor its views slow it down. Opening another platform ends the present one once it is known that
/// the other one can be run.
///
/// All functions may be called from any thread and return at once. They enqueue jobs, which are executed in
/// order between two steps of the platform. Session and recorder must outlive this object.
class PlatformThread {
 public:
  /// Called in the platform's thread with a description of what runs now, or with the reasons why nothing was
  /// loaded, in which case what ran before continues.
  using LoadHandler = std::function<void(const tl::expected<LoadedPlatform, robotlink::Errors>&)>;

  /// Starts the thread; at first no platform runs.
  /// `hosting` and `limits` may be null, see PlatformContext; otherwise they must outlive this object.
  PlatformThread(robotlink::Session& session, logplayer::Recorder& recorder, HostingMemory* hosting = nullptr,
                 const LinkLimitsMemory* limits = nullptr);
  /// Ends the platform; its programs that hang are waited for only a moment, all together.
  ~PlatformThread();

  /// The handler is called in the platform's thread with what runs now when a request has changed which
  /// robots there are; before its result is passed to the session. To be set before anything is opened.
  void onRobotsChanged(LoadHandler handler);

  /// Opens a platform. It gets the overrides of the last one that had any, if that had the same adapter and
  /// sources.
  /// `progress` is called while its file is read; may be empty.
  void open(PlatformOpening opening, logplayer::LogFile::Progress progress, LoadHandler handler);
  /// Retries a lost connection to a robot at once.
  void connectNow();
  /// Adds a log to those that are open; what the user chose for these stays. `offset` is added to its times.
  void addLog(std::filesystem::path file, robotlink::Duration offset, logplayer::LogFile::Progress progress,
              LoadHandler handler);
  /// Restarts the programs of the platform in another layout; with a name only those of that robot or team.
  void setLayout(std::filesystem::path file, LoadHandler handler, std::string name = {});
  /// Reads the file of what runs again and continues in it, see PlatformFeed::reload(); where that is
  /// impossible, its PlatformFeed::reopening() is opened instead, as open() does. One of the handlers is
  /// called.
  void reload(FileTexts texts, bool mustFit, LoadHandler inPlace, LoadHandler opened);
  /// Ends the platform, as the destructor does; none runs then.
  void close(LoadHandler handler);
  /// Fulfills a request to a robot or to the platform; the session gets one result for each. Moves in a log
  /// that are requested faster than they can be made are joined: the newest of several jumps counts, and
  /// steps add up. STOP goes before all that waits, unless the platform that runs has no such robot; that of
  /// a real robot also acts at once.
  void request(const robotcontrol::Request& request);
  /// Sets which data of the session is read, also for platforms that are opened later.
  void setDemand(const PlatformFeed::Demand& demand);

 private:
  /// Called before the platform is closed, without waiting for its thread.
  void endWaits();
  /// A request in the queue, with the ids of those that were joined with it.
  struct Asked;
  /// The last platform with overrides, in case it is opened again.
  struct Ended {
    std::string adapter;
    std::vector<std::string> sources;
    /// Keyed by robot.
    std::map<std::string, ProgramOverrides> overrides;
  };
  /// Ends the platform, if there is one; what it reports about its end is kept.
  void endFeed();
  /// Replaces the platform (null: by none) and restarts the session with it.
  void start(std::unique_ptr<PlatformFeed> feed);
  /// The overrides with which a platform is opened: those of the one that runs, or of the last one that had
  /// any, if that has the same adapter and sources.
  std::map<std::string, ProgramOverrides> overridesFor(const PlatformOpening& opening) const;
  /// Describes what runs now.
  LoadedPlatform describe() const;
  /// Fulfills a request and pushes the result for each of the ids, unless the program will answer.
  void fulfill(const robotcontrol::Request& request, const std::vector<std::uint64_t>& ids);
  /// Refuses the requests that the platform's programs did not answer; the session ignores those that they
  /// did.
  void refuseForwarded();
  /// An empty refusal means that the request was accepted.
  void pushResult(std::uint64_t id, const std::string& refusal);
  /// Fulfills STOP at once if there is such a robot, otherwise after the earlier requests.
  void stop(const robotcontrol::Request& request);
  /// Enqueues a job that no move can be joined across.
  void postOther(robotlink::PacedThread::Job job);

  robotlink::Session& session_;
  logplayer::Recorder& recorder_;
  HostingMemory* const hosting_;
  const LinkLimitsMemory* const limits_;
  /// Null if no platform runs. Only in the platform's thread.
  std::unique_ptr<PlatformFeed> feed_;
  /// Only in the platform's thread.
  PlatformFeed::Demand demand_;
  /// Only in the platform's thread.
  Ended ended_;
  /// Requests that were forwarded to a program of this platform, the newest last. Only in the platform's
  /// thread.
  std::deque<std::uint64_t> forwarded_;
  /// The reports of the previous platform about its end. Only in the platform's thread.
  std::vector<std::string> reportedAtEnd_;
  /// PlatformContext::memory by the adapter's name. Only in the platform's thread.
  std::map<std::string, std::any> memories_;

  /// See onRobotsChanged(); may be empty.
  LoadHandler robotsChanged_;

  /// Protects newest_ and stopSwitch_.
  std::mutex mutex_;
  /// The STOP switch of the running platform; null if it has none.
  std::shared_ptr<StopSwitch> stopSwitch_;
  /// The last request in the queue, if it only moves a log and so may be joined with the next one; otherwise
  /// null.
  std::shared_ptr<Asked> newest_;
  /// The last member, since the thread uses the others.
  robotlink::PacedThread thread_;
};

}  // namespace app
