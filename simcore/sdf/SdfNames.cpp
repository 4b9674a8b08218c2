// SPDX-License-Identifier: GPL-3.0-or-later
// checkSdfNames() of SdfCheck.h: names, references, masses, sizes and inertias.
#include <tinyxml2.h>

#include <algorithm>
#include <initializer_list>
#include <set>
#include <sstream>
#include <string_view>

#include "simcore/sdf/SdfCheck.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

std::string textOf(const XMLElement* element) {
  return element != nullptr && element->GetText() != nullptr ? element->GetText() : "";
}

std::string nameOf(const XMLElement& element) {
  return element.Attribute("name") != nullptr ? element.Attribute("name") : "";
}

class NameChecker {
 public:
  NameChecker(const std::string& file, robotlink::Errors& errors) : file_(file), errors_(errors) {}

  void checkWorld(const XMLElement& world) {
    checkUnique(world, {"model", "light", "frame"});
    for (auto* model = world.FirstChildElement("model"); model != nullptr;
         model = model->NextSiblingElement("model")) {
      checkModel(*model);
    }
  }

  void checkModel(const XMLElement& model) {
    if (model.FirstChildElement("link") == nullptr) {
      fail(model, "scene.no-link", "the model '" + nameOf(model) + "' has no <link>");
    }
    // In SDFormat, all of these share one scope.
    checkUnique(model, {"link", "joint", "frame", "model"});
    std::set<std::string> links, joints;
    for (auto* link = model.FirstChildElement("link"); link != nullptr;
         link = link->NextSiblingElement("link")) {
      links.insert(nameOf(*link));
      checkLink(*link);
    }
    for (auto* joint = model.FirstChildElement("joint"); joint != nullptr;
         joint = joint->NextSiblingElement("joint")) {
      checkJoint(*joint, links);
      joints.insert(nameOf(*joint));
    }
    checkDrive(model.FirstChildElement("robotcontrol:drive"), joints);
  }

 private:
  void fail(const XMLElement& element, const char* id, const std::string& text) {
    errors_.push_back({id, text, {nameOf(element)}, {file_, element.GetLineNum(), 0}});
  }

  void checkUnique(const XMLElement& parent, std::initializer_list<std::string_view> elements) {
    std::set<std::string> names;
    for (auto* child = parent.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
      if (std::ranges::find(elements, std::string_view(child->Name())) == elements.end()) continue;
      const std::string name = nameOf(*child);
      if (!name.empty() && !names.insert(name).second) {
        fail(*child, "scene.duplicate-name", "the name '" + name + "' appears here twice");
      }
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

  void checkJoint(const XMLElement& joint, const std::set<std::string>& links) {
    const std::string type = joint.Attribute("type") != nullptr ? joint.Attribute("type") : "";
    if (type != "revolute" && type != "continuous" && type != "fixed") {
      fail(joint, "scene.joint-type",
           "of joints, only revolute, continuous and fixed ones are known, not '" + type + "'");
    }
    for (const char* end : {"parent", "child"}) {
      const XMLElement* element = joint.FirstChildElement(end);
      const std::string link = textOf(element);
      if (links.contains(link) || (link == "world" && std::string_view(end) == "parent")) continue;
      const std::string what = "the joint '" + nameOf(joint) + "' has ";
      if (element == nullptr) {
        fail(joint, "scene.joint", what + "no <" + end + ">");
      } else {
        fail(*element, "scene.joint",
             what + "as its " + end + " '" + link + "', which is not a link of the model");
      }
    }
  }

  void checkLink(const XMLElement& link) {
    checkUnique(link, {"collision"});
    checkUnique(link, {"visual"});
    checkUnique(link, {"sensor"});
    if (const XMLElement* inertial = link.FirstChildElement("inertial")) checkInertial(*inertial);
    for (const char* part : {"collision", "visual"}) {
      for (auto* element = link.FirstChildElement(part); element != nullptr;
           element = element->NextSiblingElement(part)) {
        checkSizes(*element);
      }
    }
  }

  void checkRange(const XMLElement& element, double minimum, double maximum, const char* unit) {
    std::istringstream stream(textOf(&element));
    for (double value = 0; stream >> value;) {
      if (value >= minimum && value <= maximum) continue;
      std::ostringstream text;
      text << "<" << element.Name() << "> must be between " << minimum << " and " << maximum << " " << unit;
      return fail(element, "scene.range", text.str());
    }
  }

  void checkInertial(const XMLElement& inertial) {
    if (const XMLElement* mass = inertial.FirstChildElement("mass")) checkRange(*mass, 1e-6, 1e4, "kg");
    const XMLElement* inertia = inertial.FirstChildElement("inertia");
    if (inertia == nullptr) return;
    double moments[3] = {1, 1, 1};
    const char* const names[] = {"ixx", "iyy", "izz"};
    for (int i = 0; i < 3; ++i) {
      const XMLElement* element = inertia->FirstChildElement(names[i]);
      if (element == nullptr) continue;
      checkRange(*element, 1e-12, 1e6, "kg m^2");
      moments[i] = std::atof(textOf(element).c_str());
    }
    for (int i = 0; i < 3; ++i) {
      if (moments[i] <= (moments[(i + 1) % 3] + moments[(i + 2) % 3]) * 1.001) continue;
      fail(*inertia, "scene.inertia",
           std::string("no body has such moments: ") + names[i] + " exceeds the sum of the other two");
    }
  }

  void checkSizes(const XMLElement& solid) {
    const XMLElement* geometry = solid.FirstChildElement("geometry");
    const XMLElement* shape = geometry != nullptr ? geometry->FirstChildElement() : nullptr;
    if (shape == nullptr)
      return fail(solid, "scene.geometry", "'" + nameOf(solid) + "' has no shape in its <geometry>");
    for (const char* size : {"size", "radius", "length", "radii"}) {
      if (const XMLElement* element = shape->FirstChildElement(size)) checkRange(*element, 1e-5, 1000, "m");
    }
  }

  const std::string& file_;
  robotlink::Errors& errors_;
};

}  // namespace

void checkSdfNames(const XMLElement& root, const std::string& file, robotlink::Errors& errors) {
  NameChecker checker(file, errors);
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
