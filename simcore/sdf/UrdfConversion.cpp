// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/UrdfConversion.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <map>
#include <sdf/sdf.hh>
#include <sstream>
#include <string_view>

#include "simcore/sdf/SdfPaths.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

/// An attribute of numbers.
struct UrdfNumbers {
  std::string_view element, attribute;
  std::size_t count = 1;
};
constexpr UrdfNumbers kUrdfNumbers[] = {
    {"origin", "xyz", 3},   {"origin", "rpy", 3},    {"axis", "xyz", 3},      {"mass", "value"},
    {"inertia", "ixx"},     {"inertia", "ixy"},      {"inertia", "ixz"},      {"inertia", "iyy"},
    {"inertia", "iyz"},     {"inertia", "izz"},      {"box", "size", 3},      {"sphere", "radius"},
    {"cylinder", "radius"}, {"cylinder", "length"},  {"capsule", "radius"},   {"capsule", "length"},
    {"mesh", "scale", 3},   {"limit", "lower"},      {"limit", "upper"},      {"limit", "effort"},
    {"limit", "velocity"},  {"dynamics", "damping"}, {"dynamics", "friction"}};

/// How much memory libsdformat takes for an element while it converts it, MB: for each it copies the
/// description of all that may be in it.
struct UrdfCost {
  std::string_view element;
  double megabytes;
};
constexpr UrdfCost kUrdfCosts[] = {{"model", 2.5},   {"world", 2.5},  {"actor", 2.5},
                                   {"include", 2.5}, {"link", 1},     {"joint", 0.5},
                                   {"sensor", 0.5},  {"visual", 0.2}, {"collision", 0.2}};
constexpr double kOtherCost = 0.02, kMaxCost = 700;  // MB

bool areNumbers(const char* text, std::size_t count) {
  std::istringstream stream(text);
  std::size_t found = 0;
  for (std::string word; stream >> word; ++found) {
    char* end = nullptr;
    // A limit may be infinite.
    if (std::isnan(std::strtod(word.c_str(), &end)) || end != word.c_str() + word.size()) return false;
  }
  return found == count;
}

class UrdfChecker {
 public:
  UrdfChecker(const std::string& file, robotlink::Errors& errors) : file_(file), errors_(errors) {}

  void check(const XMLElement& robot) {
    checkParts(robot);
    if (megabytes_ > kMaxCost)
      fail(robot, "it has too many links and joints to be converted; write it as SDFormat");
    readLinks(robot);
    readJoints(robot);
    if (errors_.empty()) checkTree(robot);
  }

 private:
  void fail(const XMLElement& element, const std::string& text) {
    const std::string path = objectPath(element);
    errors_.push_back({"scene.urdf",
                       (path.empty() ? "" : path + ": ") + text,
                       {element.Name()},
                       {file_, element.GetLineNum(), 0}});
  }

  /// Numbers of an element and of all in it, and what they cost. The document is not deeper than tinyxml2
  /// allows.
  void checkParts(const XMLElement& element) {
    const std::string_view name = element.Name();
    const auto* cost = std::ranges::find(kUrdfCosts, name, &UrdfCost::element);
    megabytes_ += cost != std::end(kUrdfCosts) ? cost->megabytes : kOtherCost;
    for (const UrdfNumbers& numbers : kUrdfNumbers) {
      const char* const text =
          numbers.element == name ? element.Attribute(std::string(numbers.attribute).c_str()) : nullptr;
      if (text == nullptr || areNumbers(text, numbers.count)) continue;
      fail(element, "the attribute '" + std::string(numbers.attribute) + "' of <" + std::string(name) +
                        "> must be " + (numbers.count == 1 ? "a number" : "3 numbers") + ", not '" +
                        std::string(text).substr(0, 60) + "'");
    }
    for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
      checkParts(*child);
  }

  void readLinks(const XMLElement& robot) {
    for (auto* link = robot.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
      if (nameOf(*link).empty()) fail(*link, "<link> needs the attribute 'name'");
      if (!parentOf_.emplace(nameOf(*link), "").second)
        fail(*link, "the name '" + nameOf(*link) + "' appears here twice");
    }
    if (parentOf_.empty()) fail(robot, "a URDF needs a <link>");
  }

  void readJoints(const XMLElement& robot) {
    for (auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      const std::string parent = endOf(*joint, "parent"), child = endOf(*joint, "child");
      if (parent.empty() || child.empty()) continue;
      std::string& known = parentOf_[child];
      if (!known.empty()) {
        fail(*joint,
             "the link '" + child + "' is also the child of another joint; in a URDF it has one parent");
      }
      known = parent;
    }
  }

  /// The link that a joint names; empty after an error.
  std::string endOf(const XMLElement& joint, const char* end) {
    const XMLElement* element = joint.FirstChildElement(end);
    const char* link = element != nullptr ? element->Attribute("link") : nullptr;
    if (link != nullptr && parentOf_.contains(link)) return link;
    fail(element != nullptr ? *element : joint,
         "the joint '" + nameOf(joint) + "' " +
             (link != nullptr ? "names the link '" + std::string(link) + "', which does not exist"
                              : "needs <" + std::string(end) + " link=\"...\"/>"));
    return {};
  }

  /// All links hang on one.
  void checkTree(const XMLElement& robot) {
    std::vector<std::string> roots;
    for (const auto& [link, parent] : parentOf_) {
      if (parent.empty()) roots.push_back(link);
    }
    if (roots.size() > 1)
      fail(robot, "no joint connects '" + roots[0] + "' and '" + roots[1] + "'; a URDF is one tree of links");
    if (roots.size() == 1 && !hasCycle()) return;
    if (roots.size() <= 1) fail(robot, "its joints form a cycle; a URDF is one tree of links");
  }

  bool hasCycle() const {
    return std::ranges::any_of(parentOf_, [this](const auto& one) {
      std::size_t steps = 0;
      for (const std::string* at = &one.second; !at->empty(); at = &parentOf_.at(*at)) {
        if (++steps > parentOf_.size()) return true;
      }
      return false;
    });
  }

  const std::string& file_;
  robotlink::Errors& errors_;
  /// The parents of the links; empty for one without.
  std::map<std::string, std::string> parentOf_;
  double megabytes_ = 0;
};

}  // namespace

robotlink::Errors problemsOfUrdf(const XMLElement& robot, const std::string& file) {
  robotlink::Errors errors;
  UrdfChecker(file, errors).check(robot);
  return errors;
}

robotlink::Result<std::string> sdfOfUrdf(const std::string& text, const std::string& file) {
  const auto failed = [&](const std::string& reason) {
    return robotlink::failure("scene.urdf", "this URDF cannot be converted to SDFormat: " + reason,
                              {file, 1, 0});
  };
  try {
    const auto document = std::make_shared<sdf::SDF>();
    sdf::init(document);
    sdf::Errors errors;
    if (!sdf::readString(text, document, errors) || !document->Root()) {
      return failed(errors.empty() ? "libsdformat gives no reason" : errors.front().Message());
    }
    return document->Root()->ToString("");
  } catch (const sdf::Exception&) {
    return failed("libsdformat gives no reason");
  } catch (const std::exception& exception) {
    return failed(exception.what());
  }
}

}  // namespace simcore
