// SPDX-License-Identifier: GPL-3.0-or-later
// What is asked of a world's bodies, and done to them by hand, between steps.
#include "simcore/physics/Physics.h"

#include <gmock/gmock.h>

#include "tests/simcore/truth/Bodies.h"

namespace simcore::truth {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

constexpr double kSide = 0.2, kWeight = 2;

/// A cube of 0.2 m and 2 kg whose center is there.
std::string cubeNamed(const std::string& name, const Vector3& at, const std::string& inModel = "") {
  const Vector3 size = Vector3::Constant(kSide);
  return model(name, numbers(at) + " 0 0 0",
               inertial(kWeight, momentsOfBox(kWeight, size)) + solid(box(size)), inModel);
}

std::string wallNamed(const std::string& name, const Vector3& at) {
  return "<model name='" + name + "'><static>true</static><pose>" + numbers(at) +
         " 0 0 0</pose><link name='l'>" + solid(box(Vector3::Constant(kSide))) + "</link></model>";
}

/// Two cubes, 0.5 m apart along x, that a joint holds together.
std::string pairOfCubes(const std::string& jointType, const Vector3& at) {
  const Vector3 size = Vector3::Constant(kSide);
  return cubeNamed("pair", at,
                   "<link name='other'><pose>0.5 0 0 0 0 0</pose>" +
                       inertial(kWeight, momentsOfBox(kWeight, size)) + solid(box(size)) +
                       "</link><joint name='j' type='" + jointType +
                       "'><parent>body</parent><child>other</child><axis><xyz>0 0 1</xyz></axis></joint>");
}

TEST(PhysicsTest, theDeepestOfTheModelsThatOneOverlapsIsNamed) {
  Bodies bodies(cubeNamed("a", {0, 0, 1}) + cubeNamed("b", {kSide - 0.01, 0, 1}) +
                cubeNamed("c", {0, kSide - 0.03, 1}) + cubeNamed("far", {5, 0, 1}));
  const Physics& physics = bodies.physics();
  EXPECT_EQ(physics.overlappedModel(0, 0.001), 2);
  EXPECT_EQ(physics.overlappedModel(0, 0.02), 2);
  EXPECT_EQ(physics.overlappedModel(0, 0.04), -1);
  EXPECT_EQ(physics.overlappedModel(1, 0.001), 0);
  EXPECT_EQ(physics.overlappedModel(3, 0), -1);
}

TEST(PhysicsTest, aFloorAndAWallAreOverlappedToo) {
  Bodies bodies(ground() + wallNamed("wall", {1, 0, 1}) + cubeNamed("sunk", {0, 0, kSide / 2 - 0.02}) +
                cubeNamed("inWall", {1, 0, 1 + kSide - 0.02}));
  EXPECT_EQ(bodies.physics().overlappedModel(2, 0.01), 0);
  EXPECT_EQ(bodies.physics().overlappedModel(3, 0.01), 1);
  EXPECT_EQ(bodies.physics().overlappedModel(1, 0), -1) << "what never moves is not asked about";
}

TEST(PhysicsTest, theModelsThatOneTouchesAreInTheirOrder) {
  Bodies bodies(cubeNamed("last", {0, 0, kSide / 2 - 1e-4}) +
                wallNamed("wall", {-kSide + 1e-4, 0, kSide / 2}) + ground() +
                cubeNamed("beside", {kSide - 1e-4, 0, kSide / 2}) + cubeNamed("above", {0, 0, 2 * kSide}));
  EXPECT_THAT(bodies.physics().modelsTouching(0), ElementsAre(1, 2, 3));
  EXPECT_THAT(bodies.physics().modelsTouching(4), IsEmpty());
  EXPECT_THAT(bodies.physics().modelsTouching(1), IsEmpty());
}

TEST(PhysicsTest, aRayMeetsTheNearestSolidThatIsNotItsOwn) {
  Bodies bodies(wallNamed("wall", {3, 0, 1}) + cubeNamed("own", {1, 0, 1}) + cubeNamed("near", {2, 0, 1}));
  const Physics& physics = bodies.physics();
  const Vector3 origin(0, 0, 1);
  EXPECT_NEAR(physics.castRay(origin, Vector3::UnitX(), 10, 1), 2 - kSide / 2, 1e-9);
  EXPECT_NEAR(physics.castRay(origin, Vector3::UnitX(), 10, 2), 1 - kSide / 2, 1e-9);
  EXPECT_EQ(physics.castRay(origin, Vector3::UnitX(), 1.5, 1), 1.5) << "it does not reach that far";
  EXPECT_EQ(physics.castRay(origin, -Vector3::UnitX(), 10, 1), 10);
}

TEST(PhysicsTest, aModelThatIsMovedKeepsItsShapeAndLosesItsVelocity) {
  Bodies bodies(pairOfCubes("revolute", {0, 0, 5}));
  Physics& physics = bodies.physics();
  physics.throwModel(0, {1, 0, 0}, {0, 0, 2});
  bodies.run(0.1);
  const Pose3 before = physics.modelInWorld(0);
  const Pose3 otherInFirst = physics.linkInWorld(0).inverse() * physics.linkInWorld(1);
  const Pose3 transform = Eigen::Translation3d(1, 2, 3) * Eigen::AngleAxisd(0.5, Vector3::UnitX());
  physics.moveModel(0, transform);
  EXPECT_TRUE(physics.modelInWorld(0).isApprox(transform * before, 1e-9));
  EXPECT_TRUE((physics.linkInWorld(0).inverse() * physics.linkInWorld(1)).isApprox(otherInFirst, 1e-9));
  EXPECT_EQ(physics.velocityOfModel(0), Vector3::Zero());
  EXPECT_EQ(physics.angularVelocityOf(1), Vector3::Zero());
}

TEST(PhysicsTest, aMoveIsUndoneToTheLastBit) {
  Bodies bodies(pairOfCubes("revolute", {0, 0, 5}));
  Physics& physics = bodies.physics();
  physics.throwModel(0, {1, 0, 0}, {0, 0, 2});
  bodies.run(0.1);
  const std::uint64_t digest = physics.digest();
  const auto motion = physics.motionOf(0);
  physics.moveModel(0, Pose3(Eigen::Translation3d(1, 2, 3)));
  EXPECT_NE(physics.digest(), digest);
  physics.setMotion(0, motion);
  EXPECT_EQ(physics.digest(), digest);
}

TEST(PhysicsTest, aModelIsThrownAsOnePieceAboutItsCenter) {
  Bodies bodies(pairOfCubes("revolute", {0, 0, 5}));
  Physics& physics = bodies.physics();
  physics.throwModel(0, {1, 0, 0}, {0, 0, 2});
  // The center is in the middle, 0.25 m from each.
  EXPECT_TRUE(bodies.motion("pair", 0).velocity.isApprox(Vector3(1, -0.5, 0), 1e-9));
  EXPECT_TRUE(bodies.motion("pair", 1).velocity.isApprox(Vector3(1, 0.5, 0), 1e-9));
  EXPECT_TRUE(bodies.motion("pair", 1).angularVelocity.isApprox(Vector3(0, 0, 2), 1e-9));
}

TEST(PhysicsTest, whatIsPinnedNeitherFallsNorFlies) {
  Bodies bodies(cubeNamed("a", {0, 0, 5}));
  Physics& physics = bodies.physics();
  physics.setPinned(0, true);
  EXPECT_TRUE(physics.isPinned(0));
  physics.throwModel(0, {3, 0, 0}, Vector3::Zero());
  bodies.run(0.1);
  EXPECT_EQ(bodies.motion("a").position, Vector3(0, 0, 5));
  physics.setPinned(0, false);
  bodies.run(0.1);
  EXPECT_FALSE(physics.isPinned(0));
  EXPECT_NEAR(bodies.motion("a").velocity.z(), -kGravity * 0.1, 1e-6) << "with its mass again";
}

TEST(PhysicsTest, aForceActsDuringOneStepAtItsPoint) {
  Bodies bodies(cubeNamed("a", {0, 0, 5}));
  Physics& physics = bodies.physics();
  physics.addForce(0, {10, 0, 0}, {0, 0.1, 5});
  bodies.step();
  const Vector3 velocity = bodies.motion("a").velocity;
  EXPECT_NEAR(velocity.x(), 10 / kWeight * kStepSeconds, 1e-9);
  const double inertia = momentsOfBox(kWeight, Vector3::Constant(kSide)).z();
  EXPECT_NEAR(bodies.motion("a").angularVelocity.z(), -10 * 0.1 / inertia * kStepSeconds, 1e-6);
  bodies.step();
  EXPECT_NEAR(bodies.motion("a").velocity.x(), velocity.x(), 1e-9);
}

TEST(PhysicsTest, aBodyIsEasierToMoveFarFromItsCenter) {
  Bodies bodies(cubeNamed("a", {0, 0, 5}));
  const Physics& physics = bodies.physics();
  EXPECT_NEAR(physics.massAt(0, {0, 0, 5}), kWeight, 1e-9);
  const double inertia = momentsOfBox(kWeight, Vector3::Constant(kSide)).x();
  EXPECT_NEAR(physics.massAt(0, {0, 0.3, 5}), 1 / (1 / kWeight + 0.09 / inertia), 1e-9);
  EXPECT_EQ(physics.massOf(0), kWeight);
}

TEST(PhysicsTest, linksThatAreFixedShareOneBodyAndOthersHaveTheirOwn) {
  Bodies fixed(cubeNamed("a", {5, 0, 5}) + pairOfCubes("fixed", {0, 0, 5}));
  EXPECT_EQ(fixed.physics().bodiesOf(1), (std::pair<std::size_t, std::size_t>(1, 2)));
  EXPECT_EQ(fixed.physics().carrierOf(2), 1U);
  EXPECT_EQ(fixed.physics().massOf(1), 2 * kWeight);
  EXPECT_EQ(fixed.physics().motionOf(1).size(), 1U);
  Bodies jointed(cubeNamed("a", {5, 0, 5}) + pairOfCubes("revolute", {0, 0, 5}));
  EXPECT_EQ(jointed.physics().carrierOf(2), 2U);
  EXPECT_EQ(jointed.physics().massOf(1), 2 * kWeight);
  EXPECT_EQ(jointed.physics().motionOf(1).size(), 2U);
}

TEST(PhysicsTest, aFloorIsNoObstacleButAWallIs) {
  Bodies bodies(ground() + cubeNamed("free", {0, 0, kSide / 2}) + wallNamed("wall", {3, 0, kSide / 2}) +
                cubeNamed("atWall", {3 - kSide + 1e-3, 0, kSide / 2}));
  bodies.step();
  const Physics& physics = bodies.physics();
  EXPECT_TRUE(physics.touched(std::size_t{0}, 0)) << "it stands on the floor";
  EXPECT_FALSE(physics.touchedObstacle(1));
  EXPECT_TRUE(physics.touchedObstacle(3));
  EXPECT_FALSE(physics.touched(1, 3));
}

TEST(PhysicsTest, onlyModelsThatMoveAreMovedByForces) {
  Bodies bodies(ground() + cubeNamed("a", {0, 0, 5}));
  EXPECT_FALSE(bodies.physics().isMovedByForces(0));
  EXPECT_TRUE(bodies.physics().isMovedByForces(1));
  EXPECT_EQ(bodies.physics().bodyCount(), 1U);
}

}  // namespace
}  // namespace simcore::truth
