// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfCheck.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sdf/Param.hh>
#include <span>
#include <sstream>
#include <string_view>
#include <vector>

#include "robotlink/base/Spelling.h"
#include "simcore/sdf/SdfDescription.h"
#include "simcore/sdf/SdfOwnElements.h"
#include "simcore/sdf/SdfPaths.h"
#include "simcore/sdf/SdfSpec.h"
#include "simcore/sdf/SdfUnsupported.h"
#include "simcore/sdf/SdfUpgrade.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

/// The number of characters of a wrong value that an error shows.
constexpr std::size_t kMaxShown = 60;

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

constexpr std::string_view kJointTypes[] = {"revolute", "continuous", "prismatic", "ball",     "universal",
                                            "fixed",    "screw",      "gearbox",   "revolute2"};
constexpr std::string_view kLightTypes[] = {"point", "directional", "spot"};

std::string inLowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

/// Whether both say the same, as numbers if they are some.
bool isSameValue(const std::string& type, const std::string& text, const std::string& other) {
  if (type == "bool") return isTrue(text) == isTrue(other);
  std::istringstream one(text), two(other);
  std::string word, otherWord;
  while (one >> word) {
    if (!(two >> otherWord)) return false;
    const bool areNumbers = isFiniteNumber(word) && isFiniteNumber(otherWord);
    if (areNumbers ? std::atof(word.c_str()) != std::atof(otherWord.c_str()) : word != otherWord)
      return false;
  }
  return !(two >> otherWord);
}

/// Whether an element, with all in it, says what would be so without it.
bool isUsual(const XMLElement& element, const sdf::ElementPtr& description) {
  const sdf::ParamPtr value = description->GetValue();
  const std::string text = trimmedText(&element);
  if (value && !text.empty() && !isSameValue(value->GetTypeName(), text, value->GetDefaultAsString()))
    return false;
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const bool isKnown = description->HasElementDescription(child->Name());
    if (!isKnown || !isUsual(*child, description->GetElementDescription(child->Name()))) return false;
  }
  return true;
}

class Checker {
 public:
  Checker(const std::string& file, robotlink::Errors& errors, LeftOuts& leftOut)
      : file_(file), errors_(errors), leftOut_(leftOut) {}

  /// Checks an element of SDFormat; without a description, only our own elements below it. Returns whether
  /// its value can be used.
  bool check(XMLElement& element, const sdf::ElementPtr& description) {
    bool isSound = true;
    if (description) {
      checkAttributes(element, description);
      isSound = checkValue(element, description);
    }
    for (XMLElement* child = element.FirstChildElement(); child != nullptr;) {
      XMLElement* const next = child->NextSiblingElement();
      const std::string_view name = child->Name();
      if (name.starts_with(kOwnPrefix)) {
        if (!checkOwn(*child)) element.DeleteChild(child);
      } else if (name.find(':') == std::string_view::npos && !checkChild(*child, element, description)) {
        element.DeleteChild(child);
      }
      child = next;
    }
    return isSound;
  }

 private:
  void fail(const XMLElement& element, const char* id, const std::string& text) {
    const std::string path = objectPath(element);
    errors_.push_back(
        {id, path.empty() ? text : path + ": " + text, {element.Name()}, {file_, sourceLine(element), 0}});
  }
  void omit(const XMLElement& element, const std::string& what, const std::string& why) {
    leaveOut(leftOut_, {{file_, sourceLine(element), 0}, objectPath(element), what, why});
  }
  static std::string tag(const XMLElement& element) { return std::string("<") + element.Name() + ">"; }

  /// Returns whether the child stays in the tree.
  bool checkChild(XMLElement& child, const XMLElement& parent, const sdf::ElementPtr& description) {
    const std::string name = child.Name();
    sdf::ElementPtr known;
    if (description && description->HasElementDescription(name))
      known = description->GetElementDescription(name);
    const bool isPlain = known && known->ReferenceSDF().empty() && isUsual(child, known);
    const Unsupported found = unsupported(child, isPlain);
    if (found.why != nullptr) omit(child, tag(child) + " in " + tag(parent), found.why);
    if (found.removed) return false;
    if (!description) return check(child, nullptr);
    // The parameters of a plugin are arbitrary.
    if (description->GetCopyChildren()) return true;
    // Shapes newer than libsdformat's SDFormat are read by readSolidShapes(), and so are elements that are no
    // shape at all.
    if (std::string_view(parent.Name()) == "geometry" && !known) return check(child, nullptr);
    if (!known) {
      omit(child, tag(child) + " in " + tag(parent),
           "SDFormat 1.9 has no such element" + guess(name, namesIn(description), "<", ">"));
      return false;
    }
    if (!isRead(child)) {
      if (!isPlain) omit(child, tag(child) + " in " + tag(parent), "the simulator has nothing like it");
      return false;
    }
    if (name == "sensor" && !isReadSensor(child)) return false;
    if (name == "joint") checkType(child, kJointTypes, "fixed");
    if (name == "light") checkType(child, kLightTypes, "point");
    // A model inside a model is described by reference.
    if (!known->ReferenceSDF().empty() && name == "model") return check(child, model_ ? model_ : description);
    if (name == "model") model_ = known;
    return check(child, known->ReferenceSDF().empty() ? known : nullptr);
  }

  /// libsdformat refuses the whole file for a sensor that it does not know.
  bool isReadSensor(const XMLElement& sensor) {
    const char* const type = sensor.Attribute("type");
    if (type == nullptr) {
      fail(sensor, "scene.missing-attribute", "<sensor> needs the attribute 'type'");
      return false;
    }
    if (isKnownSensor(type)) return true;
    omit(sensor, "sensor of type '" + std::string(type) + "'",
         kKnownSensors + guess(type, knownSensors(), "'", "'"));
    return false;
  }

  /// Reports an unknown type and replaces it, so that the rest is read.
  void checkType(XMLElement& element, std::span<const std::string_view> types, const char* otherwise) {
    const char* const type = element.Attribute("type");
    if (type != nullptr && std::ranges::find(types, inLowerCase(type)) != types.end()) return;
    if (type != nullptr) {
      std::string all;
      for (const std::string_view one : types) all += (all.empty() ? "" : ", ") + std::string(one);
      fail(element, "scene.type",
           "there is no " + tag(element) + " of type '" + std::string(type).substr(0, kMaxShown) + "'" +
               guess(type, {types.begin(), types.end()}, "'", "'") + "; there are " + all);
      element.SetAttribute("type", otherwise);
    }
  }

  static std::string shortText(const XMLElement& element) {
    const std::string text = trimmedText(&element);
    return text.size() <= kMaxShown ? text : text.substr(0, kMaxShown - 3) + "...";
  }

  static std::vector<std::string> namesIn(const sdf::ElementPtr& description) {
    std::vector<std::string> names;
    for (unsigned i = 0; i < description->GetElementDescriptionCount(); ++i)
      names.push_back(description->GetElementDescription(i)->GetName());
    return names;
  }

  static std::string guess(const std::string& name, const std::vector<std::string>& names, const char* before,
                           const char* after) {
    const auto nearest = robotlink::nearest(name, names);
    return nearest.empty() ? "" : "; is " + (before + nearest) + after + " meant?";
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
      const std::string& key = attribute->GetKey();
      const char* const value = element.Attribute(key.c_str());
      const bool isName = key == "name";
      if (!attribute->GetRequired() || (value != nullptr && !(isName && *value == '\0'))) continue;
      fail(element, "scene.missing-attribute", tag(element) + " needs the attribute '" + key + "'");
      // Set to a name that is possible, so that the rest is read.
      if (isName) element.SetAttribute("name", ("unnamed " + std::to_string(++unnamed_)).c_str());
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

  /// Returns whether the value can be used.
  bool checkValue(const XMLElement& element, const sdf::ElementPtr& description) {
    if (!description->GetValue() || element.FirstChildElement() != nullptr) return true;
    const std::string& type = description->GetValue()->GetTypeName();
    const std::vector<std::string> values = wordsOf(element);
    const auto known = std::ranges::find(kNumberTypes, std::string_view(type), &ValueType::name);
    if (type == "bool") {
      if (values.size() == 1 && isBool(values[0])) return true;
      fail(element, "scene.value", tag(element) + " must be true or false, not '" + shortText(element) + "'");
      return false;
    }
    if (known == std::end(kNumberTypes)) return true;
    const bool isPose = type == "pose";
    const std::size_t ofPose = hasQuaternion(element) ? 7 : 6;
    if (!checkNumbers(element, values, isPose ? ofPose : known->fewest, isPose ? ofPose : known->most))
      return false;
    if (type == "color") return checkColor(element, values);
    return (type != "int" && type != "unsigned int") || checkCount(element, values);
  }

  bool checkNumbers(const XMLElement& element, const std::vector<std::string>& values, std::size_t fewest,
                    std::size_t most) {
    const bool isLimit = element.Parent() != nullptr && element.Parent()->ToElement() != nullptr &&
                         std::string_view(element.Parent()->ToElement()->Name()) == "limit";
    // An empty <pose/> or the like means the default.
    const bool countFits = values.empty() || (values.size() >= fewest && values.size() <= most);
    if (countFits && std::ranges::all_of(values, isLimit ? isLimitNumber : isFiniteNumber)) return true;
    const std::string count = fewest == 1 ? "one finite number" : std::to_string(fewest) + " finite numbers";
    fail(element, "scene.value", tag(element) + " must be " + count + ", not '" + shortText(element) + "'");
    return false;
  }

  bool checkColor(const XMLElement& element, const std::vector<std::string>& values) {
    const auto isShare = [](const std::string& word) {
      const double number = std::atof(word.c_str());
      return number >= 0 && number <= 1;
    };
    if (!std::ranges::all_of(values, isShare)) {
      fail(element, "scene.value",
           "the numbers of " + tag(element) + " must be between 0 and 1, not '" + shortText(element) + "'");
      return false;
    }
    const bool isMaterial = std::string_view(element.Parent()->ToElement()->Name()) == "material";
    if (isMaterial && values.size() == 4 && std::atof(values[3].c_str()) < 1)
      omit(element, "the fourth number of <diffuse>", "everything is opaque");
    return true;
  }

  /// Whole numbers of SDFormat count something.
  bool checkCount(const XMLElement& element, const std::vector<std::string>& values) {
    if (values.empty() ||
        std::ranges::all_of(values[0], [](unsigned char c) { return std::isdigit(c) != 0; }))
      return true;
    fail(element, "scene.value",
         tag(element) + " must be a whole number from 0 on, not '" + shortText(element) + "'");
    return false;
  }

  /// Returns whether it stays in the tree.
  bool checkOwn(XMLElement& element) {
    bool stays = true;
    const auto problems = problemsOfOwnElement(element);
    for (const OwnProblem& problem : problems) {
      if (problem.canBeLeftOut) {
        omit(element, tag(element), problem.text.substr(tag(element).size() + 1));
        stays = false;
      } else {
        fail(element, problem.id, problem.text);
      }
    }
    if (problems.empty() || problems.front().isKnown) check(element, nullptr);
    return stays;
  }

  const std::string& file_;
  robotlink::Errors& errors_;
  LeftOuts& leftOut_;
  int unnamed_ = 0;
  /// The description of <model>, for models inside models.
  sdf::ElementPtr model_;
};

}  // namespace

void checkSdfTree(tinyxml2::XMLDocument& document, const std::string& file, const SdfSpec& spec,
                  robotlink::Errors& errors, LeftOuts& leftOut) {
  XMLElement* root = document.RootElement();
  if (root == nullptr || std::string_view(root->Name()) != "sdf") {
    const int line = root != nullptr ? sourceLine(*root) : 1;
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
                      {file, sourceLine(*root), 0}});
    return;
  }
  useOwnPrefix(*root);
  if (minor < 9) upgradeSdf(document, minor);
  Checker(file, errors, leftOut).check(*root, spec.description().text->Root());
  checkSdfNames(*root, file, errors, leftOut);
}

}  // namespace simcore
