// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/Ports.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "robotlink/base/Random.h"

namespace simcore {
namespace {

using SourceKind = SensorSource::Kind;

/// The random numbers of sensors that do not have those of their number.
constexpr std::uint64_t kNamedStream = 0x6E616D6564;

/// How the reading of a kind of sensor is described, and where it comes from.
struct Reading {
  SensorDescription::Kind kind;
  SourceKind source;
  const char* type;
  const char* unit;
  /// 1 for a scalar.
  std::size_t size;
};

constexpr Reading kReadings[] = {
    {SensorDescription::Kind::kDistance, SourceKind::kDistance, "distance", "m", 1},
    {SensorDescription::Kind::kAccelerometer, SourceKind::kAccelerometer, "acceleration", "m/s^2", 3},
    {SensorDescription::Kind::kGyroscope, SourceKind::kGyroscope, "angular_velocity", "rad/s", 3},
    {SensorDescription::Kind::kContact, SourceKind::kContact, "contact", "", 1},
    {SensorDescription::Kind::kSwitch, SourceKind::kContact, "contact", "", 1},
    {SensorDescription::Kind::kWhisker, SourceKind::kWhisker, "contact", "", 1},
    {SensorDescription::Kind::kMagnetometer, SourceKind::kMagnetometer, "magnetic_field", "T", 3},
    {SensorDescription::Kind::kNavSat, SourceKind::kNavSat, "position_velocity", "m, m/s", 6},
    {SensorDescription::Kind::kAltimeter, SourceKind::kAltimeter, "altitude", "m, m/s", 2},
    {SensorDescription::Kind::kForceTorque, SourceKind::kForceTorque, "force_torque", "N, N m", 6},
    {SensorDescription::Kind::kOdometry, SourceKind::kOdometry, "odometry", "m, m, rad", 3},
    {SensorDescription::Kind::kBattery, SourceKind::kBattery, "battery", "V, share", 2},
};

/// The dimensions of a command to a guide, and their units.
std::pair<int, const char*> commandOf(GuidedMotion::Kind kind) {
  switch (kind) {
    case GuidedMotion::Kind::kFree:
      return {6, "m/s, rad/s"};
    case GuidedMotion::Kind::kOmni:
    case GuidedMotion::Kind::kWalk:
      return {3, "m/s, m/s, rad/s"};
    case GuidedMotion::Kind::kDifferential:
    case GuidedMotion::Kind::kSkid:
      return {2, "m/s"};
    case GuidedMotion::Kind::kAckermann:
      return {2, "m/s, rad"};
  }
  return {};
}

/// Adds the ports of one model after the other, numbering bodies and hinges of moving ones as Physics does.
class Collector {
 public:
  explicit Collector(Ports& ports) : ports_(ports) {}

  void add(const ModelInstance& model, int index) {
    model_ = index;
    name_ = model.name;
    type_ = model.type.get();
    if (type_->isStatic) return addStatic(model);
    firstHinge_ = hinge_;
    firstMeasured_ = measured_;
    for (const JointDescription& joint : type_->joints) measured_ += joint.isMeasured ? 1 : 0;
    firstDoor_ = ports_.doors.size();
    servos_.assign(model.type->joints.size(), kNoServo);
    for (const JointDescription& joint : model.type->joints) {
      if (!joint.hasPosition()) continue;
      addAngle(joint);
      if (joint.speedSensor) addJointSensor(joint, SourceKind::kJointSpeed, *joint.speedSensor);
      if (joint.loadSensor) addJointSensor(joint, SourceKind::kJointLoad, *joint.loadSensor);
      if (joint.servo) servos_[indexOf(joint)] = ports_.servos.size();
      if (joint.servo) addServo(joint);
      if (joint.servo && joint.door) addDoor(joint);
      ++hinge_;
    }
    bodies_ = {static_cast<int>(body_) + 1, static_cast<int>(body_ + model.type->links.size()) + 1};
    for (const SensorDescription& sensor : model.type->sensors) addSensor(sensor);
    for (std::size_t i = firstDoor_; i < ports_.doors.size(); ++i) connect(ports_.doors[i]);
    if (model.type->drive) addDrive(*model.type->drive);
    if (model.type->vehicle) addWheels(*model.type->vehicle);
    if (model.type->guided) addGuide(*model.type->guided, model.follows());
    if (model.type->walk && model.follows()) addWalk(*model.type->walk);
    body_ += model.type->links.size();
  }

 private:
  /// Adds the sensors of a model that never moves, as far as they look around: those of the world, which is
  /// body 0.
  void addStatic(const ModelInstance& model) {
    bodies_ = {0, 0};
    for (SensorDescription sensor : type_->sensors) {
      if (!looksAround(sensor.kind)) continue;
      const LinkDescription& link = type_->links[static_cast<std::size_t>(sensor.link)];
      sensor.poseInLink = model.poseInWorld * link.poseInModel * sensor.poseInLink;
      sensor.link = 0;
      addSensor(sensor);
    }
  }

  PortInfo port(const std::string& path, const char* type, std::vector<int> shape, const char* unit) const {
    return {name_ + "/" + path, name_, type, std::move(shape), unit};
  }

  /// Sets the range of all numbers of a port, as far as there is one.
  static void limit(PortInfo& info, double minimum, double maximum) {
    if (!(minimum < maximum) || !std::isfinite(maximum - minimum)) return;
    info.minimum = minimum;
    info.maximum = maximum;
  }

  SensorSource source(SourceKind kind) const {
    SensorSource result;
    result.kind = kind;
    result.model = model_;
    return result;
  }

  /// Adds a sensor with its random numbers. Sensors of the first kinds count through the scene, as they
  /// always have.
  void add(PortInfo info, SensorSource from, std::vector<double> values) {
    from.size = values.size();
    if (from.kind <= SourceKind::kContact && from.collision >= 0) {
      from.stream = {0, numbered_++};
    } else {
      from.stream = {kNamedStream, hashOfPath(info.path)};
    }
    const bool isLimited = from.maximum < SensorDescription::kNoRange;
    if (isLimited && info.maximum <= info.minimum) limit(info, from.minimum, from.maximum);
    ports_.sensors.push_back({std::move(info), std::move(values)});
    ports_.sources.push_back(std::move(from));
  }

  void addAngle(const JointDescription& joint) {
    const bool slides = joint.slides();
    SensorSource from = source(slides ? SourceKind::kSlide : SourceKind::kAngle);
    from.hinge = hinge_;
    from.errors = joint.positionErrors;
    PortInfo info = port(joint.name + "/position", slides ? "position" : "angle", {}, slides ? "m" : "rad");
    const bool turnsFreely =
        !slides && joint.lower <= -JointDescription::kFullTurn && joint.upper >= JointDescription::kFullTurn;
    if (!turnsFreely) limit(info, joint.lower, joint.upper);
    add(std::move(info), from, {joint.initialAngle});
  }

  void addJointSensor(const JointDescription& joint, SourceKind kind, const SensorErrors& errors) {
    SensorSource from = source(kind);
    from.hinge = hinge_;
    from.errors = errors;
    struct Name {
      const char* path;
      const char* type;
      const char* unit;
    };
    constexpr Name kNames[][2] = {{{"/load", "torque", "N m"}, {"/load", "force", "N"}},
                                  {{"/speed", "angular_velocity", "rad/s"}, {"/speed", "velocity", "m/s"}}};
    const bool isSpeed = kind == SourceKind::kJointSpeed;
    const Name& name = kNames[isSpeed ? 1 : 0][joint.slides() ? 1 : 0];
    PortInfo info = port(joint.name + name.path, name.type, {}, name.unit);
    const double most = isSpeed ? joint.maximumSpeed : joint.maximumTorque;
    if (joint.servo) limit(info, -most, most);
    add(std::move(info), from, {0});
  }

  void addServo(const JointDescription& joint) {
    struct Command {
      const char* name;
      const char* type;
      const char* unit;
      double limit;
    };
    const Command turning[] = {{"/request", "angle", "rad", 0},
                               {"/speed_request", "angular_velocity", "rad/s", joint.maximumSpeed},
                               {"/torque_request", "torque", "N m", joint.maximumTorque}};
    const Command sliding[] = {{"/request", "position", "m", 0},
                               {"/speed_request", "velocity", "m/s", joint.maximumSpeed},
                               {"/force_request", "force", "N", joint.maximumTorque}};
    const Command& command =
        (joint.slides() ? sliding : turning)[static_cast<std::size_t>(joint.control.kind)];
    const bool isPosition = joint.control.kind == MotorControl::Kind::kPosition;
    Servo servo{port(joint.name + command.name, command.type, {}, command.unit),
                isPosition ? joint.lower : -command.limit,
                isPosition ? joint.upper : command.limit,
                joint.maximumSpeed,
                joint.maximumTorque,
                joint.control};
    servo.info.minimum = servo.minimum;
    servo.info.maximum = servo.maximum;
    ports_.servos.push_back(std::move(servo));
    ports_.servoStates.push_back({hinge_, isPosition ? joint.initialAngle : 0, 1});
    ports_.servoModels.push_back(model_);
    ports_.servoBodies.push_back(bodiesBelow(joint.child));
  }

  void addDoor(const JointDescription& joint) {
    Door door{port(joint.name + "/door", "door", {}, ""), *joint.door, ports_.servos.size() - 1};
    door.info.maximum = 1;
    ports_.doors.push_back(std::move(door));
  }

  /// Finds the sensor of a door among those of its model.
  void connect(Door& door) const {
    if (door.description.sensor.empty()) return;
    const std::string path = name_ + "/" + door.description.sensor;
    for (std::size_t i = 0; i < ports_.sensors.size(); ++i) {
      if (ports_.sensors[i].info.path != path) continue;
      door.sensor = {DoorSensor::Kind::kNumber, i, ports_.sources[i].kind != SourceKind::kDistance};
    }
    for (std::size_t i = 0; i < ports_.ranges.size(); ++i) {
      if (ports_.ranges[i].info.path == path) door.sensor = {DoorSensor::Kind::kRange, i, false};
    }
  }

  std::size_t indexOf(const JointDescription& joint) const {
    return static_cast<std::size_t>(&joint - type_->joints.data());
  }

  /// A link and all that are joined below it.
  std::vector<std::size_t> bodiesBelow(int link) const {
    std::vector<bool> below(type_->links.size(), false);
    below[static_cast<std::size_t>(link)] = true;
    // Joints of parents come before those of their children.
    for (const JointDescription& joint : type_->joints) {
      const bool carried = joint.parent >= 0 && below[static_cast<std::size_t>(joint.parent)];
      if (carried && !joint.closesCycle) below[static_cast<std::size_t>(joint.child)] = true;
    }
    std::vector<std::size_t> bodies;
    for (std::size_t i = 0; i < below.size(); ++i) {
      if (below[i]) bodies.push_back(body_ + i);
    }
    return bodies;
  }

  void addWheels(const VehicleDescription& vehicle) {
    firstWheel_ = wheel_;
    for (const VehicleWheel& wheel : vehicle.wheels) {
      const JointDescription& joint = type_->joints[static_cast<std::size_t>(wheel.joint)];
      SensorSource from = source(SourceKind::kWheelAngle);
      from.hinge = wheel_++;
      from.length = wheel.radius;
      from.errors = joint.positionErrors;
      add(port(joint.name + "/position", "angle", {}, "rad"), from, {0});
      if (!joint.speedSensor) continue;
      from.kind = SourceKind::kWheelSpeed;
      from.errors = *joint.speedSensor;
      add(port(joint.name + "/speed", "angular_velocity", {}, "rad/s"), from, {0});
    }
  }

  void addWalk(const WalkDescription& walk) {
    GuidedMotion motion;
    motion.kind = GuidedMotion::Kind::kWalk;
    motion.name = walk.name;
    motion.maximumSpeed = walk.maximumSpeed;
    motion.maximumRate = walk.maximumRate;
    addGuide(motion, true);
    ports_.guideMeans.back().walk = &walk;
  }

  GuideMeans meansOf(bool follows) const {
    GuideMeans means;
    means.firstWheel = firstWheel_;
    if (type_->vehicle) {
      means.kind = GuideMeans::Kind::kWheels;
      means.vehicle = &*type_->vehicle;
      for (const int joint : type_->vehicle->steering)
        means.steering.push_back(servos_[static_cast<std::size_t>(joint)]);
    }
    if (follows) means.kind = GuideMeans::Kind::kFollows;
    return means;
  }

  void addGuide(const GuidedMotion& motion, bool follows) {
    auto [size, unit] = commandOf(motion.kind);
    const bool byTorque = type_->vehicle && type_->vehicle->byTorque && !follows;
    if (byTorque) unit = size == 2 && motion.kind == GuidedMotion::Kind::kAckermann ? "N m, rad" : "N m";
    Guide guide{port(motion.name, "motion", {size}, unit), motion};
    ports_.guideMeans.push_back(meansOf(follows));
    const double largest = std::max(byTorque ? maximumTorque() : motion.maximumSpeed, turningLimit(motion));
    limit(guide.info, -largest, largest);
    ports_.guides.push_back(std::move(guide));
    ports_.guideModels.push_back(model_);
  }

  /// The torque of a wheel of the vehicle, N m.
  double maximumTorque() const {
    double largest = 0;
    for (const VehicleWheel& wheel : type_->vehicle->wheels)
      if (wheel.driven) largest = std::max(largest, wheel.maximumForce * wheel.radius);
    return largest;
  }

  /// The limit of what a command says of turning; 0 if it says speeds only.
  static double turningLimit(const GuidedMotion& motion) {
    using Kind = GuidedMotion::Kind;
    if (motion.kind == Kind::kAckermann) return motion.maximumSteering;
    return motion.kind == Kind::kDifferential || motion.kind == Kind::kSkid ? 0 : motion.maximumRate;
  }

  void addDrive(const DriveDescription& drive) {
    ports_.drives.push_back({port(drive.name, "wheel_speeds", {2}, "m/s"), drive.controller,
                             drive.wheelRadius, drive.track, drive.maximumSpeed});
    ports_.drives.back().info.minimum = -drive.maximumSpeed;
    ports_.drives.back().info.maximum = drive.maximumSpeed;
    ports_.driveModels.push_back(model_);
  }

  void addSensor(const SensorDescription& sensor) {
    switch (sensor.kind) {
      case SensorDescription::Kind::kCamera:
        return addCamera(sensor);
      case SensorDescription::Kind::kSonar:
        return addRange(sensor, RangeSensor::Kind::kSonar);
      case SensorDescription::Kind::kLaser:
        return addRange(sensor, RangeSensor::Kind::kLaser);
      case SensorDescription::Kind::kImage:
        return addImage(sensor);
      default:
        return addReading(sensor);
    }
  }

  void addReading(const SensorDescription& sensor) {
    const Reading& reading = *std::ranges::find(kReadings, sensor.kind, &Reading::kind);
    SensorSource from = source(reading.source);
    from.body = body_ + static_cast<std::size_t>(sensor.link);
    from.poseInLink = sensor.poseInLink;
    const bool isSwitch = sensor.kind == SensorDescription::Kind::kSwitch;
    from.collision = isSwitch ? -1 : sensor.collision;
    from.collisions = static_cast<int>(type_->links[static_cast<std::size_t>(sensor.link)].collisions.size());
    from.errors = sensor.errors;
    const bool isWhisker = sensor.kind == SensorDescription::Kind::kWhisker;
    from.length = isWhisker ? sensor.maximum : 0;
    from.minimum = isWhisker ? 0 : sensor.minimum;
    from.maximum = isWhisker ? 0 : sensor.maximum;
    from.battery = sensor.battery;
    from.sign = sensor.towardsParent ? -1 : 1;
    if (type_->drive) {
      from.drive = static_cast<int>(ports_.drives.size());
      from.track = type_->drive->track;
    }
    if (sensor.kind == SensorDescription::Kind::kForceTorque) {
      from.isFixed = type_->joints[static_cast<std::size_t>(sensor.joint)].isMeasured;
      from.hinge = from.isFixed ? measuredOf(sensor.joint) : hingeOf(sensor.joint);
    }
    const int size = static_cast<int>(reading.size);
    PortInfo info =
        port(sensor.name, reading.type, size > 1 ? std::vector{size} : std::vector<int>{}, reading.unit);
    if (info.type == "contact") limit(info, 0, 1);
    if (reading.source == SourceKind::kBattery) limit(info, 0, std::max(1.0, sensor.battery.fullVoltage));
    add(std::move(info), from, std::vector<double>(reading.size));
  }

  /// The number of a joint's hinge or slider.
  std::size_t hingeOf(int joint) const {
    std::size_t hinge = firstHinge_;
    for (int i = 0; i < joint; ++i) {
      const JointDescription& other = type_->joints[static_cast<std::size_t>(i)];
      if (other.hasPosition()) ++hinge;
    }
    return hinge;
  }

  /// The number of a fixed joint among those that are measured.
  std::size_t measuredOf(int joint) const {
    std::size_t number = firstMeasured_;
    for (int i = 0; i < joint; ++i) number += type_->joints[static_cast<std::size_t>(i)].isMeasured ? 1 : 0;
    return number;
  }

  void addImage(const SensorDescription& sensor) {
    constexpr const char* kTypes[] = {"depth", "labels", "radiation", "facettes"};
    ImageSensor image;
    image.geometry = sensor.image;
    const bool senses = !sensor.image.classes.empty();
    const int channels = senses ? static_cast<int>(sensor.image.classes.size()) : 1;
    const bool isDepth = sensor.image.kind == ImageGeometry::Kind::kDepth;
    image.info = port(sensor.name + (senses    ? "/image"
                                     : isDepth ? "/depth"
                                               : "/labels"),
                      kTypes[static_cast<std::size_t>(sensor.image.kind)],
                      {sensor.image.camera.height, sensor.image.camera.width, channels}, isDepth ? "m" : "");
    image.info.minimum = isDepth ? sensor.image.nearest : 0;
    image.info.maximum = isDepth ? sensor.image.farthest : 0;
    image.errors = sensor.errors;
    if (sensor.rate > 0) image.period = robotlink::fromSeconds(1 / sensor.rate);
    image.body = bodies_.first + sensor.link;
    image.sensorInBody = sensor.poseInLink;
    ports_.images.push_back(std::move(image));
    ports_.imageOwners.push_back(bodies_);
  }

  void addCamera(const SensorDescription& sensor) {
    CameraSensor camera;
    camera.info = port(sensor.name + "/image", "image", {sensor.height, sensor.width, 3}, "");
    camera.model = {sensor.width,         sensor.height,     sensor.horizontalAngle,
                    sensor.verticalAngle, sensor.vignetting, sensor.distortion};
    camera.body = bodies_.first + sensor.link;
    camera.cameraInBody = sensor.poseInLink;
    camera.period = robotlink::fromSeconds(1 / sensor.rate);
    camera.noise = sensor.errors.of(0).stddev;
    camera.shutter = sensor.shutter;
    camera.errors = sensor.errors;
    camera.info.maximum = 255;
    ports_.cameras.push_back(std::move(camera));
  }

  void addRange(const SensorDescription& sensor, RangeSensor::Kind kind) {
    const bool isLaser = kind == RangeSensor::Kind::kLaser;
    RangeSensor range;
    range.info =
        port(sensor.name, "range", isLaser ? std::vector{sensor.range.readings} : std::vector<int>{}, "m");
    range.kind = kind;
    range.minimum = sensor.minimum;
    range.maximum = sensor.maximum;
    range.errors = sensor.errors;
    range.info.minimum = sensor.minimum;
    range.info.maximum = sensor.maximum;
    range.readings = isLaser ? sensor.range.readings : 1;
    range.startAngle = sensor.range.startAngle;
    range.endAngle = sensor.range.endAngle;
    range.openingAngle = sensor.range.openingAngle;
    range.mostIncidence = sensor.range.mostIncidence;
    if (sensor.rate > 0) range.period = robotlink::fromSeconds(1 / sensor.rate);
    range.body = bodies_.first + sensor.link;
    range.sensorInBody = sensor.poseInLink;
    ports_.ranges.push_back(std::move(range));
    ports_.rangeOwners.push_back(bodies_);
  }

  Ports& ports_;
  // The bodies of the model; body 0 of a RenderScene is the world.
  RayCaster::BodyRange bodies_;
  std::string name_;
  const ModelDescription* type_ = nullptr;
  int model_ = 0;
  std::size_t body_ = 0, hinge_ = 0, firstHinge_ = 0, firstDoor_ = 0;
  // Fixed joints that are measured, in the numbering of Physics.
  std::size_t measured_ = 0, firstMeasured_ = 0;
  // Wheels of vehicles, in the numbering of Physics.
  std::size_t wheel_ = 0, firstWheel_ = 0;
  static constexpr std::size_t kNoServo = static_cast<std::size_t>(-1);
  /// Keyed by joint of the model: the index of its servo.
  std::vector<std::size_t> servos_;
  std::uint64_t numbered_ = 0;
};

}  // namespace

std::uint64_t hashOfPath(const std::string& path) {
  std::uint64_t hash = path.size();
  for (const char c : path) hash = robotlink::mixBits(hash ^ static_cast<std::uint8_t>(c));
  return hash;
}

Ports Ports::of(const WorldDescription& world) {
  Ports ports;
  Collector collector(ports);
  for (std::size_t i = 0; i < world.models.size(); ++i) collector.add(world.models[i], static_cast<int>(i));
  return ports;
}

}  // namespace simcore
