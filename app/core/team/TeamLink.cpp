// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/team/TeamLink.h"

#include <algorithm>
#include <utility>

#include "app/core/team/TeamDatagram.h"
#include "robotcontrol/Game.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/process/Platform.h"

namespace app {
namespace {

/// A message that was overtaken on its way is at most this much older; a larger difference means that the
/// robot has restarted.
constexpr robotlink::Duration kOvertaken = std::chrono::seconds(1);
/// The most messages taken in a step, so that nobody holds it up, and the most robots whose newest is kept.
constexpr int kMaxTaken = 100;
constexpr std::size_t kMaxSenders = 100;

constexpr char kUnnamedTeam[] = "team";

bool isOvertaken(const robotcontrol::TeamMessage& message,
                 const std::shared_ptr<const robotcontrol::TeamMessage>& newest) {
  if (!newest) return false;
  const auto older = robotlink::instant(newest->timestamp()) - robotlink::instant(message.timestamp());
  return older > robotlink::Duration() && older < kOvertaken;
}

}  // namespace

TeamLink::TeamLink(std::unique_ptr<TeamSocket> socket, std::string robot, std::string team)
    : socket_(std::move(socket)), robot_(std::move(robot)), team_(std::move(team)) {}

robotlink::Result<std::unique_ptr<TeamLink>> TeamLink::open(const TeamLinkOptions& options,
                                                            const std::string& robot,
                                                            const std::string& team) {
  auto socket = TeamSocket::open(options.port.value_or(0), options.peers);
  if (!socket) return tl::unexpected(socket.error());
  const std::string known = team.empty() ? kUnnamedTeam : team;
  return std::unique_ptr<TeamLink>(
      new TeamLink(std::move(*socket), robot, options.team.empty() ? known : options.team));
}

robotlink::Result<void> TeamLink::attach(robotlink::Platform& platform) {
  const bool hasOwn = std::ranges::any_of(platform.senders(), [](const robotlink::AnySender* sender) {
    return sender->package() == robotlink::kTeamMessages.name;
  });
  if (hasOwn)
    return robotlink::failure(
        "team.platform", robot_ + " already exchanges its team messages through its platform", {}, {robot_});
  ends_ = std::make_unique<GameEnds>(platform, mail_);
  return {};
}

void TeamLink::step(robotlink::Instant now) {
  if (!ends_) return;
  if (hear()) {
    auto messages = std::make_shared<robotcontrol::TeamMessages>();
    robotlink::assign(*messages->mutable_timestamp(), now);
    for (const auto& [sender, message] : newest_) *messages->add_messages() = *message;
    mail_->received = std::move(messages);
  }
  ends_->exchange();
  send();
}

void TeamLink::send() {
  const auto message = std::exchange(mail_->sent, nullptr);
  if (!message) return;
  robotcontrol::TeamMessage signedMessage = *message;
  signedMessage.set_sender(robot_);
  signedMessage.set_team(team_);
  const auto datagram = teamDatagram(signedMessage);
  if (!datagram) {
    ++counts_.leftOut;
    return;
  }
  socket_->send(*datagram);
  ++counts_.sent;
}

bool TeamLink::hear() {
  bool isNew = false;
  for (int i = 0; i < kMaxTaken; ++i) {
    const auto datagram = socket_->receive();
    if (!datagram) break;
    const auto message = teamMessageIn(*datagram);
    const bool isForUs = message && (*message)->team() == team_ && (*message)->sender() != robot_ &&
                         (newest_.size() < kMaxSenders || newest_.contains((*message)->sender()));
    if (!isForUs) {
      ++counts_.leftOut;
      continue;
    }
    ++counts_.heard;
    auto& newest = newest_[(*message)->sender()];
    if (isOvertaken(**message, newest)) continue;
    newest = *message;
    isNew = true;
  }
  return isNew;
}

}  // namespace app
