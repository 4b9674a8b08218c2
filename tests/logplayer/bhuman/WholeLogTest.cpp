// SPDX-License-Identifier: GPL-3.0-or-later
// Whole logs of 2009, message by message: that of a real robot, and one that was made up.
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
#include "tests/game/Data.h"
#include "tests/game/Log.h"

using namespace logplayer;
using namespace logplayer::bhuman;

namespace {

/// What is known of a log.
struct Figures {
  std::uint64_t messages = 0, images = 0, motions = 0, texts = 0;
  int uncertain = 0;
  std::size_t entries = 0;  ///< of the log of texts: of the program, and of uncertain poses
  std::int64_t firstImageMs = 0, firstJointsMs = 0;
  double headTilt = 0, firstX = 0, lastX = 0;  ///< rad, m
  std::map<std::string, double> readings;
};
const Figures kReal{
    2444,   160,
    274,    0,
    22,     1,
    486749, 486549,
    0.463,  -0.0424,
    1.4838, {{"batteryLevel", 0.98}, {"temperature/headPan", 0x26}, {"key/chest", 0}, {"angleY", -0.0873}}};
const Figures kMade{
    game::Log::kMessages,
    game::View::kCount,
    game::Log::kMotionFrames,
    1,
    game::Log::kUncertain,
    3,
    game::Log::imageMs(0),
    game::Log::motionMs(0),
    0.1,
    0,
    game::Log::walkedMm(game::Log::kMotionFrames - 1) / 1000,
    {{"batteryLevel", 0.25}, {"temperature/headPan", 40}, {"key/chest", 1}, {"angleY", 0.25}}};

/// A log's messages by their streams.
struct ImportedLog {
  std::map<std::string, std::vector<robotlink::StreamMessage>> streams;
  std::vector<std::string> lastPaths;
  std::size_t frames = 0;
  ImportReport report;

  void read(const std::filesystem::path& file) {
    const auto source = openFile(file.string());
    ASSERT_TRUE(source) << source.error().describe();
    const auto imported = importQueue(**source, "nao",
                                      [this](FrameConverter::Frame frame) {
                                        ++frames;
                                        lastPaths.push_back(frame.back().path);
                                        for (auto& message : frame) streams[message.path].push_back(message);
                                        return robotlink::Result<void>();
                                      },
                                      {});
    ASSERT_TRUE(imported) << imported.error().describe();
    report = *imported;
  }
};

/// The parameter is the source of the log, which is read once for all tests.
class WholeLog : public testing::TestWithParam<std::string> {
 protected:
  static void TearDownTestSuite() { logs_.clear(); }
  void SetUp() override {
    const auto file = game::dataOf(GetParam()) / "logs/bhuman2009.log";
    if (!std::filesystem::exists(file)) GTEST_SKIP() << "the real log is not at " << file;
    auto& log = logs_[GetParam()];
    if (!log) {
      log = std::make_unique<ImportedLog>();
      log->read(file);
    }
    log_ = log.get();
  }

  const Figures& expected() const { return GetParam() == "real" ? kReal : kMade; }
  std::filesystem::path images() const { return game::dataOf(GetParam()) / "colour/bhuman2009"; }
  const std::vector<robotlink::StreamMessage>& stream(const std::string& path) const {
    return log_->streams[path];
  }
  template <typename Type>
  std::vector<const Type*> packages(const std::string& path) const {
    std::vector<const Type*> result;
    for (const auto& message : stream(path)) result.push_back(dynamic_cast<const Type*>(message.value.get()));
    return result;
  }

  static inline std::map<std::string, std::unique_ptr<ImportedLog>> logs_;
  ImportedLog* log_ = nullptr;
};

std::int64_t millisecondsOf(robotlink::Instant time) {
  return std::chrono::duration_cast<std::chrono::milliseconds>(time.time_since_epoch()).count();
}

}  // namespace

TEST_P(WholeLog, everyMessageIsAccountedFor) {
  const ImportReport& report = log_->report;
  EXPECT_EQ(report.messages, expected().messages);
  EXPECT_EQ(report.damage, "");
  EXPECT_TRUE(report.notUnderstood.empty());
  const std::uint64_t images = expected().images, motions = expected().motions;
  std::map<std::string, std::uint64_t> counts = {{"ProcessBegin", images + motions},
                                                 {"ProcessFinished", images + motions},
                                                 {"JPEGImage", images},
                                                 {"CameraMatrix", images},
                                                 {"ImageCoordinateSystem", images},
                                                 {"JointData", motions},
                                                 {"SensorData", motions},
                                                 {"OdometryData", motions},
                                                 {"KeyStates", motions}};
  if (expected().texts > 0) counts["Text"] = expected().texts;
  EXPECT_EQ(report.imported, counts);
}

TEST_P(WholeLog, framesEndWithTheirNumberAndCountFromOne) {
  EXPECT_EQ(log_->frames, expected().images + expected().motions);
  for (const std::string& path : log_->lastPaths) EXPECT_EQ(path.rfind("nao/frames/", 0), 0U) << path;
  for (const auto& [path, count] :
       {std::pair{"nao/frames/cognition", expected().images}, {"nao/frames/motion", expected().motions}}) {
    const auto infos = packages<robotcontrol::FrameInfo>(path);
    ASSERT_EQ(infos.size(), count);
    for (std::size_t i = 0; i < infos.size(); ++i) EXPECT_EQ(infos[i]->number(), i + 1);
  }
}

TEST_P(WholeLog, imagesHaveTheTimesThatTheirFileStates) {
  const auto& images = stream("nao/camera/image");
  ASSERT_EQ(images.size(), expected().images);
  EXPECT_EQ(millisecondsOf(images.front().time), expected().firstImageMs);
  const auto text = robotlink::readFile(this->images() / "timestamps_ms.txt");
  ASSERT_TRUE(text) << text.error().describe();
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

TEST_P(WholeLog, imagesShowWhatTheCameraSaw) {
  const auto images = packages<foxglove::RawImage>("nao/camera/image");
  // The made images were compressed on their way into the log, the real ones before they were decoded
  // elsewhere, by a decoder that may differ in its last bits.
  const int most = GetParam() == "real" ? 2 : 12;
  int compared = 0;
  for (const auto& entry : std::filesystem::directory_iterator(this->images() / "yuyv")) {
    const int number = std::stoi(entry.path().stem());
    const auto quads = robotlink::readFile(entry.path());
    ASSERT_TRUE(quads) << quads.error().describe();
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
    EXPECT_LE(largest, most) << "image " << number;
  }
  EXPECT_EQ(compared, 12);
}

TEST_P(WholeLog, cameraPosesAreThoseOfAStandingRobot) {
  const auto poses = packages<robotcontrol::CameraPose>("nao/camera/pose");
  ASSERT_EQ(poses.size(), expected().images);
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
  EXPECT_EQ(uncertain, expected().uncertain);
  EXPECT_EQ(stream("nao/log").size(), expected().entries)
      << "uncertain poses when they began, and when they ended";
}

TEST_P(WholeLog, theBodyIsImportedInSiUnits) {
  const auto joints = packages<foxglove::JointStates>("nao/joints/states");
  ASSERT_EQ(joints.size(), expected().motions);
  EXPECT_EQ(joints[0]->joints_size(), 22);
  EXPECT_EQ(joints[0]->joints(1).name(), "headTilt");
  EXPECT_NEAR(joints[0]->joints(1).position(), expected().headTilt, 1e-3);
  EXPECT_EQ(millisecondsOf(stream("nao/joints/states")[0].time), expected().firstJointsMs);

  const auto sensors = packages<robotcontrol::BodySensors>("nao/body/sensors");
  double mean = 0;
  for (const auto* each : sensors) mean += each->acceleration().z() / static_cast<double>(sensors.size());
  EXPECT_NEAR(mean, 9.81, 0.5) << "gravity, upwards for a standing body";

  const auto odometry = packages<robotcontrol::MotionStatus>("nao/motion/status");
  EXPECT_NEAR(odometry.front()->odometry().x(), expected().firstX, 1e-4);
  EXPECT_NEAR(odometry.back()->odometry().x(), expected().lastX, 1e-4);
  for (std::size_t i = 1; i < odometry.size(); ++i) {
    const double moved = std::hypot(odometry[i]->odometry().x() - odometry[i - 1]->odometry().x(),
                                    odometry[i]->odometry().y() - odometry[i - 1]->odometry().y());
    EXPECT_LT(moved, 0.1) << "between frames some 100 ms apart";
  }
}

TEST_P(WholeLog, otherSensorsKeepTheirNames) {
  const auto readings = packages<robotcontrol::BodyReadings>("nao/body/readings");
  ASSERT_EQ(readings.size(), expected().motions);
  std::map<std::string, double> first;
  for (const auto& reading : readings[0]->readings()) first[reading.name()] = reading.value();
  for (const auto& [name, value] : expected().readings) EXPECT_NEAR(first.at(name), value, 1e-4) << name;
  EXPECT_EQ(first.count("gyroZ"), GetParam() == "real" ? 0U : 1U) << "the real robot has none";
}

INSTANTIATE_TEST_SUITE_P(Logs, WholeLog, testing::ValuesIn(game::kSources),
                         [](const auto& source) { return source.param; });
