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

namespace widgets {

struct PixelValue;

/// The names of the colour classes that an image consists of, by their number: those of the true classes for
/// "<robot>/oracle/classes", those that its robot told with its regions for debug images (path
/// "<robot>/images/..."). Empty for all others, which are of colours or grey values.
std::vector<std::string> classNames(const robotlink::StreamStore& store, const std::string& path,
                                    const foxglove::RawImage& image, robotlink::Instant time);
/// What the classes are shown in: the field's colours of these names, else those of the classes of 2002, else
/// black; "unknown" is grey. The field may be null.
std::vector<robotlink::Rgb> classColors(const std::vector<std::string>& names,
                                        const robotlink::FieldDescription* field);
/// The class of a pixel: by its number or, where classes are shown by their colours, by the very colour.
std::string classNameOf(const PixelValue& pixel, const std::vector<std::string>& names,
                        const robotlink::FieldDescription* field);

}  // namespace widgets
