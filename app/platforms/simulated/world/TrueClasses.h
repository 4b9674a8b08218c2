// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "colortool/image/ColorClasses.h"
#include "robotlink/base/Image.h"

namespace simcore {
struct RenderScene;
}

namespace app {

/// The true color classes of the surfaces of a simulated scene. Images of classes (the package
/// oracle/classes) are made from it, against which color tables are scored. The numbers are those of
/// colortool's preset "2002".
///
/// The class of a surface is the one with the name of the surface's color in the scene's palette ("orange"),
/// or else the one whose display color is that very color; light and shadow do not matter. All other
/// surfaces, and the background, are kBackground.
///
/// A camera's image is in YCbCr 4:2:2, so two neighbors share their chroma. Where they are of different
/// classes, their color is that of neither, and both are kIgnored. A plain value.
class TrueClasses {
 public:
  /// No class: any other surface, or none.
  static constexpr std::uint8_t kBackground = 0;
  /// A pixel that does not count.
  static constexpr std::uint8_t kIgnored = 255;

  /// The names of the numbers.
  static colortool::ColorClasses classes();

  explicit TrueClasses(const simcore::RenderScene& scene);

  /// The class of each instance of the scene, by its index.
  std::span<const std::uint8_t> ofInstances() const { return ofInstances_; }

  /// Sets pairs of pixels of different classes to kIgnored, in a kMono8 image of even width.
  static void ignoreMixedPairs(robotlink::Image& classes);

 private:
  std::vector<std::uint8_t> ofInstances_;
};

}  // namespace app
