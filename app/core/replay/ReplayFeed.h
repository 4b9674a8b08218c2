// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "app/core/program/PlatformFeed.h"
#include "app/core/program/PublishGate.h"
#include "app/core/replay/Playback.h"
#include "app/core/replay/ReplayRun.h"
#include "robotcontrol/Requests.pb.h"

namespace app {

/// A ReplayRun in the workbench: played, stepped and jumped in as requests say, it tells a session what the
/// logs hold and what the programs say that run on them, and its own status on the stream "replay"; and a
/// recorder. Both must outlive it.
///
/// After a jump, the session is told anew, as a whole. While it is paused, what was asked of a program is
/// shown at once: the programs run again up to where the log stands.
class ReplayFeed final : public PlatformFeed {
 public:
  static constexpr const char* kAdapter = "log";

  static PlatformOpening opening(ReplayOptions options);
  /// Paused: at `time`, or, if that is not given, at the first image.
  static tl::expected<std::unique_ptr<ReplayFeed>, robotlink::Errors> create(
      ReplayOptions options, robotlink::Session& session, logplayer::Recorder& recorder,
      std::optional<robotlink::Instant> time = {});

  void begin() override;
  std::optional<PacedThread::Clock::time_point> due() override;
  void step() override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  void publishStatus() override;
  PlatformOpening::Made withLog(const std::filesystem::path& file, robotlink::Duration offset,
                                const logplayer::LogFile::Progress& progress) const override;

  robotlink::Instant now() const { return run_->now(); }
  /// With what was chosen since.
  ReplayOptions options() const;

 protected:
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override;
  robotlink::Result<void> requestSimulation(const robotcontrol::Request& request) override;
  robotlink::Result<void> requestReplay(const robotcontrol::Request& request) override;

 private:
  using Clock = PacedThread::Clock;
  using Change = std::function<robotlink::Errors()>;

  ReplayFeed(robotlink::Session& session, logplayer::Recorder& recorder)
      : session_(session), recorder_(recorder), outlet_(session, &recorder) {}
  ReplayRun::Listeners listeners();
  /// Plays as another one did that it takes the place of; both have logs in common.
  void playLike(const ReplayFeed& before);
  Playback::Place place() const;
  robotlink::Instant firstImage() const;
  /// That something failed for which nobody asked just now; it is paused.
  void publishFailure(const robotlink::Result<void>& done);
  /// What the change tells takes the place of all that was told; if it fails, that stays.
  robotlink::Errors republish(const Change& change);
  robotlink::Result<void> changed(const Change& change);
  robotlink::Result<void> jump(robotlink::Instant time);
  robotlink::Result<void> goTo(robotlink::Instant time);

  robotlink::Result<void> control(const robotcontrol::ControlReplay& control);
  robotlink::Result<void> set(const robotcontrol::ControlReplay& control);
  robotlink::Result<void> change(const robotcontrol::ControlReplay& control);
  robotlink::Result<void> act(const robotcontrol::ControlReplay& control);
  robotlink::Result<void> play();
  bool leads(robotlink::Instant to, int count) const;
  robotlink::Result<void> stepFrames(const robotcontrol::ControlReplay& control);
  robotlink::Result<void> stepMessages(const robotcontrol::ControlReplay& control);
  robotlink::Result<void> jumpToFrame(const robotcontrol::ControlReplay& control);

  robotlink::Session& session_;
  logplayer::Recorder& recorder_;
  PublishGate outlet_;
  std::unique_ptr<ReplayRun> run_;
  Playback playback_;
  bool stale_ =
      false;  // a program was asked for something that it has not yet done with the log where it stands
  Clock::time_point lastStatus_;
};

}  // namespace app
