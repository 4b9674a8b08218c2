// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/RemoteBodyPlatform.h"

#include <fmt/format.h>
#include <google/protobuf/message.h>
#include <google/protobuf/timestamp.pb.h>

#include <random>

#include "robotcontrol/Requests.pb.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/Packages.h"

namespace app {

using google::protobuf::Descriptor;
using google::protobuf::Message;
using google::protobuf::Timestamp;
using robotcontrol::BodyCommands;
using robotlink::Duration;
using robotlink::Instant;
using robotlink::PackagePtr;

namespace {

constexpr Duration kBodyStatusPeriod = std::chrono::milliseconds(250);
/// The period at which STOP is repeated to a body that has not accepted it, and to one that it holds.
constexpr Duration kStopRepeat = std::chrono::milliseconds(300);
constexpr Duration kStopHold = std::chrono::milliseconds(100);

std::uint64_t randomSender() {
  std::random_device random;
  return (std::uint64_t{random()} << 32U | random()) | 1U;  // never 0, which means no sender
}

/// Returns why a body does not move as `sender` commands; empty if it does.
std::string whyNotMoved(const robotcontrol::BodyState& state, std::uint64_t sender) {
  if (!state.text().empty()) return state.text();
  if (state.stop_engaged()) return "it is stopped: STOP is engaged there";
  return state.commander() != 0 && state.commander() != sender ? "another program commands it" : "";
}

/// Adds a time to all time stamps in a message.
void shiftTimes(Message& message, Duration by) {
  if (message.GetDescriptor() == Timestamp::descriptor()) {
    auto& stamp = dynamic_cast<Timestamp&>(message);
    robotlink::assign(stamp, robotlink::instant(stamp) + by);
    return;
  }
  const auto& fields = *message.GetReflection();
  std::vector<const google::protobuf::FieldDescriptor*> set;
  fields.ListFields(message, &set);
  for (const auto* field : set) {
    if (field->cpp_type() != google::protobuf::FieldDescriptor::CPPTYPE_MESSAGE) continue;
    if (!field->is_repeated()) {
      shiftTimes(*fields.MutableMessage(&message, field), by);
    } else {
      for (int i = 0; i < fields.FieldSize(message, field); ++i)
        shiftTimes(*fields.MutableRepeatedMessage(&message, field, i), by);
    }
  }
}

}  // namespace

RemoteBodyPlatform::RemoteBodyPlatform(BodyLink& link, BodyClock& clock, const robotlink::Clock& local,
                                       const std::set<std::string>& leftOut)
    : Platform("platform", clock),
      link_(link),
      bodyClock_(clock),
      local_(local),
      watchdog_(link.body()->offer.watchdog()),
      status_(*this, robotlink::kLinkStatus.name, robotlink::Blocking::kNo),
      sender_(randomSender()) {
  const auto types = robotlink::allPackageTypes();
  const auto& offer = link.body()->offer;
  for (const std::string& package : offer.sensors()) {
    const auto type = types.find(package);
    if (type == types.end() || leftOut.contains(package)) continue;
    Sensor& sensor = sensors_[package];
    sensor.type = type->second;
    // The state of the body's own line becomes a part of that of the link.
    if (package != status_.package())
      sensor.sender = std::make_unique<robotlink::AnySender>(*this, package, robotlink::Blocking::kNo);
  }
  for (const std::string& package : offer.commands()) {
    const auto type = types.find(package);
    if (type == types.end() || leftOut.contains(package)) continue;
    Command& command = commands_[package];
    command.type = type->second;
    command.receiver = std::make_unique<robotlink::AnyReceiver>(*this, package, robotlink::Blocking::kNo);
  }
}

RemoteBodyPlatform::~RemoteBodyPlatform() = default;

std::vector<robotlink::AnySender*> RemoteBodyPlatform::onRequest() {
  std::vector<robotlink::AnySender*> all{&status_};
  for (const auto& [package, sensor] : sensors_)
    if (sensor.sender) all.push_back(sensor.sender.get());
  return all;
}

// ---- What comes

void RemoteBodyPlatform::actuate() {
  subscribe();
  link_.tick();
  takeArrived();
  followConnection();
  repeatStop(local_.now());
  sendCommands();
}

/// Only what the program receives is sent.
void RemoteBodyPlatform::subscribe() {
  std::set<std::string> wanted;
  for (const auto& [package, sensor] : sensors_)
    if (!sensor.sender || sensor.sender->connected()) wanted.insert(package);
  if (wanted == wanted_) return;
  wanted_ = wanted;
  link_.want(wanted_);
}

void RemoteBodyPlatform::takeArrived() {
  const BodyLink::Arrived arrived = link_.take();
  if (arrived.state) takeState(*arrived.state);
  for (const auto& [package, value] : arrived.sensors) takeSensor(package, value);
  for (const std::string& text : arrived.texts) report("The body: " + text);
  for (std::string& why : refusals_->drain()) report(std::move(why));
  if (link_.isOther() != std::exchange(isOther_, link_.isOther()) && isOther_)
    report("The body offered under this name now has other sensors or commands: open it again");
}

void RemoteBodyPlatform::takeState(const robotcontrol::BodyState& state) {
  const Instant now = local_.now();
  if (heardAt_) counts_.longestSilence = std::max(counts_.longestSilence, now - *heardAt_);
  heardAt_ = now;
  bodyClock_.hear(robotlink::instant(state.timestamp()));
  ++counts_.frames;
  if (state.commander() == sender_) {
    counts_.obeyed = state.commands();
    counts_.late = state.late();
  }
  stoppedThere_.store(state.stop_engaged());
  const std::string text = whyNotMoved(state, sender_);
  if (std::exchange(bodyText_, text) == text) return;
  report(text.empty() ? "The body moves as this program commands." : "The body: " + text + ".");
}

void RemoteBodyPlatform::takeSensor(const std::string& package, const PackagePtr& value) {
  const auto found = sensors_.find(package);
  // Receivers rely on the type, and the other end is not trusted.
  if (found == sensors_.end() || !value || value->GetDescriptor() != found->second.type) return;
  PackagePtr sent = value;
  if (const Duration shift = bodyClock_.shift(); shift != Duration::zero()) {
    const std::shared_ptr<Message> shifted(value->New());
    shifted->CopyFrom(*value);
    shiftTimes(*shifted, shift);
    sent = shifted;
  }
  if (found->second.sender) {
    found->second.waiting = std::move(sent);
  } else {
    bodyLine_ = std::dynamic_pointer_cast<const robotcontrol::LinkStatus>(sent);
  }
}

void RemoteBodyPlatform::followConnection() {
  const bool isConnected = link_.state().isConnected();
  if (isConnected == isConnected_) return;
  isConnected_ = isConnected;
  if (!isConnected) {
    ++counts_.cuts;
    report(
        fmt::format("The body at {} is out of reach: {}. It stops by itself {:.3g} s after the last command "
                    "that it received. The connection is retried continuously.",
                    link_.url(), link_.state().reason, watchdog_));
  } else if (std::exchange(wasConnected_, true)) {
    report("The body at " + link_.url() + " can be reached again.");
  } else {
    report(fmt::format("Connected to the body at {}. It stops when no command arrives in time for {:.3g} s.",
                       link_.url(), watchdog_));
  }
}

void RemoteBodyPlatform::execute() {
  for (auto& [package, sensor] : sensors_)
    if (sensor.waiting) sensor.sender->send(std::exchange(sensor.waiting, nullptr));
  if (const Instant now = local_.now(); statusAt_ == Instant() || now - statusAt_ >= kBodyStatusPeriod)
    sendStatus(now);
}

std::string RemoteBodyPlatform::describe() const {
  if (!isConnected_) return link_.stateText();
  if (bodyText_.empty())
    return link_.stateText() +
           fmt::format("; the body stops when no command arrives in time for {:.3g} s", watchdog_);
  return link_.stateText() + "; " + bodyText_;
}

void RemoteBodyPlatform::sendStatus(Instant now) {
  using Status = robotcontrol::LinkStatus;
  statusAt_ = now;
  const auto state = link_.state();
  const bool hasLine = isConnected_ && bodyLine_;
  auto status = hasLine ? std::make_shared<Status>(*bodyLine_) : std::make_shared<Status>();
  robotlink::assign(*status->mutable_timestamp(), clock().now());
  if (!hasLine)
    status->set_state(isConnected_ ? Status::CONNECTED : wasConnected_ ? Status::LOST : Status::CONNECTING);
  status->set_address(hasLine ? link_.url() + ", there " + bodyLine_->address() : link_.url());
  status->set_bytes_per_second(state.bytesPerSecond);
  status->set_packets(counts_.frames);
  if (state.roundTrip) status->set_round_trip(robotlink::seconds(*state.roundTrip));
  status->set_longest_gap(robotlink::seconds(counts_.longestSilence));
  status->set_reconnects(state.connections > 0 ? state.connections - 1 : 0);
  status->set_text(hasLine && bodyLine_->state() != Status::CONNECTED ? "the body: " + bodyLine_->text()
                                                                      : describe());
  status_.send(std::move(status));
}

// ---- What goes

bool RemoteBodyPlatform::hasNewCommands() {
  bool isNew = false;
  for (auto& [package, command] : commands_) {
    const bool hasCome = std::exchange(command.taken, command.receiver->taken()) != command.receiver->taken();
    // Messages to the team move nothing; they go with the commands that do.
    isNew |= hasCome && package != robotlink::kTeamMessage.name;
  }
  return isNew;
}

/// A program that no longer commands anything is not kept alive: the body has to stop.
void RemoteBodyPlatform::sendCommands() {
  const Instant now = local_.now();
  const bool isNew = hasNewCommands();
  const bool isHeld = stopWanted_.load();
  if (unattended() || isOther_ || (isHeld ? now - sentAt_ < kStopHold : !isNew)) return;
  sentAt_ = now;
  BodyCommands commands;
  robotlink::assign(*commands.mutable_based_on(), bodyClock_.heard());
  commands.set_number(++number_);
  commands.set_sender(sender_);
  commands.set_stop(isHeld);
  for (const auto& [package, command] : commands_) {
    const PackagePtr& value = command.receiver->value();
    if (isHeld || !value || value->GetDescriptor() != command.type) continue;
    BodyCommands::Package& wire = *commands.add_packages();
    wire.set_package(package);
    wire.set_type(value->GetDescriptor()->full_name());
    value->SerializeToString(wire.mutable_data());
  }
  ++counts_.commands;
  link_.send(commands);
}

void RemoteBodyPlatform::engageStop(bool engaged) {
  stopWanted_.store(engaged);
  stopOpen_->store(engaged ? 1 : 2);
  sendStop(engaged);
}

void RemoteBodyPlatform::sendStop(bool engaged) {
  link_.engageStop(engaged, [open = stopOpen_, engaged](const std::string& why) {
    int expected = engaged ? 1 : 2;
    // A watcher cannot release it, however often it requests that.
    if (why.empty() || !engaged) open->compare_exchange_strong(expected, 0);
  });
}

void RemoteBodyPlatform::repeatStop(Instant now) {
  const int open = stopOpen_->load();
  if (open == 0 || !isConnected_ || now - stopSentAt_ < kStopRepeat) return;
  stopSentAt_ = now;
  sendStop(open == 1);
}

robotlink::Result<void> RemoteBodyPlatform::whetherConnected() const {
  if (isConnected_) return {};
  return robotlink::failure("body.cut", "the body is out of reach: " + link_.state().reason);
}

std::function<void(const std::string&)> RemoteBodyPlatform::reportRefusal(const std::string& of) {
  return [refusals = refusals_, of](const std::string& why) {
    if (!why.empty()) refusals->push("The body refused the command for its " + of + ": " + why);
  };
}

robotlink::Result<void> RemoteBodyPlatform::control(const robotcontrol::ControlDrive& details) {
  if (auto connected = whetherConnected(); !connected) return connected;
  link_.control(details, reportRefusal("base"));
  return {};
}

robotlink::Result<void> RemoteBodyPlatform::setCamera(const robotcontrol::SetCamera& details) {
  if (auto connected = whetherConnected(); !connected) return connected;
  link_.setCamera(details, reportRefusal("camera"));
  return {};
}

}  // namespace app
