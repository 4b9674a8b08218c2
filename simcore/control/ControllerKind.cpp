// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/control/ControllerKind.h"

#include <algorithm>
#include <set>

#include "robotlink/base/Registrations.h"

namespace simcore {
namespace {

robotlink::Registry<ControllerKind>& kindRegistry() {
  static robotlink::Registry<ControllerKind> registered(
      [](const ControllerKind& a, const ControllerKind& b) { return a.name < b.name; });
  return registered;
}

/// Names stand in paths and in scene files.
bool isPlainName(const std::string& name) {
  const auto fits = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  };
  return !name.empty() && std::ranges::all_of(name, fits);
}

std::string problemOfKind(const ControllerKind& kind) {
  if (!isPlainName(kind.name)) return "a name consists of letters, digits, _ and -";
  if (!kind.make) return "it needs a function that makes it";
  if (controllerKind(kind.name) != nullptr) return "there already is a controller of this name";
  std::set<std::string> names;
  for (const ControllerParameter& parameter : kind.parameters) {
    if (!isPlainName(parameter.name) || !names.insert(parameter.name).second)
      return "its parameter \"" + parameter.name + "\" has no name of its own";
  }
  return {};
}

}  // namespace

const std::vector<ControllerKind>& controllerKinds() {
  return kindRegistry().all();
}

const ControllerKind* controllerKind(const std::string& name) {
  const auto& all = controllerKinds();
  const auto found = std::ranges::find(all, name, &ControllerKind::name);
  return found == all.end() ? nullptr : &*found;
}

ControllerRegistration::ControllerRegistration(ControllerKind kind) {
  const std::string name = "controller \"" + kind.name + "\"";
  const std::string problem = problemOfKind(kind);
  kindRegistry().add(std::move(kind), name, problem);
}

}  // namespace simcore
