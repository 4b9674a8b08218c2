// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/debugging/requests/SceneEditRequests.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "robotcontrol/Requests.pb.h"

namespace robotlink {

using robotcontrol::Request;

namespace {

bool isModelName(const std::string& name) {
  constexpr std::size_t kMaxName = 100;
  const auto fits = [](unsigned char c) { return c > ' ' && c != '/' && c != ':' && c != 0x7F; };
  return name.size() <= kMaxName && !name.starts_with("__") && std::ranges::all_of(name, fits);
}

/// A name for a model that is added, which may be empty.
std::string wrongModelName(const std::string& name) {
  return isModelName(name) ? ""
                           : "'" + name +
                                 "' is not a valid model name: use up to 100 letters, digits and signs, "
                                 "without blanks, slashes and colons, and no __ at the start";
}

std::string wrongAddition(const robotcontrol::AddModel& add) {
  if (add.model().empty()) return "the request must name the model to add";
  if (add.model().find("..") != std::string::npos && add.model().find("://") != std::string::npos)
    return "a model's URI must not lead out of its folder";
  if (!add.has_pose_in_field()) return "the request needs the place of the added model";
  const auto& pose = add.pose_in_field();
  const auto isNumber = [](double value) { return std::isfinite(value); };
  if (!std::ranges::all_of(std::array{pose.x(), pose.y(), pose.heading(), add.height()}, isNumber))
    return "the place of the added model has values that are not numbers";
  return wrongModelName(add.name());
}

}  // namespace

std::string wrongSceneEdit(const Request& request) {
  const auto& edit = request.edit_scene();
  switch (edit.what_case()) {
    case robotcontrol::EditScene::kAdd:
      return wrongAddition(edit.add());
    case robotcontrol::EditScene::kRemove:
      return edit.remove().model().empty() ? "the request must name the model to remove" : "";
    case robotcontrol::EditScene::kDuplicate:
      return edit.duplicate().model().empty() ? "the request must name the model to duplicate"
                                              : wrongModelName(edit.duplicate().name());
    case robotcontrol::EditScene::kUndo:
      return "";
    case robotcontrol::EditScene::WHAT_NOT_SET:
      break;
  }
  return "the request must say what to change in the scene";
}

std::string fileOfSceneEdit(const Request& request) {
  const std::string& model = request.edit_scene().add().model();
  const bool isFound = model.starts_with("model://") || model.starts_with("package://") ||
                       model.find_first_of("/.\\") == std::string::npos;
  return isFound ? std::string() : model;
}

}  // namespace robotlink
