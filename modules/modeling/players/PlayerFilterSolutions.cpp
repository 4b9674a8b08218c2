// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "players-model" that also learn from where no robot was seen.
#include <algorithm>
#include <cmath>
#include <optional>

#include "ModelingParameters.pb.h"
#include "modules/modeling/SeenPlayers.h"
#include "modules/modeling/players/PlayerGrid.h"
#include "modules/modeling/players/PlayerKalman.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/ParameterTable.h"

namespace modules {
namespace {

using robotlink::Color;
using robotlink::kAboveZero;
using robotlink::kAtLeastZero;
using robotlink::kShare;
using robotlink::Vector2;

const robotlink::FieldDrawingKey kGridKey{
    "players-model/grid", "The evidence for other robots in each cell of the field (drawn on the field)"};
const robotlink::FieldDrawingKey kTracksKey{
    "players-model/tracks",
    "The uncertainty of the other robots' positions, and where they go (drawn on the field)"};

/// Other robots are not found farther away, m.
constexpr double kFarthestPlayer = 2.5;

/// The sector that a camera shows of the ground; it shows nothing if it looks straight up or down.
SeenSector sectorOf(const robotcontrol::CameraPose& camera, const robotlink::Pose2& robotInField) {
  const robotlink::Pose3 inRobot = robotlink::pose3(camera.camera_in_robot());
  const robotlink::Vector3 axis = inRobot.linear().col(0);
  const double height = inRobot.translation().z();
  const double elevation = std::asin(std::clamp(axis.z(), -1.0, 1.0));
  const double lowest = elevation - 0.5 * camera.vertical_angle();
  const double highest = elevation + 0.5 * camera.vertical_angle();
  SeenSector sector{robotInField, std::atan2(axis.y(), axis.x()), 0.5 * camera.horizontal_angle()};
  const auto reach = [&](double angle) {
    return angle < -1e-3 ? std::min(kFarthestPlayer, height / std::tan(-angle)) : kFarthestPlayer;
  };
  sector.nearest = std::max(0.3, reach(lowest));
  sector.farthest = reach(highest);
  return sector;
}

/// The common part of both solutions; `Filter` is PlayerGrid or PlayerKalman.
template <typename Filter>
class FilteredPlayers : public SeenPlayers {
 public:
  FilteredPlayers(robotlink::SolutionContext& context, Filter filter)
      : SeenPlayers(context),
        percepts_(context.input(robotlink::kRobotPercepts)),
        pose_(context.input(robotlink::kRobotPose)),
        camera_(context.input(robotlink::kCameraPose)),
        filter_(std::move(filter)) {}

  void execute() override {
    if (!percepts_ || !percepts_.isNew() || !pose_) return;
    PlayerFrame frame;
    frame.time = robotlink::seconds(robotlink::instant(percepts_->timestamp()));
    frame.robotInField = robotlink::pose2(pose_->robot_in_field());
    frame.positionDeviation = pose_->position_deviation();
    frame.headingDeviation = pose_->heading_deviation();
    if (camera_) frame.sector = sectorOf(*camera_, frame.robotInField);
    for (const robotcontrol::RobotPercept& robot : percepts_->robots())
      frame.seen.push_back({robot.team(), robotlink::vector2(robot.position_in_robot()), robot.confidence()});
    prepare(filter_);
    filter_.update(frame);
    publishSeen(filter_.players(), percepts_->timestamp());
    draw(filter_);
  }

 protected:
  virtual void prepare(Filter& filter) = 0;
  virtual void draw(const Filter& filter) = 0;

 private:
  robotlink::Input<robotcontrol::RobotPercepts> percepts_;
  robotlink::Input<robotcontrol::RobotPose> pose_;
  robotlink::Input<robotcontrol::CameraPose> camera_;
  Filter filter_;
};

using GridFields = robotcontrol::GridPlayersParameters;
using GridOptions = PlayerGrid::Options;
const robotlink::ParameterTable<GridOptions> kGridTable{
    {GridFields::kDeviationNearFieldNumber, &GridOptions::deviationNear, kAboveZero},
    {GridFields::kDeviationPerMetreFieldNumber, &GridOptions::deviationPerMeter, kAtLeastZero},
    {GridFields::kHalfLifeFieldNumber, &GridOptions::halfLife, kAboveZero},
    {GridFields::kSeenHalfLifeFieldNumber, &GridOptions::seenHalfLife, kAboveZero},
    {GridFields::kMinimumPeakFieldNumber, &GridOptions::minimumPeak, kShare},
    {GridFields::kApartFieldNumber, &GridOptions::apart, kAtLeastZero},
    {GridFields::kMaximumPlayersFieldNumber, &GridOptions::maximumPlayers, kAtLeastZero}};

class GridPlayers final : public FilteredPlayers<PlayerGrid> {
 public:
  explicit GridPlayers(robotlink::SolutionContext& context)
      : FilteredPlayers(context, PlayerGrid(context.robot().field->length, context.robot().field->width, {})),
        parameters_(context.parameters<GridFields>()) {}

 private:
  void prepare(PlayerGrid& grid) override { grid.setOptions(kGridTable.read(parameters_)); }
  void draw(const PlayerGrid& grid) override {
    if (!debug_.on(kGridKey)) return;
    auto drawing = debug_.fieldDrawing(kGridKey);
    constexpr double kHalf = 0.5 * PlayerGrid::kCell;
    for (const PlayerGrid::Cell& cell : grid.cells(0.03)) {
      const Color fill = teamColor(cell.team, 0.7 * cell.evidence);
      const Vector2 c = cell.center;
      const std::array corners{Vector2(c.x() - kHalf, c.y() - kHalf), Vector2(c.x() + kHalf, c.y() - kHalf),
                               Vector2(c.x() + kHalf, c.y() + kHalf), Vector2(c.x() - kHalf, c.y() + kHalf)};
      drawing.polygon(corners, {{}, 0}, 1, fill);
    }
  }

  const GridFields& parameters_;
};

const robotlink::SolutionRegistration kGridPlayers =
    robotlink::SolutionBuilder<GridPlayers>(
        "players-model", "grid",
        "Collects evidence in the cells of the field, which fades where no robot is seen; players are peaks.")
        .source("H. Moravec, A. Elfes: High resolution maps from wide angle sonar, 1985.")
        .needs(robotlink::kRobotPercepts)
        .needs(robotlink::kRobotPose)
        .uses(robotlink::kTeamMessages)
        .uses(robotlink::kCameraPose)
        .yields(robotlink::kPlayersModel)
        .keys({&kPlayersKey, &kPlayerCountKey, &kGridKey})
        .parameters<GridFields>(kGridTable.rules<GridFields>());

using TrackFields = robotcontrol::KalmanPlayersParameters;
using TrackOptions = PlayerKalman::Options;
const robotlink::ParameterTable<TrackOptions> kTrackTable{
    {TrackFields::kDeviationNearFieldNumber, &TrackOptions::deviationNear, kAboveZero},
    {TrackFields::kDeviationPerMetreFieldNumber, &TrackOptions::deviationPerMeter, kAtLeastZero},
    {TrackFields::kBearingDeviationFieldNumber, &TrackOptions::bearingDeviation, kAtLeastZero},
    {TrackFields::kAccelerationFieldNumber, &TrackOptions::acceleration, kAtLeastZero},
    {TrackFields::kFrictionFieldNumber, &TrackOptions::friction, kAtLeastZero},
    {TrackFields::kGateFieldNumber, &TrackOptions::gate, kAboveZero},
    {TrackFields::kHalfLifeFieldNumber, &TrackOptions::halfLife, kAboveZero},
    {TrackFields::kSeenHalfLifeFieldNumber, &TrackOptions::seenHalfLife, kAboveZero},
    {TrackFields::kForgetBelowFieldNumber, &TrackOptions::forgetBelow, kShare},
    {TrackFields::kApartFieldNumber, &TrackOptions::apart, kAtLeastZero},
    {TrackFields::kMaximumPlayersFieldNumber, &TrackOptions::maximumPlayers, kAtLeastZero}};

class KalmanPlayers final : public FilteredPlayers<PlayerKalman> {
 public:
  explicit KalmanPlayers(robotlink::SolutionContext& context)
      : FilteredPlayers(context, PlayerKalman({})), parameters_(context.parameters<TrackFields>()) {}

 private:
  void prepare(PlayerKalman& filter) override { filter.setOptions(kTrackTable.read(parameters_)); }
  void draw(const PlayerKalman& filter) override {
    if (!debug_.on(kTracksKey)) return;
    auto drawing = debug_.fieldDrawing(kTracksKey);
    for (const PlayerKalman::Track& track : filter.tracks()) {
      const Vector2 place = track.state.head<2>(), velocity = track.state.tail<2>();
      const Eigen::Matrix2d spread = track.covariance.topLeftCorner<2, 2>();
      const double angle = 0.5 * std::atan2(2 * spread(0, 1), spread(0, 0) - spread(1, 1));
      const Vector2 along(std::cos(angle), std::sin(angle)), across(-along.y(), along.x());
      const Color color = teamColor(track.team, 0.3 + 0.7 * track.confidence);
      drawing.ellipse(place,
                      {2 * std::sqrt(std::max(0.0, along.dot(spread * along))),
                       2 * std::sqrt(std::max(0.0, across.dot(spread * across)))},
                      angle, color);
      drawing.arrow(place, place + velocity, color);
    }
  }

  const TrackFields& parameters_;
};

const robotlink::SolutionRegistration kKalmanPlayers =
    robotlink::SolutionBuilder<KalmanPlayers>(
        "players-model", "kalman",
        "A Kalman filter with velocity for each other robot, to which percepts are assigned.")
        .source("Y. Bar-Shalom, T. Fortmann: Tracking and data association, 1988.")
        .needs(robotlink::kRobotPercepts)
        .needs(robotlink::kRobotPose)
        .uses(robotlink::kTeamMessages)
        .uses(robotlink::kCameraPose)
        .yields(robotlink::kPlayersModel)
        .keys({&kPlayersKey, &kPlayerCountKey, &kTracksKey})
        .parameters<TrackFields>(kTrackTable.rules<TrackFields>());

}  // namespace
}  // namespace modules
