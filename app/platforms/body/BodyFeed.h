// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "app/core/remote/LinkAccess.h"
#include "app/core/remote/LinkLimits.h"
#include "app/platforms/body/BodyRefusal.h"
#include "app/platforms/body/RemoteBodyPlatform.h"
#include "app/platforms/real/RealTimeFeed.h"

namespace app {

/// A remote body and the program that runs for it here. A plain value.
struct BodyOptions {
  /// "ws://HOST:PORT" or "wss://...".
  std::string url;
  /// Empty: the one that is remembered for this URL.
  std::string token = {};
  /// Whether a robot with a new certificate is believed.
  TrustRule isTrusted = askWhomToTrust();
  /// The robot whose body it is; empty: the first that is offered there.
  std::string robot = {};
  RealTimeOptions program = {};
  /// The limits of the connection, if no memory has them.
  LinkLimits limits = {};
  /// Gets why the body refuses the connection once it is open; may be null.
  std::shared_ptr<BodyRefusal> refusal = nullptr;
  /// The time to look for the body while no further information about it arrives.
  robotlink::Duration patience = std::chrono::seconds(5);
};

/// A robot whose body is remote, as its server says.
struct FoundBody {
  HostedRobot robot;
  robotcontrol::BodyOffer offer;
};

/// A robot whose body is remote (`robotctl platform ... --listen`), while its program runs here in real
/// time, each process in a thread of its own. Publishes to a session what robot and program send, and to the
/// recorder what a log may contain; both must outlive it.
///
/// It is made as a whole or refused with all reasons; the body must be within reach then. Later the
/// connection is lost and found again by itself.
class BodyFeed final : public RealTimeFeed {
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

  LoadedPlatform describe() const override;

  const RemoteBodyPlatform& platform() const { return *platform_; }
  const BodyLink& link() const { return *link_; }
  const robotlink::Clock& clock() const { return *clock_; }

 private:
  BodyFeed(BodyOptions options, robotlink::Session& session, logplayer::Recorder& recorder,
           HostingMemory* hosting, const LinkLimitsMemory* limits);
  void stepProgram() override;
  /// Returns a server's reason for having no body for this program; empty if it may still offer it.
  std::string whyNoBody() const;
  /// Names the information that a server has not sent yet, so that its body is not known.
  std::string whatIsMissing() const;
  // In this order:
  robotlink::Errors findBody();
  robotlink::Errors describeRobot();
  robotlink::Errors startProgram();

  LinkLimits limits() const;
  void followLimits();
  /// Passes on why the body refuses the connection, such as by another certificate than before.
  void noteRefusal();

  BodyOptions options_;
  const LinkLimitsMemory* const limits_;
  /// Its version when the connection got them.
  std::uint64_t limitsVersion_ = 0;
  robotlink::SteadyClock local_;
  std::unique_ptr<BodyLink> link_;
  /// These two belong to the program.
  BodyClock* clock_ = nullptr;
  RemoteBodyPlatform* platform_ = nullptr;
};

}  // namespace app
