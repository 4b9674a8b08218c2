// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/PioneerRobot.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "robotlink/arcos/PioneerConnection.h"
#include "robotlink/arcos/WireUnits.h"
#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/codec/SimulatorCommands.h"

namespace robotlink::arcos {
namespace {

/// Success, or the first error of the two.
Result<void> both(Result<void> first, Result<void> second) {
  return first ? second : first;
}

}  // namespace

PioneerRobot::PioneerRobot(std::string url)
    : PioneerRobot([url] { return open(url); }, std::make_shared<SteadyClock>()) {}

PioneerRobot::PioneerRobot(Opener opener, std::shared_ptr<const Clock> clock)
    : connection_(std::make_unique<PioneerConnection>(std::move(opener), std::move(clock))) {}

PioneerRobot::~PioneerRobot() = default;

Result<void> PioneerRobot::begin(Duration timeLimit) {
  return connection_->begin(timeLimit);
}
void PioneerRobot::end() {
  connection_->end();
}
Result<bool> PioneerRobot::read(Duration timeout) {
  return connection_->read(timeout);
}
Result<void> PioneerRobot::write(const Command& command) {
  return connection_->send(command);
}
Result<void> PioneerRobot::write(const Packet& packet) {
  return connection_->send(packet);
}

bool PioneerRobot::isConnected() const {
  return connection_->inspect([](const auto& c) { return c.client().isConnected(); });
}

std::string PioneerRobot::problem() const {
  return connection_->inspect([](const auto& c) { return c.problem(); });
}

RobotState PioneerRobot::state() const {
  return connection_->inspect([](const auto& c) { return c.client().state(); });
}

RobotType PioneerRobot::type() const {
  return connection_->inspect([](const auto& c) { return c.client().type(); });
}

double PioneerRobot::sonar(std::size_t number) const {
  return connection_->inspect([number](const auto& c) {
    const auto& sonars = c.client().state().sonars;
    return number < sonars.size() ? sonars[number].range : c.client().type().sonarMaximum;
  });
}

std::optional<RangeScan> PioneerRobot::laser() const {
  return connection_->inspect([](const auto& c) { return c.client().scan(); });
}

std::vector<Vector2> PioneerRobot::echoes() const {
  return connection_->inspect([](const auto& c) {
    std::vector<Vector2> points;
    const RobotState& state = c.client().state();
    const Pose2 fromOdometry = state.pose.inverse();
    for (const SonarReading& sonar : state.sonars) {
      if (sonar.echo && state.time - sonar.time <= kEchoTime) {
        points.push_back(fromOdometry * sonar.robot * sonar.pointInRobot());
      }
    }
    const auto& scan = c.client().scan();
    if (!scan || state.time - scan->time > kEchoTime) return points;
    const Pose2 then = fromOdometry * scan->robot;
    for (std::size_t i = 0; i < scan->ranges.size(); ++i) {
      if (scan->echo(i)) points.push_back(then * scan->pointInRobot(i));
    }
    return points;
  });
}

double PioneerRobot::nearestEcho(double fromAngle, double toAngle) const {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Vector2& point : echoes()) {
    const double direction = std::atan2(point.y(), point.x());
    if (direction >= fromAngle && direction <= toAngle) nearest = std::min(nearest, point.norm());
  }
  return nearest;
}

std::string PioneerRobot::name() const {
  return connection_->inspect([](const auto& c) {
    const Identity* identity = c.client().session().identity();
    return identity ? identity->name : std::string();
  });
}

bool PioneerRobot::isSimulated() const {
  return connection_->inspect([](const auto& c) { return c.client().isSimulated(); });
}

Result<void> PioneerRobot::requireSimulator(const std::string& why) const {
  if (!isConnected() || isSimulated()) return {};
  return failure("pioneer.not-simulated", "this robot is not a simulated one: " + why);
}

std::optional<Packet> PioneerRobot::latest(std::uint8_t packetId) const {
  return connection_->inspect([packetId](const auto& c) -> std::optional<Packet> {
    const auto found = c.latest().find(packetId);
    return found == c.latest().end() ? std::nullopt : std::optional(found->second);
  });
}

PioneerRobot::LinkCounts PioneerRobot::linkCounts() const {
  return connection_->inspect([](const auto& c) {
    const PacketParser::Counters& counters = c.client().received();
    return LinkCounts{c.client().session().statistics().information, counters.packets,
                      counters.checksumErrors, counters.skippedBytes};
  });
}

Result<void> PioneerRobot::setMotors(bool on) {
  return write(command(CommandId::kEnable, on ? 1 : 0));
}
Result<void> PioneerRobot::setSonar(bool on) {
  return write(command(CommandId::kSonar, on ? 1 : 0));
}

Result<void> PioneerRobot::setLaser(bool on) {
  if (const auto simulated = requireSimulator("its laser has its own line"); !simulated) return simulated;
  return connection_->sendBy([on](PioneerClient& client, Instant now) {
    if (!on) return client.stopLaser(now);
    return client.startLaser(-kPi / 2, kPi / 2, PioneerClient::LaserCommands::kUsual, now);
  });
}

Result<void> PioneerRobot::setSpeed(double speed) {
  return write(command(CommandId::kVel, inMillimeters(speed)));
}
Result<void> PioneerRobot::setRotation(double rotation) {
  return write(command(CommandId::kRvel, inDegrees(rotation)));
}
Result<void> PioneerRobot::drive(double speed, double rotation) {
  return both(setSpeed(speed), setRotation(rotation));
}

Result<void> PioneerRobot::setWheels(double left, double right) {
  const double step = type().wheelSpeedStep;
  const auto steps = [step](double speed) {
    return static_cast<std::int8_t>(std::clamp(std::lround(speed / step), -128L, 127L));
  };
  return write(command(CommandId::kVel2, joined({steps(left), steps(right)})));
}

Result<void> PioneerRobot::move(double distance) {
  return connection_->beginMotion(
      command(CommandId::kMove, inMillimeters(distance)),
      [distance](const RobotState& state, Instant now) { return MotionGoal::move(state, now, distance); });
}
Result<void> PioneerRobot::turn(double angle) {
  return connection_->beginMotion(
      command(CommandId::kDhead, inDegrees(angle)), [angle](const RobotState& state, Instant now) {
        return MotionGoal::turn(state, now, normalizedAngle(state.pose.heading + angle));
      });
}
Result<void> PioneerRobot::turnTo(double heading) {
  return connection_->beginMotion(
      command(CommandId::kHead, inDegrees(heading)),
      [heading](const RobotState& state, Instant now) { return MotionGoal::turn(state, now, heading); });
}
Result<MotionEnd> PioneerRobot::waitForMotion(Duration timeLimit) {
  return connection_->waitForMotion(timeLimit);
}

Result<void> PioneerRobot::setLimits(double speed, double rotation) {
  return both(write(command(CommandId::kSetV, inMillimeters(speed))),
              write(command(CommandId::kSetRv, inDegrees(rotation))));
}

Result<void> PioneerRobot::stop() {
  return write(command(CommandId::kStop));
}
Result<void> PioneerRobot::emergencyStop() {
  return write(command(CommandId::kEStop));
}
Result<void> PioneerRobot::resetOdometry() {
  return connection_->sendBy([](PioneerClient& client, Instant now) { return client.resetOdometry(now); });
}

Result<void> PioneerRobot::setDigitalOutputs(std::uint8_t which, std::uint8_t values) {
  return write(command(CommandId::kDigOut,
                       joined({static_cast<std::int8_t>(which), static_cast<std::int8_t>(values)})));
}
Result<void> PioneerRobot::setDigitalOutput(int number, bool on) {
  if (number < 0 || number > 7)
    return failure("pioneer.no-output",
                   "there is no digital output " + std::to_string(number) + ": they are numbered 0 to 7");
  const auto bit = static_cast<std::uint8_t>(1U << static_cast<unsigned>(number));
  return setDigitalOutputs(bit, on ? bit : std::uint8_t{0});
}
Result<void> PioneerRobot::setGripper(GripperAction action) {
  return write(command(CommandId::kGripper, static_cast<int>(action)));
}
Result<void> PioneerRobot::selectAnalogInput(int number) {
  if (number < 0 || number > 7)
    return failure("pioneer.no-input",
                   "there is no analog input " + std::to_string(number) + ": they are numbered 0 to 7");
  if (isSimulated())
    return failure("pioneer.simulated",
                   "simulated robots have no analog inputs: they use that command for the laser");
  return write(command(CommandId::kAdSel, number));
}

Result<void> PioneerRobot::putAt(const Pose2& pose) {
  if (const auto simulated = requireSimulator("carry it to its place"); !simulated) return simulated;
  return write(arcos::setTruePose({inMillimeters(pose.x), inMillimeters(pose.y), inDegrees(pose.heading)}));
}

Result<void> PioneerRobot::setTruePose(bool on) {
  if (const auto simulated = requireSimulator("its true pose is not known"); !simulated) return simulated;
  return write(command(CommandId::kSimStat, on ? 2 : 0));
}

std::optional<Pose2> PioneerRobot::truePose() const {
  const auto packet = latest(SimulatorStatus::kId);
  const auto status = packet ? decode<SimulatorStatus>(*packet) : Result<SimulatorStatus>(failure("", ""));
  if (!status) return std::nullopt;
  return Pose2{status->xMm / 1000.0, status->yMm / 1000.0, normalizedAngle(radians(status->headingDeg))};
}

}  // namespace robotlink::arcos
