// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/SdfElements.h"

#include <tinyxml2.h>

#include <algorithm>
#include <sdf/Exception.hh>
#include <sdf/Param.hh>
#include <string_view>

#include "simcore/sdf/SceneFiles.h"
#include "simcore/sdf/SdfDescription.h"
#include "simcore/sdf/SdfPaths.h"
#include "simcore/sdf/SdfSpec.h"

namespace simcore {
namespace {

using tinyxml2::XMLElement;

/// libsdformat rejects bodies with unlikely inertias; therefore it does not see them, and readLink() reads
/// this.
constexpr const char* kHiddenInertial = "robotcontrol:inertial";

void setAttribute(sdf::Element& element, const std::string& key, const std::string& value) {
  if (!element.HasAttribute(key)) element.AddAttribute(key, "string", "", false);
  element.GetAttribute(key)->SetFromString(value);
}

void addAttributes(const XMLElement& source, const sdf::ElementPtr& description, sdf::Element& element) {
  if (description) {
    for (const sdf::ParamPtr& known : description->GetAttributes()) {
      element.AddAttribute(known->GetKey(), known->GetTypeName(), known->GetDefaultAsString(),
                           known->GetRequired());
    }
  }
  for (const auto* one = source.FirstAttribute(); one != nullptr; one = one->Next())
    setAttribute(element, one->Name(), one->Value());
}

void addValue(const XMLElement& source, const sdf::ElementPtr& description, sdf::Element& element) {
  const std::string text = trimmedText(&source);
  if (!description) {
    element.AddValue("string", text, false);
    element.GetValue()->SetFromString(text);
    return;
  }
  const sdf::ParamPtr known = description->GetValue();
  if (!known) return;
  element.AddValue(known->GetTypeName(), known->GetDefaultAsString(), false);
  if (!text.empty()) element.GetValue()->SetFromString(text);
}

/// Adds the children that SDFormat requires and the file lacks, with their defaults, as libsdformat does.
void addRequired(const sdf::ElementPtr& description, sdf::Element& element) {
  if (element.GetName() == "joint" || element.GetName() == "model") return;
  for (unsigned i = 0; i < description->GetElementDescriptionCount(); ++i) {
    const sdf::ElementPtr child = description->GetElementDescription(i);
    if (child->GetRequired() == "1" && !element.HasElement(child->GetName()))
      element.AddElement(child->GetName());
  }
}

}  // namespace

sdf::ElementPtr SdfElements::build(const XMLElement& source, const sdf::ElementPtr& description,
                                   const std::string& file) {
  if (++count_ > kMaxElements) return nullptr;
  const auto element = std::make_shared<sdf::Element>();
  element->SetName(source.Name());
  element->SetFilePath(file);
  element->SetLineNumber(sourceLine(source));
  element->SetExplicitlySetInFile(true);
  try {
    addAttributes(source, description, *element);
    addValue(source, description, *element);
  } catch (const sdf::Exception&) {
    // An assertion of libsdformat, which no element that was checked should trigger.
    errors_.push_back({"scene.sdf",
                       objectPath(source) + ": libsdformat cannot read this <" + source.Name() + ">",
                       {},
                       {file, sourceLine(source), 0}});
    return nullptr;
  }
  if (description) {
    for (unsigned i = 0; i < description->GetElementDescriptionCount(); ++i)
      element->AddElementDescription(description->GetElementDescription(i));
  }
  addChildren(source, description, *element, element, file);
  if (description) addRequired(description, *element);
  return element;
}

void SdfElements::addChildren(const XMLElement& source, const sdf::ElementPtr& description,
                              sdf::Element& parent, const sdf::ElementPtr& shared, const std::string& file) {
  const bool isWorld = std::string_view(source.Name()) == "world";
  for (auto* child = source.FirstChildElement(); child != nullptr; child = child->NextSiblingElement()) {
    const std::string_view name = child->Name();
    if (isWorld && skipModels_ && (name == "model" || name == "include")) continue;
    sdf::ElementPtr built;
    if (name == "include") {
      built = buildIncluded(*child, file);
    } else {
      sdf::ElementPtr known;
      if (name == "model") {
        known = spec_.description().text->Root()->GetElementDescription("model");
      } else if (description && name.find(':') == std::string_view::npos &&
                 description->HasElementDescription(child->Name())) {
        known = description->GetElementDescription(child->Name());
      }
      built = build(*child, known, file);
    }
    if (!built) continue;
    if (name == "inertial") built->SetName(kHiddenInertial);
    built->SetParent(shared);
    parent.InsertElement(built);
  }
}

sdf::ElementPtr SdfElements::buildIncluded(const XMLElement& include, const std::string& file) {
  const auto* path = files_.fileOf(include);
  const XMLElement* model = path != nullptr ? files_.model(*path) : nullptr;
  if (model == nullptr) return nullptr;
  const auto fail = [&](const std::string& text) {
    errors_.push_back(
        {"scene.include", objectPath(include) + ": " + text, {}, {file, sourceLine(include), 0}});
  };
  if (std::ranges::find(open_, *path) != open_.end()) {
    fail("the model includes itself: " + path->string());
    return nullptr;
  }
  if (open_.size() >= kMaxDepth) {
    fail("models are included too deeply");
    return nullptr;
  }
  open_.push_back(*path);
  const auto known = spec_.description().text->Root()->GetElementDescription("model");
  const sdf::ElementPtr built = build(*model, known, path->string());
  open_.pop_back();
  if (!built) return nullptr;
  const std::string name = childText(include, "name");
  if (!name.empty()) setAttribute(*built, "name", name);
  const std::string placement = childText(include, "placement_frame");
  if (!placement.empty()) setAttribute(*built, "placement_frame", placement);
  for (const char* key : {"pose", "static"}) {
    const XMLElement* own = include.FirstChildElement(key);
    if (own == nullptr) continue;
    if (built->HasElement(key)) built->RemoveChild(built->FindElement(key));
    const sdf::ElementPtr added = build(*own, known->GetElementDescription(key), file);
    if (!added) return nullptr;
    added->SetParent(built);
    built->InsertElement(added);
  }
  return built;
}

sdf::ElementPtr SdfElements::root(const sdf::ElementPtr& content) const {
  const auto root = std::make_shared<sdf::Element>();
  root->SetName("sdf");
  root->AddAttribute("version", "string", "1.9", true);
  if (content) {
    content->SetParent(root);
    root->InsertElement(content);
  }
  return root;
}

sdf::ElementPtr SdfElements::modelRoot(const XMLElement& model, const std::string& file) {
  const auto known = spec_.description().text->Root()->GetElementDescription("model");
  open_ = {file};
  skipModels_ = false;
  count_ = 0;
  const sdf::ElementPtr result = root(build(model, known, file));
  if (count_ > kMaxElements)
    errors_.push_back({"scene.size", "the model has too many parts", {}, {file, sourceLine(model), 0}});
  return result;
}

sdf::ElementPtr SdfElements::worldRoot(const XMLElement& world, const std::string& file, bool whole) {
  const auto known = spec_.description().text->Root()->GetElementDescription("world");
  open_ = {file};
  skipModels_ = !whole;
  count_ = 0;
  const sdf::ElementPtr result = root(build(world, known, file));
  if (count_ > kMaxElements)
    errors_.push_back({"scene.size", "the world has too many parts", {}, {file, sourceLine(world), 0}});
  return result;
}

}  // namespace simcore
