// SPDX-License-Identifier: GPL-3.0-or-later
// The log of a real robot, message by message.
#include <gtest/gtest.h>

#include <cmath>

#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "logplayer/bhuman/QueueImport.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Motion.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/packages/Conversions.h"
#include "tests/logplayer/bhuman/QueueBuilder.h"

using namespace logplayer;
using namespace logplayer::bhuman;

namespace {

constexpr char kColorData[] = ROBOTCONTROL_SOURCE_DIR "/../shared/data/colour/bhuman2009/";

/// The log's messages by their streams, read once for all tests.
class RealLog : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    bytes_ = realLog();
    if (bytes_.empty()) return;
    const auto source = bytesInMemory(bytes_);
    const auto report = importQueue(*source, "nao",
                                    [](FrameConverter::Frame frame) {
                                      ++frames_;
                                      lastPaths_.push_back(frame.back().path);
                                      for (auto& message : frame) streams_[message.path].push_back(message);
                                      return robotlink::Result<void>();
                                    },
                                    {});
    ASSERT_TRUE(report) << report.error().describe();
    report_ = *report;
  }
  void SetUp() override {
    if (bytes_.empty()) GTEST_SKIP() << "the real log is not at " << realLogPath();
  }

  template <typename Type>
  static std::vector<const Type*> packages(const std::string& stream) {
    std::vector<const Type*> result;
    for (const auto& message : streams_[stream])
      result.push_back(dynamic_cast<const Type*>(message.value.get()));
    return result;
  }

  static inline std::vector<std::uint8_t> bytes_;
  static inline std::map<std::string, std::vector<robotlink::StreamMessage>> streams_;
  static inline std::vector<std::string> lastPaths_;
  static inline std::size_t frames_ = 0;
  static inline ImportReport report_;
};

std::int64_t millisecondsOf(robotlink::Instant time) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

}  // namespace

TEST_F(RealLog, everyMessageIsAccountedFor) {
  EXPECT_EQ(report_.messages, 2444U);
  EXPECT_EQ(report_.damage, "");
  EXPECT_TRUE(report_.notUnderstood.empty());
  const std::map<std::string, std::uint64_t> expected = {
      {"ProcessBegin", 434}, {"ProcessFinished", 434},       {"JPEGImage", 160},
      {"CameraMatrix", 160}, {"ImageCoordinateSystem", 160}, {"JointData", 274},
      {"SensorData", 274},   {"OdometryData", 274},          {"KeyStates", 274}};
  EXPECT_EQ(report_.imported, expected);
}

TEST_F(RealLog, framesEndWithTheirNumberAndCountFromOne) {
  EXPECT_EQ(frames_, 434U);
  for (const std::string& path : lastPaths_) EXPECT_EQ(path.rfind("nao/frames/", 0), 0U) << path;
  for (const auto& [stream, count] : {std::pair{"nao/frames/cognition", 160U}, {"nao/frames/motion", 274U}}) {
    const auto infos = packages<robotcontrol::FrameInfo>(stream);
    ASSERT_EQ(infos.size(), count);
    for (std::size_t i = 0; i < infos.size(); ++i) EXPECT_EQ(infos[i]->number(), i + 1);
  }
}

TEST_F(RealLog, imagesHaveTheTimesThatTheirFileStates) {
  const auto& images = streams_["nao/camera/image"];
  ASSERT_EQ(images.size(), 160U);
  EXPECT_EQ(millisecondsOf(images.front().time), 486749);
  const auto text = robotlink::readFile(std::string(kColorData) + "timestamps_ms.txt");
  if (!text) GTEST_SKIP() << "the list of time stamps is missing";
  std::istringstream stated(*text);
  std::size_t i = 0;
  for (std::int64_t time = 0; stated >> time; ++i) {
    ASSERT_LT(i, images.size());
    EXPECT_EQ(millisecondsOf(images[i].time), time);
    EXPECT_EQ(images[i].process, "cognition");
    EXPECT_EQ(images[i].frame, i + 1);
  }
  EXPECT_EQ(i, images.size());
}

TEST_F(RealLog, imagesShowWhatWasDecodedElsewhere) {
  const auto images = packages<foxglove::RawImage>("nao/camera/image");
  int compared = 0;
  for (const int number : {0, 10, 26, 32, 50, 54, 66, 96, 112, 118, 126, 138}) {
    char name[16];
    std::snprintf(name, sizeof name, "yuyv/%03d.yuyv", number);
    const auto quads = robotlink::readFile(std::string(kColorData) + name);
    if (!quads) continue;
    ++compared;
    ASSERT_EQ(quads->size(), 320U * 240 * 4);
    const robotlink::ImageView image = robotlink::imageView(*images[static_cast<std::size_t>(number)]);
    ASSERT_EQ(image.width, 320);
    ASSERT_EQ(image.height, 240);
    const auto channel = [&](int x, int y, int i) {
      return static_cast<std::uint8_t>((*quads)[static_cast<std::size_t>((y * 320 + x) * 4 + i)]);
    };
    int largest = 0;
    for (int y = 0; y < 240; ++y) {
      for (int x = 0; x < 320; ++x) {
        const robotlink::YCbCr color = robotlink::yuyvPixel(image, x, y);
        const int cb = (channel(x & ~1, y, 1) + channel(x | 1, y, 1) + 1) / 2,
                  cr = (channel(x & ~1, y, 3) + channel(x | 1, y, 3) + 1) / 2;
        largest = std::max({largest, std::abs(color.y - channel(x, y, 2)), std::abs(color.cb - cb),
                            std::abs(color.cr - cr)});
      }
    }
    EXPECT_LE(largest, 2) << "image " << number << ": decoders may differ in their last bits";
  }
  if (compared == 0) GTEST_SKIP() << "the decoded images are missing";
}

TEST_F(RealLog, cameraPosesAreThoseOfAStandingRobot) {
  const auto poses = packages<robotcontrol::CameraPose>("nao/camera/pose");
  ASSERT_EQ(poses.size(), 160U);
  int uncertain = 0;
  for (const auto* pose : poses) {
    const robotlink::Pose3 camera = robotlink::pose3(pose->camera_in_robot());
    EXPECT_GT(camera.translation().z(), 0.40);
    EXPECT_LT(camera.translation().z(), 0.50);
    EXPECT_LT(camera.linear()(2, 0), 0.05) << "it looks down, at the ball and the field";
    EXPECT_NEAR(pose->horizontal_angle(), 0.78674, 1e-9);
    EXPECT_NEAR(pose->vertical_angle(), 0.60349, 1e-9);
    // Square pixels.
    EXPECT_NEAR(160 / std::tan(pose->horizontal_angle() / 2), 120 / std::tan(pose->vertical_angle() / 2),
                0.5);
    EXPECT_EQ(pose->width(), 320U);
    uncertain += pose->uncertain() ? 1 : 0;
  }
  EXPECT_EQ(uncertain, 22);
  EXPECT_EQ(streams_["nao/log"].size(), 1U) << "told once, when it began";
}

TEST_F(RealLog, theBodyIsImportedInSiUnits) {
  const auto joints = packages<foxglove::JointStates>("nao/joints/states");
  ASSERT_EQ(joints.size(), 274U);
  EXPECT_EQ(joints[0]->joints_size(), 22);
  EXPECT_EQ(joints[0]->joints(1).name(), "headTilt");
  EXPECT_NEAR(joints[0]->joints(1).position(), 0.46331, 1e-5);
  EXPECT_EQ(millisecondsOf(streams_["nao/joints/states"][0].time), 486549);

  const auto sensors = packages<robotcontrol::BodySensors>("nao/body/sensors");
  double mean = 0;
  for (const auto* each : sensors) mean += each->acceleration().z() / static_cast<double>(sensors.size());
  EXPECT_NEAR(mean, 9.81, 0.5) << "gravity, upwards for a standing body";

  const auto odometry = packages<robotcontrol::MotionStatus>("nao/motion/status");
  EXPECT_NEAR(odometry.front()->odometry().x(), -0.04236, 1e-5);
  EXPECT_NEAR(odometry.back()->odometry().x(), 1.48375, 1e-5);
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const double moved = std::hypot(odometry[i]->odometry().x() - odometry[i - 1]->odometry().x(),
                                    odometry[i]->odometry().y() - odometry[i - 1]->odometry().y());
    EXPECT_LT(moved, 0.1) << "between frames some 100 ms apart";
  }
}

TEST_F(RealLog, otherSensorsKeepTheirNames) {
  const auto readings = packages<robotcontrol::BodyReadings>("nao/body/readings");
  ASSERT_EQ(readings.size(), 274U);
  std::map<std::string, double> first;
  for (const auto& reading : readings[0]->readings()) first[reading.name()] = reading.value();
  EXPECT_NEAR(first.at("batteryLevel"), 0.98, 1e-6);
  EXPECT_EQ(first.at("temperature/headPan"), 0x26);
  EXPECT_EQ(first.at("key/chest"), 0);
  EXPECT_EQ(first.count("gyroZ"), 0U) << "the robot has none";
  EXPECT_NEAR(first.at("angleY"), -0.08727, 1e-5);
}
