// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfGlossary.h"

#include <algorithm>
#include <sdf/Param.hh>
#include <sstream>
#include <string_view>

#include "simcore/sdf/SdfDescription.h"
#include "simcore/sdf/SdfSpec.h"

namespace simcore {
namespace {

/// The help for one of our own elements, as in SCENES.md. `attributes` are names, separated by blanks.
struct OwnElementHelp {
  const char* parent;
  const char* name;
  const char* type;
  const char* attributes;
  bool repeated;
  const char* help;
};

/// In place of a parent: sensors, also those of joints, whose errors are described.
constexpr char kErrors[] = "errors";

bool isIn(const OwnElementHelp& own, const std::string& parent) {
  const std::string_view place = own.parent;
  if (place != kErrors) return place == parent;
  return parent == "sensor" || parent == "robotcontrol:speed_sensor" ||
         parent == "robotcontrol:load_sensor" || parent == "robotcontrol:position_sensor";
}

constexpr OwnElementHelp kOwnElementHelp[] = {
    {"world", "robotcontrol:palette", "", "", false, "Named colors for all files of the scene."},
    {"model", "robotcontrol:palette", "", "", false, "Named colors for all files of the scene."},
    {"robotcontrol:palette", "robotcontrol:color", "string", "name", true,
     "A color of the palette: red, green and blue, 0 to 255."},
    {"world", "robotcontrol:controller", "", "name as", true,
     "A controller of this name: called before each step, it reads sensors, sets actuators and adds views. "
     "Its outputs are called by 'as', if that is given."},
    {"model", "robotcontrol:controller", "", "name as", true,
     "A controller of this name: called before each step, it reads sensors, sets actuators and adds views. "
     "Its outputs are called by 'as', if that is given."},
    {"robotcontrol:controller", "robotcontrol:parameter", "string", "name", true,
     "A parameter of the controller: a number, a text, a model, or the path of a port."},
    {"model", "robotcontrol:robot", "string", "", false,
     "The model is a robot, described in resources/robots/NAME.yaml."},
    {"model", "robotcontrol:ball", "bool", "", false,
     "The model is the ball: its touches are counted, and users may move it."},
    {"model", "robotcontrol:field", "string", "", false,
     "The model is the field that resources/fields/NAME.yaml describes."},
    {"model", "robotcontrol:home", "string", "team", true,
     "Where added robots of the team are placed first: x, y (m) and heading (rad) in the model."},
    {"model", "robotcontrol:drive", "", "name controller", false,
     "Wheels on two sides that motors turn. The controller is arcos (a Pioneer's) or none."},
    {"robotcontrol:drive", "robotcontrol:left", "string", "", true, "The joint of a wheel on the left."},
    {"robotcontrol:drive", "robotcontrol:right", "string", "", true, "The joint of a wheel on the right."},
    {"robotcontrol:drive", "robotcontrol:track", "double", "", false,
     "Effective track, m: on firm ground the robot turns by (right - left) / track."},
    {"robotcontrol:drive", "robotcontrol:idle_torque", "double", "", false,
     "The torque by which each wheel resists without power, N m."},
    {"model", "robotcontrol:vehicle", "", "kind name control", false,
     "Wheels that roll by forces. The kind is differential, skid, omni or ackermann."},
    {"robotcontrol:vehicle", "robotcontrol:wheel", "string", "rollers", true,
     "The joint of a driven wheel; rollers is the angle in which those of its rim push, rad."},
    {"robotcontrol:vehicle", "robotcontrol:free_wheel", "string", "rollers", true,
     "The joint of a wheel without a motor."},
    {"robotcontrol:vehicle", "robotcontrol:steer", "string", "", true,
     "The joint that steers a wheel; it has a position servo."},
    {"model", "robotcontrol:motion", "string", "objects", false,
     "physics, or kinematic: moved without forces. objects is push or stop: what it does to what is in its "
     "way."},
    {"include", "robotcontrol:motion", "string", "objects", false,
     "physics, or kinematic: moved without forces. objects is push or stop: what it does to what is in its "
     "way."},
    {"model", "robotcontrol:walk", "", "name", false,
     "How a gait executes requests, for scenes that move the robot without forces."},
    {"robotcontrol:walk", "robotcontrol:slip", "vector3", "", false,
     "Ahead, sideways, turning: the fraction of the requested motion that it really makes."},
    {"robotcontrol:walk", "robotcontrol:noise", "vector3", "", false,
     "Ahead, sideways, turning: the standard deviation after 1 m or 1 rad."},
    {"robotcontrol:walk", "robotcontrol:maximum_speed", "double", "", false,
     "m/s, also of what is requested."},
    {"robotcontrol:walk", "robotcontrol:maximum_rate", "double", "", false, "rad/s."},
    {"robotcontrol:vehicle", "robotcontrol:acceleration", "double", "", false,
     "m/s^2, of the whole vehicle."},
    {"robotcontrol:vehicle", "robotcontrol:angular_acceleration", "double", "", false, "rad/s^2."},
    {"robotcontrol:vehicle", "robotcontrol:track", "double", "", false,
     "m, the effective track with which turns are computed; without it that of the wheels."},
    {"robotcontrol:vehicle", "robotcontrol:idle_torque", "double", "", false,
     "The resisting torque of a wheel without a motor, N m."},
    {"include", "robotcontrol:team", "string", "", false,
     "The palette's color for the color team in this robot."},
    {"include", "robotcontrol:role", "string", "", false,
     "The robot's role in its team from the start: goalie. Without it the team decides."},
    {"world", "robotcontrol:game", "string", "", false,
     "A game is played by the rules that resources/games/NAME.yaml describes."},
    {"model", "robotcontrol:layout", "string", "", false,
     "The process layout of this robot's program: a shipped one's name, or a .yaml file beside this one."},
    {"include", "robotcontrol:layout", "string", "", false,
     "The process layout of this robot's program: a shipped one's name, or a .yaml file beside this one."},
    {"visual", "robotcontrol:color", "string", "", false, "A color of the palette, or team."},
    {"joint", "robotcontrol:servo", "", "", false,
     "The joint is driven: it turns to a requested angle with the limit's velocity and effort."},
    {"robotcontrol:servo", "robotcontrol:initial_position", "double", "", false,
     "The angle at the start, rad; of a prismatic joint the position, m."},
    {"robotcontrol:servo", "robotcontrol:position_noise", "double", "", false,
     "Standard deviation of the measured angle, rad or m."},
    {"robotcontrol:servo", "robotcontrol:control", "string", "", false,
     "What its command is: position, velocity or torque (of a prismatic joint the force)."},
    {"robotcontrol:servo", "robotcontrol:p", "double", "", false, "Gain of a position servo, N m per rad."},
    {"robotcontrol:servo", "robotcontrol:i", "double", "", false, "Gain of a position servo, N m per rad s."},
    {"robotcontrol:servo", "robotcontrol:d", "double", "", false, "Gain of a position servo, N m per rad/s."},
    {"robotcontrol:servo", "robotcontrol:delay", "double", "", false,
     "Delay until a command takes effect, s, 0 to 1."},
    {"joint", "robotcontrol:position_sensor", "", "", false,
     "Noise and timing of the sensor of the joint's angle."},
    {"joint", "robotcontrol:speed_sensor", "", "", false, "A sensor of the joint's speed, rad/s or m/s."},
    {"joint", "robotcontrol:load_sensor", "", "", false,
     "A sensor of the torque that turns the joint, N m, or of the force, N."},
    {"joint", "robotcontrol:door", "", "sensor", false,
     "The joint is a door, moved by its position servo. The sensor, a lidar, sonar, contact, switch or "
     "whisker of "
     "the same model, opens it; without one only commands do."},
    {"robotcontrol:door", "robotcontrol:below", "double", "", false,
     "It opens while the distance sensor reads less than this, m; required with such a sensor."},
    {"robotcontrol:door", "robotcontrol:open", "double", "", false,
     "The position of the joint when it is open, rad or m; required."},
    {"robotcontrol:door", "robotcontrol:closed", "double", "", false,
     "The position of the joint when it is closed, rad or m; default: the initial one."},
    {"robotcontrol:door", "robotcontrol:seconds", "double", "", false,
     "How long it stays open after the last reason to be open, s, 0 to 3600; default 3."},
    {"model", "robotcontrol:guided", "", "kind name", false,
     "The model moves as it is commanded. Kinds: free, omni, differential, skid, ackermann, walk."},
    {"robotcontrol:guided", "robotcontrol:maximum_speed", "double", "", false, "m/s."},
    {"robotcontrol:guided", "robotcontrol:maximum_rate", "double", "", false, "rad/s."},
    {"robotcontrol:guided", "robotcontrol:acceleration", "double", "", false, "m/s^2."},
    {"robotcontrol:guided", "robotcontrol:angular_acceleration", "double", "", false, "rad/s^2."},
    {"robotcontrol:guided", "robotcontrol:track", "double", "", false,
     "The distance between the wheels, for the kinds differential and skid, m."},
    {"robotcontrol:guided", "robotcontrol:skid", "double", "", false,
     "For the kind skid: the fraction of the turn that it really makes, 0 to 1."},
    {"robotcontrol:guided", "robotcontrol:wheelbase", "double", "", false,
     "The distance between the axles, for the kind ackermann, m."},
    {"robotcontrol:guided", "robotcontrol:maximum_steering", "double", "", false,
     "The largest steering angle, for the kind ackermann, rad."},
    {"world", "robotcontrol:sleeping", "bool", "", false,
     "Whether resting bodies are computed only when something touches or moves them; default: true."},
    {"world", "robotcontrol:radiation", "", "name", true, "A radiation class with its ambient intensity."},
    {"robotcontrol:radiation", "robotcontrol:ambient", "double", "", false,
     "The ambient intensity of the class."},
    {"visual", "robotcontrol:surface", "", "class", true, "What the surface does with a radiation class."},
    {"robotcontrol:surface", "robotcontrol:reflects", "double", "", false,
     "The share of the radiation that it reflects."},
    {"robotcontrol:surface", "robotcontrol:emits", "double", "", false, "The intensity that it emits."},
    {"link", "robotcontrol:emitter", "", "", true, "A point that emits radiation classes."},
    {"robotcontrol:emitter", "robotcontrol:position", "string", "", false,
     "Where it is in the link: x y z, m."},
    {"robotcontrol:emitter", "robotcontrol:attenuation", "double", "", false, "Per square meter."},
    {"robotcontrol:emitter", "robotcontrol:intensity", "double", "class", true,
     "The intensity that it emits of a class."},
    {"light", "robotcontrol:intensity", "double", "class", true,
     "The intensity that the light emits of a class."},
    {"camera", "robotcontrol:exposure", "double", "", false, "How long each row is exposed, s, up to 0.1."},
    {"camera", "robotcontrol:readout", "double", "", false,
     "The time between the first and the last row of a rolling shutter, s, up to 0.1."},
    {"camera", "robotcontrol:class", "string", "", true,
     "A radiation class that the camera senses: one channel each."},
    {kErrors, "robotcontrol:noise", "double", "", false,
     "Standard deviation of the noise of all channels, in the unit of the readings."},
    {kErrors, "robotcontrol:mean", "double", "", false, "The mean of the noise."},
    {kErrors, "robotcontrol:bias_mean", "double", "", false, "The mean of a bias that stays for a run."},
    {kErrors, "robotcontrol:bias_stddev", "double", "", false, "Its standard deviation over runs."},
    {kErrors, "robotcontrol:drift_stddev", "double", "", false, "Standard deviation of a bias that drifts."},
    {kErrors, "robotcontrol:drift_time", "double", "", false, "How long a drift is remembered, s."},
    {kErrors, "robotcontrol:precision", "double", "", false, "Readings are rounded to multiples of this."},
    {kErrors, "robotcontrol:delay", "double", "", false, "Seconds until a sample can be read, 0 to 1."},
    {kErrors, "robotcontrol:rate", "double", "", false, "Samples per second; 0: one in each step."},
    {kErrors, "robotcontrol:dropout", "double", "", false, "Share of samples that are lost, 0 to 1."},
    {"sensor", "robotcontrol:whisker", "double", "", false,
     "It is a whisker of this length, m, along x: 1 if it touches something, otherwise 0."},
    {"sensor", "robotcontrol:switch", "", "", false,
     "It is 1 if any collision of the link touches something."},
    {"sensor", "robotcontrol:odometry", "", "", false, "It measures x, y and heading since the start."},
    {"sensor", "robotcontrol:battery", "", "", false, "It measures voltage and charge of a battery."},
    {"robotcontrol:battery", "robotcontrol:capacity", "double", "", false, "J."},
    {"robotcontrol:battery", "robotcontrol:charge", "double", "", false, "The share at the start, 0 to 1."},
    {"robotcontrol:battery", "robotcontrol:full_voltage", "double", "", false, "V."},
    {"robotcontrol:battery", "robotcontrol:empty_voltage", "double", "", false, "V."},
    {"robotcontrol:battery", "robotcontrol:idle_power", "double", "", false, "W."},
    {"robotcontrol:battery", "robotcontrol:efficiency", "double", "", false, "Of the motors, 0 to 1."},
    {"sensor", "robotcontrol:facette", "", "", false, "It is a spherical camera with few directions."},
    {"robotcontrol:facette", "robotcontrol:azimuth", "string", "", false,
     "First angle, last angle, number; rad."},
    {"robotcontrol:facette", "robotcontrol:elevation", "string", "", false,
     "First angle, last angle, number; rad."},
    {"robotcontrol:facette", "robotcontrol:far", "double", "", false, "How far it sees, m."},
    {"robotcontrol:facette", "robotcontrol:class", "string", "", true,
     "A radiation class that it senses; without any it has Y, Cb and Cr."},
    {"camera", "robotcontrol:vertical_fov", "double", "", false,
     "Vertical opening angle, rad; without it pixels are square."},
    {"camera", "robotcontrol:vignetting", "double", "", false,
     "Share of light missing in the image's corners, 0 to 1."},
    {"camera", "robotcontrol:vignetting_tint", "double", "", false,
     "Further share of red and green missing in the corners, 0 to 1."},
    {"sensor", "robotcontrol:range", "double", "", false,
     "The largest acceleration (m/s^2) or rotation (rad/s) that it measures on an axis."},
    {"sensor", "robotcontrol:most_incidence", "double", "", false,
     "Angle to a surface's normal beyond which the sound of a sonar is reflected away, rad."},
};

/// A text of the definition, with its line breaks and indentation made blanks.
std::string inOneLine(const std::string& text) {
  std::istringstream stream(text);
  std::string result;
  for (std::string word; stream >> word;) result += (result.empty() ? "" : " ") + word;
  return result;
}

SdfElementHelp helpOf(const sdf::ElementPtr& description) {
  SdfElementHelp help;
  help.name = description->GetName();
  help.help = inOneLine(description->GetDescription());
  help.required = description->GetRequired() == "1" || description->GetRequired() == "+";
  help.repeated = description->GetRequired() == "*" || description->GetRequired() == "+";
  if (const sdf::ParamPtr value = description->GetValue()) {
    help.type = value->GetTypeName();
    help.initial = value->GetDefaultAsString();
  }
  for (const sdf::ParamPtr& one : description->GetAttributes()) {
    help.attributes.push_back({one->GetKey(), one->GetTypeName(), one->GetDefaultAsString(),
                               inOneLine(one->GetDescription()), one->GetRequired()});
  }
  return help;
}

SdfElementHelp helpOf(const OwnElementHelp& own) {
  SdfElementHelp help;
  help.name = own.name;
  help.type = own.type;
  help.help = own.help;
  help.repeated = own.repeated;
  std::istringstream stream(own.attributes);
  for (std::string word; stream >> word;) help.attributes.push_back({word, "string", "", "", false});
  return help;
}

/// The description of the last element of a path; null if there is none, or if it is one of our own.
sdf::ElementPtr descriptionOf(const SdfGlossary::Path& path, const sdf::ElementPtr& root) {
  if (path.empty() || path.front() != root->GetName()) return nullptr;
  std::vector<sdf::ElementPtr> walked{root};
  for (auto name = path.begin() + 1; name != path.end(); ++name) {
    if (!walked.back()->HasElementDescription(*name)) return nullptr;
    sdf::ElementPtr next = walked.back()->GetElementDescription(*name);
    // An element that contains itself, such as a model in a model, is described where it is outermost.
    if (!next->ReferenceSDF().empty() && next->GetElementDescriptionCount() == 0) {
      const auto outer =
          std::ranges::find(walked, *name, [](const sdf::ElementPtr& one) { return one->GetName(); });
      if (outer != walked.end())
        next = *outer;
      else if (root->HasElementDescription(*name))
        next = root->GetElementDescription(*name);
    }
    walked.push_back(std::move(next));
  }
  return walked.back();
}

}  // namespace

std::optional<SdfElementHelp> ownSdfElement(const std::string& name, const std::string& parent) {
  const auto* own = std::ranges::find_if(
      kOwnElementHelp, [&](const OwnElementHelp& one) { return name == one.name && isIn(one, parent); });
  return own != std::end(kOwnElementHelp) ? std::optional(helpOf(*own)) : std::nullopt;
}

SdfGlossary::SdfGlossary() : spec_(SdfSpec::shared()) {}
SdfGlossary::~SdfGlossary() = default;

std::vector<SdfElementHelp> SdfGlossary::children(const Path& path) const {
  const sdf::ElementPtr root = spec_.description().text->Root();
  std::vector<SdfElementHelp> all;
  if (path.empty()) {
    all.push_back(helpOf(root));
    return all;
  }
  if (const sdf::ElementPtr description = descriptionOf(path, root)) {
    for (unsigned i = 0; i < description->GetElementDescriptionCount(); ++i)
      all.push_back(helpOf(description->GetElementDescription(i)));
  }
  for (const OwnElementHelp& own : kOwnElementHelp) {
    if (isIn(own, path.back())) all.push_back(helpOf(own));
  }
  return all;
}

std::optional<SdfElementHelp> SdfGlossary::element(const Path& path) const {
  if (path.empty()) return std::nullopt;
  const sdf::ElementPtr root = spec_.description().text->Root();
  if (const sdf::ElementPtr description = descriptionOf(path, root)) return helpOf(description);
  return path.size() > 1 ? ownSdfElement(path.back(), path[path.size() - 2]) : std::nullopt;
}

}  // namespace simcore
