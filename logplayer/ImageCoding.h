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

// Images as JPEG and PNG (libjpeg-turbo, libpng). Nothing larger than 64 megapixels is decoded. All functions
// from any thread.

/// JPEG keeps the YCbCr values of a Yuyv image as they are (4:2:2), but for the loss of the coding.
robotlink::Result<std::vector<std::uint8_t>> encodeJpeg(const robotlink::ImageView& image, int quality = 90);
/// PNG is RGB or grey.
robotlink::Result<std::vector<std::uint8_t>> encodePng(const robotlink::ImageView& image);

/// A YCbCr JPEG becomes Yuyv (RGB if its width is odd), a grey one Mono8, anything else RGB. What a cut file
/// lacks is grey.
robotlink::Result<robotlink::Image> decodeJpeg(std::span<const std::uint8_t> data);
robotlink::Result<robotlink::Image> decodePng(std::span<const std::uint8_t> data);

/// The components of a JPEG as they were coded, interleaved, whatever its header says they mean.
struct JpegComponents {
  int width = 0;
  int height = 0;
  int count = 0;  ///< per pixel, 1 to 4
  std::vector<std::uint8_t> data;
  std::string damage;  ///< what the decoder complained about, in its words; empty if it is whole
};
/// Refuses an image of more than `maximumPixels` before it takes memory for it.
robotlink::Result<JpegComponents> decodeJpegComponents(std::span<const std::uint8_t> data,
                                                       std::size_t maximumPixels);

/// A message as a camera yields it, with time and frame kept.
robotlink::Result<std::shared_ptr<foxglove::RawImage>> rawImage(const foxglove::CompressedImage& image);
robotlink::Result<std::shared_ptr<foxglove::CompressedImage>> jpegImage(const foxglove::RawImage& image);
robotlink::Result<std::shared_ptr<foxglove::CompressedImage>> pngImage(const foxglove::RawImage& image);

}  // namespace logplayer
