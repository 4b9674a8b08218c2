// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ServerSession that executes commands.
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/server/ServerSession.h"
#include "robotlink/arcos/server/ServerTelemetry.h"

namespace robotlink::arcos {
namespace {

/// The unit of VEL2.
constexpr double kWheelSpeedUnit = 0.020;  // m/s

CommandId idOf(const Command& command) {
  return static_cast<CommandId>(command.id);
}
double meters(const Command& command) {
  return integerArgument(command) / 1000.0;
}
double angle(const Command& command) {
  return radians(static_cast<double>(integerArgument(command)));
}

/// Reads numbers from the bytes after a command's argument type, whatever that type is; missing bytes count
/// as 0.
class ArgumentBytes {
 public:
  explicit ArgumentBytes(const Bytes& data) : data_(data) {}

  std::int32_t number(int bytes) {
    std::uint32_t bits = 0;
    for (int i = 0; i < bytes; ++i, ++at_) {
      if (at_ < data_.size()) bits |= std::uint32_t{data_[at_]} << (8 * i);
    }
    return static_cast<std::int32_t>(bits);
  }
  std::string text(std::size_t length) {
    const std::size_t begin = std::min(at_, data_.size());
    const std::size_t end = begin + std::min(length, data_.size() - begin);
    std::string text(data_.begin() + static_cast<std::ptrdiff_t>(begin),
                     data_.begin() + static_cast<std::ptrdiff_t>(end));
    return text.substr(0, text.find('\0'));
  }

 private:
  const Bytes& data_;
  std::size_t at_ = 1;
};

}  // namespace

void ServerSession::obey(const Command& command) {
  switch (idOf(command)) {
    case CommandId::kPulse:
      return;
    case CommandId::kOpen:
      return open();
    case CommandId::kClose:
      return close();
    case CommandId::kConfig:
      return send(toPacket(configurationOf(settings_, motion_.parameters())));
    default:
      break;
  }
  [[maybe_unused]] const bool known = obeyLaser(command) || obeyTranslation(command) ||
                                      obeyRotation(command) || obeyLimits(command) ||
                                      obeySubscription(command) || obeySonar(command) || obeyDevices(command);
}

/// Commands 35 to 38 control the laser here, as in other simulators, but on real robots they are ADSEL,
/// GRIPPERVAL, GRIPREQUEST and GYROCALCW. A value for the gripper follows the gripper command that needs it.
bool ServerSession::obeyLaser(const Command& command) {
  if (idOf(command) == CommandId::kGetAux) {
    auxiliary_.ask(integerArgument(command));
    return true;
  }
  if (idOf(command) == CommandId::kGripper) {
    client_.gripperValueNext = gripper_.obey(integerArgument(command));
    return true;
  }
  if (idOf(command) == CommandId::kGripperValue && std::exchange(client_.gripperValueNext, false)) {
    gripper_.setValue(integerArgument(command));
    return true;
  }
  return laser_.obey(command);
}

bool ServerSession::obeyTranslation(const Command& command) {
  switch (idOf(command)) {
    case CommandId::kVel:
      motion_.translate(meters(command));
      return true;
    case CommandId::kMove:
      motion_.move(meters(command));
      return true;
    case CommandId::kVel2: {
      const BytePair speeds = split(integerArgument(command));
      motion_.driveWheels(speeds.high * kWheelSpeedUnit, speeds.low * kWheelSpeedUnit);
      return true;
    }
    case CommandId::kStop:
      motion_.stop();
      return true;
    case CommandId::kEStop:
    case CommandId::kQStop:
      motion_.emergencyStop();
      return true;
    case CommandId::kEnable:
      motion_.enable(integerArgument(command, 1) != 0);
      return true;
    default:
      return false;
  }
}

bool ServerSession::obeyRotation(const Command& command) {
  switch (idOf(command)) {
    case CommandId::kRvel:
    case CommandId::kRotate:
      motion_.rotate(angle(command));
      return true;
    case CommandId::kHead:
      motion_.turnTo(angle(command));
      return true;
    case CommandId::kDhead:
      motion_.turnBy(angle(command));
      return true;
    case CommandId::kDchead:
      motion_.turnFromSetpoint(angle(command));
      return true;
    case CommandId::kSetO:
      motion_.setOdometry({});
      return true;
    default:
      return false;
  }
}

bool ServerSession::obeyLimits(const Command& command) {
  const bool braking = integerArgument(command) < 0;
  switch (idOf(command)) {
    case CommandId::kSetV:
      motion_.setSpeed(meters(command));
      return true;
    case CommandId::kSetRv:
      motion_.setRotation(angle(command));
      return true;
    case CommandId::kSetA:
      braking ? motion_.setDeceleration(meters(command)) : motion_.setAcceleration(meters(command));
      return true;
    case CommandId::kSetRa:
      braking ? motion_.setRotationDeceleration(angle(command))
              : motion_.setRotationAcceleration(angle(command));
      return true;
    default:
      return false;
  }
}

bool ServerSession::obeySubscription(const Command& command) {
  const auto ask = [&](Subscribable which) {
    subscription(which).ask(integerArgument(command, 1));
    return true;
  };
  switch (idOf(command)) {
    case CommandId::kEncoder:
      return ask(kEncoder);
    case CommandId::kIoRequest:
      return ask(kIo);
    case CommandId::kImuRequest:
      return ask(kImu);
    case CommandId::kJoyRequest:
      return ask(kJoystick);
    case CommandId::kBatteryInfo:
      return ask(kBattery);
    case CommandId::kGripperRequest:
      return ask(kGripper);
    case CommandId::kSimStat:
      return ask(kStatus);
    case CommandId::kGyro:
      // Clients that use the gyroscope themselves request all readings with 1.
      subscription(kGyro).always =
          settings_.gyroscope == ServerSettings::Gyroscope::kClient && integerArgument(command, 1) != 0;
      client_.gyroUsed = integerArgument(command, 1) != 0;
      return true;
    default:
      return false;
  }
}

bool ServerSession::obeySonar(const Command& command) {
  switch (idOf(command)) {
    case CommandId::kSonar:
      sonars_.enable(integerArgument(command, 1));
      return true;
    case CommandId::kPolling:
      sonars_.setSequence(stringArgument(command));
      return true;
    case CommandId::kSonarCycle:
      sonars_.setPeriod(std::chrono::milliseconds(integerArgument(command)));
      return true;
    default:
      return false;
  }
}

bool ServerSession::obeyDevices(const Command& command) {
  const int argument = integerArgument(command);
  switch (idOf(command)) {
    case CommandId::kDigOut: {
      const BytePair bits = split(argument);
      const auto mask = static_cast<std::uint8_t>(bits.high), values = static_cast<std::uint8_t>(bits.low);
      client_.digitalOut = static_cast<std::uint8_t>((client_.digitalOut & ~mask) | (values & mask));
      return true;
    }
    case CommandId::kBumpStall:
      client_.bumpStall = argument & 3;
      return true;
    case CommandId::kBatTest:
      client_.testedBattery.reset();
      if (argument > 0) client_.testedBattery = argument / 10.0;
      return true;
    case CommandId::kLcdWrite: {
      // Column, row and a flag for clearing precede the text.
      const std::string text = stringArgument(command);
      if (text.size() > 3) ask(simulator_request::Message{text.substr(3)});
      return true;
    }
    default:
      return false;
  }
}

bool ServerSession::obeySimulator(const Packet& packet) {
  ArgumentBytes argument(packet.data);
  switch (static_cast<CommandId>(packet.id)) {
    case CommandId::kSimSetPose: {
      const double x = argument.number(4) / 1000.0, y = argument.number(4) / 1000.0;
      ask(simulator_request::SetPose{
          {x, y, normalizedAngle(radians(static_cast<double>(argument.number(4))))}});
      return true;
    }
    case CommandId::kSimReset:
      motion_.setOdometry({});
      ask(simulator_request::Reset{});
      return true;
    case CommandId::kSimControl:
      obeySimulatorControl(packet);
      return true;
    case CommandId::kSimMessage: {
      const auto command = toCommand(packet);
      const std::string text = command ? stringArgument(*command) : std::string();
      ask(simulator_request::Message{text.substr(0, text.find('\0'))});
      return true;
    }
    case CommandId::kSimExit: {
      const auto command = toCommand(packet);
      ask(simulator_request::Exit{command ? integerArgument(*command) : 0});
      return true;
    }
    default:
      return false;
  }
}

void ServerSession::obeySimulatorControl(const Packet& packet) {
  constexpr int kLoadMap = 1, kLoadMapForAll = 2, kInformation = 6;
  ArgumentBytes argument(packet.data);
  const std::int32_t operation = argument.number(2);
  if (operation == kLoadMap || operation == kLoadMapForAll) {
    const auto length = static_cast<std::size_t>(argument.number(2));
    ask(simulator_request::LoadMap{argument.text(length)});
  } else if (operation == kInformation) {
    send(toPacket(infoOf(settings_)));
  }
}

}  // namespace robotlink::arcos
