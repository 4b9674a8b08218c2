// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "app/core/team/GameMail.h"
#include "robotlink/process/Sender.h"

namespace robotcontrol {
class GameState;
class TeamMessage;
class TeamMessages;
}  // namespace robotcontrol

namespace app {

/// The ends of a robot's platform for a game: it sends game/state and team/messages, and receives
/// team/message.
class GameEnds {
 public:
  /// The owner, a platform, must outlive it.
  GameEnds(robotlink::EndOwner& owner, std::shared_ptr<GameMail> mail);
  /// Call this in each frame of the platform.
  void exchange();

 private:
  const std::shared_ptr<GameMail> mail_;
  robotlink::Sender<robotcontrol::GameState> state_;
  robotlink::Sender<robotcontrol::TeamMessages> messages_;
  robotlink::Receiver<robotcontrol::TeamMessage> message_;
  std::shared_ptr<const robotcontrol::GameState> lastState_;
};

}  // namespace app
