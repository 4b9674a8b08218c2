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

/// The true color classes of a simulated scene, for images of classes (the package oracle/classes) that
/// color tables are scored against. Classes have the numbers of colortool's preset "2002". A pixel is of the
/// class that its surface's color has the name of in the scene's palette ("orange", however it looks there),
/// or else of the one that is shown in that very color, in light or shadow. On all other surfaces, and on
/// the background, it is kBackground.
///
/// A camera's image is in YCbCr 4:2:2: two neighbors share their chroma. Where they are of different
/// classes, their color is of neither, and both are kIgnored. A plain value.
class TrueClasses {
 public:
  static constexpr std::uint8_t kBackground = 0;
  static constexpr std::uint8_t kIgnored = 255;

  /// What the numbers stand for.
  static colortool::ColorClasses classes();

  explicit TrueClasses(const simcore::RenderScene& scene);

  /// By instance of the scene.
  std::span<const std::uint8_t> ofInstances() const { return ofInstances_; }

  /// A kMono8 image of an even width.
  static void ignoreMixedPairs(robotlink::Image& classes);

 private:
  std::vector<std::uint8_t> ofInstances_;
};

}  // namespace app
