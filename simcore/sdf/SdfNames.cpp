// SPDX-License-Identifier: GPL-3.0-or-later
// checkSdfNames() of SdfCheck.h: names, references, masses, sizes and inertias.
#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <initializer_list>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <vector>

#include "robotlink/base/Spelling.h"
#include "simcore/sdf/SdfCheck.h"
#include "simcore/sdf/SdfPaths.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

/// Links, joints and frames of one model.
constexpr std::size_t kMaxFrames = 5000;

std::string textOf(const XMLElement* element) {
  return trimmedText(element);
}

class NameChecker {
 public:
  NameChecker(const std::string& file, robotlink::Errors& errors, LeftOuts& leftOut)
      : file_(file), errors_(errors), leftOut_(leftOut) {}

  void checkWorld(XMLElement& world) {
    checkCount(world);
    forEach(world, "include",
            [&](const XMLElement& include) { checkPathPart(include, childText(include, "name")); });
    checkUnique(world, {"model", "light", "frame"});
    const Scope scope = scopeOf(world, {"model", "frame"}, {"world"});
    for (const char* part : {"model", "frame", "light", "include"})
      forEach(world, part, [&](XMLElement& child) { checkFrames(child, scope); });
    forEach(world, "model", [&](XMLElement& model) { checkModel(model); });
  }

  void checkModel(XMLElement& model) {
    checkCount(model);
    checkPathPart(model, nameOf(model));
    for (const char* part : {"link", "joint"})
      forEach(model, part, [&](XMLElement& child) {
        checkPathPart(child, nameOf(child));
        forEach(child, "sensor", [&](XMLElement& sensor) { checkPathPart(sensor, nameOf(sensor)); });
      });
    const bool hasParts = model.FirstChildElement("link") != nullptr ||
                          model.FirstChildElement("model") != nullptr ||
                          model.FirstChildElement("include") != nullptr;
    if (!hasParts) fail(model, "scene.no-link", "the model '" + nameOf(model) + "' has no <link>");
    // In SDFormat, all of these share one scope.
    checkUnique(model, {"link", "joint", "frame", "model"});
    const Scope scope = scopeOf(model, {"link", "joint", "frame", "model"}, {"__model__"});
    for (const char* part : {"link", "joint", "frame", "model", "include"})
      forEach(model, part, [&](XMLElement& child) { checkFrames(child, scope); });
    for (const char* attribute : {"canonical_link", "placement_frame"}) checkFrame(model, attribute, scope);
    std::set<std::string> joints;
    forEach(model, "joint", [&](XMLElement& joint) { joints.insert(nameOf(joint)); });
    std::set<std::string> parts = joints;
    parts.insert("__model__");
    forEach(model, "link", [&](XMLElement& link) {
      checkLink(link);
      parts.insert(nameOf(link));
    });
    forEach(model, "joint", [&](XMLElement& joint) { checkJoint(joint, model, parts); });
    forEach(model, "model", [&](XMLElement& nested) { checkModel(nested); });
    checkDrive(model.FirstChildElement("robotcontrol:drive"), joints);
  }

 private:
  /// Names are parts of the paths of ports.
  void checkPathPart(const XMLElement& element, const std::string& name) {
    if (name.find('/') == std::string::npos) return;
    fail(element, "scene.name",
         "the name '" + name +
             "' must not contain a slash, which separates the parts of a path: MODEL/SENSOR");
  }

  /// The names that may be used in a world or a model; unset if there are some that only libsdformat knows.
  using Scope = std::optional<std::set<std::string>>;

  void fail(const XMLElement& element, const char* id, const std::string& text) {
    const std::string path = objectPath(element);
    errors_.push_back(
        {id, path.empty() ? text : path + ": " + text, {nameOf(element)}, {file_, sourceLine(element), 0}});
  }
  void omit(const XMLElement& element, const std::string& what, const std::string& why) {
    leaveOut(leftOut_, {{file_, sourceLine(element), 0}, objectPath(element), what, why});
  }
  template <typename Use>
  static void forEach(XMLElement& parent, const char* name, Use use) {
    for (auto* child = parent.FirstChildElement(name); child != nullptr;
         child = child->NextSiblingElement(name)) {
      use(*child);
    }
  }

  static Scope scopeOf(XMLElement& parent, std::initializer_list<const char*> parts,
                       std::initializer_list<const char*> more) {
    std::set<std::string> names(more.begin(), more.end());
    for (const char* part : parts) forEach(parent, part, [&](XMLElement& one) { names.insert(nameOf(one)); });
    bool areKnown = true;
    forEach(parent, "include", [&](const XMLElement& include) {
      const std::string name = childText(include, "name");
      areKnown = areKnown && !name.empty();
      names.insert(name);
    });
    return areKnown ? Scope(std::move(names)) : std::nullopt;
  }

  /// Frames that an element and what is in it name; those in nested models have their own scope.
  void checkFrames(XMLElement& element, const Scope& scope) {
    const std::string_view name = element.Name();
    for (const char* attribute : {"relative_to", "attached_to", "expressed_in"})
      checkFrame(element, attribute, scope);
    const bool isScope = name == "model" || name == "include";
    for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      if (!isScope || std::string_view(child->Name()) == "pose") checkFrames(*child, scope);
    }
  }

  /// Reports and removes a wrong attribute, so that the rest is read.
  void checkFrame(XMLElement& element, const char* attribute, const Scope& scope) {
    const std::string frame = element.Attribute(attribute) != nullptr ? element.Attribute(attribute) : "";
    const bool isElsewhere = frame.find("::") != std::string::npos || frame.starts_with("__");
    if (frame.empty() || isElsewhere || !scope || scope->contains(frame)) return;
    const auto nearest = robotlink::nearest(frame, {scope->begin(), scope->end()});
    fail(element, "scene.frame",
         "there is no frame '" + frame + "' here, which " + attribute + " names" +
             (nearest.empty() ? "" : "; is '" + nearest + "' meant?"));
    element.DeleteAttribute(attribute);
  }

  /// libsdformat takes time with the square of the number of frames in a chain.
  void checkCount(const XMLElement& parent) {
    std::size_t count = 0;
    for (auto* child = parent.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      const std::string_view name = child->Name();
      if (name == "link" || name == "joint" || name == "frame") ++count;
    }
    if (count <= kMaxFrames) return;
    fail(parent, "scene.size",
         "there are " + std::to_string(count) + " links, joints and frames here; at most " +
             std::to_string(kMaxFrames) + " can be in one <" + parent.Name() + ">");
  }

  /// Reports and removes elements that repeat a name, so that the rest is read.
  void checkUnique(XMLElement& parent, std::initializer_list<std::string_view> elements) {
    std::set<std::string> names;
    for (auto* child = parent.FirstChildElement(); child != nullptr;) {
      XMLElement* const next = child->NextSiblingElement();
      const bool counts = std::ranges::find(elements, std::string_view(child->Name())) != elements.end();
      const std::string name = nameOf(*child);
      if (counts && !name.empty() && !names.insert(name).second) {
        fail(*child, "scene.duplicate-name", "the name '" + name + "' appears here twice");
        parent.DeleteChild(child);
      }
      child = next;
    }
  }

  void checkDrive(const XMLElement* drive, const std::set<std::string>& joints) {
    if (drive == nullptr) return;
    for (auto* wheel = drive->FirstChildElement(); wheel != nullptr; wheel = wheel->NextSiblingElement()) {
      const std::string_view name = wheel->Name();
      if (name != "robotcontrol:left" && name != "robotcontrol:right") continue;
      if (joints.contains(textOf(wheel))) continue;
      fail(*wheel, "scene.drive", "the model has no joint '" + textOf(wheel) + "' for its drive");
    }
  }

  /// Names of links are looked up here only where a model has no other frames and parts; otherwise
  /// libsdformat resolves them.
  void checkJoint(XMLElement& joint, const XMLElement& model, const std::set<std::string>& parts) {
    for (const char* axis : {"axis", "axis2"})
      forEach(joint, axis, [&](XMLElement& one) { checkAxis(one.FirstChildElement("xyz")); });
    const bool simple = model.FirstChildElement("model") == nullptr &&
                        model.FirstChildElement("include") == nullptr &&
                        model.FirstChildElement("frame") == nullptr;
    for (const char* end : {"parent", "child"}) {
      const XMLElement* element = joint.FirstChildElement(end);
      const std::string what = "the joint '" + nameOf(joint) + "' has ";
      if (element == nullptr) {
        fail(joint, "scene.joint", what + "no <" + end + ">");
        continue;
      }
      const std::string link = textOf(element);
      if (!simple || link == "world" || parts.contains(link)) continue;
      fail(*element, "scene.joint",
           what + "as its " + end + " '" + link + "', which is not a link of the model");
    }
  }

  void checkAxis(XMLElement* xyz) {
    const std::vector<std::string> words = xyz != nullptr ? wordsOf(*xyz) : std::vector<std::string>();
    if (words.empty() ||
        std::ranges::any_of(words, [](const auto& one) { return std::atof(one.c_str()) != 0; }))
      return;
    fail(*xyz, "scene.axis", "an axis must be a vector that is not 0 0 0");
    xyz->SetText("0 0 1");
  }

  void checkLink(XMLElement& link) {
    checkUnique(link, {"collision"});
    checkUnique(link, {"visual"});
    checkUnique(link, {"sensor"});
    if (XMLElement* inertial = link.FirstChildElement("inertial")) checkInertial(*inertial);
    for (const char* part : {"collision", "visual"})
      forEach(link, part, [&](XMLElement& element) { checkSizes(element); });
  }

  /// A wrong value is reported and removed, so that the rest is read.
  void checkRange(XMLElement& element, double minimum, double maximum, const char* unit) {
    std::istringstream stream(textOf(&element));
    for (double value = 0; stream >> value;) {
      if (value >= minimum && value <= maximum) continue;
      std::ostringstream text;
      text << "<" << element.Name() << "> must be between " << minimum << " and " << maximum << " " << unit
           << ", not " << value;
      fail(element, "scene.range", text.str());
      element.Parent()->DeleteChild(&element);
      return;
    }
  }

  void checkInertial(XMLElement& inertial) {
    if (XMLElement* mass = inertial.FirstChildElement("mass")) checkRange(*mass, 0, 1e9, "kg");
    XMLElement* inertia = inertial.FirstChildElement("inertia");
    if (inertia == nullptr) return;
    double moments[3] = {1, 1, 1};
    const char* const names[] = {"ixx", "iyy", "izz"};
    for (int i = 0; i < 3; ++i) {
      XMLElement* element = inertia->FirstChildElement(names[i]);
      if (element == nullptr) continue;
      moments[i] = std::atof(textOf(element).c_str());
      checkRange(*element, 0, 1e12, "kg m^2");
    }
    for (int i = 0; i < 3; ++i) {
      if (moments[i] <= (moments[(i + 1) % 3] + moments[(i + 2) % 3]) * 1.001) continue;
      omit(*inertia, "<inertia>",
           std::string("no body has such moments: ") + names[i] +
               " exceeds the sum of the other two; they are used as they are");
    }
  }

  void checkSizes(XMLElement& solid) {
    XMLElement* geometry = solid.FirstChildElement("geometry");
    XMLElement* shape = geometry != nullptr ? geometry->FirstChildElement() : nullptr;
    if (shape == nullptr)
      return fail(solid, "scene.geometry", "'" + nameOf(solid) + "' has no shape in its <geometry>");
    // The size of a heightmap's or a mesh's texture is no edge.
    const std::string_view kind = shape->Name();
    if (kind == "heightmap" || kind == "mesh" || kind == "image") return;
    for (const char* size : {"size", "radius", "length", "radii"}) {
      if (XMLElement* element = shape->FirstChildElement(size)) checkRange(*element, 1e-6, 1e5, "m");
    }
  }

  const std::string& file_;
  robotlink::Errors& errors_;
  LeftOuts& leftOut_;
};

}  // namespace

void checkSdfNames(XMLElement& root, const std::string& file, robotlink::Errors& errors, LeftOuts& leftOut) {
  NameChecker checker(file, errors, leftOut);
  for (auto* world = root.FirstChildElement("world"); world != nullptr;
       world = world->NextSiblingElement("world")) {
    checker.checkWorld(*world);
  }
  for (auto* model = root.FirstChildElement("model"); model != nullptr;
       model = model->NextSiblingElement("model")) {
    checker.checkModel(*model);
  }
}

}  // namespace simcore
