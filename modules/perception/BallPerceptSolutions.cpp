// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "ball-percept": the ball in the image and on the ground.
#include "PerceptionParameters.pb.h"
#include "foxglove/Image.pb.h"
#include "modules/perception/BallFringes.h"
#include "modules/perception/CircleBallFinder.h"
#include "modules/perception/PerceptPackages.h"
#include "modules/perception/RegionBallFinder.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotlink::ImageDrawingKey;
using robotlink::PlotKey;
using robotlink::RobotDrawingKey;

const ImageDrawingKey kDiscKey{"ball-percept/disc",
                               "The disc in the image that was recognized as the ball (drawn in the image)"};
const RobotDrawingKey kPlaceKey{"ball-percept/place",
                                "Where the ball is on the ground (drawn around the robot)"};
const PlotKey kDistanceKey{"ball-percept/distance", "Distance of the ball, and confidence in it"};
const ImageDrawingKey kEdgeKey{
    "ball-percept/edge",
    "The points of the ball's edge; those that the circle follows are orange (drawn in the image)"};

/// Where this color meets red or pink, the camera mixes them to the ball's color: at red robots in front of
/// the yellow goal, and between the bands of beacons.
constexpr char kMixedColor[] = "yellow";

/// The common part of both solutions: inputs, the package, and drawings.
class BallPerceptor : public robotlink::Solution {
 public:
  explicit BallPerceptor(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        field_(context.robot().field),
        regions_(context.input(robotlink::kColorRegions)),
        pose_(context.input(robotlink::kCameraPose)),
        percept_(context.output(robotlink::kBallPercept)) {}

  void execute() override {
    if (!regions_ || !regions_.isNew() || !pose_) return;
    readRegions(*regions_, field_->ballColor, orange_);
    readRegions(*regions_, kMixedColor, yellow_);
    removeFringes(orange_, yellow_, fringeArea());
    const BallObservation ball = find(orange_, cameraView(*pose_));
    auto package = std::make_shared<robotcontrol::BallPercept>();
    *package->mutable_timestamp() = regions_->timestamp();
    package->set_seen(ball.seen);
    if (ball.seen) {
      robotlink::assign(*package->mutable_center_in_image(), ball.centerInImage);
      package->set_radius_in_image(ball.radiusInImage);
      robotlink::assign(*package->mutable_position_in_robot(), ball.positionInRobot);
      package->set_confidence(ball.confidence);
      draw(ball);
    }
    percept_.send(std::move(package));
  }

 protected:
  virtual BallObservation find(const std::vector<colortool::Region>& orange, const CameraView& view) = 0;
  virtual int fringeArea() const = 0;

  robotlink::DebugContext& debug_;
  std::shared_ptr<const robotlink::FieldDescription> field_;

 private:
  void draw(const BallObservation& ball) {
    using robotlink::colors::kOrange;
    if (debug_.on(kDiscKey)) {
      auto drawing = debug_.imageDrawing(kDiscKey);
      drawing.circle(ball.centerInImage, ball.radiusInImage, robotlink::colors::kPink, 2);
      drawing.dot(ball.centerInImage, robotlink::colors::kBlack);
    }
    if (debug_.on(kPlaceKey))
      debug_.robotDrawing(kPlaceKey).circle(ball.positionInRobot, field_->ballRadius, kOrange);
    if (debug_.on(kDistanceKey)) {
      debug_.plot(kDistanceKey, "distance", ball.positionInRobot.norm(), "m");
      debug_.plot(kDistanceKey, "confidence", ball.confidence);
    }
  }

  robotlink::Input<robotcontrol::ColorRegions> regions_;
  robotlink::Input<robotcontrol::CameraPose> pose_;
  robotlink::Output<robotcontrol::BallPercept> percept_;
  std::vector<colortool::Region> orange_, yellow_;
};

class RegionBallPerceptor final : public BallPerceptor {
 public:
  explicit RegionBallPerceptor(robotlink::SolutionContext& context)
      : BallPerceptor(context), parameters_(context.parameters<robotcontrol::RegionBallParameters>()) {}

 private:
  BallObservation find(const std::vector<colortool::Region>& orange, const CameraView& view) override {
    const RegionBallFinder finder({parameters_.minimum_area(), parameters_.minimum_fill(),
                                   parameters_.maximum_stretch(),
                                   ballGeometry(parameters_.geometry(), field_->ballRadius)});
    return finder.find(orange, view);
  }
  int fringeArea() const override { return parameters_.fringe_area(); }

  const robotcontrol::RegionBallParameters& parameters_;
};

const robotlink::SolutionRegistration kRegion =
    robotlink::SolutionBuilder<RegionBallPerceptor>(
        "ball-percept", "region",
        "Chooses the orange region whose shape, size and position best match a ball on the ground.")
        .source("A method of this project.")
        .needs(robotlink::kColorRegions)
        .needs(robotlink::kCameraPose)
        .yields(robotlink::kBallPercept)
        .keys({&kDiscKey, &kPlaceKey, &kDistanceKey})
        .parameters<robotcontrol::RegionBallParameters>();

class CircleFitBallPerceptor final : public BallPerceptor {
 public:
  explicit CircleFitBallPerceptor(robotlink::SolutionContext& context)
      : BallPerceptor(context),
        parameters_(context.parameters<robotcontrol::CircleFitBallParameters>()),
        image_(context.input(robotlink::kCameraImage)) {}

 private:
  BallObservation find(const std::vector<colortool::Region>& orange, const CameraView& view) override {
    if (!image_) return {};
    finder_.setOptions({parameters_.minimum_area(), parameters_.candidates(), parameters_.rays(),
                        parameters_.color_difference(), parameters_.tolerance(),
                        parameters_.minimum_inliers(),
                        ballGeometry(parameters_.geometry(), field_->ballRadius)});
    BallObservation ball = finder_.find(robotlink::imageView(*image_), orange, view);
    if (debug_.on(kEdgeKey)) drawEdge();
    return ball;
  }
  int fringeArea() const override { return parameters_.fringe_area(); }

  void drawEdge() {
    auto drawing = debug_.imageDrawing(kEdgeKey);
    for (const CircleBallFinder::EdgePoint& point : finder_.edge())
      drawing.dot(point.at, point.onCircle ? robotlink::colors::kOrange : robotlink::colors::kWhite, 2);
  }

  const robotcontrol::CircleFitBallParameters& parameters_;
  robotlink::Input<foxglove::RawImage> image_;
  CircleBallFinder finder_{{}};
};

const robotlink::SolutionRegistration kCircleFit =
    robotlink::SolutionBuilder<CircleFitBallPerceptor>("ball-percept", "circle-fit",
                                                       "Follows rays from the center of orange regions to "
                                                       "the ball's edge and robustly fits a circle to it.")
        .source("I. K\u00e5sa: A circle fitting procedure and its error analysis, 1976.")
        .needs(robotlink::kColorRegions)
        .needs(robotlink::kCameraPose)
        .needs(robotlink::kCameraImage)
        .yields(robotlink::kBallPercept)
        .keys({&kDiscKey, &kPlaceKey, &kDistanceKey, &kEdgeKey})
        .parameters<robotcontrol::CircleFitBallParameters>();

}  // namespace
}  // namespace modules
