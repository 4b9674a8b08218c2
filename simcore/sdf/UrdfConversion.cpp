// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/UrdfConversion.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <exception>
#include <sdf/sdf.hh>
#include <set>
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

/// An element of URDF that SDFormat, or this simulator, does not have.
struct UrdfUnknown {
  std::string_view element, parent;
  const char* why;
};
constexpr UrdfUnknown kUrdfUnknown[] = {
    {"mimic", "joint", "the joint turns independently"},
    {"safety_controller", "joint", "motors are limited by <limit> only"},
    {"transmission", "robot", "motors are <robotcontrol:servo>s of a scene in SDFormat"}};

constexpr std::string_view kUrdfJoints[] = {"revolute", "continuous", "prismatic", "fixed"};

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
  UrdfChecker(const std::string& file, UrdfParts& parts, robotlink::Errors& errors, LeftOuts& leftOut)
      : file_(file), parts_(parts), errors_(errors), leftOut_(leftOut) {}

  void check(XMLElement& robot) {
    parts_.line = robot.GetLineNum();
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

  void omit(const XMLElement& element, const std::string& what, const char* why) {
    leaveOut(leftOut_, {{file_, element.GetLineNum(), 0}, objectPath(element), what, why});
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
    for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      const auto unknown = std::ranges::find_if(kUrdfUnknown, [&](const UrdfUnknown& one) {
        return one.element == child->Name() && one.parent == name;
      });
      if (unknown != std::end(kUrdfUnknown))
        omit(*child, "<" + std::string(child->Name()) + "> in <" + std::string(name) + ">", unknown->why);
      checkParts(*child);
    }
  }

  /// libsdformat has no joints that leave their links apart, and says on the console what else is wrong.
  void checkType(XMLElement& joint) {
    const std::string type = joint.Attribute("type") != nullptr ? joint.Attribute("type") : "";
    if (type == "floating" || type == "planar") {
      omit(joint, "joint of type '" + type + "'", "its links are not joined");
      joint.SetAttribute("type", "continuous");
      parts_.apart.insert(nameOf(joint));
    } else if (std::ranges::find(kUrdfJoints, type) == std::end(kUrdfJoints)) {
      fail(joint, "there is no joint of type '" + type +
                      "'; there are revolute, continuous, prismatic, fixed, floating and planar");
    }
    // libsdformat would check it.
    while (XMLElement* safety = joint.FirstChildElement("safety_controller")) joint.DeleteChild(safety);
    if (type != "revolute" && type != "prismatic") return;
    const XMLElement* limit = joint.FirstChildElement("limit");
    if (limit == nullptr) {
      return fail(joint, "a joint of type '" + type + "' needs a <limit>" +
                             (type == "revolute" ? "; without stops its type is continuous" : ""));
    }
    for (const char* attribute : {"effort", "velocity"}) {
      if (limit->Attribute(attribute) == nullptr)
        fail(*limit, std::string("<limit> needs the attribute '") + attribute + "'");
    }
  }

  void readLinks(const XMLElement& robot) {
    for (auto* link = robot.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
      if (nameOf(*link).empty()) fail(*link, "<link> needs the attribute 'name'");
      parts_.links.emplace(nameOf(*link), link->GetLineNum());
      if (!parentOf_.emplace(nameOf(*link), "").second)
        fail(*link, "the name '" + nameOf(*link) + "' appears here twice");
    }
    if (parentOf_.empty()) fail(robot, "a URDF needs a <link>");
  }

  void readJoints(XMLElement& robot) {
    for (auto* joint = robot.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      checkType(*joint);
      parts_.joints.emplace(nameOf(*joint), joint->GetLineNum());
      const std::string parent = endOf(*joint, "parent"), child = endOf(*joint, "child");
      if (parent.empty() || child.empty()) continue;
      const char* const type = joint->Attribute("type");
      if (type == nullptr || std::string_view(type) != "fixed") parts_.moving.insert(child);
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

  /// Checks that all links depend on one root.
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
  UrdfParts& parts_;
  robotlink::Errors& errors_;
  LeftOuts& leftOut_;
  /// The parents of the links; empty for one without.
  std::map<std::string, std::string> parentOf_;
  double megabytes_ = 0;
};

/// Makes a joint a frame at the same place, so that what is placed by it stays there.
void becomeFrame(XMLElement& joint) {
  const std::string parent = childText(joint, "parent");
  joint.SetName("frame");
  joint.DeleteAttribute("type");
  if (!parent.empty()) joint.SetAttribute("attached_to", parent.c_str());
  for (XMLElement* child = joint.FirstChildElement(); child != nullptr;) {
    XMLElement* const next = child->NextSiblingElement();
    if (std::string_view(child->Name()) != "pose") joint.DeleteChild(child);
    child = next;
  }
}

/// Sets the lines of an element and of all in it, and makes frames of joints; collects the names of links.
void finishElement(XMLElement& element, int line, const UrdfParts& parts, std::set<std::string>& links) {
  const std::string_view kind = element.Name();
  const std::string name = nameOf(element);
  const bool isLink = kind == "link" || kind == "frame";
  if (isLink) links.insert(name);
  const auto& lines = kind == "joint" ? parts.joints : parts.links;
  const auto known = lines.find(name);
  if ((isLink || kind == "joint") && known != lines.end()) line = known->second;
  setSourceLine(element, line);
  if (kind == "joint" && parts.apart.contains(name)) becomeFrame(element);
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement())
    finishElement(*child, line, parts, links);
}

}  // namespace

robotlink::Errors checkUrdf(XMLElement& robot, const std::string& file, UrdfParts& parts, LeftOuts& leftOut) {
  robotlink::Errors errors;
  UrdfChecker(file, parts, errors, leftOut).check(robot);
  return errors;
}

void finishUrdf(XMLElement& sdf, const std::string& file, const UrdfParts& parts, LeftOuts& leftOut) {
  std::set<std::string> links;
  finishElement(sdf, parts.line, parts, links);
  for (const std::string& name : parts.moving) {
    if (links.contains(name)) continue;
    const std::string what = "link '" + name + "'";
    leaveOut(leftOut,
             {{file, parts.links.at(name), 0}, name, what, "it has no <inertial>, so it is no body"});
  }
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
