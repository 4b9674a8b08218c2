// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/ranging/RangeSensing.h"

#include <gtest/gtest.h>

#include <array>

#include "robotlink/base/Random.h"

using namespace simcore;
using Eigen::Vector3d;
using robotlink::radians;

namespace {

constexpr double kQuarter = robotlink::kPi / 2;

/// A cart of two bodies with a sonar and a laser of 19 readings, 0.2 m before its center and 0.3 m high;
/// another body, a box; and what is built of walls.
class Ranging {
 public:
  Ranging() {
    scene_->bodies = {"world", "cart", "mast", "box"};
    scene_->meshes = {boxMesh({0.5F, 0.4F, 0.5F}), boxMesh({0.02F, 0.02F, 1})};
    scene_->instances = {{0, 1, Pose3(Eigen::Translation3d(0, 0, 0.25)), {}, "cart", true},
                         {1, 2, Pose3::Identity(), {}, "mast", true},
                         {0, 3, Pose3::Identity(), {}, "box", true}};
    poses_[2].translation() = Vector3d(0.24, 0, 0.5);  // right before the sensors
    poses_[3].translation() = Vector3d(0, 0, -100);
    RangeSensor sonar;
    sonar.body = 1;
    sonar.sensorInBody.translation() = Vector3d(0.2, 0, 0.3);
    sonar.minimum = 0.1;
    sonar.maximum = 5;
    sonar.openingAngle = radians(30);
    sonar.mostIncidence = radians(55);
    RangeSensor laser = sonar;
    laser.kind = RangeSensor::Kind::kLaser;
    laser.minimum = 0.05;
    laser.maximum = 30;
    laser.readings = 19;
    laser.startAngle = -kQuarter;
    laser.endAngle = kQuarter;
    laser.errors.noise = {{.stddev = 0.005}};
    sensors = {sonar, laser};
  }

  Ranging& wall(double x, double y, double sizeX, double sizeY, double angle = 0) {
    scene_->meshes.push_back(boxMesh({static_cast<float>(sizeX), static_cast<float>(sizeY), 2}));
    scene_->instances.push_back(
        {static_cast<int>(scene_->meshes.size()) - 1,
         0,
         Eigen::Translation3d(x, y, 1) * Pose3(Eigen::AngleAxisd(angle, Vector3d::UnitZ())),
         {},
         "wall",
         true});
    return *this;
  }
  void placeCart(double x, double y, double heading) {
    poses_[1] = Eigen::Translation3d(x, y, 0) * Pose3(Eigen::AngleAxisd(heading, Vector3d::UnitZ()));
    poses_[2] = poses_[1] * Eigen::Translation3d(0.24, 0, 0.5);
  }
  void placeBox(double x, double y) { poses_[3].translation() = Vector3d(x, y, 0.25); }

  double sonar(const RangeSensing::Noise& noise = {.on = false}) { return measure(0, noise)[0]; }
  std::vector<double> laser(const RangeSensing::Noise& noise = {.on = false}) { return measure(1, noise); }

  std::vector<RangeSensor> sensors;

 private:
  std::vector<double> measure(std::size_t sensor, const RangeSensing::Noise& noise) {
    if (!sensing_)
      sensing_ =
          std::make_unique<RangeSensing>(scene_, sensors, std::vector<RayCaster::BodyRange>(2, {1, 3}));
    sensing_->setPoses(poses_);
    std::vector<double> ranges(static_cast<std::size_t>(sensors[sensor].readings), -1);
    sensing_->measure(sensor, noise, ranges);
    return ranges;
  }

  std::shared_ptr<RenderScene> scene_ = std::make_shared<RenderScene>();
  std::array<Pose3, 4> poses_{Pose3::Identity(), Pose3::Identity(), Pose3::Identity(), Pose3::Identity()};
  std::unique_ptr<RangeSensing> sensing_;
};

}  // namespace

TEST(RangeSensing, whereThereIsNothingTheReadingIsTheMaximum) {
  Ranging nothing;
  EXPECT_EQ(nothing.sonar({.seed = 3}), 5);
  for (const double range : nothing.laser({.seed = 3})) EXPECT_EQ(range, 30);
}

TEST(RangeSensing, theLaserMeasuresARoomFromRightToLeft) {
  Ranging room;
  // Walls at x = 3, y = -2 and y = 1, seen from x = 0.2.
  room.wall(3.5, 0, 1, 20).wall(0, -2.5, 20, 1).wall(0, 1.5, 20, 1);
  const std::vector<double> ranges = room.laser();
  for (int i = 0; i < 19; ++i) {
    const double angle = radians(-90 + 10 * i), c = std::cos(angle), s = std::sin(angle);
    const double side = std::abs(s) < 1e-9 ? 1e9 : (s < 0 ? 2 : 1) / std::abs(s);
    const double ahead = c < 1e-5 ? 1e9 : 2.8 / c;
    EXPECT_NEAR(ranges[static_cast<std::size_t>(i)], std::min(side, ahead), 1e-4) << i;
  }
}

TEST(RangeSensing, aSonarHearsTheNearestInItsCone) {
  Ranging inside;
  // The post's nearer edge is 10 degrees off the axis.
  inside.wall(3.5, 0, 1, 20).wall(1.7, 0.3, 0.1, 0.1);
  EXPECT_NEAR(inside.sonar(), std::hypot(1.45, 0.26), 0.02);
  Ranging beside;
  beside.wall(3.5, 0, 1, 20).wall(1.7, 0.7, 0.1, 0.1);
  EXPECT_NEAR(beside.sonar(), 2.8, 1e-4);
}

TEST(RangeSensing, aThinPostIsHeardWhereverItIsInTheCone) {
  for (const double degrees : {-14.0, -9.3, -3.1, 0.0, 5.2, 11.9, 14.4}) {
    Ranging post;
    post.wall(0.2 + 1.5 * std::cos(radians(degrees)), 1.5 * std::sin(radians(degrees)), 0.04, 0.04);
    EXPECT_NEAR(post.sonar(), 1.48, 0.03) << degrees;
  }
}

TEST(RangeSensing, aWallAtASlantReflectsTheSoundAway) {
  const auto heard = [](double degrees, double mostIncidence) {
    Ranging slanting;
    slanting.sensors[0].mostIncidence = radians(mostIncidence);
    slanting.wall(2.2, 0, 0.02, 40, radians(degrees));
    return slanting.sonar();
  };
  // The cone's ray nearest to the wall's normal has 15 degrees less.
  EXPECT_NEAR(heard(0, 55), 1.99, 1e-3);
  EXPECT_NEAR(heard(40, 55), 2 * std::cos(radians(40)) / std::cos(radians(25)), 0.03);
  EXPECT_LT(heard(68, 55), 3);
  EXPECT_EQ(heard(72, 55), 5);
  EXPECT_LT(heard(72, 90), 3) << "nothing is lost if the sensor says so";
  EXPECT_EQ(heard(40, 20), 5);
}

TEST(RangeSensing, nothingIsMeasuredNearerThanTheMinimum) {
  Ranging near;
  near.wall(0.31, 0, 0.1, 2);
  EXPECT_EQ(near.sonar(), 0.1);
  EXPECT_NEAR(near.laser()[9], 0.06, 1e-4);
}

TEST(RangeSensing, otherBodiesAreSeenWhereTheyAreAndTheOwnNever) {
  Ranging world;
  world.placeBox(2, 0);
  EXPECT_NEAR(world.sonar(), 1.55, 1e-4);
  EXPECT_NEAR(world.laser()[9], 1.55, 1e-4);
  EXPECT_EQ(world.laser()[13], 30);
  world.placeBox(0.2, -3);
  EXPECT_EQ(world.sonar(), 5);
  EXPECT_NEAR(world.laser()[0], 2.8, 1e-4);
  world.placeCart(-1, -3.2, kQuarter);
  EXPECT_NEAR(world.laser()[9], 30, 1e-4) << "it stands to the right";
  world.placeBox(-1, -1);
  EXPECT_NEAR(world.laser()[9], 2 - 0.2, 1e-4);
}

TEST(RangeSensing, bodiesBehindWallsAreHidden) {
  Ranging world;
  world.wall(1.5, 0, 0.1, 4);
  world.placeBox(3, 0);
  EXPECT_NEAR(world.laser()[9], 1.25, 1e-4);
  world.placeBox(1.2, 0);
  EXPECT_NEAR(world.laser()[9], 0.75, 1e-4);
}

TEST(RangeSensing, allRaysOfAScanAgreeWithSingleRays) {
  // The same rays one by one, through everything that stands around, with the scan's direction turned all the
  // way round.
  auto scene = std::make_shared<RenderScene>();
  scene->meshes = {boxMesh({0.3F, 0.2F, 0.5F}), sphereMesh(0.4F)};
  robotlink::Random random(1);
  std::vector<Pose3> poses{Pose3::Identity()};
  for (int i = 0; i < 60; ++i) {
    const int body = i % 3 == 0 ? 0 : static_cast<int>(poses.size());
    const Pose3 pose =
        Eigen::Translation3d{random.uniform(-6, 6), random.uniform(-6, 6), random.uniform(-0.2, 0.2)} *
        Pose3(Eigen::AngleAxisd(random.uniform(0, 6), Vector3d::UnitZ()));
    scene->instances.push_back({i % 2, body, body == 0 ? pose : Pose3::Identity(), {}, "thing", true});
    if (body != 0) poses.push_back(pose);
  }
  RayCaster caster(scene);
  caster.setPoses(poses);
  const RayFan fan(-2.5, 2.5, 181);
  std::vector<FanHit> hits(fan.size());
  for (int turn = 0; turn < 8; ++turn) {
    const Pose3 frame = Eigen::Translation3d(0.1 * turn, 0, 0) *
                        Eigen::AngleAxisd(0.8 * turn, Vector3d::UnitZ()) *
                        Pose3(Eigen::AngleAxisd(0.02, Vector3d::UnitY()));
    caster.castFan(fan, frame, 5, {3, 6}, hits);
    for (std::size_t i = 0; i < fan.size(); ++i) {
      const Eigen::Vector2d& d = fan.directions()[i];
      const auto hit = caster.firstHit(frame.translation(), frame.linear() * Vector3d(d.x(), d.y(), 0), 5,
                                       std::array{3, 4, 5});
      ASSERT_NEAR(hits[i].distance, hit ? hit->distance : 5, 1e-5) << turn << " " << i;
    }
  }
}

TEST(RangeSensing, noiseDependsOnSeedSensorAndStepOnly) {
  Ranging a, b;
  for (Ranging* world : {&a, &b}) world->wall(3.5, 0, 1, 90);
  const std::vector<double> once = a.laser({true, 4, 10});
  a.sonar({true, 4, 11});
  a.laser({true, 4, 12});
  EXPECT_EQ(a.laser({true, 4, 10}), once);
  EXPECT_EQ(b.laser({true, 4, 10}), once);
  EXPECT_NE(a.laser({true, 5, 10}), once);
  EXPECT_NE(a.laser({true, 4, 11}), once);
}

TEST(RangeSensing, noiseHasItsStandardDeviation) {
  Ranging world;
  world.wall(3.5, 0, 1, 90);
  double sum = 0, squares = 0;
  constexpr std::uint64_t kCount = 1000;
  for (std::uint64_t step = 0; step < kCount; ++step) {
    const double error = world.laser({true, 1, step})[9] - 2.8;
    sum += error;
    squares += error * error;
  }
  EXPECT_NEAR(sum / kCount, 0, 0.001);
  EXPECT_NEAR(std::sqrt(squares / kCount), 0.005, 0.0005);
}
