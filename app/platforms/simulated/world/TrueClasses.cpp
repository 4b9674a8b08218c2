// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/world/TrueClasses.h"

#include "colortool/image/ClassPresets.h"
#include "simcore/world/RenderScene.h"

namespace app {
namespace {

/// The class of a surface by the name of its color, or else by the color itself.
std::uint8_t classOf(const simcore::RenderInstance& surface, const colortool::ColorClasses& classes) {
  if (const std::uint8_t named = classes.index(surface.colorName); named != TrueClasses::kBackground)
    return named;
  for (int i = 1; i < classes.size(); ++i) {
    if (classes.shownColor(i) == surface.color) return static_cast<std::uint8_t>(i);
  }
  return TrueClasses::kBackground;
}

}  // namespace

colortool::ColorClasses TrueClasses::classes() {
  return colortool::findClassPreset("2002")->classes();
}

TrueClasses::TrueClasses(const simcore::RenderScene& scene) {
  const colortool::ColorClasses all = classes();
  for (const simcore::RenderInstance& instance : scene.instances)
    ofInstances_.push_back(classOf(instance, all));
}

void TrueClasses::ignoreMixedPairs(robotlink::Image& classes) {
  for (std::size_t i = 0; i + 1 < classes.data.size(); i += 2) {
    if (classes.data[i] != classes.data[i + 1]) classes.data[i] = classes.data[i + 1] = kIgnored;
  }
}

}  // namespace app
