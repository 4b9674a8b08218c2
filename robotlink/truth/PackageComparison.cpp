// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/truth/PackageComparison.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "robotcontrol/Game.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"
#include "robotlink/packages/Packages.h"
#include "robotlink/packages/ViewFrustum.h"
#include "robotlink/truth/LineComparison.h"
#include "robotlink/truth/PackageErrors.h"

namespace robotlink {
namespace {

using robotcontrol::OracleWorld;
using robotcontrol::RobotState;

/// How far away a thing may be that counts as missed if it is not reported, m.
constexpr double kNear = 2;
/// A report farther than this from each thing of its kind is invented: m, and a share of the
/// distance.
constexpr double kInvented = 0.3, kInventedShare = 0.25;
/// The relative error counts up to this distance, m; nearer things than the second are taken as that far.
constexpr double kRelativeUpTo = 1.5, kRelativeFrom = 0.1;
/// A ball model whose percept is older does not count as seen, s.
constexpr double kJustSeen = 0.1;
/// Landmarks are looked at up to this distance, m, at about half of their height, m.
constexpr double kLandmarkDistance = 4, kLandmarkHeight = 0.2;
/// The height of another robot's center, for deciding whether it is visible, m.
constexpr double kRobotHeight = 0.1;
/// The legs whose collisions are compared, as packages name them.
constexpr const char* kLegs[] = {"front left", "front right", "hind left", "hind right"};

bool isInvented(double error, double distance) {
  return error > kInvented + kInventedShare * distance;
}

/// The things of a kind that are there, and whether each could be seen or known.
struct Thing {
  Vector2 position;  ///< m, in the robot's frame
  bool isDue = false;
};

/// Returns the view of a robot's true camera.
ViewFrustum viewOf(const OracleWorld& truth) {
  return ViewFrustum(truth.camera());
}

Pose2 robotIn(const OracleWorld& truth) {
  return pose2(truth.robot_in_field());
}

Vector2 ballInRobot(const OracleWorld& truth) {
  const Vector3 ball = vector3(truth.ball_in_field());
  return robotIn(truth).inverse() * Vector2(ball.head<2>());
}

void noteBall(PackageErrors& errors, const Vector2& reported, const Vector2& ball) {
  const double error = (reported - ball).norm(), distance = ball.norm();
  errors.add("position", "m", error);
  if (distance <= kRelativeUpTo) errors.add("relative", "", error / std::max(distance, kRelativeFrom));
}

void compareBallModel(const google::protobuf::Message& value, const OracleWorld& truth,
                      const FieldDescription*, PackageErrors& errors) {
  const auto* model = dynamic_cast<const robotcontrol::BallModel*>(&value);
  if (model == nullptr || !truth.has_ball_in_field()) return;
  const Vector2 ball = ballInRobot(truth);
  const bool isDue = ball.norm() <= kNear;
  errors.there += isDue ? 1 : 0;
  errors.missed += isDue && !model->known() ? 1 : 0;
  if (!model->known()) return;
  const Vector2 reported = vector2(model->position_in_robot());
  ++errors.reported;
  errors.invented += isInvented((reported - ball).norm(), ball.norm()) ? 1 : 0;
  noteBall(errors, reported, ball);
  if (model->seconds_since_seen() <= kJustSeen && ball.norm() <= kRelativeUpTo)
    errors.add("relative-seen", "", (reported - ball).norm() / std::max(ball.norm(), kRelativeFrom));
}

void compareTeamBall(const google::protobuf::Message& value, const OracleWorld& truth,
                     const FieldDescription*, PackageErrors& errors) {
  const auto* model = dynamic_cast<const robotcontrol::TeamBall*>(&value);
  if (model == nullptr || !truth.has_ball_in_field()) return;
  const Vector2 ball(vector3(truth.ball_in_field()).head<2>());
  const double distance = ballInRobot(truth).norm();
  errors.there += 1;
  errors.missed += model->known() ? 0 : 1;
  if (!model->known()) return;
  const double error = (vector2(model->position_in_field()) - ball).norm();
  ++errors.reported;
  errors.invented += isInvented(error, distance) ? 1 : 0;
  errors.add("position", "m", error);
}

void compareBallPercept(const google::protobuf::Message& value, const OracleWorld& truth,
                        const FieldDescription*, PackageErrors& errors) {
  const auto* percept = dynamic_cast<const robotcontrol::BallPercept*>(&value);
  if (percept == nullptr || !truth.has_ball_in_field()) return;
  const Vector2 ball = ballInRobot(truth);
  const Vector3 center(ball.x(), ball.y(), truth.ball_in_field().z());
  const bool isDue = ball.norm() <= kNear && viewOf(truth).shows(center);
  errors.there += isDue ? 1 : 0;
  errors.missed += isDue && !percept->seen() ? 1 : 0;
  if (!percept->seen()) return;
  const Vector2 reported = vector2(percept->position_in_robot());
  ++errors.reported;
  if (isInvented((reported - ball).norm(), ball.norm()))
    ++errors.invented;
  else
    noteBall(errors, reported, ball);
}

void comparePose(const google::protobuf::Message& value, const OracleWorld& truth, const FieldDescription*,
                 PackageErrors& errors) {
  const auto* estimate = dynamic_cast<const robotcontrol::RobotPose*>(&value);
  if (estimate == nullptr || !truth.has_robot_in_field()) return;
  const Pose2 reported = pose2(estimate->robot_in_field()), pose = robotIn(truth);
  errors.add("position", "m", (reported.translation() - pose.translation()).norm());
  errors.add("heading", "rad", std::abs(normalizedAngle(reported.heading - pose.heading)));
}

void compareCameraPose(const google::protobuf::Message& value, const OracleWorld& truth,
                       const FieldDescription*, PackageErrors& errors) {
  const auto* estimate = dynamic_cast<const robotcontrol::CameraPose*>(&value);
  if (estimate == nullptr || !truth.has_camera()) return;
  const Pose3 reported = pose3(estimate->camera_in_robot());
  const Pose3 camera = pose3(truth.camera().camera_in_robot());
  errors.add("position", "m", (reported.translation() - camera.translation()).norm());
  const Eigen::AngleAxisd between(reported.linear().transpose() * camera.linear());
  errors.add("direction", "rad", std::abs(between.angle()));
}

/// Assigns each reported place to the nearest thing that is left, notes its error, and counts.
void matchPlaces(const std::vector<Vector2>& reported, std::vector<Thing> things, PackageErrors& errors) {
  for (const Thing& thing : things) errors.there += thing.isDue ? 1 : 0;
  for (const Vector2& place : reported) {
    ++errors.reported;
    const auto nearest = std::ranges::min_element(
        things, {}, [&](const Thing& thing) { return (thing.position - place).norm(); });
    const double error = nearest == things.end() ? 0 : (nearest->position - place).norm();
    if (nearest == things.end() || isInvented(error, nearest->position.norm())) {
      ++errors.invented;
      continue;
    }
    errors.add("position", "m", error);
    things.erase(nearest);
  }
  for (const Thing& thing : things) errors.missed += thing.isDue ? 1 : 0;
}

void compareRobots(const google::protobuf::Message& value, const OracleWorld& truth, const FieldDescription*,
                   PackageErrors& errors) {
  const auto* percepts = dynamic_cast<const robotcontrol::RobotPercepts*>(&value);
  if (percepts == nullptr) return;
  const ViewFrustum view = viewOf(truth);
  std::vector<Thing> others;
  for (const OracleWorld::Robot& other : truth.others()) {
    const Vector2 place = robotIn(truth).inverse() * pose2(other.pose_in_field()).translation();
    others.push_back({place, place.norm() <= kNear && view.shows({place.x(), place.y(), kRobotHeight})});
  }
  std::vector<Vector2> reported;
  for (const auto& robot : percepts->robots()) reported.push_back(vector2(robot.position_in_robot()));
  matchPlaces(reported, std::move(others), errors);
}

void comparePlayers(const google::protobuf::Message& value, const OracleWorld& truth, const FieldDescription*,
                    PackageErrors& errors) {
  const auto* model = dynamic_cast<const robotcontrol::PlayersModel*>(&value);
  if (model == nullptr) return;
  const Pose2 fieldInRobot = robotIn(truth).inverse();
  std::vector<Thing> others;
  for (const OracleWorld::Robot& other : truth.others()) {
    const Vector2 place = fieldInRobot * pose2(other.pose_in_field()).translation();
    others.push_back({place, place.norm() <= kNear});
  }
  std::vector<Vector2> reported;
  for (const auto& player : model->players())
    reported.push_back(fieldInRobot * vector2(player.position_in_field()));
  matchPlaces(reported, std::move(others), errors);
}

/// Landmarks by their names as in the field's description.
std::map<std::string, Vector2> landmarksOf(const FieldDescription& field) {
  std::map<std::string, Vector2> landmarks;
  for (const auto& beacon : field.beacons) landmarks[beacon.name] = beacon.position;
  for (const auto& goal : field.goals) landmarks[goal.name] = {goal.x, 0};
  return landmarks;
}

void compareLandmarks(const google::protobuf::Message& value, const OracleWorld& truth,
                      const FieldDescription* field, PackageErrors& errors) {
  const auto* percepts = dynamic_cast<const robotcontrol::LandmarkPercepts*>(&value);
  if (percepts == nullptr || field == nullptr || !truth.has_robot_in_field()) return;
  std::map<std::string, Thing> landmarks;
  const ViewFrustum view = viewOf(truth);
  for (const auto& [name, position] : landmarksOf(*field)) {
    const Vector2 place = robotIn(truth).inverse() * position;
    const bool isDue =
        place.norm() <= kLandmarkDistance && view.shows({place.x(), place.y(), kLandmarkHeight});
    landmarks[name] = {place, isDue};
    errors.there += isDue ? 1 : 0;
  }
  std::map<std::string, Thing> missed = landmarks;
  for (const auto& percept : percepts->landmarks()) {
    ++errors.reported;
    missed.erase(percept.name());
    const auto known = landmarks.find(percept.name());
    const double distance = known == landmarks.end() ? 0 : known->second.position.norm();
    const Vector2 reported(percept.distance() * std::cos(percept.bearing()),
                           percept.distance() * std::sin(percept.bearing()));
    if (known == landmarks.end() || isInvented((reported - known->second.position).norm(), 2 * distance)) {
      ++errors.invented;
      continue;
    }
    const Vector2& place = known->second.position;
    errors.add("distance", "m", std::abs(percept.distance() - distance));
    errors.add("bearing", "rad",
               std::abs(normalizedAngle(percept.bearing() - std::atan2(place.y(), place.x()))));
  }
  for (const auto& [name, thing] : missed) errors.missed += thing.isDue ? 1 : 0;
}

void compareFieldLines(const google::protobuf::Message& value, const OracleWorld& truth,
                       const FieldDescription* field, PackageErrors& errors) {
  const auto* percepts = dynamic_cast<const robotcontrol::FieldLinePercepts*>(&value);
  if (percepts == nullptr || field == nullptr || !truth.has_robot_in_field() || !truth.has_camera()) return;
  compareLines(*percepts, truth, *field, errors);
}

/// `name` is that of the quantity, `event` that of one of several events that it has.
void compareEvent(const std::string& name, const std::string& event, Instant time, bool happens,
                  bool isReported, PackageErrors& errors) {
  ErrorQuantity& quantity = errors.quantities[name];
  quantity.unit = kShareOfTime;
  if (const auto delay = errors.events[event].add(time, happens, isReported, quantity))
    errors.add(name + " delay", "s", seconds(*delay));
}

/// Compares the state of the body according to a solution with that of the oracle.
void compareState(const RobotState& state, const RobotState& truth, PackageErrors& errors) {
  const Instant time = instant(state.timestamp());
  compareEvent("picked up", "picked up", time, truth.picked_up(), state.picked_up(), errors);
  compareEvent("fallen", "fallen", time, truth.fallen(), state.fallen(), errors);
  if (truth.fallen() && state.fallen())
    errors.add("side", kShareOfTime, truth.side() == state.side() ? 0 : 1);
  for (const char* leg : kLegs) {
    const auto has = [&](const RobotState& one) {
      return std::ranges::find(one.collisions(), leg) != one.collisions().end();
    };
    compareEvent("collided", leg, time, has(truth), has(state), errors);
  }
}

using Compare = void (*)(const google::protobuf::Message&, const OracleWorld&, const FieldDescription*,
                         PackageErrors&);

const std::map<std::string, Compare>& comparisons() {
  static const std::map<std::string, Compare> kAll{
      {kCameraPose.name, compareCameraPose}, {kBallPercept.name, compareBallPercept},
      {kRobotPercepts.name, compareRobots},  {kLandmarkPercepts.name, compareLandmarks},
      {kBallModel.name, compareBallModel},   {kRobotPose.name, comparePose},
      {kPlayersModel.name, comparePlayers},  {kTeamBall.name, compareTeamBall},
      {kFieldLines.name, compareFieldLines}};
  return kAll;
}

}  // namespace

std::vector<std::string> comparablePackages() {
  std::vector<std::string> names{kRobotState.name};
  for (const auto& [name, compare] : comparisons()) names.push_back(name);
  return names;
}

const char* truthOf(std::string_view package) {
  return package == kRobotState.name ? kOracleState.name : kOracleWorld.name;
}

void comparePackage(const std::string& package, const google::protobuf::Message& value,
                    const google::protobuf::Message& truth, const FieldDescription* field,
                    PackageErrors& errors) {
  if (package == kRobotState.name) {
    const auto* state = dynamic_cast<const RobotState*>(&value);
    const auto* known = dynamic_cast<const RobotState*>(&truth);
    if (state != nullptr && known != nullptr) compareState(*state, *known, errors);
    return;
  }
  const auto found = comparisons().find(package);
  const auto* world = dynamic_cast<const OracleWorld*>(&truth);
  if (found != comparisons().end() && world != nullptr) found->second(value, *world, field, errors);
}

}  // namespace robotlink
