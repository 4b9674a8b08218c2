// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "mapping": an occupancy grid of where a robot on wheels drives, and its pose in
// it.
#include <cmath>
#include <optional>

#include "MappingParameters.pb.h"
#include "foxglove/Grid.pb.h"
#include "foxglove/Ranging.pb.h"
#include "modules/FinitePose.h"
#include "modules/mapping/OccupancyMap.h"
#include "modules/mapping/ScanMatcher.h"
#include "modules/modeling/SelfLocalization.h"
#include "modules/navigation/OdometryHistory.h"
#include "modules/navigation/RangePackages.h"
#include "robotcontrol/Driving.pb.h"
#include "robotlink/base/GroundMap.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/packages/MapPackages.h"

namespace modules {
namespace {

using robotlink::FieldDrawingKey;
using robotlink::Instant;
using robotlink::kAboveZero;
using robotlink::kAtLeastOne;
using robotlink::kAtLeastZero;
using robotlink::kShare;
using robotlink::Level;
using robotlink::PlotKey;
using robotlink::Pose2;
using robotlink::Vector2;

const FieldDrawingKey kMapKey{"mapping/map", "What the robot has mapped so far (drawn on the field)"};
const FieldDrawingKey kScanKey{"mapping/scan",
                               "The last scan of the laser, as placed on the map (drawn on the field)"};
const PlotKey kMatchKey{"mapping/match",
                        "How well the scan fits the map, and how far the match is from dead reckoning"};

/// A drawing has at most this many parts of walls; a map with more is drawn in part.
constexpr std::size_t kMaxDrawn = 6000;
/// The range of a laser whose robot description says nothing of it, m.
constexpr double kLaserMaximum = 32;

/// The options that all solutions of the task share.
struct MappingOptions : OccupancyMap::Options {
  /// The motion between two scans that are added, m and rad.
  double leastWay = 0.1, leastTurn = 0.1;
  /// The time between two maps that are sent, s.
  double period = 1;
};

struct MatchingOptions : MappingOptions {
  ScanMatcher::Options matcher;
};

constexpr robotlink::ParameterRange kCellSize{0.01, 1};

using OdometryFields = robotcontrol::OdometryMappingParameters;
const robotlink::ParameterTable<MappingOptions> kOdometryMappingTable{
    {OdometryFields::kCellFieldNumber, +[](MappingOptions& o) -> double& { return o.cell; }, kCellSize},
    {OdometryFields::kHitFieldNumber, +[](MappingOptions& o) -> double& { return o.hit; }, kAtLeastZero},
    {OdometryFields::kMissFieldNumber, +[](MappingOptions& o) -> double& { return o.miss; }, kAtLeastZero},
    {OdometryFields::kClearToFieldNumber, +[](MappingOptions& o) -> double& { return o.clearTo; },
     kAtLeastZero},
    {OdometryFields::kLeastWayFieldNumber, &MappingOptions::leastWay, kAtLeastZero},
    {OdometryFields::kLeastTurnFieldNumber, &MappingOptions::leastTurn, kAtLeastZero},
    {OdometryFields::kPeriodFieldNumber, &MappingOptions::period, kAtLeastZero}};

using MatchingFields = robotcontrol::ScanMatchingParameters;
template <double ScanMatcher::Options::*kMember>
double& matcherOption(MatchingOptions& options) {
  return options.matcher.*kMember;
}
template <double OccupancyMap::Options::*kMember>
double& gridOption(MatchingOptions& options) {
  return options.*kMember;
}
template <double MappingOptions::*kMember>
double& mappingOption(MatchingOptions& options) {
  return options.*kMember;
}
const robotlink::ParameterTable<MatchingOptions> kScanMatchingTable{
    {MatchingFields::kCellFieldNumber, &gridOption<&OccupancyMap::Options::cell>, kCellSize},
    {MatchingFields::kHitFieldNumber, &gridOption<&OccupancyMap::Options::hit>, kAtLeastZero},
    {MatchingFields::kMissFieldNumber, &gridOption<&OccupancyMap::Options::miss>, kAtLeastZero},
    {MatchingFields::kClearToFieldNumber, &gridOption<&OccupancyMap::Options::clearTo>, kAtLeastZero},
    {MatchingFields::kLeastWayFieldNumber, &mappingOption<&MappingOptions::leastWay>, kAtLeastZero},
    {MatchingFields::kLeastTurnFieldNumber, &mappingOption<&MappingOptions::leastTurn>, kAtLeastZero},
    {MatchingFields::kPeriodFieldNumber, &mappingOption<&MappingOptions::period>, kAtLeastZero},
    {MatchingFields::kRaysFieldNumber, +[](MatchingOptions& o) -> int& { return o.matcher.rays; },
     kAtLeastOne},
    {MatchingFields::kReachFieldNumber, &matcherOption<&ScanMatcher::Options::reach>,
     robotlink::ParameterRange{0, 2}},
    {MatchingFields::kTurnReachFieldNumber, &matcherOption<&ScanMatcher::Options::turnReach>,
     robotlink::ParameterRange{0, 1}},
    {MatchingFields::kDeviationFieldNumber, &matcherOption<&ScanMatcher::Options::deviation>, kAboveZero},
    {MatchingFields::kTrustFieldNumber, &matcherOption<&ScanMatcher::Options::trust>, kAtLeastZero},
    {MatchingFields::kLeastScoreFieldNumber, &matcherOption<&ScanMatcher::Options::leastScore>, kShare}};

/// The part of an occupancy grid's message that only depends on its frame.
std::shared_ptr<foxglove::Grid> emptyGrid(const GridFrame& frame) {
  auto grid = std::make_shared<foxglove::Grid>();
  grid->set_frame_id("field");
  grid->mutable_pose()->mutable_position()->set_x(frame.low.x());
  grid->mutable_pose()->mutable_position()->set_y(frame.low.y());
  grid->mutable_pose()->mutable_orientation()->set_w(1);
  grid->set_column_count(static_cast<std::uint32_t>(frame.width));
  grid->mutable_cell_size()->set_x(frame.cell);
  grid->mutable_cell_size()->set_y(frame.cell);
  grid->set_row_stride(static_cast<std::uint32_t>(frame.width));
  grid->set_cell_stride(1);
  auto& field = *grid->add_fields();
  field.set_name("occupancy");
  field.set_type(foxglove::PackedElementField::INT8);
  return grid;
}

/// The base of solutions of the task: reckons by the wheels from scan to scan, adds scans to the map, and
/// sends and draws it. A derived class says where the robot was when it made a scan.
///
/// The map begins at the robot's position, at the home of a map that it already has, so that both can be
/// compared, or else at 0, 0.
class Mapper : public SelfLocalization {
 public:
  Mapper(robotlink::SolutionContext& context, const MappingOptions& options)
      : SelfLocalization(context),
        map_(options),
        laserMaximum_(context.robot().description.laser ? context.robot().description.laser->maximum
                                                        : kLaserMaximum),
        drive_(context.input(robotlink::kDriveState)),
        laser_(context.input(robotlink::kLaser)),
        grid_(context.output(robotlink::kGridMap)) {
    const auto& known = context.robot().map;
    const auto* home = known ? known->find(robotlink::GroundMap::Place::Kind::kHome) : nullptr;
    if (home != nullptr) robotInMap_ = home->pose;
  }

  void execute() override {
    if (!drive_) return;
    takeStep();
    if (laser_ && laser_.isNew()) takeScan();
    if (drive_.isNew() && scanned_) {
      const std::optional<Pose2> now = odometry_.latest();
      PoseEstimate estimate;
      estimate.robotInField = now ? robotInMap_ * (*scanned_).inverse() * *now : robotInMap_;
      estimate.positionDeviation = positionDeviation();
      estimate.headingDeviation = headingDeviation();
      publish(estimate, drive_->timestamp());
    }
    sendMap();
  }

 protected:
  virtual MappingOptions mappingOptions() const = 0;
  /// The robot's pose at a scan, by dead reckoning from the last one and by the scan itself.
  virtual Pose2 placed(const Pose2& predicted, const std::vector<RangeBeam>& scan) = 0;
  /// A scan was added to the map.
  virtual void added() {}
  virtual double positionDeviation() const = 0;
  virtual double headingDeviation() const = 0;

  const OccupancyMap& map() const { return map_; }
  /// The total distance that the robot has driven and turned, m and rad.
  double way() const { return way_; }
  double turned() const { return turned_; }

 private:
  void takeStep() {
    const Pose2 odometry = robotlink::pose2(drive_->odometry());
    if (!drive_.isNew() || !isFinite(odometry)) return;
    const std::optional<Pose2> last = odometry_.latest();
    const bool continued = odometry_.add(robotlink::instant(drive_->timestamp()), odometry);
    if (!last) return;
    const Pose2 step = last->inverse() * odometry;
    // After a reset of the odometry the motion in between is unknown, but small: it continues from the last
    // pose.
    if (!continued) {
      if (scanned_) robotInMap_ = robotInMap_ * scanned_->inverse() * *last;
      if (scanned_) scanned_ = odometry;
      return;
    }
    way_ += std::hypot(step.x, step.y);
    turned_ += std::abs(step.heading);
  }

  void takeScan() {
    const std::optional<Pose2> then = odometry_.at(robotlink::instant(laser_->timestamp()));
    if (!then) return;
    const std::vector<RangeBeam> scan = beams(*laser_, laserMaximum_);
    const MappingOptions options = mappingOptions();
    map_.setOptions(options);
    robotInMap_ = placed(scanned_ ? robotInMap_ * (scanned_->inverse() * *then) : robotInMap_, scan);
    scanned_ = then;
    draw(scan);
    if (addedAt_) {
      const Pose2 step = addedAt_->inverse() * robotInMap_;
      const bool moved = std::hypot(step.x, step.y) >= options.leastWay ||
                         std::abs(robotlink::normalizedAngle(step.heading)) >= options.leastTurn;
      if (!moved) return;
    }
    addedAt_ = robotInMap_;
    const bool all = map_.insert(robotInMap_, scan);
    if (!all && !std::exchange(warned_, true))
      debug_.text(Level::kWarning, "mapping",
                  "the map has reached its maximum size; areas beyond it are left out");
    added();
  }

  void sendMap() {
    const Instant now = robotlink::instant(drive_->timestamp());
    const bool due =
        !sentAt_ || now < *sentAt_ || robotlink::seconds(now - *sentAt_) >= mappingOptions().period;
    if (!due || !addedAt_ || addedAt_ == sentWith_) return;
    sentAt_ = now;
    sentWith_ = addedAt_;
    const GridFrame& frame = map_.frame();
    auto grid = emptyGrid(frame);
    *grid->mutable_timestamp() = drive_->timestamp();
    std::string& data = *grid->mutable_data();
    data.reserve(frame.size());
    for (int row = 0; row < frame.height; ++row) {
      for (int column = 0; column < frame.width; ++column)
        data.push_back(static_cast<char>(map_.percent(column, row)));
    }
    grid_.send(std::move(grid));
  }

  void draw(const std::vector<RangeBeam>& scan) {
    if (debug_.on(kScanKey)) {
      auto drawing = debug_.fieldDrawing(kScanKey);
      for (const RangeBeam& beam : scan) {
        if (beam.hit()) drawing.dot(robotInMap_ * beam.endInRobot(), robotlink::colors::kRed, 0.06);
      }
      drawing.pose(robotInMap_, robotlink::colors::kRed, 0.4);
    }
    if (debug_.on(kMapKey)) drawMap();
  }

  void drawMap() {
    auto drawing = debug_.fieldDrawing(kMapKey);
    const GridFrame& frame = map_.frame();
    std::size_t drawn = 0;
    for (int row = 0; row < frame.height; ++row) {
      for (int column = 0; column < frame.width && drawn < kMaxDrawn; ++column) {
        const int begin = column;
        while (map_.occupied(column, row)) ++column;
        if (column == begin) continue;
        const Vector2 low = frame.low + frame.cell * Vector2(begin, row);
        const Vector2 high = frame.low + frame.cell * Vector2(column, row + 1);
        const Vector2 corners[]{low, {high.x(), low.y()}, high, {low.x(), high.y()}};
        drawing.polygon(corners, robotlink::colors::kBlue, 0, robotlink::colors::kBlue);
        ++drawn;
      }
    }
  }

  OccupancyMap map_;
  double laserMaximum_;
  robotlink::Input<robotcontrol::DriveState> drive_;
  robotlink::Input<foxglove::LaserScan> laser_;
  robotlink::Output<foxglove::Grid> grid_;
  OdometryHistory odometry_;
  /// The robot's pose at the last scan, and what the odometry said then.
  Pose2 robotInMap_;
  std::optional<Pose2> scanned_;
  /// The pose at which the last scan was added, and that at which the map was last sent.
  std::optional<Pose2> addedAt_, sentWith_;
  std::optional<Instant> sentAt_;
  double way_ = 0, turned_ = 0;
  bool warned_ = false;
};

/// The deviations of dead reckoning, m a meter and rad a radian.
constexpr double kDriftPerMeter = 0.05, kDriftPerRadian = 0.03;

class OdometryMapping final : public Mapper {
 public:
  explicit OdometryMapping(robotlink::SolutionContext& context)
      : Mapper(context, kOdometryMappingTable.read(context.parameters<OdometryFields>())),
        parameters_(context.parameters<OdometryFields>()) {}

 private:
  MappingOptions mappingOptions() const override { return kOdometryMappingTable.read(parameters_); }
  Pose2 placed(const Pose2& predicted, const std::vector<RangeBeam>&) override { return predicted; }
  double headingDeviation() const override { return kDriftPerRadian * turned(); }
  double positionDeviation() const override {
    return kDriftPerMeter * way() + 0.5 * way() * headingDeviation();
  }

  const OdometryFields& parameters_;
};

const robotlink::SolutionRegistration kOdometryMapping =
    robotlink::SolutionBuilder<OdometryMapping>(
        "mapping", "odometry",
        "Places each scan of the laser by dead reckoning; walls smear and double as its error grows.")
        .source("Occupancy grids: H. Moravec, A. Elfes: High resolution maps from wide angle sonar, 1985.")
        .needs(robotlink::kDriveState)
        .needs(robotlink::kLaser)
        .yields(robotlink::kGridMap)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorPlotKey, &kMapKey, &kScanKey})
        .parameters<OdometryFields>(kOdometryMappingTable.rules<OdometryFields>());

class ScanMatchingMapping final : public Mapper {
 public:
  explicit ScanMatchingMapping(robotlink::SolutionContext& context)
      : Mapper(context, kScanMatchingTable.read(context.parameters<MatchingFields>())),
        parameters_(context.parameters<MatchingFields>()) {}

 private:
  MappingOptions mappingOptions() const override { return kScanMatchingTable.read(parameters_); }

  Pose2 placed(const Pose2& predicted, const std::vector<RangeBeam>& scan) override {
    const MatchingOptions options = kScanMatchingTable.read(parameters_);
    const ScanMatcher::Match match = matcher_.match(predicted, scan, options.matcher);
    if (match.accepted) {
      matchedWay_ = way();
      matchedTurn_ = turned();
    }
    if (debug_.on(kMatchKey)) {
      const Pose2 step = predicted.inverse() * match.robotInMap;
      debug_.plot(kMatchKey, "score", match.score);
      debug_.plot(kMatchKey, "way", std::hypot(step.x, step.y), "m");
      debug_.plot(kMatchKey, "turn", robotlink::normalizedAngle(step.heading), "rad");
    }
    return match.robotInMap;
  }

  void added() override { matcher_.follow(map(), kScanMatchingTable.read(parameters_).matcher); }

  /// The standard deviation of a match plus that of dead reckoning since the last match.
  double headingDeviation() const override { return 0.01 + kDriftPerRadian * (turned() - matchedTurn_); }
  double positionDeviation() const override { return 0.05 + kDriftPerMeter * (way() - matchedWay_); }

  const MatchingFields& parameters_;
  ScanMatcher matcher_;
  double matchedWay_ = 0, matchedTurn_ = 0;
};

const robotlink::SolutionRegistration kScanMatching =
    robotlink::SolutionBuilder<ScanMatchingMapping>(
        "mapping", "scan-matching",
        "Places each scan of the laser where it best fits the map so far, near the pose from dead reckoning.")
        .source(
            "E. Olson: Real-time correlative scan matching, 2009; H. Moravec, A. Elfes: High resolution maps "
            "from wide angle sonar, 1985.")
        .needs(robotlink::kDriveState)
        .needs(robotlink::kLaser)
        .yields(robotlink::kGridMap)
        .yields(robotlink::kRobotPose)
        .keys({&kLocatorPoseKey, &kLocatorPlotKey, &kMapKey, &kScanKey, &kMatchKey})
        .parameters<MatchingFields>(kScanMatchingTable.rules<MatchingFields>());

}  // namespace
}  // namespace modules
