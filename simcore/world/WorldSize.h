// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simcore/world/WorldDescription.h"

namespace simcore {

/// No scene has more parts, so that a small file whose models include each other many times is an error
/// instead of taking all memory.
inline constexpr std::size_t kMaxWorldParts = 200'000;

/// No more pairs of solids start inside each other, where each is counted from both of its models: the
/// contacts of a thousand bodies in one place would take gigabytes.
inline constexpr std::size_t kMaxOverlaps = 20'000;

/// The links, joints, sensors and shapes of a model.
inline std::size_t partCount(const ModelDescription& model) {
  std::size_t parts = model.links.size() + model.joints.size() + model.sensors.size();
  for (const LinkDescription& link : model.links) parts += link.collisions.size() + link.visuals.size();
  return parts;
}

/// The first model with which a world has more than `most` parts; null if it never has.
inline const ModelInstance* firstTooMany(const WorldDescription& world, std::size_t most = kMaxWorldParts) {
  std::size_t parts = 0;
  for (const ModelInstance& model : world.models) {
    parts += partCount(*model.type);
    if (parts > most) return &model;
  }
  return nullptr;
}

}  // namespace simcore
