// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfOwnElements.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>

#include "robotlink/base/Spelling.h"
#include "simcore/sdf/SdfGlossary.h"
#include "simcore/sdf/SdfPaths.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

constexpr std::string_view kOwnUri = "urn:robotcontrol:sdf";

/// One of our own elements: where it is allowed, how many numbers it contains (0: text or elements), and
/// whether what it is in has no meaning without its value.
struct OwnElement {
  std::string_view name;
  std::array<std::string_view, 6> parents;
  int numbers = 0;
  bool needed = false;
};

// The elements in which errors of a sensor may be described.
constexpr std::array<std::string_view, 6> kWithErrors = {
    "sensor", "robotcontrol:speed_sensor", "robotcontrol:load_sensor", "robotcontrol:position_sensor"};

constexpr OwnElement kOwnElements[] = {
    {"robotcontrol:robot", {"model", ""}, 0},
    {"robotcontrol:ball", {"model", ""}, 0, true},
    {"robotcontrol:field", {"model", ""}, 0},
    {"robotcontrol:home", {"model", ""}, 3},
    {"robotcontrol:palette", {"model", "world"}, 0},
    {"robotcontrol:color", {"visual", "robotcontrol:palette"}, 0},
    {"robotcontrol:servo", {"joint", ""}, 0},
    {"robotcontrol:initial_position", {"robotcontrol:servo", ""}, 1},
    {"robotcontrol:position_noise", {"robotcontrol:servo", ""}, 1},
    {"robotcontrol:vertical_fov", {"camera", ""}, 1},
    {"robotcontrol:vignetting", {"camera", ""}, 1},
    {"robotcontrol:vignetting_tint", {"camera", ""}, 1},
    {"robotcontrol:range", {"sensor", ""}, 1},
    {"robotcontrol:noise",
     {"sensor", "robotcontrol:speed_sensor", "robotcontrol:load_sensor", "robotcontrol:position_sensor",
      "robotcontrol:walk"},
     1},
    {"robotcontrol:mean", kWithErrors, 1},
    {"robotcontrol:bias_mean", kWithErrors, 1},
    {"robotcontrol:bias_stddev", kWithErrors, 1},
    {"robotcontrol:drift_stddev", kWithErrors, 1},
    {"robotcontrol:drift_time", kWithErrors, 1},
    {"robotcontrol:precision", kWithErrors, 1},
    {"robotcontrol:delay",
     {"sensor", "robotcontrol:speed_sensor", "robotcontrol:load_sensor", "robotcontrol:position_sensor",
      "robotcontrol:servo"},
     1},
    {"robotcontrol:rate", kWithErrors, 1},
    {"robotcontrol:dropout", kWithErrors, 1},
    {"robotcontrol:speed_sensor", {"joint"}, 0},
    {"robotcontrol:load_sensor", {"joint"}, 0},
    {"robotcontrol:position_sensor", {"joint"}, 0},
    {"robotcontrol:control", {"robotcontrol:servo"}, 0},
    {"robotcontrol:p", {"robotcontrol:servo"}, 1},
    {"robotcontrol:i", {"robotcontrol:servo"}, 1},
    {"robotcontrol:d", {"robotcontrol:servo"}, 1},
    {"robotcontrol:exposure", {"camera"}, 1},
    {"robotcontrol:readout", {"camera"}, 1},
    {"robotcontrol:class", {"camera", "robotcontrol:facette"}, 0},
    {"robotcontrol:whisker", {"sensor"}, 1, true},
    {"robotcontrol:switch", {"sensor"}, 0},
    {"robotcontrol:odometry", {"sensor"}, 0},
    {"robotcontrol:battery", {"sensor"}, 0},
    {"robotcontrol:capacity", {"robotcontrol:battery"}, 1},
    {"robotcontrol:charge", {"robotcontrol:battery"}, 1},
    {"robotcontrol:full_voltage", {"robotcontrol:battery"}, 1},
    {"robotcontrol:empty_voltage", {"robotcontrol:battery"}, 1},
    {"robotcontrol:idle_power", {"robotcontrol:battery"}, 1},
    {"robotcontrol:efficiency", {"robotcontrol:battery"}, 1},
    {"robotcontrol:facette", {"sensor"}, 0},
    {"robotcontrol:azimuth", {"robotcontrol:facette"}, 3, true},
    {"robotcontrol:elevation", {"robotcontrol:facette"}, 3, true},
    {"robotcontrol:far", {"robotcontrol:facette"}, 1},
    {"robotcontrol:radiation", {"world"}, 0},
    {"robotcontrol:sleeping", {"world"}, 0},
    {"robotcontrol:ambient", {"robotcontrol:radiation"}, 1},
    {"robotcontrol:surface", {"visual"}, 0},
    {"robotcontrol:reflects", {"robotcontrol:surface"}, 1},
    {"robotcontrol:emits", {"robotcontrol:surface"}, 1},
    {"robotcontrol:emitter", {"link"}, 0},
    {"robotcontrol:position", {"robotcontrol:emitter"}, 3, true},
    {"robotcontrol:attenuation", {"robotcontrol:emitter"}, 1},
    {"robotcontrol:intensity", {"robotcontrol:emitter", "light"}, 1, true},
    {"robotcontrol:door", {"joint"}, 0},
    {"robotcontrol:open", {"robotcontrol:door"}, 1, true},
    {"robotcontrol:closed", {"robotcontrol:door"}, 1},
    {"robotcontrol:below", {"robotcontrol:door"}, 1, true},
    {"robotcontrol:seconds", {"robotcontrol:door"}, 1},
    {"robotcontrol:controller", {"model", "world"}, 0},
    {"robotcontrol:parameter", {"robotcontrol:controller"}, 0},
    {"robotcontrol:guided", {"model"}, 0},
    {"robotcontrol:maximum_speed", {"robotcontrol:guided", "robotcontrol:walk"}, 1},
    {"robotcontrol:maximum_rate", {"robotcontrol:guided", "robotcontrol:walk"}, 1},
    {"robotcontrol:acceleration", {"robotcontrol:guided", "robotcontrol:vehicle"}, 1},
    {"robotcontrol:angular_acceleration", {"robotcontrol:guided", "robotcontrol:vehicle"}, 1},
    {"robotcontrol:wheelbase", {"robotcontrol:guided"}, 1},
    {"robotcontrol:skid", {"robotcontrol:guided"}, 1},
    {"robotcontrol:maximum_steering", {"robotcontrol:guided"}, 1},
    {"robotcontrol:most_incidence", {"sensor", ""}, 1},
    {"robotcontrol:team", {"include", ""}, 0},
    {"robotcontrol:role", {"include"}, 0},
    {"robotcontrol:game", {"world"}, 0},
    {"robotcontrol:layout", {"model", "include"}, 0},
    {"robotcontrol:drive", {"model", ""}, 0},
    {"robotcontrol:left", {"robotcontrol:drive", ""}, 0},
    {"robotcontrol:right", {"robotcontrol:drive", ""}, 0},
    {"robotcontrol:track", {"robotcontrol:drive", "robotcontrol:guided", "robotcontrol:vehicle"}, 1, true},
    {"robotcontrol:idle_torque", {"robotcontrol:drive", "robotcontrol:vehicle"}, 1},
    {"robotcontrol:vehicle", {"model"}, 0},
    {"robotcontrol:wheel", {"robotcontrol:vehicle"}, 0},
    {"robotcontrol:free_wheel", {"robotcontrol:vehicle"}, 0},
    {"robotcontrol:steer", {"robotcontrol:vehicle"}, 0},
    {"robotcontrol:walk", {"model"}, 0},
    {"robotcontrol:slip", {"robotcontrol:walk"}, 3},
    {"robotcontrol:motion", {"model", "include"}, 0},
};

/// The names of attributes that an element has and does not know, each with a guess.
std::string unknownAttribute(const XMLElement& element, const SdfElementHelp& help) {
  std::vector<std::string> known;
  for (const SdfAttribute& one : help.attributes) known.push_back(one.name);
  for (auto* one = element.FirstAttribute(); one != nullptr; one = one->Next()) {
    const std::string name = one->Name();
    const bool isOther = name == "xmlns" || name.find(':') != std::string::npos;
    if (isOther || std::ranges::find(known, name) != known.end()) continue;
    const std::string guess = robotlink::nearest(name, known);
    return "<" + help.name + "> has no attribute '" + name + "'" +
           (guess.empty() ? "" : "; is '" + guess + "' meant?");
  }
  return {};
}

bool isSecond(const XMLElement& element) {
  return element.PreviousSiblingElement(element.Name()) != nullptr;
}

void renameOwn(XMLElement& element, std::vector<std::string> prefixes, int depth) {
  constexpr int kDeepest = 1000;
  for (auto* one = element.FirstAttribute(); one != nullptr; one = one->Next()) {
    const std::string name = one->Name();
    if (name.starts_with("xmlns:") && one->Value() == kOwnUri) prefixes.push_back(name.substr(6) + ":");
  }
  const std::string name = element.Name();
  for (const std::string& prefix : prefixes) {
    if (!name.starts_with(prefix) || prefix == kOwnPrefix) continue;
    element.SetName((std::string(kOwnPrefix) + name.substr(prefix.size())).c_str());
    break;
  }
  if (depth > kDeepest) return;
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    renameOwn(*child, prefixes, depth + 1);
}

}  // namespace

void useOwnPrefix(XMLElement& root) {
  renameOwn(root, {}, 0);
}

std::vector<OwnProblem> problemsOfOwnElement(const XMLElement& element) {
  const std::string name = element.Name(), parent = element.Parent()->ToElement()->Name();
  const auto* known = std::ranges::find(kOwnElements, std::string_view(name), &OwnElement::name);
  if (known == std::end(kOwnElements))
    return {{"scene.unknown-element", "there is no <" + name + ">", false}};
  if (std::ranges::find(known->parents, std::string_view(parent)) == known->parents.end())
    return {{"scene.unknown-element", "<" + name + "> has no meaning in <" + parent + ">", false}};
  std::vector<OwnProblem> problems;
  const std::vector<std::string> values = wordsOf(element);
  // A gait's noise is that of three directions.
  const bool ofGait = parent == "robotcontrol:walk" && name == "robotcontrol:noise";
  const auto numbers = ofGait ? 3 : static_cast<std::size_t>(known->numbers);
  if (numbers > 0 && (values.size() != numbers || !std::ranges::all_of(values, isFiniteNumber))) {
    const std::string count =
        numbers == 1 ? "one finite number" : std::to_string(numbers) + " finite numbers";
    problems.push_back({"scene.value", "<" + name + "> must be " + count, true, !known->needed});
  }
  const auto help = ownSdfElement(name, parent);
  if (!help) return problems;
  if (help->type == "bool" && (values.size() != 1 || !isBool(values[0]))) {
    problems.push_back({"scene.value",
                        "<" + name + "> must be true or false, not '" + trimmedText(&element) + "'", true,
                        !known->needed});
  }
  if (std::string text = unknownAttribute(element, *help); !text.empty())
    problems.push_back({"scene.unknown-attribute", std::move(text)});
  if (!help->repeated && isSecond(element))
    problems.push_back(
        {"scene.duplicate-element", "there is another <" + name + "> in this <" + parent + ">"});
  return problems;
}

std::vector<std::pair<std::string, std::string>> ownSdfElements() {
  std::vector<std::pair<std::string, std::string>> all;
  for (const OwnElement& own : kOwnElements) {
    for (const std::string_view parent : own.parents) {
      if (!parent.empty()) all.emplace_back(own.name, parent);
    }
  }
  return all;
}

}  // namespace simcore
