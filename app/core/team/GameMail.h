// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

namespace robotcontrol {
class GameState;
class TeamMessage;
class TeamMessages;
}  // namespace robotcontrol

namespace app {

/// The messages exchanged between a robot's platform and the game in a step: the platform sends its program
/// what others have put here, and puts here what its program has sent. It outlives platforms, which are
/// replaced. One thread at a time.
struct GameMail {
  /// Null: there is no referee.
  std::shared_ptr<const robotcontrol::GameState> state = nullptr;
  /// The messages that arrived since the platform took them; null: none.
  std::shared_ptr<const robotcontrol::TeamMessages> received = nullptr;
  /// The message that was sent since it was taken; null: none.
  std::shared_ptr<const robotcontrol::TeamMessage> sent = nullptr;
};

}  // namespace app
