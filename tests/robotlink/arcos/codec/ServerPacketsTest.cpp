// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/codec/ServerPackets.h"

#include <gtest/gtest.h>

#include "tests/robotlink/arcos/HexBytes.h"

namespace robotlink::arcos {
namespace {

StandardInformation information() {
  StandardInformation sip;
  sip.moving = true;
  sip.xMm = -12345;
  sip.yMm = 300;
  sip.heading4096 = -2047;
  sip.leftSpeedMmS = -100;
  sip.rightSpeedMmS = 101;
  sip.batteryDecivolts = 130;
  sip.stallAndBumpers = 0x0B05;
  sip.headingSetpoint4096 = 7;
  sip.flags = 0x001F;
  sip.compass2Deg = 45;
  sip.sonars = {{0, 5000}, {15, 123}};
  return sip;
}

/// All trailing fields, each another value.
StandardInformation longInformation() {
  StandardInformation sip = information();
  sip.gripState = 1;
  sip.analogPort = 2;
  sip.analog = 3;
  sip.digitalIn = 4;
  sip.digitalOut = 5;
  sip.batteryDecivolts16 = 131;
  sip.chargeState = 6;
  sip.rotationRateDeciDegS = -700;
  sip.faultFlags = 0x0018;
  sip.lateralSpeedMmS = -9;
  sip.temperatureDegC = -10;
  sip.stateOfChargePercent = 11;
  sip.controllerTimeUs = 0xFEDCBA98;
  sip.moreFlags = 13;
  return sip;
}

template <typename T>
void expectSameBack(const T& value) {
  const Packet packet = toPacket(value);
  const auto back = decodeServerPacket(packet);
  ASSERT_TRUE(back) << back.error().text;
  ASSERT_TRUE(std::holds_alternative<T>(*back)) << back->index();
  EXPECT_TRUE(std::get<T>(*back) == value);
  EXPECT_EQ(toPacket(*back), packet);
}

TEST(ServerPacketsTest, fieldsStandWhereTheManualHasThem) {
  const Packet packet = toPacket(longInformation());
  EXPECT_EQ(packet.id, 0x33);
  EXPECT_EQ(toHex(packet.data),
            toHex(hexBytes("C7CF 2C01 01F8 9CFF 6500 82 050B 0700 1F00 2D 02 008813 0F7B00"
                           "01 02 03 04 05 8300 06 44FD 1800 F7FF F6 0B 98BADCFE 0D000000")));
  StandardInformation sip = information();
  sip.moving = false;
  EXPECT_EQ(toPacket(sip).id, 0x32);
}

TEST(ServerPacketsTest, informationMayEndBehindEveryTrailingField) {
  const Packet whole = toPacket(longInformation());
  const std::size_t required = toPacket(information()).data.size();
  for (std::size_t size = required; size <= whole.data.size(); ++size) {
    Packet cut = whole;
    cut.data.resize(size);
    const auto found = decode<StandardInformation>(cut);
    ASSERT_TRUE(found) << found.error().text;
    EXPECT_EQ(toPacket(*found), cut) << size;
    EXPECT_EQ(found->digitalOut.has_value(), size >= required + 5);
    EXPECT_EQ(found->rotationRateDeciDegS.has_value(), size >= required + 10);
  }
  Packet longer = whole;
  longer.data.push_back(99);
  EXPECT_EQ(decode<StandardInformation>(longer)->rest, Bytes{99});
}

TEST(ServerPacketsTest, shortPacketsSayWhatTheyLack) {
  Packet packet = toPacket(information());
  packet.data.resize(packet.data.size() - 1);
  const auto cut = decode<StandardInformation>(packet);
  ASSERT_FALSE(cut);
  EXPECT_EQ(cut.error().text, "the standard information packet of 24 bytes ends before its sonar");
  packet.data.resize(2);
  EXPECT_EQ(decode<StandardInformation>(packet).error().text,
            "the standard information packet of 2 bytes ends before its y");
  EXPECT_EQ(decode<EncoderPacket>(packet).error().text,
            "this is another packet than expected: standard information");
  EXPECT_FALSE(decode<Configuration>({Configuration::kId, hexBytes("4100 4200")}));
  EXPECT_FALSE(decode<Identity>({2, {}}));
  EXPECT_FALSE(decode<SimulatorInfo>({0x63, hexBytes("00 00 00000000 FFFFFFFF 00")}));
  EXPECT_FALSE(decode<BatteryPacket>({0xFA, hexBytes("01 04 01020304")}));
}

TEST(ServerPacketsTest, bumpersAndStallsAreInTheirBytes) {
  StandardInformation sip;
  sip.stallAndBumpers = 0x0301;
  EXPECT_TRUE(sip.leftStalled());
  EXPECT_TRUE(sip.rightStalled());
  EXPECT_EQ(sip.frontBumpers(), 1U);
  EXPECT_EQ(sip.rearBumpers(), 0U);
  sip.stallAndBumpers = 0x0022;
  EXPECT_FALSE(sip.leftStalled());
  EXPECT_EQ(sip.frontBumpers(), 0U);
  EXPECT_EQ(sip.rearBumpers(), 0x11U);
}

TEST(ServerPacketsTest, everyPacketIsReadAsItWasWritten) {
  expectSameBack(Identity{"MobileSim", "Pioneer", "p3at-sh", {}});
  expectSameBack(longInformation());
  expectSameBack(information());
  expectSameBack(EncoderPacket{-1, 1234567890, {}});
  expectSameBack(IoPacket{{1, 2, 3, 4}, {5}, {0, 1023, 512}, {9}});
  expectSameBack(GyroPacket{{{512, 25}, {1023, 0}}, {}});
  expectSameBack(ImuPacket{7, {{2, {-100}, {}, {30}}, {3, {1, 2, 3}, {-4, 5, 6}, {7, 8, 9}}}, {}});
  for (int port = 1; port <= 3; ++port) expectSameBack(AuxSerialPacket{port, {1, 2, 3}});
  expectSameBack(CompassPacket{3599, -10, 20, {1, -2, 3}, 215, 4, 5, 6, 700, {}});
  expectSameBack(GripperPacket{1, 2, 3, {}});
  expectSameBack(JoystickPacket{1, 0, -5, 6, 700, {}});
  expectSameBack(BatteryPacket{5, {{1, 2, 3, 90, 91, {}}, {4, 5, 6, 80, 81, {}}}, {}});
  expectSameBack(BatteryPacket{7, {{1, 2, 3, 90, 91, {8, 9}}, {4, 5, 6, 80, 81, {10, 11}}}, {12}});
  expectSameBack(SimulatorStatus{0, 0, 2, 100, 101, 99, 1, -2, 3, -4, 5, 6, 7, 8, 9, 10, 11, {}});
  expectSameBack(
      SimulatorInfo{"MobileSim", "0.9.8", 1, {{"laser", "LMS200", 0, 3}, {"sonar", "", 1, 0}}, {}});
  expectSameBack(MapChanged{1, 1, "office.map", {}});
  expectSameBack(RawPacket{{0xD0, {1, 2, 3}}});
}

TEST(ServerPacketsTest, lasersComePlainAndExtended) {
  LaserPacket extended;
  extended.total = 181;
  extended.first = 160;
  extended.readings = {{5000, 3, {}}, {32767, 0, {}}};
  extended.device = 1;
  extended.flags = 1;
  expectSameBack(extended);
  EXPECT_EQ(toHex(toPacket(extended).data),
            "b500a0000288130300"
            "00ff7f000000"
            "0101");

  LaserPacket plain;
  plain.extended = false;
  plain.total = 2;
  plain.xMm = -100;
  plain.headingDeg = 90;
  plain.readings = {{1, 0, {}}, {2, 0, {}}};
  expectSameBack(plain);
  EXPECT_EQ(toHex(toPacket(plain).data),
            "9cff00005a00"
            "02000000"
            "02"
            "01000200");
}

TEST(ServerPacketsTest, aSimulatorsStatusIsAsLongAsRealOnes) {
  EXPECT_EQ(toPacket(SimulatorStatus{}).count(), 59U);
}

TEST(ServerPacketsTest, configurationMayEndAnywhere) {
  Configuration whole;
  whole.subtype = "p3at-sh";
  whole.serialNumber = "SIM";
  whole.version = "1.0";
  whole.ticksMm = 138;
  whole.driftFactor = -3;
  whole.bootVersion = "boot";
  whole.highTemperatureDegC = -1;
  whole.configFlags = 0xFFFFFFFF;
  whole.gyroFirmwareVersion = -2;
  whole.fieldCount = Configuration::kAllFields;
  expectSameBack(whole);
  const Packet packet = toPacket(whole);
  for (std::size_t size = 20; size < packet.data.size(); ++size) {
    Packet cut = packet;
    cut.data.resize(size);
    const auto found = decode<Configuration>(cut);
    ASSERT_TRUE(found) << found.error().text;
    EXPECT_LT(found->fieldCount, Configuration::kAllFields);
    EXPECT_EQ(toPacket(*found), cut);
    EXPECT_EQ(found->gyroFirmwareVersion, 0);
  }
  Packet longer = packet;
  longer.data.push_back(1);
  EXPECT_EQ(decode<Configuration>(longer)->rest, Bytes{1});
}

}  // namespace
}  // namespace robotlink::arcos
