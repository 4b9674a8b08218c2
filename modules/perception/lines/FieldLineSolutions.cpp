// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "line-percepts": lines of the field in the image and on the ground.
#include <array>
#include <cmath>

#include "PerceptionParameters.pb.h"
#include "foxglove/Image.pb.h"
#include "modules/perception/PerceptPackages.h"
#include "modules/perception/lines/FieldLineScanner.h"
#include "modules/perception/lines/SegmentFinder.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldEdges.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/GamePackages.h"

namespace modules {
namespace {

using robotlink::Color;
using robotlink::kAtLeastOne;
using robotlink::kAtLeastZero;
using robotlink::Vector2;

const robotlink::ImageDrawingKey kLinePointsKey{
    "line-percepts/points",
    "The points where green turns into white or white into green (drawn in the image)"};
const robotlink::RobotDrawingKey kLinePlacesKey{
    "line-percepts/places",
    "Where the points of lines are on the ground, with the lines' directions (drawn around the robot)"};
const robotlink::PlotKey kLineCountKey{"line-percepts/count", "How many points and segments were found"};
const robotlink::RobotDrawingKey kSegmentsKey{
    "line-percepts/segments", "The segments that were fitted to points (drawn around the robot)"};

/// The colors of segments and their points, in turn.
constexpr std::array kSegmentColors{robotlink::colors::kRed,     robotlink::colors::kBlue,
                                    robotlink::colors::kOrange,  robotlink::colors::kPink,
                                    robotlink::colors::kSkyBlue, robotlink::colors::kYellow};

using Scan = FieldLineScanner::Options;
using Joining = SegmentFinder::Options;
using PointFields = robotcontrol::EdgePointLineParameters;
using SegmentFields = robotcontrol::RansacLineParameters;

const robotlink::ParameterTable<Scan> kScanTable{
    {PointFields::kColumnSpacingFieldNumber, &Scan::columnSpacing, kAtLeastOne},
    {PointFields::kRowSpacingFieldNumber, &Scan::rowSpacing, kAtLeastOne},
    {PointFields::kContrastFieldNumber, &Scan::contrast, kAtLeastZero},
    {PointFields::kGreennessFieldNumber, &Scan::greenness, kAtLeastZero},
    {PointFields::kWhitenessFieldNumber, &Scan::whiteness, kAtLeastZero},
    {PointFields::kMaximumGapFieldNumber, &Scan::maximumGap, kAtLeastZero},
    {PointFields::kMinimumDistanceFieldNumber, &Scan::minimumDistance, kAtLeastZero},
    {PointFields::kMaximumDistanceFieldNumber, &Scan::maximumDistance, kAtLeastZero},
    {PointFields::kMaximumPointsFieldNumber, &Scan::maximumPoints, kAtLeastOne}};

struct LineOptions : FieldLineScanner::Options, SegmentFinder::Options {};

const robotlink::ParameterTable<LineOptions> kSegmentTable{
    {SegmentFields::kColumnSpacingFieldNumber, &Scan::columnSpacing, kAtLeastOne},
    {SegmentFields::kRowSpacingFieldNumber, &Scan::rowSpacing, kAtLeastOne},
    {SegmentFields::kContrastFieldNumber, &Scan::contrast, kAtLeastZero},
    {SegmentFields::kGreennessFieldNumber, &Scan::greenness, kAtLeastZero},
    {SegmentFields::kWhitenessFieldNumber, &Scan::whiteness, kAtLeastZero},
    {SegmentFields::kMaximumGapFieldNumber, &Scan::maximumGap, kAtLeastZero},
    {SegmentFields::kMinimumDistanceFieldNumber, &Scan::minimumDistance, kAtLeastZero},
    {SegmentFields::kMaximumDistanceFieldNumber, &Scan::maximumDistance, kAtLeastZero},
    {SegmentFields::kMaximumPointsFieldNumber, &Scan::maximumPoints, kAtLeastOne},
    {SegmentFields::kToleranceFieldNumber, &Joining::tolerance, kAtLeastZero},
    {SegmentFields::kTolerancePerMetreFieldNumber, &Joining::tolerancePerMeter, kAtLeastZero},
    {SegmentFields::kDirectionToleranceFieldNumber, &Joining::directionTolerance, kAtLeastZero},
    {SegmentFields::kSamplesFieldNumber, &Joining::samples, kAtLeastOne},
    {SegmentFields::kMinimumPointsFieldNumber, &Joining::minimumPoints, kAtLeastOne},
    {SegmentFields::kMinimumLengthFieldNumber, &Joining::minimumLength, kAtLeastZero},
    {SegmentFields::kMaximumSegmentGapFieldNumber, &Joining::maximumGap, kAtLeastZero},
    {SegmentFields::kMaximumSegmentsFieldNumber, &Joining::maximumSegments, kAtLeastOne}};

/// The common part of all solutions: the package, and drawings.
class LinePerceptor : public robotlink::Solution {
 public:
  explicit LinePerceptor(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        image_(context.input(robotlink::kCameraImage)),
        percepts_(context.output(robotlink::kFieldLines)) {}

  void execute() override {
    if (!image_ || !image_.isNew()) return;
    const std::vector<LinePoint>* found = find(*image_);
    if (found == nullptr) return;
    const std::vector<LinePoint>& points = *found;
    auto package = std::make_shared<robotcontrol::FieldLinePercepts>();
    *package->mutable_timestamp() = image_->timestamp();
    package->mutable_points()->Reserve(static_cast<int>(points.size()));
    for (const LinePoint& point : points) {
      robotcontrol::FieldLinePercepts::EdgePoint& added = *package->add_points();
      robotlink::assign(*added.mutable_position_in_robot(), point.inRobot);
      added.set_direction(point.direction);
      robotlink::assign(*added.mutable_position_in_image(), point.inImage);
    }
    addSegments(points, *package);
    draw(points);
    if (debug_.on(kLineCountKey)) {
      debug_.plot(kLineCountKey, "points", static_cast<double>(points.size()));
      debug_.plot(kLineCountKey, "segments", package->segments_size());
    }
    percepts_.send(std::move(package));
  }

 protected:
  /// The points in an image; null if something is missing that it needs.
  virtual const std::vector<LinePoint>* find(const foxglove::RawImage& image) = 0;
  virtual void addSegments(const std::vector<LinePoint>&, robotcontrol::FieldLinePercepts&) {}
  virtual Color colorOf(std::size_t /*point*/) const { return robotlink::colors::kPink; }

  robotlink::DebugContext& debug_;

 private:
  void draw(const std::vector<LinePoint>& points) {
    if (debug_.on(kLinePointsKey)) {
      auto drawing = debug_.imageDrawing(kLinePointsKey);
      for (std::size_t i = 0; i < points.size(); ++i) drawing.dot(points[i].inImage, colorOf(i));
    }
    if (debug_.on(kLinePlacesKey)) {
      auto drawing = debug_.robotDrawing(kLinePlacesKey);
      for (std::size_t i = 0; i < points.size(); ++i) {
        const LinePoint& point = points[i];
        drawing.dot(point.inRobot, colorOf(i), 0.02);
        const Vector2 along(std::cos(point.direction), std::sin(point.direction));
        if (along.allFinite()) drawing.line(point.inRobot, point.inRobot + 0.06 * along, colorOf(i));
      }
    }
  }

  robotlink::Input<foxglove::RawImage> image_;
  robotlink::Output<robotcontrol::FieldLinePercepts> percepts_;
};

/// Finds points along scan lines.
class ScanningPerceptor : public LinePerceptor {
 public:
  explicit ScanningPerceptor(robotlink::SolutionContext& context)
      : LinePerceptor(context), pose_(context.input(robotlink::kCameraPose)) {}

 protected:
  virtual Scan scanOptions() const = 0;

 private:
  const std::vector<LinePoint>* find(const foxglove::RawImage& image) override {
    if (!pose_) return nullptr;
    scanner_.setOptions(scanOptions());
    return &scanner_.find(robotlink::imageView(image), cameraView(*pose_));
  }

  robotlink::Input<robotcontrol::CameraPose> pose_;
  FieldLineScanner scanner_{{}};
};

class EdgePointLinePerceptor final : public ScanningPerceptor {
 public:
  explicit EdgePointLinePerceptor(robotlink::SolutionContext& context)
      : ScanningPerceptor(context), parameters_(context.parameters<PointFields>()) {}

 private:
  Scan scanOptions() const override { return kScanTable.read(parameters_); }

  const PointFields& parameters_;
};

const robotlink::SolutionRegistration kEdgePoints =
    robotlink::SolutionBuilder<EdgePointLinePerceptor>(
        "line-percepts", "edge-points",
        "Finds where scan lines cross from green to white and back, and the direction of the edge there.")
        .source(
            "T. R\u00f6fer, M. J\u00fcngel: Vision-based fast and reactive Monte-Carlo localization, ICRA "
            "2003.")
        .needs(robotlink::kCameraImage)
        .needs(robotlink::kCameraPose)
        .yields(robotlink::kFieldLines)
        .keys({&kLinePointsKey, &kLinePlacesKey, &kLineCountKey})
        .parameters<PointFields>(kScanTable.rules<PointFields>());

class RansacLinePerceptor final : public ScanningPerceptor {
 public:
  explicit RansacLinePerceptor(robotlink::SolutionContext& context)
      : ScanningPerceptor(context), parameters_(context.parameters<SegmentFields>()) {}

 private:
  Scan scanOptions() const override { return kSegmentTable.read(parameters_); }

  void addSegments(const std::vector<LinePoint>& points, robotcontrol::FieldLinePercepts& package) override {
    finder_.setOptions(kSegmentTable.read(parameters_));
    const std::vector<LineSegment>& segments = finder_.find(points);
    for (const LineSegment& segment : segments) {
      robotcontrol::FieldLinePercepts::Segment& added = *package.add_segments();
      robotlink::assign(*added.mutable_start_in_robot(), segment.start);
      robotlink::assign(*added.mutable_end_in_robot(), segment.end);
      added.set_confidence(segment.confidence);
    }
    // Points that belong to no segment are those of robots and of noise.
    auto& all = *package.mutable_points();
    int kept = 0;
    for (int i = 0; i < all.size(); ++i)
      if (finder_.segmentOfPoint()[static_cast<std::size_t>(i)] >= 0) all.SwapElements(kept++, i);
    all.DeleteSubrange(kept, all.size() - kept);
    if (!debug_.on(kSegmentsKey)) return;
    auto drawing = debug_.robotDrawing(kSegmentsKey);
    for (std::size_t i = 0; i < segments.size(); ++i)
      drawing.line(segments[i].start, segments[i].end, kSegmentColors[i % kSegmentColors.size()], 3);
  }

  Color colorOf(std::size_t point) const override {
    const int owner = finder_.segmentOfPoint()[point];
    return owner < 0 ? robotlink::colors::kGray
                     : kSegmentColors[static_cast<std::size_t>(owner) % kSegmentColors.size()];
  }

  const SegmentFields& parameters_;
  SegmentFinder finder_{{}};
};

const robotlink::SolutionRegistration kRansacSegments =
    robotlink::SolutionBuilder<RansacLinePerceptor>(
        "line-percepts", "ransac-segments",
        "Combines edge points into segments by random sample consensus, and drops the others.")
        .source(
            "M. Fischler, R. Bolles: Random sample consensus, 1981, on the points of T. R\u00f6fer, M. "
            "J\u00fcngel, 2003.")
        .needs(robotlink::kCameraImage)
        .needs(robotlink::kCameraPose)
        .yields(robotlink::kFieldLines)
        .keys({&kLinePointsKey, &kLinePlacesKey, &kLineCountKey, &kSegmentsKey})
        .parameters<SegmentFields>(kSegmentTable.rules<SegmentFields>());

/// Projects the edges of the field's lines and walls into the image, as if nothing stood before them.
class OracleLinePerceptor final : public LinePerceptor {
 public:
  explicit OracleLinePerceptor(robotlink::SolutionContext& context)
      : LinePerceptor(context), world_(context.input(robotlink::kOracleWorld)) {
    if (context.robot().field) edges_ = robotlink::fieldEdges(*context.robot().field);
  }

 private:
  const std::vector<LinePoint>* find(const foxglove::RawImage&) override {
    if (!world_ || !world_->has_camera()) return nullptr;
    const CameraView view = cameraView(world_->camera());
    const robotlink::Pose2 robot = robotlink::pose2(world_->robot_in_field());
    points_.clear();
    segments_.clear();
    for (const robotlink::FieldEdge& edge : edges_) addEdge(edge, robot, view);
    return &points_;
  }

  void addEdge(const robotlink::FieldEdge& edge, const robotlink::Pose2& robot, const CameraView& view) {
    constexpr double kSpacing = 0.05, kFarthest = 2.5;
    const Vector2 along = edge.end - edge.start;
    const int steps = std::max(1, static_cast<int>(along.norm() / kSpacing));
    bool wasSeen = false;
    for (int i = 0; i <= steps; ++i) {
      const Vector2 place = robot.inverse() * Vector2(edge.start + along * i / steps);
      const auto pixel = view.pixelOf({place.x(), place.y(), 0});
      const bool isSeen = pixel && view.contains(*pixel) && place.norm() <= kFarthest;
      if (isSeen) {
        points_.push_back({*pixel, place, std::remainder(edge.direction() - robot.heading, robotlink::kPi)});
        if (!wasSeen) segments_.push_back({place, place, 1});
        segments_.back().end = place;
      }
      wasSeen = isSeen;
    }
  }

  void addSegments(const std::vector<LinePoint>&, robotcontrol::FieldLinePercepts& package) override {
    for (const LineSegment& segment : segments_) {
      if (segment.start == segment.end) continue;
      robotcontrol::FieldLinePercepts::Segment& added = *package.add_segments();
      robotlink::assign(*added.mutable_start_in_robot(), segment.start);
      robotlink::assign(*added.mutable_end_in_robot(), segment.end);
      added.set_confidence(segment.confidence);
    }
  }

  robotlink::Input<robotcontrol::OracleWorld> world_;
  std::vector<robotlink::FieldEdge> edges_;
  std::vector<LinePoint> points_;
  std::vector<LineSegment> segments_;
};

const robotlink::SolutionRegistration kOracleLines =
    robotlink::SolutionBuilder<OracleLinePerceptor>("line-percepts", "oracle",
                                                    "The lines of the field and the bottom edges of its "
                                                    "walls as the true camera sees them, from the simulator.")
        .source("The simulator.")
        .needs(robotlink::kCameraImage)
        .needs(robotlink::kOracleWorld)
        .yields(robotlink::kFieldLines)
        .keys({&kLinePointsKey, &kLinePlacesKey, &kLineCountKey});

}  // namespace
}  // namespace modules
