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

/// One of our own elements, as SCENES.md describes it. `attributes` are names, separated by blanks.
struct OwnElementHelp {
  const char* parent;
  const char* name;
  const char* type;
  const char* attributes;
  bool repeated;
  const char* help;
};

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
    {"include", "robotcontrol:team", "string", "", false,
     "The palette's color for the color team in this robot."},
    {"visual", "robotcontrol:color", "string", "", false, "A color of the palette, or team."},
    {"joint", "robotcontrol:servo", "", "", false,
     "The joint is driven: it turns to a requested angle with the limit's velocity and effort."},
    {"robotcontrol:servo", "robotcontrol:initial_position", "double", "", false,
     "The angle at the start, rad."},
    {"robotcontrol:servo", "robotcontrol:position_noise", "double", "", false,
     "Standard deviation of the measured angle, rad."},
    {"camera", "robotcontrol:vertical_fov", "double", "", false,
     "Vertical opening angle, rad; without it pixels are square."},
    {"camera", "robotcontrol:vignetting", "double", "", false,
     "Share of light missing in the image's corners, 0 to 1."},
    {"camera", "robotcontrol:vignetting_tint", "double", "", false,
     "Further share of red and green missing in the corners, 0 to 1."},
    {"sensor", "robotcontrol:range", "double", "", false,
     "The largest acceleration (m/s^2) or rotation (rad/s) that it measures on an axis."},
    {"sensor", "robotcontrol:noise", "double", "", false, "Standard deviation of a sonar's distance, m."},
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
    // What is in itself, such as a model in a model, is described where it is outermost.
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
    if (path.back() == own.parent) all.push_back(helpOf(own));
  }
  return all;
}

std::optional<SdfElementHelp> SdfGlossary::element(const Path& path) const {
  if (path.empty()) return std::nullopt;
  const sdf::ElementPtr root = spec_.description().text->Root();
  if (const sdf::ElementPtr description = descriptionOf(path, root)) return helpOf(description);
  for (const OwnElementHelp& own : kOwnElementHelp) {
    if (path.size() > 1 && path.back() == own.name && path[path.size() - 2] == own.parent) return helpOf(own);
  }
  return std::nullopt;
}

}  // namespace simcore
