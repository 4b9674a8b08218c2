// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/team/GameEnds.h"

#include <utility>

#include "robotcontrol/Game.pb.h"
#include "robotlink/packages/GamePackages.h"

namespace app {

using robotlink::Blocking;

GameEnds::GameEnds(robotlink::EndOwner& owner, std::shared_ptr<GameMail> mail)
    : mail_(std::move(mail)),
      state_(owner, robotlink::kGameState.name, Blocking::kNo),
      messages_(owner, robotlink::kTeamMessages.name, Blocking::kNo),
      message_(owner, robotlink::kTeamMessage.name, Blocking::kNo) {}

void GameEnds::exchange() {
  if (mail_->state && mail_->state != lastState_) {
    lastState_ = mail_->state;
    state_.send(mail_->state);
  }
  if (mail_->received) messages_.send(std::exchange(mail_->received, nullptr));
  if (message_.isNew())
    mail_->sent = std::static_pointer_cast<const robotcontrol::TeamMessage>(message_.value());
}

}  // namespace app
