// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "robotlink/base/Clock.h"
#include "robotlink/base/Image.h"

namespace foxglove {
class RawImage;
}
namespace robotlink {
class StreamStore;
struct FieldDescription;
}  // namespace robotlink

// Names and colors of the classes in segmented images.
namespace widgets {

struct PixelValue;

/// Names of the color classes by their numbers, if the image consists of classes: the true classes for
/// "<robot>/oracle/classes", those that the robot published with its regions for debug images
/// ("<robot>/images/..."). Empty for images of colors or gray values.
std::vector<std::string> classNames(const robotlink::StreamStore& store, const std::string& path,
                                    const foxglove::RawImage& image, robotlink::Instant time);
/// Colors in which the classes are shown: the field's color of the same name, else that of the class preset
/// of 2002, else black; "unknown" is gray. `field` may be null.
std::vector<robotlink::Rgb> classColors(const std::vector<std::string>& names,
                                        const robotlink::FieldDescription* field);
/// The class of a pixel, by its number or, where classes are shown by their colors, by exactly this color.
/// Empty: none.
std::string classNameOf(const PixelValue& pixel, const std::vector<std::string>& names,
                        const robotlink::FieldDescription* field);

}  // namespace widgets
