// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/arcos/codec/Command.h"
#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/codec/SimulatorCommands.h"

/// One packet of every kind, in both directions.
inline std::vector<robotlink::arcos::Packet> arcosSeedPackets() {
  using namespace robotlink::arcos;
  StandardInformation sip;
  sip.sonars = {{0, 5000}, {9, 300}};
  sip.gripState = sip.analogPort = sip.analog = sip.digitalIn = sip.digitalOut = std::uint8_t{1};
  sip.batteryDecivolts16 = 130;
  sip.chargeState = 0;
  sip.rotationRateDeciDegS = -5;
  sip.faultFlags = 0;
  sip.lateralSpeedMmS = 0;
  sip.temperatureDegC = 20;
  sip.stateOfChargePercent = 90;
  Configuration configuration;
  configuration.subtype = "p3at-sh";
  configuration.fieldCount = Configuration::kAllFields;
  LaserPacket extended, plain;
  extended.total = plain.total = 2;
  extended.readings = plain.readings = {{1000, 1, {}}, {2000, 0, {}}};
  plain.extended = false;
  return {toPacket(Identity{"MobileSim", "Pioneer", "p3at-sh", {}}),
          toPacket(sip),
          toPacket(StandardInformation{}),
          toPacket(configuration),
          toPacket(EncoderPacket{1, -2, {}}),
          toPacket(IoPacket{{1, 2, 3, 4}, {5}, {0, 1023}, {}}),
          toPacket(GyroPacket{{{512, 25}}, {}}),
          toPacket(ImuPacket{7, {{2, {1, 2, 3}, {4, 5, 6}, {7}}}, {}}),
          toPacket(AuxSerialPacket{2, {1, 2, 3}}),
          toPacket(CompassPacket{}),
          toPacket(GripperPacket{1, 2, 3, {}}),
          toPacket(JoystickPacket{1, 0, -5, 6, 7, {}}),
          toPacket(BatteryPacket{6, {{1, 2, 3, 90, 91, {8}}}, {}}),
          toPacket(extended),
          toPacket(plain),
          toPacket(SimulatorStatus{}),
          toPacket(SimulatorInfo{"MobileSim", "1", 1, {{"laser", "LMS200", 0, 3}}, {}}),
          toPacket(MapChanged{1, 1, "office.map", {}}),
          toPacket(command(CommandId::kPulse)),
          toPacket(command(CommandId::kOpen, 1)),
          toPacket(command(CommandId::kVel, -250)),
          toPacket(command(CommandId::kVel2, -1275)),
          toPacket(command(CommandId::kSimMessage, "hello")),
          toPacket(setTruePose({1, -2, 90})),
          toPacket(simulatorControl({SimulatorControl::kLoadMap, "office.map"}))};
}
