// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/core/platform/PlatformFeed.h"
#include "app/core/platform/PublishGate.h"
#include "app/platforms/replay/Playback.h"
#include "app/platforms/replay/ReplayRun.h"
#include "robotcontrol/Requests.pb.h"

namespace app {

class HostingMemory;

/// A ReplayRun in the workbench: it is played, stepped and moved by jumps as the user requests, and publishes
/// to a session what the logs contain, what the programs that run on them send, and its own status on the
/// stream "replay". A recorder gets the same. Session and recorder must outlive it.
///
/// After a jump, the whole history of the session is replaced. In a pause, a request to a program is answered
/// at once, and then its effect becomes visible: the programs run again up to the present instant.
class ReplayFeed final : public PlatformFeed {
 public:
  /// The name of its PlatformAdapter.
  static constexpr const char* kAdapter = "log";

  /// Returns the opening of logs for PlatformThread.
  static PlatformOpening opening(ReplayOptions options);
  /// Opens the logs, paused at `time` or, if that is not given, at the first image. Fails with all reasons if
  /// that is impossible.
  static tl::expected<std::unique_ptr<ReplayFeed>, robotlink::Errors> create(
      ReplayOptions options, robotlink::Session& session, logplayer::Recorder& recorder,
      std::optional<robotlink::Instant> time = {});

  /// Publishes what the last jump has collected, and the status.
  void begin() override;
  /// While it plays, also the times at which the status is due.
  std::optional<robotlink::PacedThread::Clock::time_point> due() override;
  void step() override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  /// Publishes the streams "replay" and "recording".
  void publishStatus() override;
  void setDemand(const Demand& demand) override;
  std::vector<std::string> end() override;
  bool hasEnded() const override { return !run_ || run_->hasEnded(); }
  /// Opens the same logs and one more at the present instant; playback and choices are inherited.
  PlatformOpening::Made withLog(const std::filesystem::path& file, robotlink::Duration offset,
                                const logplayer::LogFile::Progress& progress) const override;

  /// Whether there is a handler for requests of this kind, other than those to robots.
  static bool fulfills(const robotcontrol::Request& request);
  /// The present instant of the timeline.
  robotlink::Instant now() const { return run_->now(); }
  /// The options with which it was created, updated by what the user chose since.
  ReplayOptions options() const;

 protected:
  /// Passes a request to a robot's program. STOP pauses the log.
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override;
  /// Only where programs run counts here: nothing is simulated.
  robotlink::Result<void> requestSimulation(const robotcontrol::Request& request) override;
  /// Controls playback, packages and offsets.
  robotlink::Result<void> requestReplay(const robotcontrol::Request& request) override;

 private:
  using Clock = robotlink::PacedThread::Clock;
  using Change = std::function<robotlink::Errors()>;

  ReplayFeed(robotlink::Session& session, logplayer::Recorder& recorder)
      : session_(session), recorder_(recorder), gate_(session, &recorder) {}
  /// Listeners that publish.
  ReplayRun::Listeners listeners();
  /// Inherits playback and step process from the feed that this one replaces; both have logs in common.
  void playLike(const ReplayFeed& before);
  /// The position in the logs.
  Playback::Place place() const;
  /// The time of the first image of the robot by which the logs are stepped; without images the first frame
  /// of the step process; else the beginning.
  robotlink::Instant firstImage() const;
  /// Pauses and publishes an error if something failed that no request is waiting for.
  void publishFailure(const robotlink::Result<void>& done);
  /// Makes a change and replaces the history of the session by what it publishes. If the change fails, the
  /// session keeps its history.
  robotlink::Errors republish(const Change& change);
  /// The same, with the first error only.
  robotlink::Result<void> changed(const Change& change);
  /// Jumps to an instant, or to the nearer end of the logs.
  robotlink::Result<void> jump(robotlink::Instant time);
  /// Steps forward to a near instant, which keeps the history; jumps to others.
  robotlink::Result<void> goTo(robotlink::Instant time);

  /// Fulfills all parts of a request: settings, choices, then the action.
  robotlink::Result<void> control(const robotcontrol::Request& request);
  struct Handlers;
  /// Applies settings that change no program: speed, loop, gaps, range, step process. All or none.
  robotlink::Result<void> set(const robotcontrol::ControlReplay& control);
  /// Applies what restarts the programs: sources of packages, and offsets.
  robotlink::Result<void> change(const robotcontrol::ControlReplay& control);
  /// Plays, pauses, steps or jumps.
  robotlink::Result<void> act(const robotcontrol::ControlReplay& control);
  /// Plays from the present instant; at the end, from the first image.
  robotlink::Result<void> play();
  robotlink::Result<void> stop(const robotcontrol::Request& request);
  /// In a pause, publishes the results of requests that the programs have not processed yet.
  void publishAnswers();
  /// Whether a step by `count` that ends at `to` moves in its direction; at the ends of the logs it does not.
  bool leads(robotlink::Instant to, int count) const;
  robotlink::Result<void> stepFrames(const robotcontrol::ControlReplay& control);
  robotlink::Result<void> stepMessages(const robotcontrol::ControlReplay& control);
  robotlink::Result<void> jumpToFrame(const robotcontrol::ControlReplay& control);

  robotlink::Session& session_;
  logplayer::Recorder& recorder_;
  /// Publishes to the session from begin() on; closed during jumps.
  PublishGate gate_;
  /// Whether it has readers.
  bool isRead_ = true;
  std::unique_ptr<ReplayRun> run_;
  /// Remembers where the user lets programs run; may be null.
  HostingMemory* hosting_ = nullptr;
  Playback playback_;
  /// A program got a request whose effect at the present instant is not published yet.
  bool stale_ = false;
  /// The time at which the status was last published.
  Clock::time_point lastStatus_;
};

}  // namespace app
