// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "logplayer/images/ImageCoding.h"
#include "tests/fuzz/FuzzTarget.h"
#include "tests/logplayer/bhuman/QueueBuilder.h"

namespace image_decoding_fuzz {

using namespace logplayer;
using robotlink::Image;
using robotlink::PixelFormat;

namespace {

void check(const robotlink::Result<Image>& image) {
  if (!image) return require(!image.error().text.empty(), "a refusal says why");
  const auto bytes = static_cast<std::size_t>(image->step()) * static_cast<std::size_t>(image->height);
  require(image->width > 0 && image->height > 0 && image->data.size() == bytes, "the data suits the size");
}

Image picture(int width, int height, PixelFormat format) {
  Image image(width, height, format);
  for (std::size_t i = 0; i < image.data.size(); ++i)
    image.data[i] = static_cast<std::uint8_t>(128 + 100 * std::sin(static_cast<double>(i) / 9));
  return image;
}

std::string fileText(const std::vector<std::uint8_t>& bytes) {
  return {bytes.begin(), bytes.end()};
}

}  // namespace

int runInput(const std::uint8_t* data, std::size_t size) {
  const std::span<const std::uint8_t> bytes(data, size);
  const auto quads = decodeJpegQuads(bytes, 1U << 16U);
  if (quads)
    require(quads->data.size() == static_cast<std::size_t>(quads->width * quads->height * 4),
            "the data suits the components");
  // Only the size of a large image is looked at, or a run would take hours.
  const bool large = !quads && quads.error().id == "image.size";
  if (!large || size % 16 == 0) check(decodeJpeg(bytes));
  check(decodePng(bytes));
  return 0;
}

std::vector<std::string> fuzzSeeds() {
  std::vector<std::string> seeds;
  for (const PixelFormat format : {PixelFormat::kYuyv, PixelFormat::kRgb8, PixelFormat::kMono8}) {
    const Image image = picture(26, 17, format);
    seeds.push_back(fileText(encodeJpeg(image.view()).value()));
    seeds.push_back(fileText(encodePng(image.view()).value()));
  }
  const Image image = picture(64, 8, PixelFormat::kMono8);
  seeds.push_back(fileText(bhuman::fourComponentJpeg(image.data, 16, 8)));
  return seeds;
}

const FuzzRegistration kTarget({"image_decoding", &fuzzSeeds, &runInput});

}  // namespace image_decoding_fuzz
