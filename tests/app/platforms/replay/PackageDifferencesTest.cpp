// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/replay/PackageDifferences.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Sensing.pb.h"

using namespace app;
using namespace std::chrono_literals;
using robotlink::Instant;

namespace {

std::shared_ptr<robotcontrol::BallModel> ball(double x, double deviation = 0) {
  auto model = std::make_shared<robotcontrol::BallModel>();
  model->mutable_position_in_robot()->set_x(x);
  model->set_standard_deviation(deviation);
  return model;
}

robotcontrol::ReplayStatus::Difference only(const PackageDifferences& differences) {
  robotcontrol::ReplayStatus status;
  differences.describe("red1", 0s, status);
  EXPECT_EQ(status.differences_size(), 1);
  return status.differences_size() == 1 ? status.differences(0) : robotcontrol::ReplayStatus::Difference();
}

void compare(PackageDifferences& differences, Instant at, double logged, double recomputed) {
  differences.addLogged("models/ball", ball(logged));
  differences.addRecomputed("models/ball", ball(recomputed));
  differences.endInstant(at);
}

}  // namespace

TEST(PackageDifferences, reportsHowManyTheFirstAndTheLargest) {
  PackageDifferences differences;
  compare(differences, Instant(1s), 1, 1);
  compare(differences, Instant(2s), 1, 1.5);
  compare(differences, Instant(3s), 1, -2);
  compare(differences, Instant(4s), 1, 1.25);
  const auto difference = only(differences);
  EXPECT_EQ(difference.package(), "red1/models/ball");
  EXPECT_EQ(difference.compared(), 4U);
  EXPECT_EQ(difference.different(), 3U);
  EXPECT_EQ(difference.first_time(), 2'000'000'000);
  EXPECT_EQ(difference.largest_field(), "position_in_robot.x");
  EXPECT_EQ(difference.largest(), 3);
  EXPECT_EQ(difference.largest_time(), 3'000'000'000);
}

TEST(PackageDifferences, directionsAreComparedTheShortWayRound) {
  const auto pose = [](double heading) {
    auto value = std::make_shared<robotcontrol::Pose2>();
    value->set_heading(heading);
    return value;
  };
  PackageDifferences differences;
  differences.addLogged("models/pose", pose(std::numbers::pi - 0.01));
  differences.addRecomputed("models/pose", pose(0.02 - std::numbers::pi));
  differences.endInstant(Instant(1s));
  const auto difference = only(differences);
  EXPECT_EQ(difference.different(), 1U);
  EXPECT_EQ(difference.largest_field(), "heading");
  EXPECT_NEAR(difference.largest(), 0.03, 1e-9);
}

TEST(PackageDifferences, anInstantThatIsGoneOverAgainCountsOnce) {
  PackageDifferences differences;
  compare(differences, Instant(1s), 1, 2);
  compare(differences, Instant(1s), 1, 1);
  EXPECT_EQ(only(differences).compared(), 1U);
  EXPECT_EQ(only(differences).different(), 0U);
  EXPECT_EQ(only(differences).largest(), 0);
}

TEST(PackageDifferences, theLargestIsFoundAnewWhenItsInstantIsGoneOverAgain) {
  PackageDifferences differences;
  compare(differences, Instant(1s), 1, 2);
  compare(differences, Instant(3s), 1, 9);
  compare(differences, Instant(2s), 1, 4);
  EXPECT_EQ(only(differences).largest(), 8);
  compare(differences, Instant(3s), 1, 1.5);
  EXPECT_EQ(only(differences).largest(), 3);
  EXPECT_EQ(only(differences).largest_time(), 2'000'000'000);
  EXPECT_EQ(only(differences).different(), 3U);
  EXPECT_EQ(only(differences).compared(), 3U);
}

TEST(PackageDifferences, whatOnlyOneOfThemHasIsCountedApart) {
  PackageDifferences differences;
  differences.addLogged("models/ball", ball(1));
  differences.endInstant(Instant(1s));
  differences.addRecomputed("models/ball", ball(1));
  differences.addRecomputed("models/ball", ball(1));
  differences.addLogged("models/ball", ball(1));
  differences.endInstant(Instant(2s));
  const auto difference = only(differences);
  EXPECT_EQ(difference.compared(), 1U);
  EXPECT_EQ(difference.different(), 0U);
  EXPECT_EQ(difference.only_logged(), 1U);
  EXPECT_EQ(difference.only_recomputed(), 1U);
  EXPECT_EQ(difference.first_time(), 1'000'000'000);
}

TEST(PackageDifferences, whatIsNoNumberOnOneSideDiffersMost) {
  PackageDifferences differences;
  differences.addLogged("models/ball", ball(std::nan(""), 5));
  differences.addRecomputed("models/ball", ball(1, 90));
  differences.endInstant(Instant(1s));
  EXPECT_EQ(only(differences).largest_field(), "position_in_robot.x");
  EXPECT_TRUE(std::isinf(only(differences).largest()));
}

TEST(PackageDifferences, timesAreMovedAndWhatIsDroppedIsForgotten) {
  PackageDifferences differences;
  differences.addLogged("models/ball", ball(1));
  differences.dropInstant();
  differences.endInstant(Instant(1s));
  robotcontrol::ReplayStatus status;
  differences.describe("red1", 10s, status);
  EXPECT_EQ(status.differences_size(), 0);
  compare(differences, Instant(1s), 1, 2);
  differences.describe("red1", 10s, status);
  ASSERT_EQ(status.differences_size(), 1);
  EXPECT_EQ(status.differences(0).first_time(), 11'000'000'000);
  differences.clear();
  robotcontrol::ReplayStatus empty;
  differences.describe("red1", 0s, empty);
  EXPECT_EQ(empty.differences_size(), 0);
}
