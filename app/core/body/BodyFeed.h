// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "app/core/body/BodyRefusal.h"
#include "app/core/body/RemoteBodyPlatform.h"
#include "app/core/own/OwnProgram.h"
#include "app/core/platform/HostingChoices.h"
#include "app/core/platform/PlatformFeed.h"
#include "app/core/platform/PublishGate.h"
#include "app/core/program/LeftOverPrograms.h"
#include "app/core/program/RecordingTap.h"
#include "app/core/program/RobotHost.h"
#include "app/core/remote/LinkAccess.h"
#include "app/core/remote/LinkLimits.h"
#include "app/core/spread/SpreadProgram.h"

namespace app {

class HostingMemory;

/// A body elsewhere and the program that runs for it here. A plain value.
struct BodyOptions {
  /// "ws://HOST:PORT" or "wss://...".
  std::string url;
  /// Empty: the one that is remembered for this URL.
  std::string token = {};
  /// Whether a robot with a new certificate is believed.
  TrustRule isTrusted = askWhomToTrust();
  /// The robot whose body it is; empty: the first that is offered there.
  std::string robot = {};
  /// The file of the process layout; empty: that of its kind.
  std::filesystem::path layout = {};
  /// The file of the map by which it drives; empty if it knows none.
  std::filesystem::path map = {};
  /// Maps tasks to the solutions at the start, instead of the layout's.
  std::map<std::string, std::string> solutions = {};
  /// What the connection may carry, where no memory has it.
  LinkLimits limits = {};
  /// Gets why the body refuses the connection once it is open; may be null.
  std::shared_ptr<BodyRefusal> refusal = nullptr;
  /// What the user chose for this robot when it was open before.
  ProgramOverrides overrides = {};
  /// How long the body is looked for while nothing comes that says more about it.
  robotlink::Duration patience = std::chrono::seconds(5);
  /// Whether the program runs in a process of the operating system of its own.
  HostingChoices hosting = {};
  /// How it is run there; always with threads, in real time.
  OwnProgram::Options own = {};
  /// Which of the layout's programs it is, if other programs run the other processes.
  SpreadOptions spread = {};
  /// Gets sentences about the other programs, from any thread; empty: they go to the robot's log.
  std::function<void(const std::string& text)> spreadReport = {};
};

/// A robot whose body is elsewhere, as its server says.
struct FoundBody {
  HostedRobot robot;
  robotcontrol::BodyOffer offer;
};

/// A robot whose body is elsewhere (`robotctl platform ... --listen`), while its program runs here in real
/// time, each process in a thread of its own. Publishes to a session what robot and program send, and to the
/// recorder what a log may contain; both must outlive it.
///
/// It is made as a whole or refused with all reasons; the body must be within reach then. Later the
/// connection is lost and found again by itself.
class BodyFeed final : public PlatformFeed {
 public:
  /// The name of its PlatformAdapter.
  static constexpr const char* kAdapter = "body";

  /// Returns the opening for PlatformThread. The robot's overrides are those of the last time it was open. If
  /// the body objects to what a person can decide, the errors say so: questionIn().
  static PlatformOpening opening(BodyOptions options);
  /// `hosting` remembers what the user chooses, and `limits` knows what the connection may carry; they may be
  /// null, otherwise they must outlive the feed.
  static tl::expected<std::unique_ptr<BodyFeed>, robotlink::Errors> create(
      BodyOptions options, robotlink::Session& session, logplayer::Recorder& recorder,
      HostingMemory* hosting = nullptr, const LinkLimitsMemory* limits = nullptr);
  ~BodyFeed() override;
  /// Looks for the body only.
  static tl::expected<FoundBody, robotlink::Errors> find(BodyOptions options);

  void begin() override;
  std::optional<PacedThread::Clock::time_point> due() override { return due_; }
  void step() override;
  robotlink::Errors setLayout(const std::filesystem::path& file) override;
  LoadedPlatform describe() const override;
  void publishStatus() override;
  void setDemand(const Demand& demand) override;
  std::vector<std::string> end() override;
  bool hasEnded() const override { return leftOver_.haveEnded(); }
  std::shared_ptr<StopSwitch> stopSwitch() const override { return stopSwitch_; }
  std::map<std::string, ProgramOverrides> overrides() const override;

  const RemoteBodyPlatform& platform() const { return *platform_; }
  const BodyLink& link() const { return *link_; }
  const robotlink::Clock& clock() const { return clock_; }

 protected:
  robotlink::Result<void> requestRobot(const robotcontrol::Request& request) override;
  /// Only where the program runs counts here.
  robotlink::Result<void> requestSimulation(const robotcontrol::Request& request) override;

 private:
  using Clock = PacedThread::Clock;

  BodyFeed(BodyOptions options, robotlink::Session& session, logplayer::Recorder& recorder);
  /// Why a server has no body for this program, as it says itself; empty if it may still offer it.
  std::string whyNoBody() const;
  /// What a server has not said yet, so that its body is not known.
  std::string whatIsMissing() const;
  // In this order:
  robotlink::Errors findBody();
  robotlink::Errors describeRobot();
  robotlink::Errors startProgram();

  std::filesystem::path layoutFileInUse() const;
  tl::expected<RobotHost::Candidate, robotlink::Errors> makeProgram(
      std::unique_ptr<robotlink::Platform> platform, const std::filesystem::path& file);
  OwnProgram::Options ownOptions() const;
  /// Publishes a sentence about the other programs; any thread.
  void reportSpread(const std::string& text);
  void publishLostOverrides();
  robotlink::Errors hostProgram(const std::string& asked, const robotcontrol::HostProgram& choice);
  LinkLimits limits() const;
  void followLimits();
  /// Passes on why the body refuses the connection, such as by another certificate than before.
  void noteRefusal();
  /// Adopts a program and starts its threads.
  void adopt(RobotHost::Candidate program);
  void stopProgram();
  const std::string& name() const { return robot_->name(); }

  BodyOptions options_;
  /// Publishes to the session from begin() on.
  PublishGate gate_;
  /// Whether somebody reads that.
  bool isRead_ = true;
  logplayer::Recorder& recorder_;
  HostingMemory* hosting_ = nullptr;
  const LinkLimitsMemory* limits_ = nullptr;
  /// Its version when the connection got them.
  std::uint64_t limitsVersion_ = 0;
  robotlink::SteadyClock local_;
  BodyClock clock_{local_};
  std::unique_ptr<BodyLink> link_;
  std::unique_ptr<RecordingTap> tap_;
  /// Owned by robot_.
  RemoteBodyPlatform* platform_ = nullptr;
  /// Null if all processes run in this program.
  std::unique_ptr<SpreadProgram> spread_;
  std::unique_ptr<RobotHost> robot_;
  std::vector<std::string> lostChoices_;
  std::shared_ptr<StopSwitch> stopSwitch_;
  LeftOverPrograms leftOver_;
  std::unique_ptr<ProgramExecutor> executor_;
  /// When the next step is due, and when the status was last published.
  Clock::time_point due_, lastStatus_;
};

}  // namespace app
