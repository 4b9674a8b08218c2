// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfCheck.h"

#include <tinyxml2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <sdf/Param.hh>
#include <sstream>
#include <string_view>
#include <vector>

#include "robotlink/base/Spelling.h"
#include "simcore/sdf/SdfDescription.h"
#include "simcore/sdf/SdfPaths.h"
#include "simcore/sdf/SdfSpec.h"
#include "simcore/sdf/SdfUnsupported.h"
#include "simcore/sdf/SdfUpgrade.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

constexpr std::string_view kOwnPrefix = "robotcontrol:";
/// As much of a wrong value is shown.
constexpr std::size_t kMaxShown = 60;

/// One of our own elements: where it is allowed, and how many numbers it contains (0: text or elements).
struct OwnElement {
  std::string_view name;
  std::array<std::string_view, 6> parents;
  int numbers = 0;
};

// Where errors of a sensor may be described.
constexpr std::array<std::string_view, 6> kWithErrors = {
    "sensor", "robotcontrol:speed_sensor", "robotcontrol:load_sensor", "robotcontrol:position_sensor"};

constexpr OwnElement kOwnElements[] = {
    {"robotcontrol:robot", {"model", ""}, 0},
    {"robotcontrol:ball", {"model", ""}, 0},
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
    {"robotcontrol:whisker", {"sensor"}, 1},
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
    {"robotcontrol:azimuth", {"robotcontrol:facette"}, 3},
    {"robotcontrol:elevation", {"robotcontrol:facette"}, 3},
    {"robotcontrol:far", {"robotcontrol:facette"}, 1},
    {"robotcontrol:radiation", {"world"}, 0},
    {"robotcontrol:sleeping", {"world"}, 0},
    {"robotcontrol:ambient", {"robotcontrol:radiation"}, 1},
    {"robotcontrol:surface", {"visual"}, 0},
    {"robotcontrol:reflects", {"robotcontrol:surface"}, 1},
    {"robotcontrol:emits", {"robotcontrol:surface"}, 1},
    {"robotcontrol:emitter", {"link"}, 0},
    {"robotcontrol:position", {"robotcontrol:emitter"}, 3},
    {"robotcontrol:attenuation", {"robotcontrol:emitter"}, 1},
    {"robotcontrol:intensity", {"robotcontrol:emitter", "light"}, 1},
    {"robotcontrol:door", {"joint"}, 0},
    {"robotcontrol:open", {"robotcontrol:door"}, 1},
    {"robotcontrol:closed", {"robotcontrol:door"}, 1},
    {"robotcontrol:below", {"robotcontrol:door"}, 1},
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
    {"robotcontrol:track", {"robotcontrol:drive", "robotcontrol:guided", "robotcontrol:vehicle"}, 1},
    {"robotcontrol:idle_torque", {"robotcontrol:drive", "robotcontrol:vehicle"}, 1},
    {"robotcontrol:vehicle", {"model"}, 0},
    {"robotcontrol:wheel", {"robotcontrol:vehicle"}, 0},
    {"robotcontrol:free_wheel", {"robotcontrol:vehicle"}, 0},
    {"robotcontrol:steer", {"robotcontrol:vehicle"}, 0},
    {"robotcontrol:walk", {"model"}, 0},
    {"robotcontrol:slip", {"robotcontrol:walk"}, 3},
    {"robotcontrol:motion", {"model", "include"}, 0},
};

std::vector<std::string> words(const XMLElement& element) {
  std::vector<std::string> result;
  std::istringstream stream(element.GetText() != nullptr ? element.GetText() : "");
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

bool isFiniteNumber(const std::string& word) {
  char* end = nullptr;
  return std::isfinite(std::strtod(word.c_str(), &end)) && end == word.c_str() + word.size();
}

bool isBool(const std::string& word) {
  return isTrue(word) || word == "0" || word == "false" || word == "False" || word == "FALSE";
}

/// Limits may be infinite: in SDFormat this means that there is none.
bool isLimitNumber(const std::string& word) {
  return word == "inf" || word == "-inf" || isFiniteNumber(word);
}

struct ValueType {
  std::string_view name;
  // Numbers of values.
  std::size_t fewest, most;
};

constexpr ValueType kNumberTypes[] = {{"double", 1, 1},       {"float", 1, 1},   {"int", 1, 1},
                                      {"unsigned int", 1, 1}, {"vector3", 3, 3}, {"vector2d", 2, 2},
                                      {"color", 3, 4},        {"pose", 6, 7}};

class Checker {
 public:
  Checker(const std::string& file, robotlink::Errors& errors, LeftOuts& leftOut)
      : file_(file), errors_(errors), leftOut_(leftOut) {}

  /// Checks an element of SDFormat; without a description, only our own elements below it.
  void check(XMLElement& element, const sdf::ElementPtr& description) {
    if (description) {
      checkAttributes(element, description);
      checkValue(element, description);
    }
    for (XMLElement* child = element.FirstChildElement(); child != nullptr;) {
      XMLElement* const next = child->NextSiblingElement();
      const std::string_view name = child->Name();
      if (name.starts_with(kOwnPrefix)) {
        checkOwn(*child, element.Name());
      } else if (name.find(':') == std::string_view::npos && !checkChild(*child, element, description)) {
        element.DeleteChild(child);
      }
      child = next;
    }
  }

 private:
  void fail(const XMLElement& element, const char* id, const std::string& text) {
    const std::string path = objectPath(element);
    errors_.push_back(
        {id, path.empty() ? text : path + ": " + text, {element.Name()}, {file_, element.GetLineNum(), 0}});
  }
  void omit(const XMLElement& element, const std::string& what, const std::string& why) {
    leaveOut(leftOut_, {{file_, element.GetLineNum(), 0}, objectPath(element), what, why});
  }
  static std::string tag(const XMLElement& element) { return std::string("<") + element.Name() + ">"; }

  /// Returns whether the child stays in the tree.
  bool checkChild(XMLElement& child, const XMLElement& parent, const sdf::ElementPtr& description) {
    const Unsupported found = unsupported(child);
    if (found.why != nullptr) omit(child, tag(child) + " in " + tag(parent), found.why);
    if (found.removed) return false;
    if (!description) {
      check(child, nullptr);
      return true;
    }
    // The parameters of a plugin are arbitrary.
    if (description->GetCopyChildren()) return true;
    // Newer than the SDFormat that libsdformat describes, and read by readSolidShapes().
    if (std::string_view(child.Name()) == "cone" && std::string_view(parent.Name()) == "geometry") {
      check(child, nullptr);
      return true;
    }
    if (!description->HasElementDescription(child.Name())) {
      omit(child, tag(child) + " in " + tag(parent),
           "SDFormat 1.9 has no such element" + guess(child, description));
      return false;
    }
    const sdf::ElementPtr known = description->GetElementDescription(child.Name());
    // A model inside a model is described by reference.
    if (!known->ReferenceSDF().empty() && std::string_view(child.Name()) == "model") {
      check(child, model_ ? model_ : description);
    } else {
      if (std::string_view(child.Name()) == "model") model_ = known;
      check(child, known->ReferenceSDF().empty() ? known : nullptr);
    }
    return true;
  }

  static std::string shortText(const XMLElement& element) {
    const std::string text = trimmedText(&element);
    return text.size() <= kMaxShown ? text : text.substr(0, kMaxShown - 3) + "...";
  }

  static std::string guess(const XMLElement& child, const sdf::ElementPtr& description) {
    std::vector<std::string> names;
    for (unsigned i = 0; i < description->GetElementDescriptionCount(); ++i)
      names.push_back(description->GetElementDescription(i)->GetName());
    const auto nearest = robotlink::nearest(child.Name(), names);
    return nearest.empty() ? "" : "; is <" + nearest + "> meant?";
  }

  void checkAttributes(XMLElement& element, const sdf::ElementPtr& description) {
    std::vector<std::string> unknown;
    for (auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
      const std::string name = attribute->Name();
      if (name.find(':') != std::string::npos || description->HasAttribute(name)) continue;
      unknown.push_back(name);
    }
    for (const std::string& name : unknown) {
      omit(element, "attribute '" + name + "' of " + tag(element), "SDFormat 1.9 has no such attribute");
      element.DeleteAttribute(name.c_str());
    }
    for (std::size_t i = 0; i < description->GetAttributeCount(); ++i) {
      const auto attribute = description->GetAttribute(static_cast<unsigned int>(i));
      if (!attribute->GetRequired() || element.Attribute(attribute->GetKey().c_str()) != nullptr) continue;
      fail(element, "scene.missing-attribute",
           tag(element) + " needs the attribute '" + attribute->GetKey() + "'");
    }
    checkAttributeValues(element, description);
  }

  /// Values that libsdformat does not expect end in its assertions.
  void checkAttributeValues(const XMLElement& element, const sdf::ElementPtr& description) {
    const auto check = [&](const std::string& name, bool valid, const char* rule) {
      if (valid) return;
      fail(element, "scene.value",
           "the attribute '" + name + "' of " + tag(element) + " must be " + rule + ", not '" +
               std::string(element.Attribute(name.c_str())).substr(0, kMaxShown) + "'");
    };
    for (const sdf::ParamPtr& known : description->GetAttributes()) {
      const std::string name = known->GetKey();
      const char* const value = element.Attribute(name.c_str());
      if (value == nullptr) continue;
      if (known->GetTypeName() == "bool") check(name, isBool(value), "true or false");
      if (name == "rotation_format")
        check(name, std::string_view(value) == "euler_rpy" || hasQuaternion(element),
              "euler_rpy or quat_xyzw");
    }
  }

  void checkValue(const XMLElement& element, const sdf::ElementPtr& description) {
    if (!description->GetValue() || element.FirstChildElement() != nullptr) return;
    const std::string& type = description->GetValue()->GetTypeName();
    const std::vector<std::string> values = words(element);
    const auto known = std::ranges::find(kNumberTypes, std::string_view(type), &ValueType::name);
    if (type == "bool") {
      if (values.size() != 1 || !isBool(values[0]))
        fail(element, "scene.value",
             tag(element) + " must be true or false, not '" + shortText(element) + "'");
    } else if (known != std::end(kNumberTypes)) {
      const bool isPose = type == "pose";
      const std::size_t ofPose = hasQuaternion(element) ? 7 : 6;
      checkNumbers(element, values, isPose ? ofPose : known->fewest, isPose ? ofPose : known->most);
    }
  }

  void checkNumbers(const XMLElement& element, const std::vector<std::string>& values, std::size_t fewest,
                    std::size_t most) {
    const bool isLimit = element.Parent() != nullptr && element.Parent()->ToElement() != nullptr &&
                         std::string_view(element.Parent()->ToElement()->Name()) == "limit";
    // An empty <pose/> or the like means the default.
    const bool countFits = values.empty() || (values.size() >= fewest && values.size() <= most);
    if (countFits && std::ranges::all_of(values, isLimit ? isLimitNumber : isFiniteNumber)) return;
    const std::string count = fewest == 1 ? "one finite number" : std::to_string(fewest) + " finite numbers";
    fail(element, "scene.value", tag(element) + " must be " + count + ", not '" + shortText(element) + "'");
  }

  void checkOwn(XMLElement& element, std::string_view parent) {
    const std::string name = element.Name();
    const auto* known = std::ranges::find(kOwnElements, std::string_view(name), &OwnElement::name);
    if (known == std::end(kOwnElements))
      return fail(element, "scene.unknown-element", "there is no <" + name + ">");
    if (std::ranges::find(known->parents, parent) == known->parents.end()) {
      return fail(element, "scene.unknown-element",
                  "<" + name + "> has no meaning in <" + std::string(parent) + ">");
    }
    const std::vector<std::string> values = words(element);
    // A gait's noise is that of three directions.
    const bool ofGait = parent == "robotcontrol:walk" && name == "robotcontrol:noise";
    const auto numbers = ofGait ? 3 : static_cast<std::size_t>(known->numbers);
    if (numbers > 0 && (values.size() != numbers || !std::ranges::all_of(values, isFiniteNumber))) {
      const std::string count =
          numbers == 1 ? "one finite number" : std::to_string(numbers) + " finite numbers";
      fail(element, "scene.value", "<" + name + "> must be " + count);
    }
    check(element, nullptr);
  }

  const std::string& file_;
  robotlink::Errors& errors_;
  LeftOuts& leftOut_;
  /// The description of <model>, for models inside models.
  sdf::ElementPtr model_;
};

}  // namespace

void checkSdfTree(tinyxml2::XMLDocument& document, const std::string& file, const SdfSpec& spec,
                  robotlink::Errors& errors, LeftOuts& leftOut) {
  XMLElement* root = document.RootElement();
  if (root == nullptr || std::string_view(root->Name()) != "sdf") {
    const int line = root != nullptr ? root->GetLineNum() : 1;
    const std::string found = root != nullptr ? ", but <" + std::string(root->Name()) + ">" : "";
    errors.push_back(
        {"scene.no-sdf", "this is not an SDFormat file: its root is not <sdf>" + found, {}, {file, line, 0}});
    return;
  }
  const std::string version = root->Attribute("version") != nullptr ? root->Attribute("version") : "";
  const int minor = sdfMinorVersion(version);
  if (minor < kOldestSdf || minor > kNewestSdf) {
    errors.push_back({"scene.version",
                      "the version must be 1.9, or another one from 1.2 to 1.12, not '" + version + "'",
                      {},
                      {file, root->GetLineNum(), 0}});
    return;
  }
  if (minor < 9) upgradeSdf(document, minor);
  Checker(file, errors, leftOut).check(*root, spec.description().text->Root());
  checkSdfNames(*root, file, errors, leftOut);
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
