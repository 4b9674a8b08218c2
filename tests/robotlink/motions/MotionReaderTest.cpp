// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionReader.h"

#include <gtest/gtest.h>

#include "robotlink/base/Geometry.h"
#include "robotlink/base/Random.h"
#include "robotlink/motions/MotionWriter.h"

namespace robotlink {
namespace {

const std::vector<std::string> kJoints{"a", "b", "c"};

/// The only error of a text, as "id line:column".
std::string errorOf(const std::string& text) {
  const auto motion = readMotion(text, "x.mof", kJoints);
  if (motion) return "none";
  std::string result;
  for (const Error& error : motion.error()) {
    if (!result.empty()) result += ", ";
    result += error.id + " " + std::to_string(error.where.line) + ":" + std::to_string(error.where.column);
  }
  return result;
}

TEST(MotionReaderTest, aMotionIsReadLineByLine) {
  const auto motion = readMotion(
      "motion_id = nod\r\n\r\n\"what it does\"\r\nlabel start\r\nhardness 100 50 * 200\r\n"
      "90 -45.5 *  1 300 // down\r\n~ - +10 0 8\r\ntransition allMotions extern start\r\n",
      "nod.mof", kJoints);
  ASSERT_TRUE(motion) << describe(motion.error());
  EXPECT_EQ(motion->name, "nod");
  ASSERT_EQ(motion->lines.size(), 7u);
  EXPECT_EQ(motion->lines[1].comment, "\"what it does\"");
  EXPECT_EQ(std::get<MotionLabel>(motion->lines[2].statement).name, "start");
  const auto& hardness = std::get<MotionHardness>(motion->lines[3].statement);
  EXPECT_EQ(hardness.shares, (std::vector<std::optional<double>>{1.0, 0.5, std::nullopt}));
  EXPECT_EQ(hardness.duration, std::chrono::milliseconds(200));
  const auto& frame = std::get<KeyFrame>(motion->lines[4].statement);
  EXPECT_DOUBLE_EQ(frame.joints[0].angle, kPi / 2);
  EXPECT_DOUBLE_EQ(frame.joints[1].angle, radians(-45.5));
  EXPECT_EQ(frame.joints[2].kind, JointValue::Kind::kKeep);
  EXPECT_EQ(frame.interpolation, 1);
  EXPECT_EQ(frame.duration, std::chrono::milliseconds(300));
  EXPECT_EQ(motion->lines[4].comment, "// down");
  EXPECT_EQ(motion->lines[4].number, 6);
  const auto& loose = std::get<KeyFrame>(motion->lines[5].statement);
  EXPECT_EQ(loose.joints[0].kind, JointValue::Kind::kKeep);
  EXPECT_EQ(loose.joints[1].kind, JointValue::Kind::kRelease);
  EXPECT_DOUBLE_EQ(loose.joints[2].angle, radians(10));
  EXPECT_EQ(std::get<MotionTransition>(motion->lines[6].statement).request, "allMotions");
}

TEST(MotionReaderTest, theHeaderSaysWhatColumnsAndNumbersMean) {
  const auto motion = readMotion(
      "motion_id = nod\njoints = c a\nunits = mrad\ntime = ticks\nbegin = walk\nodometry = 20 -5.5 30\n"
      "label start\n1500 -250 1 4\n",
      "nod.mof", kJoints);
  ASSERT_TRUE(motion) << describe(motion.error());
  EXPECT_EQ(motion->joints, (std::vector<std::string>{"c", "a"}));
  const auto& frame = std::get<KeyFrame>(motion->lines[1].statement);
  EXPECT_DOUBLE_EQ(frame.joints[0].angle, 1.5);
  EXPECT_DOUBLE_EQ(frame.joints[1].angle, -0.25);
  EXPECT_EQ(frame.duration, std::chrono::milliseconds(32));
  EXPECT_EQ(motion->begin, MotionFile::Begin::kWalk);
  EXPECT_DOUBLE_EQ(motion->odometry.x, 0.02);
  EXPECT_DOUBLE_EQ(motion->odometry.y, -0.0055);
  EXPECT_DOUBLE_EQ(motion->odometry.heading, radians(30));
  EXPECT_EQ(*readMotion(writeMotion(*motion), "nod.mof", kJoints), *motion);
}

TEST(MotionReaderTest, columnsAreCountedWhenNobodyNamesThem) {
  EXPECT_TRUE(readMotion("motion_id = x\nlabel start\n1 2 3 4 0 100\n5 6 7 8 1 100\n", "x.mof"));
  const auto motion = readMotion("motion_id = x\nlabel start\n1 2 3 4 0 100\n5 6 7 1 100\n", "x.mof");
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error()[0].describe(), "x.mof:4:9: expected 4 joints and 2 more numbers, found 5 values");
}

TEST(MotionReaderTest, eachFaultIsReportedWhereItStands) {
  const std::string head = "motion_id = x\nlabel start\n";
  EXPECT_EQ(errorOf(head + "1 2 3 1 100\n"), "none");
  EXPECT_EQ(errorOf(head + "1 2 1 100\n"), "motion.wrong-count 3:7");
  EXPECT_EQ(errorOf(head + "1 2 3 4 1 100\n"), "motion.wrong-count 3:7");
  EXPECT_EQ(errorOf(head + "1 211 3 1 100\n"), "motion.angle-out-of-range 3:3");
  EXPECT_EQ(errorOf(head + "1 nan 3 1 100\n"), "motion.bad-angle 3:3");
  EXPECT_EQ(errorOf(head + "1 2x 3 1 100\n"), "motion.bad-angle 3:3");
  EXPECT_EQ(errorOf(head + "1 2 3 4 100\n"), "motion.bad-interpolation 3:7");
  EXPECT_EQ(errorOf(head + "1 2 3 1 0\n"), "motion.bad-duration 3:9");
  EXPECT_EQ(errorOf(head + "1 2 3 1 -8\n"), "motion.bad-duration 3:9");
  EXPECT_EQ(errorOf(head + "1 2 3 1 1e300\n"), "motion.bad-duration 3:9");
  EXPECT_EQ(errorOf(head + "hardness 1 2 101 5\n"), "motion.bad-hardness 3:14");
  EXPECT_EQ(errorOf(head + "hardness 1 2 5\n"), "motion.wrong-count 3:14");
  EXPECT_EQ(errorOf(head + "label\n"), "motion.wrong-count 3:1");
  EXPECT_EQ(errorOf(head + "transition a b\n"), "motion.wrong-count 3:14");
  EXPECT_EQ(errorOf(head + "transition a b c/d\n"), "motion.bad-name 3:16");
  EXPECT_EQ(errorOf(head + "  jump x\n"), "motion.unknown-line 3:3");
  EXPECT_EQ(errorOf(head + "motion_id = y\n"), "motion.second-name 3:13");
  EXPECT_EQ(errorOf(head + "units = rad\n"), "motion.bad-header 3:1");
  EXPECT_EQ(errorOf(head + "begin = run\n"), "motion.bad-header 3:1");
  EXPECT_EQ(errorOf(head + "odometry = 1 2\n"), "motion.bad-header 3:1");
  EXPECT_EQ(errorOf(head + "odometry = 1 2 x\n"), "motion.bad-odometry 3:16");
  EXPECT_EQ(errorOf(head + "odometry = 1001 2 3\n"), "motion.bad-odometry 3:12");
  EXPECT_EQ(errorOf(head + "1 2 3 1 100\nunits = mrad\n"), "motion.late-header 4:1");
  EXPECT_EQ(errorOf("motion_id = x\njoints = a a\n"), "motion.duplicate-joint 2:12");
  EXPECT_EQ(errorOf("motion_id = x\njoints =\n"), "motion.no-joints 2:1");
  EXPECT_EQ(errorOf("label start\n"), "motion.no-name 1:1");
  EXPECT_EQ(errorOf(""), "motion.no-name 1:1");
}

TEST(MotionReaderTest, allFaultsOfAFileAreReportedTogether) {
  EXPECT_EQ(errorOf("motion_id = x\nlabel start\n1 2 3 9 100\n1 2 1 100\n"),
            "motion.bad-interpolation 3:7, motion.wrong-count 4:7");
}

TEST(MotionReaderTest, tooLongAFileIsRefused) {
  std::string text = "motion_id = x\n";
  for (int i = 0; i < kMaxMotionLines; ++i) text += "\n";
  EXPECT_EQ(errorOf(text), "motion.too-many-lines 32001:1");
  text = "motion_id = x\n";
  for (int i = 0; i <= kMaxMotionLabels; ++i) text += "label l" + std::to_string(i) + "\n";
  EXPECT_EQ(errorOf(text), "motion.too-many-labels 5002:1");
}

TEST(MotionReaderTest, anUnreadableFileIsAnError) {
  const auto motion = readMotionFile("/nonexistent/x.mof");
  ASSERT_FALSE(motion);
  EXPECT_EQ(motion.error()[0].id, "motion.unreadable");
}

TEST(MotionReaderTest, writtenTextGivesTheSameMotion) {
  const std::string text =
      "motion_id = nod\njoints = c a b\nunits = mrad\ntime = ticks\n\" remark\nlabel start\n\n"
      "hardness 100 50 * 20\n1500 -250.125 * 1 4 // down\n* - 10 3 1\ntransition allMotions extern start\n";
  const auto motion = readMotion(text, "nod.mof", kJoints);
  ASSERT_TRUE(motion) << describe(motion.error());
  EXPECT_EQ(writeMotion(*motion), text);
  EXPECT_EQ(*readMotion(writeMotion(*motion), "nod.mof", kJoints), *motion);
}

TEST(MotionReaderTest, damagedTextNeverCrashesTheReader) {
  const std::string text =
      "motion_id = nod\njoints = c a b\nunits = mrad\nlabel start\nhardness 100 50 * 20\n"
      "1500 -250.125 * 1 4 // down\n* - 10 3 1\ntransition allMotions extern start\n";
  Random random(7);
  int refused = 0;
  for (int round = 0; round < 3000; ++round) {
    std::string damaged = text.substr(0, text.size() - random.bits() % text.size());
    for (int i = 0; i < 3; ++i) damaged[random.bits() % damaged.size()] = static_cast<char>(random.bits());
    refused += readMotion(damaged, "x.mof").has_value() ? 0 : 1;
  }
  EXPECT_GT(refused, 500);
}

}  // namespace
}  // namespace robotlink
