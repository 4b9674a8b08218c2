// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "colortool/samples/Samples.h"

namespace colortool {

/// An image with four quarters: orange, green, white and a gray wall. `darker` is subtracted from Y.
inline ColorImage quarters(int width = 40, int height = 30, int darker = 0) {
  ColorImage image(width, height);
  const auto shade = [&](int y) { return static_cast<std::uint8_t>(y - darker); };
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const bool left = x < width / 2, upper = y < height / 2;
      const robotlink::YCbCr color =
          upper ? (left ? robotlink::YCbCr{shade(140), 60, 200} : robotlink::YCbCr{shade(90), 110, 90})
                : (left ? robotlink::YCbCr{shade(220), 128, 128} : robotlink::YCbCr{shade(110), 132, 126});
      image.pixels[static_cast<std::size_t>(y * width + x)] = color;
    }
  }
  return image;
}

inline Samples emptySamples() {
  Samples samples;
  samples.classes =
      ColorClasses({{"orange", {255, 128, 0}}, {"green", {0, 160, 40}}, {"white", {255, 255, 255}}});
  return samples;
}

inline SampleImage placeOf(const std::string& name, const std::string& camera = "nao") {
  return {0, name, camera, "", 0, 0};
}

/// A disc of 29 pixels.
inline PixelArea disc(const ColorImage& image, double x, double y) {
  const ImagePoint at[] = {{x, y}};
  return brushArea(image.width, image.height, at, 3);
}

/// One stroke in each quarter of an image; the wall is background.
inline Samples quarterSamples() {
  Samples samples = emptySamples();
  const ColorImage image = quarters();
  addStroke(samples, placeOf("a"), image, disc(image, 8, 7), {1, false, 1, "brush"});
  addStroke(samples, placeOf("a"), image, disc(image, 30, 7), {2, false, 1, "brush"});
  addStroke(samples, placeOf("a"), image, disc(image, 8, 22), {3, false, 1, "brush"});
  addStroke(samples, placeOf("a"), image, disc(image, 30, 22), {0, false, 1, "brush"});
  return samples;
}

}  // namespace colortool
