// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "path-planning": how the robot gets to the goal that the user has set.
#include <optional>

#include "NavigationParameters.pb.h"
#include "foxglove/Geometry.pb.h"
#include "foxglove/Ranging.pb.h"
#include "modules/FinitePose.h"
#include "modules/navigation/GridPlanner.h"
#include "modules/navigation/OdometryHistory.h"
#include "modules/navigation/RangePackages.h"
#include "modules/navigation/SeenObstacles.h"
#include "robotcontrol/Driving.pb.h"
#include "robotcontrol/Modeling.pb.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotcontrol::DrivePath;
using robotlink::FieldDrawingKey;
using robotlink::Level;
using robotlink::Vector2;

const robotlink::PlotKey kLengthKey{"path-planning/length", "How long the planned path is (plot, m)"};
const FieldDrawingKey kPathKey{"path-planning/path",
                               "The path to the goal, and the goal (drawn on the field)"};
const FieldDrawingKey kWaveKey{
    "path-planning/wave",
    "How far each place is from the goal, from near (green) to far (blue) (drawn on the field)"};

const FieldDrawingKey kObstaclesKey{
    "path-planning/obstacles",
    "What the laser has recently seen and the map does not show (drawn on the field)"};

Vector2 goalOf(const robotcontrol::DriveGoal& goal) {
  return {goal.pose_in_field().x(), goal.pose_in_field().y()};
}

std::string nameOf(const robotcontrol::DriveGoal& goal) {
  if (!goal.name().empty()) return "“" + goal.name() + "”";
  char text[64];
  std::snprintf(text, sizeof text, "(%.2f, %.2f)", goal.pose_in_field().x(), goal.pose_in_field().y());
  return text;
}

/// Plans when there is a new goal, and repeatedly while the robot is on its way.
class PathPlanner : public robotlink::Solution {
 public:
  explicit PathPlanner(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        clock_(context.clock()),
        pose_(context.input(robotlink::kRobotPose)),
        goal_(context.input(robotlink::kDriveGoal)),
        path_(context.output(robotlink::kDrivePath)) {}

  void execute() override {
    observe(pose_);
    if (goal_ && goal_.isNew()) {
      published_.clear();
      planNow_ = true;
    }
    const double now = robotlink::seconds(clock_.now());
    if (!planNow_ && now - plannedAt_ < period() && now >= plannedAt_) return draw();
    planNow_ = false;
    plannedAt_ = now;
    sent_ = std::make_shared<DrivePath>();
    robotlink::assign(*sent_->mutable_timestamp(), clock_.now());
    if (goal_ && !goal_->cancelled()) planFor(*goal_);
    path_.send(sent_);
    draw();
  }

 protected:
  virtual double period() const { return 0.5; }
  /// The standard deviation of the pose, m, above which nothing is planned.
  virtual double lostDeviation() const { return 1.0; }
  virtual PlannedPath plan(const Vector2& from, const Vector2& goal) = 0;
  /// Examines the packages that have arrived, each time the task runs.
  virtual void observe(const robotlink::Input<robotcontrol::RobotPose>&) {}
  virtual void drawMore() {}

  robotlink::DebugContext& debug_;

 private:
  void planFor(const robotcontrol::DriveGoal& goal) {
    *sent_->mutable_goal() = goal;
    if (!pose_ || !(pose_->position_deviation() <= lostDeviation())) {
      sent_->set_reason("the robot is not localized well enough");
      return sayOnce(Level::kInfo, "to " + nameOf(goal) + ": " + sent_->reason() + " yet");
    }
    const robotlink::Pose2 robot = robotlink::pose2(pose_->robot_in_field());
    const PlannedPath planned = plan(robot.translation(), goalOf(goal));
    sent_->set_blocked(planned.blocked());
    sent_->set_reason(planned.reason);
    for (const Vector2& point : planned.points) robotlink::assign(*sent_->add_points_in_field(), point);
    if (planned.blocked())
      return sayOnce(Level::kWarning, "no way to " + nameOf(goal) + ": " + planned.reason);
    char length[32];
    std::snprintf(length, sizeof length, "%.1f m", planned.length());
    const char* const around = planned.around ? " around something that is not on the map" : "";
    sayOnce(Level::kInfo, "to " + nameOf(goal) + " it is " + length + around, "to " + nameOf(goal) + around);
  }

  /// Logs a text, but not again until there is another goal or another text; `what` identifies the text if
  /// its wording varies.
  void sayOnce(Level level, const std::string& text, const std::string& what = "") {
    const std::string about = what.empty() ? text : what;
    if (about == published_) return;
    published_ = about;
    debug_.text(level, "path-planning", text);
  }

  void draw() {
    if (sent_ && debug_.on(kLengthKey)) {
      double length = 0;
      for (int i = 1; i < sent_->points_in_field_size(); ++i)
        length += (robotlink::vector2(sent_->points_in_field(i)) -
                   robotlink::vector2(sent_->points_in_field(i - 1)))
                      .norm();
      debug_.plot(kLengthKey, "length", length, "m");
    }
    if (sent_ && debug_.on(kPathKey)) {
      auto drawing = debug_.fieldDrawing(kPathKey);
      for (int i = 1; i < sent_->points_in_field_size(); ++i)
        drawing.line(robotlink::vector2(sent_->points_in_field(i - 1)),
                     robotlink::vector2(sent_->points_in_field(i)), robotlink::colors::kGreen, 2);
      if (sent_->has_goal()) {
        const auto color = sent_->blocked() ? robotlink::colors::kRed : robotlink::colors::kOrange;
        drawing.circle(goalOf(sent_->goal()), 0.2, color, 2);
        if (!sent_->goal().any_heading())
          drawing.pose(robotlink::pose2(sent_->goal().pose_in_field()), color, 0.4);
      }
    }
    drawMore();
  }

  const robotlink::Clock& clock_;
  robotlink::Input<robotcontrol::RobotPose> pose_;
  robotlink::Input<robotcontrol::DriveGoal> goal_;
  robotlink::Output<DrivePath> path_;
  std::shared_ptr<DrivePath> sent_;
  std::string published_;
  bool planNow_ = true;
  double plannedAt_ = 0;
};

struct GridPlanningOptions : GridPlanner::Options {
  /// The standard deviation of the pose above which nothing is planned, m.
  double lostDeviation = 1.0;
  /// The time between two plans, s.
  double period = 0.5;
  /// The criteria for an obstacle that is not on the map.
  SeenObstacles::Options seen;
  /// The standard deviation of the pose above which no obstacles are looked for, m.
  double obstacleDeviation = 0.25;
};

using PlanningFields = robotcontrol::GridPlanningParameters;
const robotlink::ParameterTable<GridPlanningOptions> kGridPlanningTable{
    {PlanningFields::kClearanceFieldNumber, &GridPlanningOptions::clearance, robotlink::kAtLeastZero},
    {PlanningFields::kComfortFieldNumber, &GridPlanningOptions::comfort, robotlink::kAtLeastZero},
    {PlanningFields::kNearnessFieldNumber, &GridPlanningOptions::nearness, robotlink::kAtLeastZero},
    {PlanningFields::kLostDeviationFieldNumber, &GridPlanningOptions::lostDeviation, robotlink::kAboveZero},
    {PlanningFields::kPeriodFieldNumber, &GridPlanningOptions::period, robotlink::kAtLeastZero},
    {PlanningFields::kObstacleRangeFieldNumber,
     +[](GridPlanningOptions& o) -> double& { return o.seen.range; }, robotlink::kAtLeastZero},
    {PlanningFields::kObstacleMemoryFieldNumber,
     +[](GridPlanningOptions& o) -> double& { return o.seen.memory; }, robotlink::kAtLeastZero},
    {PlanningFields::kWallDistanceFieldNumber,
     +[](GridPlanningOptions& o) -> double& { return o.seen.wallDistance; }, robotlink::kAtLeastZero},
    {PlanningFields::kObstacleDeviationFieldNumber, &GridPlanningOptions::obstacleDeviation,
     robotlink::kAtLeastZero}};

/// The options of a robot whose parameters say nothing: it needs half of its width, and a little more.
GridPlanningOptions builtInPlanning(const robotlink::RobotSetup& robot) {
  GridPlanningOptions options;
  if (const auto& drive = robot.description.drive; drive && drive->width > 0)
    options.clearance = 0.5 * drive->width + 0.07;
  return options;
}

class GridPathPlanner final : public PathPlanner {
 public:
  explicit GridPathPlanner(robotlink::SolutionContext& context)
      : PathPlanner(context),
        parameters_(context.parameters<robotcontrol::GridPlanningParameters>()),
        laserMaximum_(context.robot().description.laser ? context.robot().description.laser->maximum : 0),
        drive_(context.input(robotlink::kDriveState)),
        laser_(context.input(robotlink::kLaser)) {
    if (context.robot().map == nullptr) {
      debug_.text(Level::kWarning, "path-planning",
                  "there is no map to plan in: open one, or choose the solution direct");
      return;
    }
    planner_.emplace(*context.robot().map,
                     kGridPlanningTable.read(parameters_, builtInPlanning(context.robot())));
    obstacles_.emplace(planner_->walls());
  }

 private:
  double period() const override { return kGridPlanningTable.read(parameters_).period; }
  double lostDeviation() const override { return kGridPlanningTable.read(parameters_).lostDeviation; }

  /// Adds what the laser sees to the obstacles, from where the robot was then.
  void observe(const robotlink::Input<robotcontrol::RobotPose>& pose) override {
    if (drive_ && drive_.isNew()) {
      const robotlink::Pose2 odometry = robotlink::pose2(drive_->odometry());
      if (isFinite(odometry)) odometry_.add(robotlink::instant(drive_->timestamp()), odometry);
    }
    if (!obstacles_ || !pose || !laser_ || !laser_.isNew()) return;
    const GridPlanningOptions options = kGridPlanningTable.read(parameters_);
    if (!(pose->position_deviation() <= options.obstacleDeviation)) return;
    const robotlink::Instant time = robotlink::instant(laser_->timestamp());
    const auto now = odometry_.at(robotlink::instant(pose->timestamp())), then = odometry_.at(time);
    if (!now || !then) return;
    const robotlink::Pose2 robot = robotlink::pose2(pose->robot_in_field()) * now->inverse() * *then;
    obstacles_->see(time, robot, beams(*laser_, laserMaximum_), options.seen);
  }

  PlannedPath plan(const Vector2& from, const Vector2& goal) override {
    if (!planner_) return {{}, "there is no map to plan in"};
    if (obstacles_->generation() != planned_) {
      planned_ = obstacles_->generation();
      planner_->setObstacles(obstacles_->places());
    }
    if (planner_->goal() != goal) planner_->setGoal(goal);
    return planner_->path(from);
  }

  void drawMore() override {
    if (!planner_) return;
    if (debug_.on(kObstaclesKey)) {
      auto drawing = debug_.fieldDrawing(kObstaclesKey);
      for (const Vector2& place : obstacles_->places()) drawing.dot(place, robotlink::colors::kOrange, 0.1);
    }
    if (!debug_.on(kWaveKey)) return;
    auto drawing = debug_.fieldDrawing(kWaveKey);
    for (const GridPlanner::WavePoint& point : planner_->wave(1500)) {
      const auto share = static_cast<std::uint8_t>(255 * point.share);
      drawing.dot(point.place, {{40, static_cast<std::uint8_t>(220 - 0.7 * share), share}}, 0.1);
    }
  }

  const robotcontrol::GridPlanningParameters& parameters_;
  double laserMaximum_;
  robotlink::Input<robotcontrol::DriveState> drive_;
  robotlink::Input<foxglove::LaserScan> laser_;
  OdometryHistory odometry_;
  std::optional<GridPlanner> planner_;
  /// The walls of planner_ are its.
  std::optional<SeenObstacles> obstacles_;
  /// The generation of obstacles_ that planner_ has.
  std::uint64_t planned_ = 0;
};

const robotlink::SolutionRegistration kGrid =
    robotlink::SolutionBuilder<GridPathPlanner>("path-planning", "grid",
                                                "The path of least cost on the map's grid, away from walls "
                                                "and from seen obstacles that are not on the map, outside of "
                                                "forbidden areas.")
        .source(
            "E. W. Dijkstra: A note on two problems in connexion with graphs, 1959; P. Felzenszwalb, D. "
            "Huttenlocher: Distance transforms of sampled functions, 2012.")
        .needs(robotlink::kRobotPose)
        .uses(robotlink::kDriveGoal)
        .uses(robotlink::kDriveState)
        .uses(robotlink::kLaser)
        .yields(robotlink::kDrivePath)
        .keys({&kPathKey, &kLengthKey, &kWaveKey, &kObstaclesKey})
        .parameters<robotcontrol::GridPlanningParameters>(
            kGridPlanningTable.rules<robotcontrol::GridPlanningParameters>(builtInPlanning));

class DirectPathPlanner final : public PathPlanner {
 public:
  explicit DirectPathPlanner(robotlink::SolutionContext& context) : PathPlanner(context) {}

 private:
  PlannedPath plan(const Vector2& from, const Vector2& goal) override { return {{from, goal}, ""}; }
};

const robotlink::SolutionRegistration kDirect =
    robotlink::SolutionBuilder<DirectPathPlanner>("path-planning", "direct",
                                                  "Straight to the goal, ignoring obstacles.")
        .source("A method of this project.")
        .needs(robotlink::kRobotPose)
        .uses(robotlink::kDriveGoal)
        .yields(robotlink::kDrivePath)
        .keys({&kPathKey, &kLengthKey});

}  // namespace
}  // namespace modules
