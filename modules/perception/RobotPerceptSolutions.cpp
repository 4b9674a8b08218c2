// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "robot-percepts": other robots, found by the patches in their team's color.
#include <algorithm>
#include <string>
#include <vector>

#include "PerceptionParameters.pb.h"
#include "modules/perception/FieldLandmarks.h"
#include "modules/perception/PatchFinder.h"
#include "modules/perception/PerceptPackages.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotlink::PlotKey;
using robotlink::RobotDrawingKey;

const RobotDrawingKey kRobotPlacesKey{"robot-percepts/places",
                                      "Where other robots are, seen from this one (drawn around the robot)"};
const PlotKey kRobotCountKey{"robot-percepts/count", "How many other robots were seen"};

/// The common part of both solutions: the teams' colors, the package, and drawings.
class RobotPerceptor : public robotlink::Solution {
 public:
  explicit RobotPerceptor(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        parameters_(context.parameters<robotcontrol::PatchParameters>()),
        classes_(fieldClasses(*context.robot().field)),
        teams_(context.robot().field->teams),
        regions_(context.input(robotlink::kColorRegions)),
        pose_(context.input(robotlink::kCameraPose)),
        percepts_(context.output(robotlink::kRobotPercepts)) {}

  void execute() override {
    if (!regions_ || !regions_.isNew() || !pose_) return;
    readRegions(*regions_, classes_, known_);
    const PatchFinder finder({parameters_.minimum_area(), parameters_.patch_height(),
                              parameters_.minimum_distance(), parameters_.maximum_distance(),
                              parameters_.robot_length()});
    std::vector<int> teams;
    for (const auto& team : teams_) teams.push_back(classes_.index(team.color));
    const std::vector<RobotObservation> seen = find(finder, teams, cameraView(*pose_));
    draw(seen);
    auto package = std::make_shared<robotcontrol::RobotPercepts>();
    *package->mutable_timestamp() = regions_->timestamp();
    for (const RobotObservation& robot : seen) {
      robotcontrol::RobotPercept& added = *package->add_robots();
      added.set_team(teamOf(robot.teamClass));
      robotlink::assign(*added.mutable_position_in_robot(), robot.positionInRobot);
      added.set_confidence(robot.confidence);
    }
    percepts_.send(std::move(package));
  }

 protected:
  virtual std::vector<RobotObservation> find(const PatchFinder& finder, std::span<const int> teams,
                                             const CameraView& view) const = 0;
  const std::vector<colortool::Region>& regions() const { return known_; }

 private:
  const std::string& teamOf(int color) const {
    return std::ranges::find(teams_, classes_.name(color), &robotlink::FieldDescription::Team::color)->name;
  }

  void draw(const std::vector<RobotObservation>& seen) {
    if (debug_.on(kRobotCountKey)) debug_.plot(kRobotCountKey, static_cast<double>(seen.size()));
    if (!debug_.on(kRobotPlacesKey)) return;
    auto drawing = debug_.robotDrawing(kRobotPlacesKey);
    for (const RobotObservation& robot : seen)
      drawing.circle(robot.positionInRobot, 0.1, {classes_.shownColor(robot.teamClass)}, 2);
  }

  robotlink::DebugContext& debug_;
  const robotcontrol::PatchParameters& parameters_;
  colortool::ColorClasses classes_;
  std::vector<robotlink::FieldDescription::Team> teams_;
  robotlink::Input<robotcontrol::ColorRegions> regions_;
  robotlink::Input<robotcontrol::CameraPose> pose_;
  robotlink::Output<robotcontrol::RobotPercepts> percepts_;
  std::vector<colortool::Region> known_;
};

/// Finds robots by one of the two functions of PatchFinder.
template <auto kFind>
class PatchSolution final : public RobotPerceptor {
 public:
  using RobotPerceptor::RobotPerceptor;

 private:
  std::vector<RobotObservation> find(const PatchFinder& finder, std::span<const int> teams,
                                     const CameraView& view) const override {
    return (finder.*kFind)(regions(), teams, view);
  }
};

const robotlink::SolutionRegistration kPatches =
    robotlink::SolutionBuilder<PatchSolution<&PatchFinder::findPatches>>(
        "robot-percepts", "patches", "Counts every patch of a team's color as a robot.")
        .source("A method of this project.")
        .needs(robotlink::kColorRegions)
        .needs(robotlink::kCameraPose)
        .yields(robotlink::kRobotPercepts)
        .keys({&kRobotPlacesKey, &kRobotCountKey})
        .parameters<robotcontrol::PatchParameters>();

const robotlink::SolutionRegistration kClusters =
    robotlink::SolutionBuilder<PatchSolution<&PatchFinder::findClusters>>(
        "robot-percepts", "patch-clusters",
        "Counts patches of a team's color less than a robot's length apart as one robot.")
        .source("A method of this project.")
        .needs(robotlink::kColorRegions)
        .needs(robotlink::kCameraPose)
        .yields(robotlink::kRobotPercepts)
        .keys({&kRobotPlacesKey, &kRobotCountKey})
        .parameters<robotcontrol::PatchParameters>();

}  // namespace
}  // namespace modules
