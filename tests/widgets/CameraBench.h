// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>

#include "foxglove/Image.pb.h"
#include "robotlink/packages/Conversions.h"
#include "tests/colortool/SampleFixture.h"
#include "tests/widgets/FieldBench.h"
#include "widgets/color/ColorBench.h"

namespace widgets::test {

/// A bench whose robot's camera shows four quarters: orange, green, white and a gray wall
/// (SampleFixture.h).
class CameraBench : public FieldBench {
 public:
  static constexpr char kStream[] = "red1/camera/image";

  static std::shared_ptr<const foxglove::RawImage> image(int width = 40, int height = 30, int darker = 0) {
    const colortool::ColorImage colors = colortool::quarters(width, height, darker);
    robotlink::Image yuyv(width, height, robotlink::PixelFormat::kYuyv);
    std::uint8_t* to = yuyv.data.data();
    for (std::size_t i = 0; i + 1 < colors.pixels.size(); i += 2) {
      for (const std::uint8_t value :
           {colors.pixels[i].y, colors.pixels[i].cb, colors.pixels[i + 1].y, colors.pixels[i].cr})
        *to++ = value;
    }
    auto message = std::make_shared<foxglove::RawImage>();
    robotlink::assign(*message, yuyv.view(), {}, "camera");
    return message;
  }
  ColorFramePtr frame(int width = 40, int height = 30, int darker = 0) const {
    return std::make_shared<ColorFrame>(image(width, height, darker), kStream, "", now());
  }
  /// Publishes an image.
  void show(int width = 40, int height = 30, int darker = 0) {
    push(kStream, image(width, height, darker));
    advance();
  }
};

}  // namespace widgets::test
