// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/platforms/simulated/game/GameRules.h"
#include "robotlink/base/Clock.h"
#include "robotlink/base/Geometry.h"

namespace robotcontrol {
class TeamMessage;
class TeamMessages;
class TeamRadioSettings;
}  // namespace robotcontrol

namespace simcore {
class StateStream;
}

namespace app {

/// The simulated radio by which robots of a team hear each other: what one sends arrives at the others of its
/// team after a delay, unless they are too far away or it is lost. Which messages are lost follows from the
/// seed and how many each robot has sent, so it is the same for any number of threads.
///
/// One thread at a time.
class TeamRadio {
 public:
  using Message = std::shared_ptr<const robotcontrol::TeamMessage>;
  using Messages = std::shared_ptr<const robotcontrol::TeamMessages>;
  /// A robot that can send and receive.
  struct Station {
    std::string robot;
    /// Empty: no robot receives its messages.
    std::string team;
    robotlink::Vector2 place = robotlink::Vector2::Zero();
  };

  explicit TeamRadio(std::uint64_t seed = 0) : seed_(seed) {}

  const RadioSettings& settings() const { return settings_; }
  /// For what is sent from now on.
  void setSettings(const RadioSettings& settings) { settings_ = settings; }
  /// Changes those that are set.
  void setSettings(const robotcontrol::TeamRadioSettings& settings);

  /// Discards all messages and statistics, and seeds the losses.
  void restart(std::uint64_t seed);
  /// Sets the positions of all robots that can receive, and drops messages in transit to others.
  void setStations(std::vector<Station> stations);
  /// Sends a message of a station; its sender and team are filled in.
  void send(const std::string& robot, const Message& message, robotlink::Instant now);
  /// Returns what a robot has received by now, the newest of each teammate, if there is something new
  /// since the last call; otherwise null. Instants do not decrease.
  Messages receive(const std::string& robot, robotlink::Instant now);

  /// Writes or reads the messages sent, in transit, and received. The remaining time of one in transit counts
  /// from `now`, since instants keep increasing when a world goes back.
  void transfer(simcore::StateStream& stream, robotlink::Instant now);

  /// The number of messages sent to other robots, and of those that did not arrive, since the start.
  std::uint64_t sent() const { return sent_; }
  std::uint64_t lost() const { return lost_; }

 private:
  struct OnTheWay {
    robotlink::Instant due;
    /// The number of its sender's message, from 1.
    std::uint64_t number = 0;
    Message message;
  };
  struct Heard {
    std::uint64_t number = 0;
    Message message;
  };
  struct Receiver {
    std::vector<OnTheWay> onTheWay;
    /// The newest message of each sender, by its name.
    std::map<std::string, Heard> heard;
  };
  bool arrives(const Station& from, const Station& to, std::uint64_t number) const;

  std::uint64_t seed_ = 0;
  RadioSettings settings_;
  std::vector<Station> stations_;
  /// The receiver of each robot, by its name.
  std::map<std::string, Receiver> receivers_;
  std::map<std::string, std::uint64_t> numbers_;
  std::uint64_t sent_ = 0, lost_ = 0;
};

}  // namespace app
