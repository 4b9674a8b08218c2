// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of ClientSession: names of states, descriptions, reasons of timeouts.
#include "robotlink/arcos/ClientSession.h"

namespace robotlink::arcos {
namespace {

using State = ClientSession::State;

}  // namespace

/// The reason for a timeout, as far as the received bytes allow to tell.
Error ClientSession::silence() const {
  if (damages_ > 0 && !heard_) {
    return {
        "arcos.only-damage",
        "the robot's bytes do not form valid packets: set the serial line to the robot's baud rate (usually "
        "9600), and check that this is a robot",
        {},
        {}};
  }
  if (state_ == State::kOpening) {
    return {
        "arcos.no-information", "the robot answers, but sends no standard information after OPEN", {}, {}};
  }
  return {
      "arcos.no-answer",
      "no answer to SYNC" + std::to_string(sync_) +
          ": check that the robot is turned on and connected, that the address is right, and that no other "
          "client drives it",
      {},
      {}};
}

std::string ClientSession::describe() const {
  const std::string after = problem_ ? " (" + problem_->text + ")" : "";
  switch (state_) {
    case State::kClosed:
      return "closed";
    case State::kPausing:
      return "waits " + std::to_string(std::chrono::duration_cast<std::chrono::seconds>(pause_).count()) +
             " s before it connects again" + after;
    case State::kWaitingForLink:
      return "opens the line" + after;
    case State::kSynchronizing:
      return "sent SYNC" + std::to_string(sync_) + ", try " + std::to_string(tries_ + 1) + " of " +
             std::to_string(options_.syncTries) + after;
    case State::kResynchronizing:
      return "waits until the robot is silent" + after;
    case State::kOpening:
      return "waits for the robot's configuration and standard information";
    case State::kConnected:
      return "connected to " + identity_->name + " (" + identity_->robotClass + ", " + identity_->subclass +
             ")" + (configured_ ? "" : "; the robot has not reported its configuration");
    case State::kFailed:
      return "has given up" + after;
  }
  return "";
}

}  // namespace robotlink::arcos
