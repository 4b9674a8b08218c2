// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/SimulatorCommands.h"

#include "robotlink/arcos/codec/WireFields.h"

namespace robotlink::arcos {
namespace {

bool namesFile(int operation) {
  return operation == SimulatorControl::kLoadMap || operation == SimulatorControl::kLoadMasterMap;
}

}  // namespace

Command setTruePose(const TruePose& pose) {
  Command result = command(CommandId::kSimSetPose);
  FieldWriter writer(result.extra);
  writer("type", std::uint8_t{0});
  writer("x", pose.xMm);
  writer("y", pose.yMm);
  writer("heading", pose.headingDeg);
  writer.finish();
  return result;
}

std::optional<TruePose> truePoseOf(const Command& command) {
  // Some clients mark the coordinates as an integer argument, so they are searched in the bytes of the
  // packet.
  const Packet packet = toPacket(command);
  FieldReader reader(packet.data);
  std::uint8_t type = 0;
  TruePose pose;
  reader("type", type);
  reader("x", pose.xMm);
  reader("y", pose.yMm);
  reader("heading", pose.headingDeg);
  return reader.ok() ? std::optional(pose) : std::nullopt;
}

Command simulatorControl(const SimulatorControl& control) {
  Command result = command(CommandId::kSimControl, control.operation);
  if (namesFile(control.operation)) {
    FieldWriter writer(result.extra);
    writer("length", static_cast<std::uint16_t>(std::min<std::size_t>(control.file.size(), 0xFFFF)));
    writer.finish();
    result.extra.insert(result.extra.end(), control.file.begin(), control.file.end());
  }
  return result;
}

std::optional<SimulatorControl> simulatorControlOf(const Command& command) {
  const int* operation = std::get_if<int>(&command.argument);
  if (!operation) return std::nullopt;
  SimulatorControl control{*operation, {}};
  if (!namesFile(*operation)) return control;
  FieldReader reader(command.extra);
  std::uint16_t length = 0;
  Bytes name;
  reader("length", length);
  reader.bytes(name, length);
  if (!reader.ok()) return std::nullopt;
  control.file.assign(name.begin(), name.end());
  return control;
}

}  // namespace robotlink::arcos
