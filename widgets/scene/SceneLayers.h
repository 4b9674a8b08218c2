// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "widgets/scene/ForceMarkers.h"
#include "widgets/scene/SceneMarkers.h"
#include "widgets/scene/SensorMarkers.h"

class QPalette;

namespace widgets {

class SceneAssembly;
class SceneModes;
class ShownParts;

/// Adds to what a view shows the layers that are chosen: solids, forces, joints, frames, centers of mass,
/// sensors, names. Layers that are not chosen cost nothing. GUI thread.
class SceneLayers {
 public:
  /// The sources of the layers.
  struct Sources {
    robotlink::Session& session;
    const SceneState& scene;
    const ShownParts& parts;
    const SceneModes& modes;
    SceneAssembly& assembly;
    /// Solids that are shown in place of what is visible get its colors.
    const QPalette& palette;
    /// The selected object; empty: none.
    const std::string& selected;
  };

  /// `contents` has the visible shapes, which are taken away if they are not wanted.
  void add(const Sources& sources, VisibleScene& contents);
  /// The objects of the scene are others.
  void forget() { sensors_.clear(); }

 private:
  static void addSolids(const Sources& sources, VisibleScene& contents);
  void addMarkers(const Sources& sources, VisibleScene& contents);
  static void addNames(const Sources& sources, VisibleScene& contents);

  SceneMarkers markers_;
  SensorMarkers sensors_;
  ForceMarkers forces_;
};

}  // namespace widgets
