// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/pictures/FrameImport.h"

#include <gtest/gtest.h>

#include <deque>
#include <numbers>

#include "foxglove/Image.pb.h"
#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Sensing.pb.h"

using namespace logplayer;
using robotlink::Duration;
using robotlink::StreamMessage;

namespace {

/// Frames that the test lists; an empty one is one that cannot be read.
class ListedFrames final : public FrameSource {
 public:
  explicit ListedFrames(std::deque<std::optional<Frame>> frames) : frames_(std::move(frames)) {}
  std::string format() const override { return "list"; }
  robotlink::Result<std::optional<Frame>> next() override {
    if (frames_.empty()) return std::optional<Frame>();
    std::optional<Frame> frame = frames_.front();
    frames_.pop_front();
    if (!frame) return robotlink::failure("test.broken", "it is broken");
    return frame;
  }
  double share() const override { return frames_.empty() ? 1 : 0.5; }

 private:
  std::deque<std::optional<Frame>> frames_;
};

FrameSource::Frame frameAt(Duration time) {
  return {time, std::make_shared<foxglove::RawImage>(), 40, 30};
}

class FrameImportTest : public testing::Test {
 protected:
  robotlink::Result<ImportReport> import(std::deque<std::optional<FrameSource::Frame>> frames) {
    ListedFrames source(std::move(frames));
    return importFrames(
        source, camera_,
        [this](std::vector<StreamMessage> messages) -> robotlink::Result<void> {
          frames_.push_back(std::move(messages));
          return {};
        },
        "eye", [this](double) { return frames_.size() < stopAfter_; });
  }

  robotlink::RobotDescription::Camera camera_{.horizontalAngle = std::numbers::pi / 2};
  std::size_t stopAfter_ = 1000;
  std::vector<std::vector<StreamMessage>> frames_;
};

}  // namespace

TEST_F(FrameImportTest, givesEachImageWithTheCamerasPose) {
  const auto report = import({frameAt({}), frameAt(std::chrono::milliseconds(40))});
  ASSERT_TRUE(report) << report.error().describe();
  EXPECT_EQ(report->format, "list");
  EXPECT_EQ(report->messages, 2U);
  EXPECT_TRUE(report->damage.empty());
  ASSERT_EQ(frames_.size(), 2U);
  ASSERT_EQ(frames_[1].size(), 3U);
  EXPECT_EQ(frames_[1][0].path, "eye/camera/image");
  EXPECT_EQ(frames_[1][0].time, robotlink::Instant(std::chrono::milliseconds(40)));
  EXPECT_EQ(frames_[1][1].path, "eye/camera/pose");
  const auto& pose = dynamic_cast<const robotcontrol::CameraPose&>(*frames_[1][1].value);
  EXPECT_EQ(frames_[1][2].path, "eye/frames/camera");
  EXPECT_EQ(dynamic_cast<const robotcontrol::FrameInfo&>(*frames_[1][2].value).number(), 2U);
  EXPECT_EQ(frames_[1][0].frame, 2U);
  EXPECT_EQ(pose.width(), 40U);
  EXPECT_EQ(pose.height(), 30U);
  EXPECT_NEAR(std::tan(pose.vertical_angle() / 2), 0.75 * std::tan(pose.horizontal_angle() / 2), 1e-12)
      << "pixels are square";
}

TEST_F(FrameImportTest, leavesOutWhatCannotBeReadAndSaysSo) {
  const auto report = import({frameAt({}), std::nullopt, frameAt(Duration(1)), std::nullopt});
  ASSERT_TRUE(report);
  EXPECT_EQ(report->messages, 2U);
  EXPECT_EQ(report->notUnderstood.at("image"), 2U);
  EXPECT_NE(report->damage.find("2 images cannot be read"), std::string::npos) << report->damage;
  EXPECT_NE(report->damage.find("it is broken"), std::string::npos) << report->damage;
}

TEST_F(FrameImportTest, failsWhereThereIsNothing) {
  EXPECT_EQ(import({}).error().id, "import.empty");
  EXPECT_EQ(import({std::nullopt}).error().id, "test.broken");
}

TEST_F(FrameImportTest, endsAtASourceThatOnlyFails) {
  EXPECT_EQ(import(std::deque<std::optional<FrameSource::Frame>>(100000)).error().id, "test.broken");
  EXPECT_TRUE(frames_.empty());
}

TEST_F(FrameImportTest, canBeCanceled) {
  stopAfter_ = 1;
  const auto report = import({frameAt({}), frameAt(Duration(1)), frameAt(Duration(2))});
  ASSERT_FALSE(report);
  EXPECT_EQ(report.error().id, "log.given-up");
  EXPECT_EQ(frames_.size(), 1U);
}
