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

#include "simcore/sdf/SdfDescription.h"
#include "simcore/sdf/SdfSpec.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

constexpr std::string_view kOwnPrefix = "robotcontrol:";

/// One of our own elements: where it is allowed, and how many numbers it contains (0: text or elements).
struct OwnElement {
  std::string_view name;
  std::array<std::string_view, 2> parents;
  int numbers = 0;
};

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
    {"robotcontrol:noise", {"sensor", ""}, 1},
    {"robotcontrol:most_incidence", {"sensor", ""}, 1},
    {"robotcontrol:team", {"include", ""}, 0},
    {"robotcontrol:drive", {"model", ""}, 0},
    {"robotcontrol:left", {"robotcontrol:drive", ""}, 0},
    {"robotcontrol:right", {"robotcontrol:drive", ""}, 0},
    {"robotcontrol:track", {"robotcontrol:drive", ""}, 1},
    {"robotcontrol:idle_torque", {"robotcontrol:drive", ""}, 1},
};

// Versions that libsdformat converts.
constexpr std::string_view kOlderVersions[] = {"1.5", "1.6", "1.7", "1.8"};

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
  Checker(const std::string& file, robotlink::Errors& errors) : file_(file), errors_(errors) {}

  /// Checks an element of SDFormat; without a description, only our own elements below it.
  void check(const XMLElement& element, const sdf::ElementPtr& description) {
    if (description) {
      checkAttributes(element, description);
      checkValue(element, description);
    }
    for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      const std::string_view name = child->Name();
      if (name.starts_with(kOwnPrefix)) {
        checkOwn(*child, element.Name());
      } else if (name.find(':') == std::string_view::npos) {
        checkChild(*child, element, description);
      }
    }
  }

 private:
  void fail(const XMLElement& element, const char* id, const std::string& text) {
    errors_.push_back({id, text, {element.Name()}, {file_, element.GetLineNum(), 0}});
  }

  void checkChild(const XMLElement& child, const XMLElement& parent, const sdf::ElementPtr& description) {
    if (!description) return check(child, nullptr);
    // The parameters of a plugin are arbitrary.
    if (description->GetCopyChildren()) return;
    if (!description->HasElementDescription(child.Name())) {
      return fail(child, "scene.unknown-element",
                  std::string("SDFormat 1.9 has no <") + child.Name() + "> in <" + parent.Name() + ">");
    }
    const sdf::ElementPtr found = description->GetElementDescription(child.Name());
    // A model inside a model is described by reference.
    check(child, found->ReferenceSDF().empty() ? found : nullptr);
  }

  void checkAttributes(const XMLElement& element, const sdf::ElementPtr& description) {
    for (auto* attribute = element.FirstAttribute(); attribute != nullptr; attribute = attribute->Next()) {
      const std::string name = attribute->Name();
      if (name.find(':') != std::string::npos || description->HasAttribute(name)) continue;
      fail(element, "scene.unknown-attribute",
           "<" + std::string(element.Name()) + "> has no attribute '" + name + "'");
    }
    for (std::size_t i = 0; i < description->GetAttributeCount(); ++i) {
      const auto attribute = description->GetAttribute(static_cast<unsigned int>(i));
      if (!attribute->GetRequired() || element.Attribute(attribute->GetKey().c_str()) != nullptr) continue;
      fail(element, "scene.missing-attribute",
           "<" + std::string(element.Name()) + "> needs the attribute '" + attribute->GetKey() + "'");
    }
  }

  void checkValue(const XMLElement& element, const sdf::ElementPtr& description) {
    if (!description->GetValue() || element.FirstChildElement() != nullptr) return;
    const std::string& type = description->GetValue()->GetTypeName();
    const std::vector<std::string> values = words(element);
    const auto known = std::ranges::find(kNumberTypes, std::string_view(type), &ValueType::name);
    if (type == "bool") {
      const bool valid = values.size() == 1 && (values[0] == "true" || values[0] == "false" ||
                                                values[0] == "1" || values[0] == "0");
      if (!valid) fail(element, "scene.value", "<" + std::string(element.Name()) + "> must be true or false");
    } else if (known != std::end(kNumberTypes)) {
      checkNumbers(element, values, known->fewest, known->most);
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
    fail(element, "scene.value", "<" + std::string(element.Name()) + "> must be " + count);
  }

  void checkOwn(const XMLElement& element, std::string_view parent) {
    const std::string name = element.Name();
    const auto* known = std::ranges::find(kOwnElements, std::string_view(name), &OwnElement::name);
    if (known == std::end(kOwnElements))
      return fail(element, "scene.unknown-element", "there is no <" + name + ">");
    if (std::ranges::find(known->parents, parent) == known->parents.end()) {
      return fail(element, "scene.unknown-element",
                  "<" + name + "> has no meaning in <" + std::string(parent) + ">");
    }
    const std::vector<std::string> values = words(element);
    const auto numbers = static_cast<std::size_t>(known->numbers);
    if (numbers > 0 && (values.size() != numbers || !std::ranges::all_of(values, isFiniteNumber))) {
      const std::string count =
          numbers == 1 ? "one finite number" : std::to_string(numbers) + " finite numbers";
      fail(element, "scene.value", "<" + name + "> must be " + count);
    }
    check(element, nullptr);
  }

  const std::string& file_;
  robotlink::Errors& errors_;
};

}  // namespace

void checkSdfTree(const tinyxml2::XMLDocument& document, const std::string& file, const SdfSpec& spec,
                  robotlink::Errors& errors) {
  const XMLElement* root = document.RootElement();
  if (root == nullptr || std::string_view(root->Name()) != "sdf") {
    const int line = root != nullptr ? root->GetLineNum() : 1;
    errors.push_back(
        {"scene.no-sdf", "this is not an SDFormat file: its root is not <sdf>", {}, {file, line, 0}});
    return;
  }
  const std::string_view version = root->Attribute("version") != nullptr ? root->Attribute("version") : "";
  const bool current = version == "1.9";
  if (!current && std::ranges::find(kOlderVersions, version) == std::end(kOlderVersions)) {
    errors.push_back({"scene.version",
                      "the version must be 1.9, or an older one down to 1.5",
                      {},
                      {file, root->GetLineNum(), 0}});
    return;
  }
  Checker(file, errors).check(*root, current ? spec.description().text->Root() : nullptr);
  checkSdfNames(*root, file, errors);
}

}  // namespace simcore
