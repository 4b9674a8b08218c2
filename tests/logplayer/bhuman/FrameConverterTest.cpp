// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <array>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/bhuman/QueueImport.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/Random.h"
#include "tests/logplayer/bhuman/MemoryBytes.h"
#include "tests/logplayer/bhuman/QueueBuilder.h"

using namespace logplayer;
using namespace logplayer::bhuman;

namespace {

struct Imported {
  std::vector<FrameConverter::Frame> frames;
  ImportReport report;

  /// "motion 1 @100: joints/states motion/status frames/motion", a line for each frame.
  std::string text() const {
    std::string result;
    for (const auto& frame : frames) {
      const auto time =
          std::chrono::duration_cast<std::chrono::milliseconds>(frame[0].time.time_since_epoch());
      result +=
          frame[0].process + " " + std::to_string(frame[0].frame) + " @" + std::to_string(time.count()) + ":";
      for (const auto& message : frame) result += " " + message.path.substr(4);
      result += "\n";
    }
    return result;
  }
};

Imported import(const std::vector<std::uint8_t>& file) {
  Imported result;
  const auto source = bytesInMemory(file);
  const auto report = importQueue(*source, "nao",
                                  [&](FrameConverter::Frame frame) {
                                    result.frames.push_back(std::move(frame));
                                    return robotlink::Result<void>();
                                  },
                                  {});
  EXPECT_TRUE(report);
  if (report) result.report = *report;
  return result;
}

}  // namespace

TEST(FrameConverter, framesHaveTheTimeOfTheirImageOrJoints) {
  const auto imported = import(QueueBuilder()
                                   .begin('m')
                                   .joints(100)
                                   .odometry(0.1, 20, 30)
                                   .end('m')
                                   .begin('c')
                                   .image(150, 4, 2)
                                   .cameraMatrix(true)
                                   .end('c')
                                   .begin('m')
                                   .joints(200)
                                   .keys()
                                   .end('m')
                                   .file());
  EXPECT_EQ(imported.text(),
            "motion 1 @100: joints/states motion/status frames/motion\n"
            "cognition 1 @150: camera/image camera/pose frames/cognition\n"
            "motion 2 @200: joints/states body/readings frames/motion\n");
}

TEST(FrameConverter, valuesAreConvertedToSiUnits) {
  const auto imported = import(QueueBuilder().begin('m').joints(100).odometry(0.1, 20, 30).end('m').file());
  const auto& joints = dynamic_cast<const foxglove::JointStates&>(*imported.frames[0][0].value);
  EXPECT_FALSE(joints.joints(0).has_position()) << "1000 is a joint that is off";
  EXPECT_DOUBLE_EQ(joints.joints(1).position(), 0.1);
  const auto& status = dynamic_cast<const robotcontrol::MotionStatus&>(*imported.frames[0][1].value);
  EXPECT_DOUBLE_EQ(status.odometry().x(), 0.02);
  EXPECT_DOUBLE_EQ(status.odometry().heading(), 0.1);
}

TEST(FrameConverter, rawImagesKeepTheSecondYOfEachQuadruple) {
  const auto imported = import(QueueBuilder().begin('c').image(150, 4, 2).end('c').file());
  const auto& image = dynamic_cast<const foxglove::RawImage&>(*imported.frames[0][0].value);
  EXPECT_EQ(image.width(), 4U);
  EXPECT_EQ(image.step(), 8U);
  EXPECT_EQ(image.data().substr(0, 4), "\x60\x40\x60\xA0");
}

TEST(FrameConverter, jpegsOfFourComponentsAreNotInverted) {
  const auto imported = import(QueueBuilder().begin('c').jpegImage(150, 16, 8).end('c').file());
  EXPECT_EQ(imported.report.damage, "");
  const auto& image = dynamic_cast<const foxglove::RawImage&>(*imported.frames[0][0].value);
  ASSERT_EQ(image.data().size(), 16U * 8 * 2);
  constexpr std::array kExpected = {0x60, 0x40, 0x60, 0xA0};
  for (std::size_t i = 0; i < image.data().size(); ++i)
    EXPECT_NEAR(static_cast<std::uint8_t>(image.data()[i]), kExpected[i % 4], 2) << i;
}

TEST(FrameConverter, theCamerasAnglesAreThoseThatWereLogged) {
  const auto imported = import(
      QueueBuilder().begin('c').image(150, 4, 2).cameraMatrix(true).imageCoordinateSystem().end('c').file());
  const auto& pose = dynamic_cast<const robotcontrol::CameraPose&>(*imported.frames[0][1].value);
  EXPECT_EQ(pose.horizontal_angle(), 0.9);
  EXPECT_EQ(pose.vertical_angle(), 0.7);
  EXPECT_EQ(pose.width(), 160U);
}

TEST(FrameConverter, theAccelerationAtRestPointsUp) {
  const auto imported = import(QueueBuilder().begin('m').sensors(100).end('m').file());
  const auto& sensors = dynamic_cast<const robotcontrol::BodySensors&>(*imported.frames[0][0].value);
  EXPECT_NEAR(sensors.acceleration().z(), 9.81, 1e-6);
  EXPECT_NEAR(sensors.acceleration().x(), -9.81 / 4, 1e-6);
}

TEST(FrameConverter, textsBecomeMessagesOfTheLog) {
  const auto imported =
      import(QueueBuilder().begin('c').image(150, 4, 2).text("ball lost \xFF").end('c').file());
  const auto& log = dynamic_cast<const foxglove::Log&>(*imported.frames[0][1].value);
  EXPECT_EQ(log.message(), "ball lost ?");
  EXPECT_EQ(log.name(), "cognition");
}

TEST(FrameConverter, framesWithoutATimeGetThatOfTheOneBefore) {
  const auto imported = import(QueueBuilder()
                                   .begin('c')
                                   .text("starting")
                                   .end('c')
                                   .begin('m')
                                   .joints(100)
                                   .end('m')
                                   .begin('m')
                                   .joints(200)
                                   .end('m')
                                   .begin('c')
                                   .text("running")
                                   .end('c')
                                   .file());
  EXPECT_EQ(imported.text(),
            "cognition 1 @100: log frames/cognition\n"
            "motion 1 @100: joints/states frames/motion\n"
            "motion 2 @200: joints/states frames/motion\n"
            "cognition 2 @100: log frames/cognition\n");
}

TEST(FrameConverter, aFrameThatWouldPublishNothingIsNone) {
  const auto imported = import(
      QueueBuilder().imageCoordinateSystem().begin('m').joints(100).end('m').imageCoordinateSystem().file());
  EXPECT_EQ(imported.text(), "motion 1 @100: joints/states frames/motion\n");
  EXPECT_EQ(imported.report.imported.at("ImageCoordinateSystem"), 2U);
}

TEST(FrameConverter, aTimeFarFromThoseAroundItIsDamaged) {
  const auto imported = import(QueueBuilder()
                                   .begin('m')
                                   .joints(1000)
                                   .end('m')
                                   .begin('m')
                                   .joints(0x80000000U + 1100)
                                   .end('m')
                                   .begin('m')
                                   .joints(1200)
                                   .end('m')
                                   .file());
  EXPECT_EQ(imported.text(),
            "motion 1 @1000: joints/states frames/motion\n"
            "motion 2 @1000: joints/states frames/motion\n"
            "motion 3 @1200: joints/states frames/motion\n");
  EXPECT_NE(imported.report.damage.find("the time of a frame, 2147484.748"), std::string::npos)
      << imported.report.damage;
}

TEST(FrameConverter, aGapThatTheNextFrameConfirmsIsOne) {
  const auto imported = import(QueueBuilder()
                                   .begin('m')
                                   .joints(1000)
                                   .end('m')
                                   .begin('m')
                                   .joints(900000)
                                   .end('m')
                                   .begin('m')
                                   .joints(900100)
                                   .end('m')
                                   .file());
  EXPECT_EQ(imported.text(),
            "motion 1 @1000: joints/states frames/motion\n"
            "motion 2 @900000: joints/states frames/motion\n"
            "motion 3 @900100: joints/states frames/motion\n");
  EXPECT_EQ(imported.report.damage, "");
}

TEST(FrameConverter, framesWithoutTheirEndOrBeginningAreKeptAndReported) {
  const auto imported = import(QueueBuilder()
                                   .begin('m')
                                   .joints(100)
                                   .begin('m')
                                   .joints(200)
                                   .joints(300)
                                   .end('m')
                                   .end('m')
                                   .joints(400)
                                   .file());
  EXPECT_EQ(imported.text(),
            "motion 1 @100: joints/states frames/motion\n"
            "motion 2 @200: joints/states frames/motion\n"
            "motion 3 @300: joints/states frames/motion\n"
            " 0 @400: joints/states\n");
  EXPECT_NE(imported.report.damage.find("a process began before the one before it had ended"),
            std::string::npos);
  EXPECT_NE(imported.report.damage.find("a process ended without having begun"), std::string::npos);
}

TEST(FrameConverter, whatIsNotUnderstoodIsCountedByItsKind) {
  const auto imported = import(QueueBuilder()
                                   .begin('c')
                                   .image(150, 4, 2)
                                   .message(13, "a ball percept")
                                   .message(13, "another")
                                   .end('c')
                                   .begin('c')
                                   .message(200, "?")
                                   .end('c')
                                   .file());
  const std::map<std::string, std::uint64_t> expected = {{"BallPercept", 2}, {"id 200", 1}};
  EXPECT_EQ(imported.report.notUnderstood, expected);
  EXPECT_EQ(imported.report.imported.at("Image"), 1U);
  EXPECT_EQ(imported.report.messages, 8U);
}

TEST(FrameConverter, anImageThatCannotBeReadIsReportedWithItsPlace) {
  QueueBuilder builder;
  builder.begin('c');
  const std::size_t offset = builder.size();
  std::string payload(16, '\0');
  payload[0] = payload[4] = 4;
  payload[12] = 5;
  builder.message(4, payload + "hello").end('c').begin('m').joints(100).end('m');
  const auto imported = import(builder.file());
  EXPECT_EQ(imported.report.notUnderstood.at("JPEGImage"), 1U);
  EXPECT_NE(imported.report.damage.find("at byte " + std::to_string(offset) + ": an image was left out"),
            std::string::npos)
      << imported.report.damage;
}

TEST(FrameConverter, aSizeThatIsOnlyClaimedTakesNoMemory) {
  std::string payload(16, '\x7F');
  payload.replace(12, 4, 4, '\0');
  const auto imported = import(QueueBuilder().begin('c').message(4, payload).end('c').file());
  EXPECT_EQ(imported.report.notUnderstood.at("JPEGImage"), 1U);
  EXPECT_NE(imported.report.damage.find("which no camera of these robots had"), std::string::npos);
}

TEST(FrameConverter, aCameraThatCannotBeReliedOnIsReported) {
  const auto imported = import(QueueBuilder()
                                   .begin('c')
                                   .image(100, 4, 2)
                                   .cameraMatrix(true)
                                   .end('c')
                                   .begin('c')
                                   .image(200, 4, 2)
                                   .cameraMatrix(false)
                                   .end('c')
                                   .begin('c')
                                   .image(300, 4, 2)
                                   .cameraMatrix(false)
                                   .end('c')
                                   .file());
  EXPECT_EQ(imported.text(),
            "cognition 1 @100: camera/image camera/pose frames/cognition\n"
            "cognition 2 @200: camera/image camera/pose log frames/cognition\n"
            "cognition 3 @300: camera/image camera/pose frames/cognition\n");
  const auto& pose = dynamic_cast<const robotcontrol::CameraPose&>(*imported.frames[1][1].value);
  EXPECT_TRUE(pose.uncertain());
  EXPECT_NEAR(pose.camera_in_robot().position().z(), 0.5, 1e-12);
  EXPECT_NEAR(pose.camera_in_robot().orientation().y(), std::sin(robotlink::radians(15)), 1e-9)
      << "30 degrees down";
}

TEST(FrameConverter, damagedLogsNeverDoHarm) {
  const auto file = QueueBuilder()
                        .begin('m')
                        .joints(100)
                        .odometry(0.1, 20, 30)
                        .keys()
                        .end('m')
                        .begin('c')
                        .image(150, 8, 4)
                        .cameraMatrix(true)
                        .text("hello")
                        .end('c')
                        .file();
  for (std::size_t size = 0; size < file.size(); ++size)
    import({file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size)});
  for (std::size_t at = 0; at < file.size(); ++at) {
    for (int bit = 0; bit < 8; ++bit) {
      auto damaged = file;
      damaged[at] = static_cast<std::uint8_t>(damaged[at] ^ (1U << bit));
      const auto imported = import(damaged);
      EXPECT_GE(imported.report.messages + 2, 10U) << at;
    }
  }
}
