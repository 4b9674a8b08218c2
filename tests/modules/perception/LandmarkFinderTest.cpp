// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "modules/perception/BandLandmarkFinder.h"
#include "modules/perception/HorizonLandmarkFinder.h"
#include "tests/modules/perception/FieldCamera.h"

namespace modules {
namespace {

using robotlink::Pose2;
using robotlink::Vector2;

/// Both finders on the same images; each test holds for both.
class LandmarkFinder : public testing::TestWithParam<bool> {
 protected:
  std::vector<LandmarkObservation> look(const Pose2& robot, const NeckAngles& neck = {}) {
    const CameraView view = FieldCamera::view(neck);
    const robotlink::Image& image = world_.look(robot, view);
    return GetParam() ? horizon_.find(image.view(), view) : bands_.find(world_.regions(), view);
  }
  const LandmarkObservation* find(const std::vector<LandmarkObservation>& seen,
                                  const std::string& name) const {
    const auto found =
        std::ranges::find_if(seen, [&](const auto& s) { return landmarks_[s.landmark].name == name; });
    return found == seen.end() ? nullptr : &*found;
  }
  /// True place of a landmark as the robot sees it.
  Vector2 inRobot(const LandmarkObservation& seen, const Pose2& robot) const {
    return robot.inverse() * landmarks_[seen.landmark].position;
  }

  FieldCamera world_;
  std::vector<FieldLandmark> landmarks_ = fieldLandmarks(world_.field(), world_.classes());
  BandLandmarkFinder bands_{world_.field(), landmarks_, {}};
  HorizonLandmarkFinder horizon_{world_.field(), landmarks_, world_.table(), {}};
};

TEST_P(LandmarkFinder, knowsEveryBeaconByItsColors) {
  for (const FieldLandmark& beacon : landmarks_) {
    if (beacon.kind != FieldLandmark::Kind::kBeacon) continue;
    const Vector2 toBeacon = beacon.position - Vector2(0.2, -0.1);
    const Pose2 robot{0.2, -0.1, std::atan2(toBeacon.y(), toBeacon.x())};
    const auto seen = look(robot);
    const LandmarkObservation* found = find(seen, beacon.name);
    ASSERT_NE(found, nullptr) << beacon.name;
    const Vector2 truth = inRobot(*found, robot);
    EXPECT_NEAR(found->bearing, 0, 0.03) << beacon.name;
    EXPECT_NEAR(found->distance, truth.norm(), 0.15 * truth.norm()) << beacon.name;
  }
}

TEST_P(LandmarkFinder, knowsBothGoals) {
  for (const auto& [name, heading] : {std::pair{"skyblue", 0.1}, std::pair{"yellow", 3.1}}) {
    const Pose2 robot{0, 0.2, heading};
    const auto seen = look(robot);
    const LandmarkObservation* found = find(seen, name);
    ASSERT_NE(found, nullptr) << name;
    const Vector2 truth = inRobot(*found, robot);
    EXPECT_NEAR(found->bearing, std::atan2(truth.y(), truth.x()), 0.06) << name;
    EXPECT_NEAR(found->distance, truth.norm(), 0.2 * truth.norm()) << name;
  }
}

TEST_P(LandmarkFinder, isRightAboutAllThatItSeesAllAround) {
  std::vector<bool> everSeen(landmarks_.size(), false);
  for (int i = 0; i < 36; ++i) {
    const Pose2 robot{-0.5, 0.3, i * robotlink::kPi / 18};
    for (const LandmarkObservation& seen : look(robot, {0, 0, 0.1})) {
      const Vector2 truth = inRobot(seen, robot);
      const double off = robotlink::normalizedAngle(seen.bearing - std::atan2(truth.y(), truth.x()));
      EXPECT_LT(std::abs(off), 0.08) << landmarks_[seen.landmark].name << " heading " << i * 10;
      EXPECT_NEAR(seen.distance, truth.norm(), 0.35 * truth.norm()) << landmarks_[seen.landmark].name;
      everSeen[seen.landmark] = true;
    }
  }
  EXPECT_GE(std::ranges::count(everSeen, true), 7);
}

TEST_P(LandmarkFinder, seesNoneOnTheFloor) {
  EXPECT_TRUE(look({0, 0, 0}, {robotlink::radians(-70), 0, 0}).empty());
}

INSTANTIATE_TEST_SUITE_P(, LandmarkFinder, testing::Bool(),
                         [](const auto& test) { return test.param ? "horizonScan" : "colorBands"; });

TEST(FieldLandmarks, areTheSixBeaconsAndTwoGoals) {
  const auto field = robotlink::FieldDescription::load(ROBOTCONTROL_SOURCE_DIR "/resources/fields/2002.yaml");
  ASSERT_TRUE(field);
  const auto classes = fieldClasses(*field);
  const auto landmarks = fieldLandmarks(*field, classes);
  ASSERT_EQ(landmarks.size(), 8U);
  EXPECT_EQ(landmarks[0].name, "yellow_left");
  EXPECT_EQ(classes.name(landmarks[0].topClass), "yellow");
  EXPECT_EQ(classes.name(landmarks[0].bottomClass), "pink");
  EXPECT_EQ(landmarks[7].name, "skyblue");
  EXPECT_NEAR(landmarks[7].position.x(), 2.25, 1e-9);
}

}  // namespace
}  // namespace modules
