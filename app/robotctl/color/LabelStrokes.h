// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/robotctl/color/ColorImages.h"
#include "colortool/image/ColorClasses.h"
#include "colortool/samples/StrokeList.h"

namespace app {

/// Strokes as an expert who knows the true class of each pixel would make them: up to `count` small discs in
/// each class of an image, spread over those of its pixels whose neighbors are of the class, too. Class 0 is
/// background; 255, and numbers without a name, are passed over.
std::vector<colortool::DiscStroke> strokesInside(const robotlink::Image& labels, const std::string& image,
                                                 const colortool::ColorClasses& classes, std::size_t count);

/// Makes strokes for all images that have a PNG of the same name in a folder of labels. Fails if none has.
robotlink::Result<std::vector<colortool::DiscStroke>> strokesOfLabels(const ColorImages& images,
                                                                      const std::filesystem::path& labels,
                                                                      const colortool::ColorClasses& classes,
                                                                      std::size_t count);

}  // namespace app
