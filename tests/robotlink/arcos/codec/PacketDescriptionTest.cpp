// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/PacketDescription.h"

#include <gtest/gtest.h>

#include "robotlink/arcos/codec/ServerPackets.h"
#include "robotlink/arcos/codec/SimulatorCommands.h"
#include "tests/robotlink/arcos/HexBytes.h"

namespace robotlink::arcos {
namespace {

std::string line(const Command& command) {
  return describe(toPacket(command), Direction::kFromClient).line();
}

std::string fromRobot(const ServerPacket& packet) {
  return describe(toPacket(packet), Direction::kFromRobot).line(1000);
}

TEST(PacketDescriptionTest, commandsShowTheirArguments) {
  EXPECT_EQ(line(command(CommandId::kVel, -250)), "VEL -250 mm/s");
  EXPECT_EQ(line(command(CommandId::kEnable, 1)), "ENABLE 1");
  EXPECT_EQ(line(command(CommandId::kStop)), "STOP");
  EXPECT_EQ(line(command(CommandId::kVel2, joined({-5, 5}))), "VEL2: left -100 mm/s, right 100 mm/s");
  EXPECT_EQ(line(command(CommandId::kDigOut, joined({-1, 4}))), "DIGOUT: high byte 0xff, low byte 0x04");
  EXPECT_EQ(line(command(CommandId::kSimMessage, "hi \"there\"\n")), "SIM_MESSAGE \"hi \"there\"\\x0a\"");
  EXPECT_EQ(line(command(CommandId::kPulse)), "PULSE or SYNC0");
  EXPECT_EQ(line(command(CommandId::kOpen, 1)), "OPEN 1");
  EXPECT_EQ(line(setTruePose({1000, -20, 90})),
            "SIM_SET_POSE: true x 1000 mm, true y -20 mm, true heading 90 deg");
  EXPECT_EQ(line(simulatorControl({SimulatorControl::kLoadMap, "a.map"})),
            "SIM_CTRL: operation 1, file \"a.map\"");
  EXPECT_EQ(line(simulatorControl({SimulatorControl::kInfo, ""})), "SIM_CTRL: operation 6");
  EXPECT_EQ(line(command(static_cast<CommandId>(111), 5)), "command 111 5");
  EXPECT_EQ(describe({11, {}}, Direction::kFromClient).summary,
            "Drives at that speed, backward if negative.");
}

TEST(PacketDescriptionTest, informationIsShownInUnitsThatPeopleUse) {
  StandardInformation sip;
  sip.heading4096 = 1024;
  sip.batteryDecivolts = 131;
  sip.stallAndBumpers = 0x0201;
  sip.flags = 0x0003;
  sip.sonars = {{7, 1500}};
  sip.gripState = 0x12;
  const PacketDescription description = describe(toPacket(sip), Direction::kFromRobot);
  EXPECT_EQ(description.name, "standard information");
  const auto field = [&](const std::string& name) {
    for (const PacketField& found : description.fields) {
      if (found.name == name) return found.value + (found.unit.empty() ? "" : " " + found.unit);
    }
    return std::string("missing");
  };
  EXPECT_EQ(field("heading"), "90 deg");
  EXPECT_EQ(field("battery"), "13.1 V");
  EXPECT_EQ(field("stall and bumpers"), "0x0201 left stall, front 1");
  EXPECT_EQ(field("flags"), "0x0003 motors on, sonar array 1");
  EXPECT_EQ(field("sonars"), "1");
  EXPECT_EQ(field("sonar 7"), "1500 mm");
  EXPECT_EQ(field("gripper state"), "0x12 closed, lift up");
  EXPECT_EQ(field("analog port"), "missing");
}

TEST(PacketDescriptionTest, valuesWithAMeaningAreNamed) {
  StandardInformation sip;
  sip.gripState = sip.analogPort = sip.analog = sip.digitalIn = sip.digitalOut = std::uint8_t{0};
  sip.batteryDecivolts16 = 131;
  sip.chargeState = 3;
  sip.rotationRateDeciDegS = -15;
  sip.faultFlags = 0x0010;
  sip.lateralSpeedMmS = 0;
  sip.temperatureDegC = StandardInformation::kNoTemperature;
  sip.stateOfChargePercent = 50;
  EXPECT_TRUE(
      fromRobot(sip).ends_with("battery, fine 13.1 V, charge state float, rotation rate -1.5 deg/s, "
                               "fault flags 0x0010 gyroscope, lateral speed 0 mm/s, temperature unknown, "
                               "state of charge 50 %"))
      << fromRobot(sip);
  LaserPacket laser;
  laser.total = 1;
  laser.readings = {{5000, 3, {}}};
  EXPECT_EQ(fromRobot(laser),
            "laser: total 1 readings, first 0, readings 1, reading 0 5000 mm, "
            "reading 0 reflectance 3, device 0, flags 0x00");
  Configuration configuration;
  configuration.auxBaud1 = 4;
  EXPECT_NE(fromRobot(configuration).find("host baud 9600 baud, aux baud 1 115200 baud"), std::string::npos);
}

TEST(PacketDescriptionTest, everyPacketOfARobotIsNamedWithItsFields) {
  EXPECT_EQ(fromRobot(EncoderPacket{-1, 2, {}}), "encoder: left -1 ticks, right 2 ticks");
  EXPECT_EQ(fromRobot(Identity{"A", "Pioneer", "p3at-sh", {}}),
            "identity: name \"A\", class \"Pioneer\", subclass \"p3at-sh\"");
  EXPECT_EQ(fromRobot(IoPacket{{1, 2}, {3}, {1023}, {}}),
            "inputs and outputs: digital inputs 2, digital in 0 0x01, digital in 1 0x02, digital outputs 1, "
            "digital out 0 0x03, analog inputs 1, analog in 0 5 V");
  EXPECT_EQ(fromRobot(BatteryPacket{5, {{1, 0, 0, 90, 80, {}}}, {}}),
            "battery: batteries 1, battery 0 flags 1 0x01, battery 0 flags 2 0x00, battery 0 flags 3 0x00, "
            "battery 0 relative charge 90 %, battery 0 absolute charge 80 %");
  EXPECT_EQ(fromRobot(CompassPacket{3599, -10, 20, {1, -2, 3}, 215, 0, 5, 6, 700, {}}),
            "compass: heading 359.9 deg, pitch -1 deg, roll 2 deg, magnetic x 0.01 uT, magnetic y -0.02 uT, "
            "magnetic z 0.03 uT, temperature 21.5 degC, error 0x0000, horizontal score 5, vertical score 6, "
            "magnetic score 7");
  EXPECT_EQ(fromRobot(RawPacket{{0, {}}}), "SYNC0 echo");
  EXPECT_EQ(fromRobot(RawPacket{{0x7A, {1, 255}}}), "packet 0x7a: bytes 01ff");
  EXPECT_EQ(describe({0x90, {1}}, Direction::kFromRobot).line(),
            "encoder: bytes 01 (the encoder packet of 1 bytes ends before its left)");
}

TEST(PacketDescriptionTest, longOnesAreCutInTheirLine) {
  StandardInformation sip;
  sip.sonars.resize(16);
  const std::string text = describe(toPacket(sip), Direction::kFromRobot).line(80);
  EXPECT_LT(text.size(), 130U);
  EXPECT_TRUE(text.ends_with(", ...")) << text;
}

TEST(PacketDescriptionTest, anyBytesHaveADescription) {
  for (unsigned id = 0; id < 256; ++id) {
    for (const char* data :
         {"", "00", "3B", "1B05", "2B03", "2B0361626300", "0102030405060708090A0B0C0D0E0F", "FFFFFFFFFFFF"}) {
      for (const Direction direction : {Direction::kFromClient, Direction::kFromRobot}) {
        const PacketDescription found = describe({static_cast<std::uint8_t>(id), hexBytes(data)}, direction);
        EXPECT_FALSE(found.name.empty());
        EXPECT_FALSE(found.line().empty());
      }
    }
  }
}

}  // namespace
}  // namespace robotlink::arcos
