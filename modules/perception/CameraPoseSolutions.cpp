// SPDX-License-Identifier: GPL-3.0-or-later
// The solutions of the task "camera-pose": the pose of the camera when it took the image.
#include <cmath>
#include <optional>
#include <stdexcept>
#include <utility>

#include "PerceptionParameters.pb.h"
#include "foxglove/Image.pb.h"
#include "foxglove/Robot.pb.h"
#include "modules/motion/JointLayout.h"
#include "modules/perception/BodyPosture.h"
#include "modules/perception/BodyTiltFilter.h"
#include "modules/perception/PerceptPackages.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Sensing.pb.h"
#include "robotlink/debugging/ParameterTable.h"
#include "robotlink/debugging/Solution.h"
#include "robotlink/packages/Conversions.h"

namespace modules {
namespace {

using robotlink::ImageDrawingKey;
using robotlink::PlotKey;
using robotlink::RobotDrawingKey;

const ImageDrawingKey kHorizonKey{"camera-pose/horizon",
                                  "The horizon, computed from the camera's pose (drawn in the image)"};
const RobotDrawingKey kViewKey{
    "camera-pose/view", "The camera, and the part of the ground that it sees (drawn around the robot)"};
const PlotKey kCameraKey{"camera-pose/camera",
                         "Height of the camera over the ground, and the elevation of its axis"};
const PlotKey kTiltKey{"camera-pose/tilt", "Height, pitch and roll of the body over the ground"};

/// The common part of all solutions: the package, and drawings.
class CameraPoseEstimator : public robotlink::Solution {
 public:
  explicit CameraPoseEstimator(robotlink::SolutionContext& context)
      : debug_(context.debug()),
        image_(context.input(robotlink::kCameraImage)),
        pose_(context.output(robotlink::kCameraPose)) {}

  void execute() override {
    if (!image_ || !image_.isNew()) return;
    const auto view = estimate(static_cast<int>(image_->width()), static_cast<int>(image_->height()));
    if (!view) return;
    auto package = std::make_shared<robotcontrol::CameraPose>();
    *package->mutable_timestamp() = image_->timestamp();
    assign(*package, *view);
    pose_.send(std::move(package));
    draw(*view);
  }

 protected:
  /// The camera when it took the image of this size, pixels; empty if it is not known.
  virtual std::optional<CameraView> estimate(int width, int height) = 0;

  robotlink::DebugContext& debug_;

 private:
  void draw(const CameraView& view) {
    if (debug_.on(kHorizonKey)) {
      const auto left = view.horizonRow(0), right = view.horizonRow(view.width);
      if (left && right)
        debug_.imageDrawing(kHorizonKey).line({0, *left}, {view.width, *right}, robotlink::colors::kSkyBlue);
    }
    if (debug_.on(kViewKey)) drawView(view);
    if (debug_.on(kCameraKey)) {
      debug_.plot(kCameraKey, "height", view.cameraInRobot.translation().z(), "m");
      debug_.plot(kCameraKey, "elevation", view.elevation(view.center()), "rad");
    }
  }

  void drawView(const CameraView& view) {
    auto drawing = debug_.robotDrawing(kViewKey);
    drawing.axes(view.cameraInRobot, 0.05);
    const double w = view.width, h = view.height;
    for (const robotlink::Vector2& corner : {robotlink::Vector2{0, 0}, {w, 0}, {w, h}, {0, h}}) {
      const robotlink::Vector3 from = view.cameraInRobot.translation();
      const auto ground = view.onPlane(corner, 0);
      const bool near = ground && ground->norm() < 3;
      const robotlink::Vector3 to =
          near ? robotlink::Vector3(ground->x(), ground->y(), 0) : from + view.ray(corner) * 0.5;
      drawing.line(from, to, robotlink::colors::kSkyBlue);
    }
  }

  robotlink::Input<foxglove::RawImage> image_;
  robotlink::Output<robotcontrol::CameraPose> pose_;
};

/// The camera of a head: the neck's joints on a body that leans.
class HeadCameraPose : public CameraPoseEstimator {
 public:
  explicit HeadCameraPose(robotlink::SolutionContext& context)
      : CameraPoseEstimator(context),
        joints_(context.input(robotlink::kJointStates)),
        layout_(layoutOf(context.robot().description)) {}

 protected:
  virtual BodyTilt estimateTilt() = 0;
  virtual double horizontalAngle() const = 0;
  virtual double verticalAngle() const = 0;
  /// The tilt that follows from the joints of the legs and the contacts of the paws, as far as there are any.
  BodyTilt tiltByLegs(const robotlink::Input<robotcontrol::BodySensors>& body,
                      const BodyPosture::Options& options) const {
    std::array<LegAngles, 4> angles;
    std::array<bool, 4> contacts{true, true, true, true};
    for (const Leg each : kLegs) {
      angles[index(each)] = layout_.leg(positions_, each);
      const int number = static_cast<int>(index(each));
      if (body && number < body->paw_contacts_size()) contacts[index(each)] = body->paw_contacts(number);
    }
    return BodyPosture(LegKinematics(), options).estimate(angles, contacts);
  }

 private:
  static JointLayout layoutOf(const robotlink::RobotDescription& description) {
    auto layout = JointLayout::of(description.joints);
    if (!layout) throw std::runtime_error(layout.error().describe());
    return *std::move(layout);
  }

  std::optional<CameraView> estimate(int width, int height) override {
    if (!joints_) return std::nullopt;
    positions_.assign(layout_.size(), 0);
    for (int i = 0; i < joints_->joints_size() && i < static_cast<int>(layout_.size()); ++i)
      positions_[static_cast<std::size_t>(i)] = joints_->joints(i).position();
    const HeadAngles head = layout_.head(positions_);
    const BodyTilt tilt = estimateTilt();
    if (debug_.on(kTiltKey)) {
      debug_.plot(kTiltKey, "height", tilt.height, "m");
      debug_.plot(kTiltKey, "pitch", tilt.pitch, "rad");
      debug_.plot(kTiltKey, "roll", tilt.roll, "rad");
    }
    const robotlink::Pose3 camera =
        tilt.bodyInRobot() * cameraInBody(RobotDimensions{}, {head.tilt, head.pan, head.roll});
    return CameraView::fromAngles(camera, horizontalAngle(), verticalAngle(), width, height);
  }

  robotlink::Input<foxglove::JointStates> joints_;
  JointLayout layout_;
  std::vector<double> positions_;
};

class KinematicCameraPose final : public HeadCameraPose {
 public:
  explicit KinematicCameraPose(robotlink::SolutionContext& context)
      : HeadCameraPose(context),
        parameters_(context.parameters<robotcontrol::KinematicCameraPoseParameters>()),
        body_(context.input(robotlink::kBodySensors)) {}

 private:
  double horizontalAngle() const override { return parameters_.horizontal_angle(); }
  double verticalAngle() const override { return parameters_.vertical_angle(); }

  BodyTilt estimateTilt() override {
    const BodyTilt now = tiltByLegs(
        body_, {parameters_.ground_weight(), parameters_.level_weight(), parameters_.usual_pitch()});
    const double keep = last_ ? parameters_.smoothing() : 0;
    const BodyTilt before = last_.value_or(now);
    last_ =
        BodyTilt{keep * before.height + (1 - keep) * now.height, keep * before.pitch + (1 - keep) * now.pitch,
                 keep * before.roll + (1 - keep) * now.roll};
    return *last_;
  }

  const robotcontrol::KinematicCameraPoseParameters& parameters_;
  robotlink::Input<robotcontrol::BodySensors> body_;
  std::optional<BodyTilt> last_;
};

const robotlink::SolutionRegistration kKinematic =
    robotlink::SolutionBuilder<KinematicCameraPose>(
        "camera-pose", "kinematic",
        "Computed along the neck's joints from a body whose "
        "height and tilt come from its leg joints and paw contacts.")
        .source("T. R\u00f6fer et al.: GermanTeam RoboCup 2002, team report, 2002.")
        .needs(robotlink::kCameraImage)
        .needs(robotlink::kJointStates)
        .uses(robotlink::kBodySensors)
        .yields(robotlink::kCameraPose)
        .keys({&kHorizonKey, &kViewKey, &kCameraKey, &kTiltKey})
        .parameters<robotcontrol::KinematicCameraPoseParameters>();

struct AccelerometerOptions : BodyPosture::Options, BodyTiltFilter::Options {
  /// Fields of view of the ERS-210's camera, rad.
  double horizontalAngle = 1.00531, verticalAngle = 0.834267;
};

using AccelerometerFields = robotcontrol::AccelerometerCameraPoseParameters;
constexpr robotlink::ParameterRange kOpening{0, robotlink::kPi, true};
const robotlink::ParameterTable<AccelerometerOptions> kAccelerometerTable{
    {AccelerometerFields::kHorizontalAngleFieldNumber, &AccelerometerOptions::horizontalAngle, kOpening},
    {AccelerometerFields::kVerticalAngleFieldNumber, &AccelerometerOptions::verticalAngle, kOpening},
    {AccelerometerFields::kGroundWeightFieldNumber, &BodyPosture::Options::groundWeight,
     robotlink::kAtLeastZero},
    {AccelerometerFields::kLevelWeightFieldNumber, &BodyPosture::Options::levelWeight, robotlink::kAboveZero},
    {AccelerometerFields::kUsualPitchFieldNumber, &BodyPosture::Options::usualPitch, {-1, 1}},
    {AccelerometerFields::kTimeConstantFieldNumber, &BodyTiltFilter::Options::timeConstant,
     robotlink::kAtLeastZero},
    {AccelerometerFields::kMaximumJoltFieldNumber, &BodyTiltFilter::Options::maximumJolt,
     robotlink::kAtLeastZero}};

class AccelerometerCameraPose final : public HeadCameraPose {
 public:
  explicit AccelerometerCameraPose(robotlink::SolutionContext& context)
      : HeadCameraPose(context),
        parameters_(context.parameters<AccelerometerFields>()),
        body_(context.input(robotlink::kBodySensors)) {}

 private:
  double horizontalAngle() const override { return options_.horizontalAngle; }
  double verticalAngle() const override { return options_.verticalAngle; }

  BodyTilt estimateTilt() override {
    options_ = kAccelerometerTable.read(parameters_);
    const BodyTilt legs = tiltByLegs(body_, options_);
    if (!body_) return legs;
    const double now = robotlink::seconds(robotlink::instant(body_->timestamp()));
    const double passed = last_ ? now - *last_ : 0;
    last_ = now;
    return filter_.update(legs, robotlink::vector3(body_->acceleration()), passed, options_);
  }

  const AccelerometerFields& parameters_;
  robotlink::Input<robotcontrol::BodySensors> body_;
  AccelerometerOptions options_;
  BodyTiltFilter filter_;
  std::optional<double> last_;
};

const robotlink::SolutionRegistration kAccelerometer =
    robotlink::SolutionBuilder<AccelerometerCameraPose>(
        "camera-pose", "accelerometer",
        "Computed along the neck's joints from a body whose tilt comes from the legs in the short term and "
        "from the accelerometer in the long term.")
        .source(
            "R. Mahony, T. Hamel, J.-M. Pflimlin: Nonlinear complementary filters on the special orthogonal "
            "group, 2008.")
        .needs(robotlink::kCameraImage)
        .needs(robotlink::kJointStates)
        .needs(robotlink::kBodySensors)
        .yields(robotlink::kCameraPose)
        .keys({&kHorizonKey, &kViewKey, &kCameraKey, &kTiltKey})
        .parameters<AccelerometerFields>(kAccelerometerTable.rules<AccelerometerFields>());

class FixedStanceCameraPose final : public HeadCameraPose {
 public:
  explicit FixedStanceCameraPose(robotlink::SolutionContext& context)
      : HeadCameraPose(context),
        parameters_(context.parameters<robotcontrol::FixedStanceCameraPoseParameters>()) {}

 private:
  double horizontalAngle() const override { return parameters_.horizontal_angle(); }
  double verticalAngle() const override { return parameters_.vertical_angle(); }
  BodyTilt estimateTilt() override { return {parameters_.body_height(), parameters_.body_pitch(), 0}; }

  const robotcontrol::FixedStanceCameraPoseParameters& parameters_;
};

const robotlink::SolutionRegistration kFixedStance =
    robotlink::SolutionBuilder<FixedStanceCameraPose>(
        "camera-pose", "fixed-stance",
        "Computed along the neck's joints from a body that always has the height and tilt of the stance.")
        .source("A method of this project.")
        .needs(robotlink::kCameraImage)
        .needs(robotlink::kJointStates)
        .yields(robotlink::kCameraPose)
        .keys({&kHorizonKey, &kViewKey, &kCameraKey, &kTiltKey})
        .parameters<robotcontrol::FixedStanceCameraPoseParameters>();

class MountedCameraPose final : public CameraPoseEstimator {
 public:
  explicit MountedCameraPose(robotlink::SolutionContext& context)
      : CameraPoseEstimator(context),
        parameters_(context.parameters<robotcontrol::MountedCameraPoseParameters>()),
        camera_(cameraOf(context.robot().description)) {}

 private:
  static robotlink::RobotDescription::Camera cameraOf(const robotlink::RobotDescription& description) {
    if (!description.camera)
      throw std::runtime_error("the robot's description has no camera at a fixed place");
    return *description.camera;
  }

  std::optional<CameraView> estimate(int width, int height) override {
    const Eigen::Matrix3d rotation = camera_.inRobot.rotation();
    robotlink::Vector3 position = camera_.inRobot.translation();
    if (parameters_.has_height()) position.z() = parameters_.height();
    // Rotation = Rz(pan) Ry(tilt) Rx(roll), with a tilt downward.
    const double pan = std::atan2(rotation(1, 0), rotation(0, 0));
    const double tilt = parameters_.has_tilt() ? parameters_.tilt() : std::asin(-rotation(2, 0));
    const double roll =
        parameters_.has_roll() ? parameters_.roll() : std::atan2(rotation(2, 1), rotation(2, 2));
    const robotlink::Pose3 camera = Eigen::Translation3d(position) *
                                    Eigen::AngleAxisd(pan, robotlink::Vector3::UnitZ()) *
                                    Eigen::AngleAxisd(tilt, robotlink::Vector3::UnitY()) *
                                    Eigen::AngleAxisd(roll, robotlink::Vector3::UnitX());
    const double horizontal =
        parameters_.has_horizontal_angle() ? parameters_.horizontal_angle() : camera_.horizontalAngle;
    const double vertical = 2 * std::atan(std::tan(horizontal / 2) * height / width);
    return CameraView::fromAngles(camera, horizontal, vertical, width, height);
  }

  const robotcontrol::MountedCameraPoseParameters& parameters_;
  const robotlink::RobotDescription::Camera camera_;
};

const robotlink::SolutionRegistration kMounted =
    robotlink::SolutionBuilder<MountedCameraPose>("camera-pose", "mounted",
                                                  "The fixed camera pose in the robot's description, as for "
                                                  "one on a tripod; height and angles can be tuned.")
        .source("A method of this project.")
        .needs(robotlink::kCameraImage)
        .yields(robotlink::kCameraPose)
        .keys({&kHorizonKey, &kViewKey, &kCameraKey})
        .parameters<robotcontrol::MountedCameraPoseParameters>();

class OracleCameraPose final : public CameraPoseEstimator {
 public:
  explicit OracleCameraPose(robotlink::SolutionContext& context)
      : CameraPoseEstimator(context), world_(context.input(robotlink::kOracleWorld)) {}

 private:
  std::optional<CameraView> estimate(int width, int height) override {
    if (!world_) return std::nullopt;
    if (!world_->has_camera()) {
      if (!std::exchange(saidWhy_, true))
        debug_.text(robotlink::Level::kWarning, "camera-pose",
                    "The ground truth has no camera, as in older logs: choose another solution.");
      return std::nullopt;
    }
    const robotcontrol::CameraPose& camera = world_->camera();
    return CameraView::fromAngles(robotlink::pose3(camera.camera_in_robot()), camera.horizontal_angle(),
                                  camera.vertical_angle(), width, height);
  }

  robotlink::Input<robotcontrol::OracleWorld> world_;
  bool saidWhy_ = false;
};

const robotlink::SolutionRegistration kOracle =
    robotlink::SolutionBuilder<OracleCameraPose>("camera-pose", "oracle",
                                                 "The camera's true position and angles, from the simulator.")
        .source("The simulator.")
        .needs(robotlink::kCameraImage)
        .needs(robotlink::kOracleWorld)
        .yields(robotlink::kCameraPose)
        .keys({&kHorizonKey, &kViewKey, &kCameraKey});

}  // namespace
}  // namespace modules
