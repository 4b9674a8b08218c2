// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfUnsupported.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>
#include <vector>

#include "simcore/sdf/SdfPaths.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

/// When an element is not worth a report.
enum class Harmless : std::uint8_t {
  kNever,
  kAlways,
  kIfFalse,
  kIfTrue,
  kIfZero,
  /// If it says what it would be without the element.
  kIfUsual,
  /// If its attribute `enabled` is not true.
  kIfDisabled,
  /// If the material also has a <diffuse>, or if it lights a lamp whose light does not fade.
  kBesideDiffuse,
  kIfDirectional
};

struct Row {
  std::string_view name;
  /// The element that contains it; empty: any.
  std::string_view parent;
  const char* why;
  Harmless harmless = Harmless::kNever;
};

constexpr const char* kOtherSolver = "the solver's settings are the simulator's own";
constexpr const char* kNoSuchContact = "contacts only have Coulomb friction <mu> and restitution";
constexpr const char* kDiffuseOnly = "a surface has one color, its <diffuse>";
constexpr const char* kNoSky = "the background is one color";
constexpr const char* kNoAir = "there is no air";
constexpr const char* kNoNeed = "";
constexpr const char* kHardStops = "stops of joints are hard";
constexpr const char* kPlainImages = "images are those of a pinhole camera with its <distortion>";
constexpr const char* kQuadraticOnly = "light fades with <quadratic> only";

constexpr Row kRows[] = {
    {"plugin", "", "plugins of other simulators are not run"},
    {"physics", "world", kOtherSolver},
    {"physics", "joint", kOtherSolver},
    {"gui", "", kNoNeed, Harmless::kAlways},
    {"state", "world", kNoNeed, Harmless::kAlways},
    {"spherical_coordinates", "world", "the world has no geographic position"},
    {"atmosphere", "world", kNoAir},
    {"wind", "", kNoAir, Harmless::kIfZero},
    {"enable_wind", "", kNoAir, Harmless::kIfFalse},
    {"audio", "", "there is no sound"},
    {"audio_source", "", "there is no sound"},
    {"audio_sink", "", "there is no sound"},
    {"actor", "world", "there are no animated figures"},
    {"road", "world", "roads are not drawn"},
    {"population", "world", "populations are not supported"},
    {"shadows", "scene", "lamps have shadows", Harmless::kIfTrue},
    {"grid", "scene", kNoNeed, Harmless::kAlways},
    {"origin_visual", "scene", kNoNeed, Harmless::kAlways},
    {"sky", "scene", kNoSky},
    {"fog", "scene", kNoAir},
    {"self_collide", "", "solids of one model do not touch each other", Harmless::kIfFalse},
    {"allow_auto_disable", "model", kNoNeed, Harmless::kAlways},
    {"must_be_base_link", "", kNoNeed, Harmless::kAlways},
    {"kinematic", "link", "links are moved by forces", Harmless::kIfFalse},
    {"gripper", "model", "grippers are only links and joints"},
    {"projector", "link", "there are no projectors"},
    {"battery", "link", "batteries do not run down"},
    {"particle_emitter", "", "there is no smoke"},
    {"light", "link", "only the world has lights"},
    {"light", "model", "only the world has lights"},
    {"max_contacts", "collision", "the number of contact points is not limited", Harmless::kIfUsual},
    {"laser_retro", "", "lasers only measure distances", Harmless::kIfZero},
    {"mu2", "ode", kNoSuchContact},
    {"fdir1", "ode", kNoSuchContact, Harmless::kIfZero},
    {"slip1", "ode", kNoSuchContact, Harmless::kIfZero},
    {"slip2", "ode", kNoSuchContact, Harmless::kIfZero},
    {"torsional", "friction", kNoSuchContact},
    {"bullet", "", "friction is that of <ode>"},
    {"threshold", "bounce", "surfaces bounce from 5 cm/s on"},
    {"contact", "surface", "contacts have the stiffness of the solver (kp, kd, max_vel, min_depth, ...)"},
    {"soft_contact", "surface", "bodies are rigid"},
    {"script", "material", "material scripts are not read: the color is lost"},
    {"shader", "material", kDiffuseOnly},
    {"pbr", "material", "textures are not drawn"},
    {"specular", "material", kNoNeed, Harmless::kAlways},
    {"ambient", "material", kDiffuseOnly, Harmless::kBesideDiffuse},
    {"shininess", "material", kNoNeed, Harmless::kAlways},
    {"emissive", "material", kDiffuseOnly, Harmless::kIfZero},
    {"double_sided", "material", kNoNeed, Harmless::kAlways},
    {"render_order", "material", kNoNeed, Harmless::kAlways},
    {"lighting", "material", kDiffuseOnly, Harmless::kIfTrue},
    {"transparency", "visual", "everything is opaque", Harmless::kIfZero},
    {"visibility_flags", "visual", "every camera sees everything"},
    {"meta", "visual", kNoNeed, Harmless::kAlways},
    {"spring_stiffness", "dynamics", "joints have no springs", Harmless::kIfZero},
    {"spring_reference", "dynamics", kNoNeed, Harmless::kAlways},
    {"stiffness", "limit", kHardStops, Harmless::kIfUsual},
    {"dissipation", "limit", kHardStops, Harmless::kIfUsual},
    {"mimic", "axis", "the joint turns independently"},
    {"mimic", "axis2", "the joint turns independently"},
    {"fluid_added_mass", "inertial", "there is no water"},
    {"density", "inertial", "masses are those of <mass>"},
    {"auto_inertia_params", "", "masses are those of <mass>"},
    {"specular", "light", kNoNeed, Harmless::kAlways},
    {"visualize", "light", kNoNeed, Harmless::kAlways},
    {"cast_shadows", "light", "all lights have shadows", Harmless::kIfTrue},
    {"attenuation", "light", kNoNeed, Harmless::kIfDirectional},
    {"range", "attenuation", kQuadraticOnly, Harmless::kIfUsual},
    {"linear", "attenuation", kQuadraticOnly, Harmless::kIfUsual},
    {"constant", "attenuation", kQuadraticOnly, Harmless::kIfUsual},
    {"falloff", "spot", "the light falls off with the cosine between the two angles", Harmless::kIfUsual},
    {"lens", "camera", kPlainImages},
    {"format", "image", "images have their brightness and colors", Harmless::kIfUsual},
    {"save", "camera", "images are not saved; recordings have them", Harmless::kIfDisabled},
    {"visibility_mask", "camera", "every camera sees everything", Harmless::kIfUsual},
    {"resolution", "range", "distances are not rounded; use <robotcontrol:precision>", Harmless::kIfUsual},
    {"orientation_reference_frame", "imu", "orientations are not measured"},
    {"enable_orientation", "imu", kNoNeed, Harmless::kAlways},
    {"visualize", "sensor", kNoNeed, Harmless::kAlways},
    {"topic", "sensor", "streams have the names of their sensors", Harmless::kAlways},
    {"always_on", "sensor", kNoNeed, Harmless::kAlways},
    {"topic", "contact", kNoNeed, Harmless::kAlways},
    {"enable_metrics", "sensor", kNoNeed, Harmless::kAlways},
};

/// The children of an element that are read, or are reported as a part of it.
struct ReadRow {
  std::string_view parent, children;
};

constexpr std::string_view kScans = "samples min_angle max_angle noise";
constexpr std::string_view kSensing = "horizontal vertical";

constexpr ReadRow kRead[] = {
    {"sdf", "world model light"},
    {"world", "include gravity magnetic_field scene light frame model"},
    {"scene", "ambient background"},
    {"include", "uri name static pose placement_frame"},
    {"model", "static frame pose link joint include model"},
    {"frame", "pose"},
    {"link", "gravity velocity_decay pose inertial collision visual sensor"},
    {"velocity_decay", "linear angular"},
    {"inertial", "mass pose inertia"},
    {"inertia", "ixx ixy ixz iyy iyz izz"},
    {"collision", "pose geometry surface"},
    {"visual", "cast_shadows pose material geometry"},
    {"surface", "bounce friction"},
    {"bounce", "restitution_coefficient"},
    {"friction", "ode"},
    {"ode", "mu"},
    {"material", "diffuse"},
    {"geometry", "empty box capsule cylinder ellipsoid heightmap image mesh plane polyline sphere cone"},
    {"box", "size"},
    {"capsule", "radius length"},
    {"cylinder", "radius length"},
    {"ellipsoid", "radii"},
    {"sphere", "radius"},
    {"mesh", "uri submesh scale"},
    {"submesh", "name center"},
    {"plane", "normal size"},
    {"polyline", "point height"},
    {"heightmap", "uri size pos texture blend use_terrain_paging sampling"},
    {"texture", "size diffuse normal"},
    {"blend", "min_height fade_dist"},
    {"joint", "parent child axis axis2 pose sensor gearbox_ratio gearbox_reference_body thread_pitch"},
    {"axis", "xyz dynamics limit"},
    {"axis2", "xyz dynamics limit"},
    {"dynamics", "damping friction"},
    {"limit", "lower upper effort velocity"},
    {"sensor",
     "pose update_rate altimeter camera contact force_torque gps navsat imu lidar ray magnetometer sonar"},
    {"camera", "horizontal_fov image clip depth_camera noise distortion"},
    // <image> of a camera, and <image> of a geometry (heightmap).
    {"image", "width height uri scale threshold granularity"},
    {"clip", "near far"},
    {"depth_camera", "clip"},
    {"distortion", "k1 k2 k3 p1 p2 center"},
    {"noise",
     "type mean stddev bias_mean bias_stddev dynamic_bias_stddev dynamic_bias_correlation_time precision"},
    {"imu", "angular_velocity linear_acceleration"},
    {"angular_velocity", "x y z"},
    {"linear_acceleration", "x y z"},
    {"force_torque", "frame measure_direction force torque"},
    {"force", "x y z"},
    {"torque", "x y z"},
    {"magnetometer", "x y z"},
    {"x", "noise"},
    {"y", "noise"},
    {"z", "noise"},
    {"lidar", "scan range noise"},
    {"ray", "scan range noise"},
    {"scan", kSensing},
    {"horizontal", kScans},
    // More than one sample is reported.
    {"vertical", "samples resolution min_angle max_angle noise"},
    {"range", "min max"},
    {"sonar", "geometry min max radius"},
    {"contact", "collision"},
    {"altimeter", "vertical_position vertical_velocity"},
    {"vertical_position", "noise"},
    {"vertical_velocity", "noise"},
    {"gps", "position_sensing velocity_sensing"},
    {"navsat", "position_sensing velocity_sensing"},
    {"position_sensing", kSensing},
    {"velocity_sensing", kSensing},
    {"light", "intensity diffuse attenuation direction spot pose"},
    {"attenuation", "quadratic"},
    {"spot", "inner_angle outer_angle"},
};

constexpr std::string_view kSensors[] = {
    "camera",       "depth_camera", "depth",        "rgbd_camera", "rgbd",    "segmentation_camera",
    "segmentation", "lidar",        "gpu_lidar",    "ray",         "gpu_ray", "sonar",
    "imu",          "contact",      "magnetometer", "navsat",      "gps",     "altimeter",
    "force_torque", "custom"};

bool isWordOf(std::string_view word, std::string_view words) {
  for (std::size_t at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const std::size_t end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

std::string_view parentName(const XMLElement& element) {
  const auto* parent = element.Parent() != nullptr ? element.Parent()->ToElement() : nullptr;
  return parent != nullptr ? parent->Name() : "";
}

bool allZero(const std::string& text) {
  const char* at = text.c_str();
  for (char* end = nullptr; *at != '\0'; at = end) {
    if (std::strtod(at, &end) != 0) return false;
    if (end == at) return false;
  }
  return true;
}

bool hasAttribute(const XMLElement& element, const char* name, std::string_view value) {
  return element.Attribute(name) != nullptr && value == element.Attribute(name);
}

bool isHarmless(const XMLElement& element, Harmless when, bool isUsual) {
  const std::string text = trimmedText(&element);
  switch (when) {
    case Harmless::kNever:
      return false;
    case Harmless::kAlways:
      return true;
    case Harmless::kIfFalse:
      return !isTrue(text);
    case Harmless::kIfTrue:
      return text.empty() || isTrue(text);
    case Harmless::kIfZero:
      return element.FirstChildElement() == nullptr && allZero(text);
    case Harmless::kIfUsual:
      return isUsual;
    case Harmless::kIfDisabled:
      return element.Attribute("enabled") == nullptr || !isTrue(element.Attribute("enabled"));
    case Harmless::kBesideDiffuse:
      return allZero(text) || element.Parent()->FirstChildElement("diffuse") != nullptr;
    case Harmless::kIfDirectional:
      return hasAttribute(*element.Parent()->ToElement(), "type", "directional");
  }
  return false;
}

}  // namespace

Unsupported unsupported(const XMLElement& element, bool isUsual) {
  const std::string_view name = element.Name(), above = parentName(element);
  const auto* found = std::ranges::find_if(
      kRows, [&](const Row& row) { return row.name == name && (row.parent.empty() || row.parent == above); });
  if (found == std::end(kRows)) return {};
  const bool harmless = isHarmless(element, found->harmless, isUsual);
  // The element is read for lights with attenuation.
  if (found->harmless == Harmless::kIfDirectional && !harmless) return {};
  return {harmless ? nullptr : found->why, true};
}

bool isRead(const XMLElement& element) {
  const std::string_view name = element.Name(), above = parentName(element);
  return std::ranges::any_of(
      kRead, [&](const ReadRow& row) { return row.parent == above && isWordOf(name, row.children); });
}

bool isKnownSensor(std::string_view type) {
  return std::ranges::find(kSensors, type) != std::end(kSensors);
}

std::vector<std::string> knownSensors() {
  return {std::begin(kSensors), std::end(kSensors)};
}

}  // namespace simcore
