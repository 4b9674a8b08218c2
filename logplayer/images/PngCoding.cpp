// SPDX-License-Identifier: GPL-3.0-or-later
// The PNG functions of ImageCoding.h, by libpng.
#include <png.h>

#include "logplayer/images/ImageCoding.h"

namespace logplayer {
namespace {

using robotlink::Image;
using robotlink::ImageView;
using robotlink::PixelFormat;
using robotlink::Result;

constexpr std::size_t kMaxPngPixels = 64U << 20U;

/// The state of libpng for one image; its simplified API handles longjmp internally.
struct PngImage : png_image {
  PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
  ~PngImage() { png_image_free(this); }
  PngImage(const PngImage&) = delete;
  PngImage& operator=(const PngImage&) = delete;

  std::string text() const { return message; }
};

tl::unexpected<robotlink::Error> refused(const PngImage& png) {
  return robotlink::failure("image.png", "this is not a readable PNG image: " + png.text());
}

}  // namespace

Result<std::vector<std::uint8_t>> encodePng(const ImageView& image) {
  if (image.empty()) return robotlink::failure("image.empty", "an image without pixels cannot be coded");
  if (image.format != PixelFormat::kRgb8 && image.format != PixelFormat::kMono8)
    return encodePng(robotlink::toRgbImage(image).view());
  PngImage png;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = image.format == PixelFormat::kRgb8 ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  png.flags = PNG_IMAGE_FLAG_FAST;
  std::vector<std::uint8_t> data(PNG_IMAGE_PNG_SIZE_MAX(png));
  png_alloc_size_t size = data.size();
  if (png_image_write_to_memory(&png, data.data(), &size, 0, image.data, image.step, nullptr) == 0)
    return robotlink::failure("image.png", "the image cannot be coded as PNG: " + png.text());
  data.resize(size);
  data.shrink_to_fit();
  return data;
}

Result<Image> decodePng(std::span<const std::uint8_t> data) {
  PngImage png;
  if (png_image_begin_read_from_memory(&png, data.data(), data.size()) == 0) return refused(png);
  if (std::size_t{png.width} * png.height > kMaxPngPixels)
    return robotlink::failure("image.size", "the PNG image states " + std::to_string(png.width) + " x " +
                                                std::to_string(png.height) +
                                                " pixels, which is not decoded; at most " +
                                                std::to_string(kMaxPngPixels) + " are");
  const bool color = (png.format & PNG_FORMAT_FLAG_COLOR) != 0;
  png.format = color ? PNG_FORMAT_RGB : PNG_FORMAT_GRAY;
  Image image(static_cast<int>(png.width), static_cast<int>(png.height),
              color ? PixelFormat::kRgb8 : PixelFormat::kMono8);
  if (png_image_finish_read(&png, nullptr, image.data.data(), image.step(), nullptr) == 0)
    return refused(png);
  return image;
}

}  // namespace logplayer
