// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "landmark-percepts": beacons and goals in the image.
#include <optional>

#include "PerceptionParameters.pb.h"
#include "foxglove/Image.pb.h"
#include "modules/perception/BandLandmarkFinder.h"
#include "modules/perception/HorizonLandmarkFinder.h"
#include "modules/perception/PerceptPackages.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotlink::ImageDrawingKey;
using robotlink::PlotKey;
using robotlink::RobotDrawingKey;

const ImageDrawingKey kBoxesKey{
    "landmark-percepts/boxes",
    "The boxes of beacons and goals in the image, with their names (drawn in the image)"};
const RobotDrawingKey kLandmarkPlacesKey{
    "landmark-percepts/places", "Where beacons and goals are, seen from the robot (drawn around the robot)"};
const PlotKey kLandmarkCountKey{"landmark-percepts/count", "How many landmarks were seen"};

/// The common part of both solutions: the landmarks of the field, the package, and drawings.
class LandmarkPerceptor : public robotlink::Solution {
 public:
  explicit LandmarkPerceptor(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        field_(context.robot().field),
        classes_(fieldClasses(*field_)),
        landmarks_(fieldLandmarks(*field_, classes_)),
        pose_(context.input(robotlink::kCameraPose)),
        percepts_(context.output(robotlink::kLandmarkPercepts)) {}

 protected:
  void publish(const std::vector<LandmarkObservation>& seen, const google::protobuf::Timestamp& time) {
    auto package = std::make_shared<robotcontrol::LandmarkPercepts>();
    *package->mutable_timestamp() = time;
    for (const LandmarkObservation& each : seen) {
      const FieldLandmark& landmark = landmarks_[each.landmark];
      robotcontrol::LandmarkPercept& added = *package->add_landmarks();
      added.set_kind(landmark.kind == FieldLandmark::Kind::kBeacon ? robotcontrol::LandmarkPercept::BEACON
                                                                   : robotcontrol::LandmarkPercept::GOAL);
      added.set_name(landmark.name);
      added.set_bearing(each.bearing);
      added.set_distance(each.distance);
      added.set_left(each.box.left);
      added.set_top(each.box.top);
      added.set_right(each.box.right);
      added.set_bottom(each.box.bottom);
      added.set_confidence(each.confidence);
    }
    draw(seen);
    percepts_.send(std::move(package));
  }

  robotlink::DebugContext& debug_;
  std::shared_ptr<const robotlink::FieldDescription> field_;
  colortool::ColorClasses classes_;
  std::vector<FieldLandmark> landmarks_;
  robotlink::Input<robotcontrol::CameraPose> pose_;

 private:
  void draw(const std::vector<LandmarkObservation>& seen) {
    if (debug_.on(kLandmarkCountKey)) debug_.plot(kLandmarkCountKey, static_cast<double>(seen.size()));
    if (debug_.on(kBoxesKey)) {
      auto drawing = debug_.imageDrawing(kBoxesKey);
      for (const LandmarkObservation& each : seen) {
        const robotlink::Color color{classes_.shownColor(landmarks_[each.landmark].topClass)};
        drawing.rectangle({each.box.left, each.box.top}, {each.box.right, each.box.bottom}, color, 2);
        drawing.text({each.box.left, each.box.top - 1}, landmarks_[each.landmark].name, color);
      }
    }
    if (debug_.on(kLandmarkPlacesKey)) {
      auto drawing = debug_.robotDrawing(kLandmarkPlacesKey);
      for (const LandmarkObservation& each : seen) {
        const robotlink::Vector2 place(each.distance * std::cos(each.bearing),
                                       each.distance * std::sin(each.bearing));
        const robotlink::Color color{classes_.shownColor(landmarks_[each.landmark].topClass)};
        drawing.line(robotlink::Vector2(0, 0), place, color);
        drawing.circle(place, 0.05, color);
      }
    }
  }

  robotlink::Output<robotcontrol::LandmarkPercepts> percepts_;
};

class ColorBandsLandmarkPerceptor final : public LandmarkPerceptor {
 public:
  explicit ColorBandsLandmarkPerceptor(robotlink::SolutionContext& context)
      : LandmarkPerceptor(context),
        parameters_(context.parameters<robotcontrol::ColorBandsLandmarkParameters>()),
        regions_(context.input(robotlink::kColorRegions)) {}

  void execute() override {
    if (!regions_ || !regions_.isNew() || !pose_) return;
    readRegions(*regions_, classes_, known_);
    const BandLandmarkFinder finder(*field_, landmarks_,
                                    {parameters_.minimum_band_area(), parameters_.minimum_goal_area(),
                                     landmarkGeometry(parameters_.geometry())});
    publish(finder.find(known_, cameraView(*pose_)), regions_->timestamp());
  }

 private:
  const robotcontrol::ColorBandsLandmarkParameters& parameters_;
  robotlink::Input<robotcontrol::ColorRegions> regions_;
  std::vector<colortool::Region> known_;
};

const robotlink::SolutionRegistration kColorBands =
    robotlink::SolutionBuilder<ColorBandsLandmarkPerceptor>(
        "landmark-percepts", "color-bands",
        "Recognizes two regions on top of each other as a beacon, and the largest other region in a goal's "
        "color as the goal.")
        .source(
            "A method of this project, on regions as J. Bruce, T. Balch and M. Veloso find them: Fast and "
            "inexpensive color image segmentation for interactive robots, 2000.")
        .needs(robotlink::kColorRegions)
        .needs(robotlink::kCameraPose)
        .yields(robotlink::kLandmarkPercepts)
        .keys({&kBoxesKey, &kLandmarkPlacesKey, &kLandmarkCountKey})
        .parameters<robotcontrol::ColorBandsLandmarkParameters>();

class HorizonScanLandmarkPerceptor final : public LandmarkPerceptor {
 public:
  explicit HorizonScanLandmarkPerceptor(robotlink::SolutionContext& context)
      : LandmarkPerceptor(context),
        parameters_(context.parameters<robotcontrol::HorizonScanLandmarkParameters>()),
        image_(context.input(robotlink::kCameraImage)) {}

  void execute() override {
    if (!image_ || !image_.isNew() || !pose_) return;
    updateFinder();
    publish(finder_->find(robotlink::imageView(*image_), cameraView(*pose_)), image_->timestamp());
  }

 private:
  void updateFinder() {
    const std::string wanted = parameters_.SerializeAsString();
    if (finder_ && wanted == finderParameters_) return;
    finderParameters_ = wanted;
    const HorizonLandmarkFinder::Options options{parameters_.spacing(),
                                                 parameters_.above(),
                                                 parameters_.below(),
                                                 parameters_.minimum_run(),
                                                 parameters_.minimum_goal_lines(),
                                                 landmarkGeometry(parameters_.geometry())};
    finder_.emplace(*field_, landmarks_,
                    fieldColorTable(*field_, classes_, lightingRange(parameters_.lighting())), options);
  }

  const robotcontrol::HorizonScanLandmarkParameters& parameters_;
  robotlink::Input<foxglove::RawImage> image_;
  std::string finderParameters_;
  std::optional<HorizonLandmarkFinder> finder_;
};

const robotlink::SolutionRegistration kHorizonScan =
    robotlink::SolutionBuilder<HorizonScanLandmarkPerceptor>(
        "landmark-percepts", "horizon-scan",
        "Reads scan lines across the horizon as sequences "
        "of colors and collects those of beacons and goals.")
        .source(
            "T. R\u00f6fer, M. J\u00fcngel: Vision-based fast and reactive Monte-Carlo localization, ICRA "
            "2003.")
        .needs(robotlink::kCameraImage)
        .needs(robotlink::kCameraPose)
        .yields(robotlink::kLandmarkPercepts)
        .keys({&kBoxesKey, &kLandmarkPlacesKey, &kLandmarkCountKey})
        .parameters<robotcontrol::HorizonScanLandmarkParameters>();

}  // namespace
}  // namespace modules
