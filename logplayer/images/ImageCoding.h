// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"

namespace foxglove {
class CompressedImage;
class RawImage;
}  // namespace foxglove

namespace logplayer {

// Encoding and decoding of images as JPEG and PNG (libturbojpeg, libpng). Images of more than 64 megapixels
// are not decoded. All functions may be called from any thread.

/// Encodes as JPEG; `quality` is 1 to 100. The YCbCr values of a kYuyv image are encoded directly (4:2:2),
/// without a conversion to RGB.
robotlink::Result<std::vector<std::uint8_t>> encodeJpeg(const robotlink::ImageView& image, int quality = 90);
/// Encodes as PNG, in RGB or gray.
robotlink::Result<std::vector<std::uint8_t>> encodePng(const robotlink::ImageView& image);

/// Decodes a YCbCr JPEG to kYuyv (to kRgb8 if its width is odd, or its color is sampled in an unusual way), a
/// gray one to kMono8, any other to kRgb8. Missing parts of a truncated file are gray.
robotlink::Result<robotlink::Image> decodeJpeg(std::span<const std::uint8_t> data);
/// Decodes to kMono8 or kRgb8.
robotlink::Result<robotlink::Image> decodePng(std::span<const std::uint8_t> data);

/// The components of a JPEG of four a pixel (CMYK) as they were encoded, interleaved, without any color
/// conversion.
struct JpegQuads {
  int width = 0;
  int height = 0;
  /// width * height * 4 bytes, top row first.
  std::vector<std::uint8_t> data;
  /// The decoder's first warning; empty if the file is intact.
  std::string damage;
};
/// Fails for images of more than `maximumPixels` before it allocates memory for them.
robotlink::Result<JpegQuads> decodeJpegQuads(std::span<const std::uint8_t> data, std::size_t maximumPixels);

/// Conversions between compressed messages and raw ones as cameras publish them; timestamp and frame id are
/// kept.
robotlink::Result<std::shared_ptr<foxglove::RawImage>> rawImage(const foxglove::CompressedImage& image);
robotlink::Result<std::shared_ptr<foxglove::CompressedImage>> jpegImage(const foxglove::RawImage& image);
robotlink::Result<std::shared_ptr<foxglove::CompressedImage>> pngImage(const foxglove::RawImage& image);

}  // namespace logplayer
