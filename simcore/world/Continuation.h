// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>

namespace simcore {

/// How a model stands and moves, with all its links. Immutable.
struct ModelMotion;

/// How a simulation continues in another scene.
struct Continuation {
  /// Whether it may have other sensors, cameras, servos and drives than before.
  bool otherPorts = false;
  /// Whether new models have to fit between those that are there now, instead of those at the start.
  bool fitsNow = false;
  /// New models that begin with a motion instead of at rest at their places, by name.
  std::map<std::string, std::shared_ptr<const ModelMotion>> motions = {};
};

}  // namespace simcore
