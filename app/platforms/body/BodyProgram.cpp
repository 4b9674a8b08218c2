// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/body/BodyProgram.h"

#include <fmt/format.h>
#include <google/protobuf/message.h>

#include <algorithm>
#include <mutex>
#include <optional>

#include "app/core/own/StandInProcess.h"
#include "app/core/program/HostedRobot.h"
#include "app/core/remote/BodyStreams.h"
#include "robotlink/config/RobotDescription.h"
#include "robotlink/debugging/RegisteredTasks.h"
#include "robotlink/debugging/SharedDebugQueue.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/packages/ParsedMessage.h"
#include "robotlink/process/Platform.h"

namespace app {

using robotcontrol::BodyCommands;
using robotcontrol::HostingStatus;
using robotlink::Instant;
using robotlink::PackagePtr;

namespace {

/// The name of the stand-in for the program in the executor.
constexpr char kBodyProcess[] = "body";

/// The newest package that a sender of the platform has sent since the last frame.
class NewestLink final : public robotlink::Link {
 public:
  void offer(PackagePtr package) override {
    const std::lock_guard lock(mutex_);
    if (newest_) ++missed_;
    newest_ = std::move(package);
  }
  bool delivered() const override { return true; }
  PackagePtr take() override {
    const std::lock_guard lock(mutex_);
    return std::exchange(newest_, nullptr);
  }
  void close() override { closed_.store(true); }
  bool closed() const override { return closed_.load(); }
  std::uint64_t missed() const override {
    const std::lock_guard lock(mutex_);
    return missed_;
  }

 private:
  /// Protects newest_ and missed_.
  mutable std::mutex mutex_;
  PackagePtr newest_;
  std::uint64_t missed_ = 0;
  std::atomic<bool> closed_{false};
};

/// A package in its own type; null if it is of another type, or damaged.
PackagePtr packageOf(const BodyCommands::Package& wire, const google::protobuf::Descriptor* type) {
  if (type == nullptr || wire.type() != type->full_name()) return nullptr;
  return robotlink::parsedMessage(wire.type(), wire.data());
}

/// Whether a package is expensive to produce and only of interest to people; such packages are not sent to
/// the program.
bool isForPeople(const std::string& package) {
  return package == robotlink::kOracleClasses.name || package == robotlink::kLinkPackets.name;
}

/// A preview that never changes anything: a body has no program state that requests could change.
class NoPreview final : public ProgramPreview {
 public:
  std::string add(const robotcontrol::Request&) override { return {}; }
  bool answer(const robotcontrol::Request&) override { return false; }
  std::shared_ptr<const robotlink::SharedDebugQueue> takeQueue(Instant) override { return nullptr; }
};

}  // namespace

struct BodyProgram::Implementation {
  Implementation(Options given, const Parts& parts)
      : options(std::move(given)),
        robot(parts.robot.name),
        platform(parts.platform),
        exchange(kBodyProcess, parts.platform.clock()) {
    exchange.setPeriod(options.period);
    exchange.setFrame([this] { runFrame(); });
    executed.push_back(&exchange);
    const auto types = robotlink::allPackageTypes();
    connectSensors();
    connectCommands(types);
    describe(parts.robot);
    setStands(robot + " is stopped: no program commands it yet");
  }

  void connectSensors();
  void connectCommands(const std::map<std::string, const google::protobuf::Descriptor*>& types);
  void describe(const HostedRobot& of);
  // In each frame:
  void runFrame();
  void takeCommands(Instant now);
  void obey(const BodyCommands& newest);
  /// Whether the newest command answers readings that are not too old.
  bool isInTime(Instant now) const { return basedOn && now - *basedOn <= options.watchdog; }
  void followLateness(Instant now);
  std::string whyStand(Instant now) const;
  void publish(Instant now);
  void setStands(const std::string& why);

  struct Sensor {
    std::string package;
    std::shared_ptr<NewestLink> link;
  };
  struct Command {
    const google::protobuf::Descriptor* type = nullptr;
    std::unique_ptr<robotlink::AnySender> sender;
  };

  const Options options;
  const std::string robot;
  robotlink::Platform& platform;
  const robotlink::Layout layout;
  StandInProcess exchange;
  std::vector<robotlink::Process*> executed;
  std::vector<Sensor> sensors;
  std::map<std::string, Command> commands;
  Listeners listeners;
  robotcontrol::BodyOffer offer;
  bool isOffered = false;
  /// The time of the readings that the newest command answers.
  std::optional<Instant> basedOn;
  bool isStoppedThere = false;
  std::uint64_t frame = 0;
  /// The sender of the newest command, and the counts of its commands that were obeyed and late.
  std::uint64_t commander = 0, obeyed = 0, late = 0;
  /// Whether commands were late or missing, and are not trusted again yet; and since when they arrive
  /// in time.
  bool isUnsteady = false;
  std::optional<Instant> steadySince;
  HostingStatus status;
};

// ---- Making it

HostedProgram::Maker BodyProgram::maker(Options options) {
  return [options = std::move(options)](const Parts& parts) -> Made {
    return std::unique_ptr<HostedProgram>(new BodyProgram(std::make_unique<Implementation>(options, parts)));
  };
}

BodyProgram::BodyProgram(std::unique_ptr<Implementation> implementation)
    : implementation_(std::move(implementation)) {}

BodyProgram::~BodyProgram() {
  BodyProgram::stop();
}

void BodyProgram::Implementation::connectSensors() {
  for (robotlink::AnySender* sender : platform.senders()) {
    if (isForPeople(sender->package())) continue;
    sensors.push_back({sender->package(), std::make_shared<NewestLink>()});
    sender->connect(sensors.back().link);
  }
}

void BodyProgram::Implementation::connectCommands(
    const std::map<std::string, const google::protobuf::Descriptor*>& types) {
  for (robotlink::AnyReceiver* receiver : platform.receivers()) {
    const auto type = types.find(receiver->package());
    if (type == types.end()) continue;
    Command& command = commands[receiver->package()];
    command.type = type->second;
    command.sender =
        std::make_unique<robotlink::AnySender>(exchange, receiver->package(), robotlink::Blocking::kNo);
    connectUnchecked(*command.sender, *receiver);
  }
}

void BodyProgram::Implementation::describe(const HostedRobot& of) {
  offer.set_robot(of.name);
  offer.set_team(of.team);
  offer.set_kind(of.description->name);
  for (const Sensor& sensor : sensors) offer.add_sensors(sensor.package);
  for (const auto& [package, command] : commands) offer.add_commands(package);
  offer.set_watchdog(robotlink::seconds(options.watchdog));
}

void BodyProgram::stop() {
  for (auto& sensor : implementation_->sensors) sensor.link->close();
  implementation_->exchange.stop();
}

// ---- Frames

void BodyProgram::Implementation::runFrame() {
  const Instant now = exchange.clock().now();
  ++frame;
  takeCommands(now);
  followLateness(now);
  setStands(whyStand(now));
  publish(now);
}

void BodyProgram::Implementation::takeCommands(Instant now) {
  // The world was reset: earlier commands answer readings that have not been made yet.
  if (basedOn && *basedOn > now) basedOn.reset();
  const auto newest = options.inbox->take(robot);
  if (!newest) return;
  const Instant answered = robotlink::instant(newest->based_on());
  isStoppedThere = newest->stop();
  if (std::exchange(commander, newest->sender()) != newest->sender()) {
    obeyed = late = 0;
    isUnsteady = false;
  }
  if (answered > now || now - answered > options.watchdog) {
    ++late;
    steadySince.reset();
    return;
  }
  basedOn = answered;
  obey(*newest);
}

void BodyProgram::Implementation::obey(const BodyCommands& newest) {
  ++obeyed;
  if (newest.stop()) return;
  for (const auto& wire : newest.packages()) {
    const auto command = commands.find(wire.package());
    if (command == commands.end()) continue;
    if (const PackagePtr package = packageOf(wire, command->second.type))
      command->second.sender->send(package);
  }
}

/// A slow link delivers commands now in time, now too late. A robot that started and stopped many times a
/// second would fall: after a stop it waits until all commands were in time for as long as they may be
/// late.
void BodyProgram::Implementation::followLateness(Instant now) {
  if (!isInTime(now)) {
    isUnsteady = basedOn || late > 0;
    steadySince.reset();
  } else if (isUnsteady) {
    if (!steadySince || *steadySince > now) steadySince = now;
    isUnsteady = now - *steadySince < options.watchdog;
  }
}

std::string BodyProgram::Implementation::whyStand(Instant now) const {
  const double limit = robotlink::seconds(options.watchdog);
  if (isStoppedThere) return robot + " is stopped: STOP is engaged where its program runs";
  if (isInTime(now) && !isUnsteady) return {};
  if (!basedOn && late == 0) return robot + " is stopped: no program commands it yet";
  return fmt::format(
      "{} is stopped: for {:.3g} s no command of the program of {} arrived in time; the link may be slow or "
      "lost, or the program hangs or has ended",
      robot, limit, options.inbox->commander(robot));
}

void BodyProgram::Implementation::publish(Instant now) {
  if (!listeners.queue) return;
  auto queue = std::make_shared<robotlink::SharedDebugQueue>();
  queue->process = kBodyProcess;
  queue->number = frame;
  if (!std::exchange(isOffered, true)) queue->add<robotcontrol::BodyOffer>(kBodyOffer, now) = offer;
  for (const Sensor& sensor : sensors)
    if (PackagePtr package = sensor.link->take())
      queue->messages.push_back({sensor.package, now, std::move(package)});
  auto& state = queue->add<robotcontrol::BodyState>(kBodyState, now);
  robotlink::assign(*state.mutable_timestamp(), now);
  state.set_frame(frame);
  state.set_stop_engaged(platform.stopEngaged());
  state.set_stands(status.state() != HostingStatus::RUNNING);
  if (state.stands()) state.set_text(status.text());
  state.set_commands(obeyed);
  state.set_late(late);
  state.set_commander(commander);
  listeners.queue(std::move(queue));
}

void BodyProgram::Implementation::setStands(const std::string& why) {
  const auto now = why.empty() ? HostingStatus::RUNNING : HostingStatus::NOT_ANSWERING;
  if (now == status.state() && (why.empty() || why == status.text())) return;
  status.set_state(now);
  status.set_text(
      !why.empty() ? why : robot + " is commanded by the program of " + options.inbox->commander(robot));
  if (listeners.hosting) listeners.hosting();
}

// ---- What it is

void BodyProgram::setListeners(Listeners listeners) {
  implementation_->listeners = std::move(listeners);
}

const robotlink::Layout& BodyProgram::layout() const {
  return implementation_->layout;
}

const std::vector<robotlink::Process*>& BodyProgram::processes() const {
  return implementation_->executed;
}

const robotlink::Process& BodyProgram::debugProcess() const {
  return implementation_->exchange;
}

std::string BodyProgram::refusal() const {
  return "the program of " + implementation_->robot +
         " runs elsewhere; only its body is here: send the request to the computer where the program runs";
}

std::unique_ptr<ProgramPreview> BodyProgram::preview() {
  return std::make_unique<NoPreview>();
}

HostingStatus BodyProgram::hosting() const {
  return implementation_->status;
}

}  // namespace app
