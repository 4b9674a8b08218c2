// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/SdfCheck.h"

#include <tinyxml2.h>

#include <set>

namespace simcore {
namespace {

using tinyxml2::XMLElement;

void checkJoint(const XMLElement& joint, const std::set<std::string>& links, const std::string& file,
                robotlink::Errors& errors) {
  for (const char* end : {"parent", "child"}) {
    const XMLElement* element = joint.FirstChildElement(end);
    const std::string name = element != nullptr && element->GetText() != nullptr ? element->GetText() : "";
    if (links.contains(name) || (name == "world" && std::string(end) == "parent")) continue;
    const int line = element != nullptr ? element->GetLineNum() : joint.GetLineNum();
    errors.push_back({"scene.joint",
                      std::string("the joint's ") + end + " '" + name + "' is no link of the model",
                      {name},
                      {file, line, 0}});
  }
}

void checkModel(const XMLElement& model, const std::string& file, robotlink::Errors& errors) {
  std::set<std::string> links;
  for (auto* link = model.FirstChildElement("link"); link != nullptr;
       link = link->NextSiblingElement("link")) {
    if (link->Attribute("name") != nullptr) links.insert(link->Attribute("name"));
  }
  for (auto* joint = model.FirstChildElement("joint"); joint != nullptr;
       joint = joint->NextSiblingElement("joint")) {
    checkJoint(*joint, links, file, errors);
  }
}

}  // namespace

void checkSdfTree(const tinyxml2::XMLDocument& document, const std::string& file, robotlink::Errors& errors) {
  const XMLElement* root = document.RootElement();
  if (root == nullptr) return;
  if (const XMLElement* model = root->FirstChildElement("model")) checkModel(*model, file, errors);
}

}  // namespace simcore
