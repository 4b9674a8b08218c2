// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfUpgrade.h"

#include <tinyxml2.h>

#include <cstdlib>
#include <string_view>

#include "simcore/sdf/SdfPaths.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

/// The child of this name, added if it does not exist.
XMLElement& childOf(XMLElement& element, const char* name) {
  if (XMLElement* found = element.FirstChildElement(name)) return *found;
  XMLElement* added = element.GetDocument()->NewElement(name);
  element.InsertEndChild(added);
  return *added;
}

void removeAll(XMLElement& element, const char* name) {
  while (XMLElement* child = element.FirstChildElement(name)) element.DeleteChild(child);
}

/// Up to version 1.6 a pose could have an attribute `frame`, and an axis the element
/// `use_parent_model_frame`; up to 1.4 axes were always in the model's frame.
void upgradeAxis(XMLElement& axis, int minor) {
  const XMLElement* flag = axis.FirstChildElement("use_parent_model_frame");
  const bool inModel = flag != nullptr ? isTrue(trimmedText(flag)) : minor <= 4;
  removeAll(axis, "use_parent_model_frame");
  removeAll(axis, "initial_position");
  XMLElement* direction = axis.FirstChildElement("xyz");
  if (inModel && direction != nullptr) direction->SetAttribute("expressed_in", "__model__");
}

void copyNumber(const XMLElement& from, const char* name, XMLElement& to) {
  const XMLElement* value = from.FirstChildElement(name);
  if (value != nullptr) childOf(to, name).SetText(trimmedText(value).c_str());
}

/// In version 1.4 the axes of an IMU shared their noise.
void upgradeImu(XMLElement& imu) {
  XMLElement* noise = imu.FirstChildElement("noise");
  if (noise == nullptr) return;
  const std::string type = childText(*noise, "type");
  for (const auto& [from, to] : {std::pair("rate", "angular_velocity"), {"accel", "linear_acceleration"}}) {
    const XMLElement* shared = noise->FirstChildElement(from);
    if (shared == nullptr) continue;
    for (const char* axis : {"x", "y", "z"}) {
      XMLElement& own = childOf(childOf(childOf(imu, to), axis), "noise");
      own.SetAttribute("type", type.empty() ? "gaussian" : type.c_str());
      for (const char* name : {"mean", "stddev", "bias_mean", "bias_stddev"}) copyNumber(*shared, name, own);
    }
  }
  removeAll(imu, "noise");
}

void upgradeWorld(XMLElement& world) {
  XMLElement* physics = world.FirstChildElement("physics");
  XMLElement* gravity = physics != nullptr ? physics->FirstChildElement("gravity") : nullptr;
  if (gravity == nullptr) return;
  childOf(world, "gravity").SetText(trimmedText(gravity).c_str());
  physics->DeleteChild(gravity);
}

/// Names with "::" were written by programs that flattened nested models; in 1.8 and later they denote parts
/// of nested models.
void unscope(XMLElement& element) {
  const auto plain = [](std::string text) {
    for (std::size_t at = text.find("::"); at != std::string::npos; at = text.find("::", at)) {
      text.erase(at, 1);
      text[at] = '_';
    }
    return text;
  };
  for (const char* key : {"name", "relative_to", "expressed_in"}) {
    if (const char* value = element.Attribute(key)) element.SetAttribute(key, plain(value).c_str());
  }
  const std::string_view name = element.Name();
  if (name == "parent" || name == "child" || name == "collision") {
    const std::string text = trimmedText(&element);
    if (text.find("::") != std::string::npos) element.SetText(plain(text).c_str());
  }
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    unscope(*child);
  }
}

bool hasScopedName(const XMLElement& element) {
  const std::string_view name = element.Name();
  if ((name == "link" || name == "joint") && nameOf(element).find("::") != std::string::npos) return true;
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    if (hasScopedName(*child)) return true;
  }
  return false;
}

void upgradeElement(XMLElement& element, int minor) {
  const std::string_view name = element.Name();
  if (name == "pose" && minor <= 6 && element.Attribute("frame") != nullptr) {
    const std::string frame = element.Attribute("frame");
    element.DeleteAttribute("frame");
    if (!frame.empty()) element.SetAttribute("relative_to", frame.c_str());
  } else if (name == "axis" || name == "axis2") {
    upgradeAxis(element, minor);
  } else if (name == "imu" && minor <= 5) {
    upgradeImu(element);
  } else if (name == "world" && minor <= 5) {
    upgradeWorld(element);
  }
  for (auto* child = element.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    upgradeElement(*child, minor);
  }
}

}  // namespace

int sdfMinorVersion(const std::string& version) {
  if (!version.starts_with("1.")) return -1;
  char* end = nullptr;
  const long minor = std::strtol(version.c_str() + 2, &end, 10);
  return end != version.c_str() + 2 && (*end == '\0' || *end == '.') && minor >= 0 && minor < 100
             ? static_cast<int>(minor)
             : -1;
}

void upgradeSdf(tinyxml2::XMLDocument& document, int minor) {
  XMLElement* root = document.RootElement();
  if (root == nullptr) return;
  upgradeElement(*root, minor);
  if (minor <= 7 && hasScopedName(*root)) unscope(*root);
  root->SetAttribute("version", "1.9");
}

}  // namespace simcore
