// SPDX-License-Identifier: GPL-3.0-or-later
// readImage() and readJpegImage() of Payloads.h: images of the logs of 2009.
#include "logplayer/bhuman/Payloads.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/base/bytes/ByteReader.h"

namespace logplayer::bhuman {
namespace {

using robotlink::ByteReader;
using robotlink::Image;
using robotlink::PixelFormat;
using robotlink::Result;

constexpr std::size_t kMaxCameraPixels = 4U << 20U;
/// Bytes of a pixel: Y0 Cb Y1 Cr of two neighbors in a row of the camera.
constexpr std::size_t kQuad = 4;

struct ImageHeader {
  int width = 0;
  int height = 0;
  robotlink::Instant time;
  std::size_t pixels() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
};

Result<ImageHeader> readHeader(ByteReader& payload) {
  ImageHeader header;
  header.width = payload.take<std::int32_t>();
  header.height = payload.take<std::int32_t>();
  header.time = robotlink::Instant(std::chrono::milliseconds(payload.take<std::uint32_t>()));
  constexpr int kMaxSide = 1 << 14;
  const bool possible = header.width > 0 && header.width % 2 == 0 && header.height > 0 &&
                        header.width <= kMaxSide && header.height <= kMaxSide &&
                        header.pixels() <= kMaxCameraPixels;
  if (!possible)
    return robotlink::failure("bhuman.image", "the image claims " + std::to_string(header.width) + " x " +
                                                  std::to_string(header.height) +
                                                  " pixels, which no camera of these robots had");
  return header;
}

/// The robot's program used the second Y of each quadruple for its pixel and every second row of the camera.
/// This does the same, so that the robot's color tables remain valid and pixels are square. Two pixels of a
/// Yuyv image share the mean of their Cb and Cr.
Image fromQuads(const ImageHeader& header, std::span<const std::uint8_t> quads) {
  Image image(header.width, header.height, PixelFormat::kYuyv);
  for (std::size_t at = 0, to = 0; at + 2 * kQuad <= quads.size(); at += 2 * kQuad, to += 4) {
    image.data[to] = quads[at + 2];
    image.data[to + 1] = static_cast<std::uint8_t>((quads[at + 1] + quads[at + 5] + 1) / 2);
    image.data[to + 2] = quads[at + 6];
    image.data[to + 3] = static_cast<std::uint8_t>((quads[at + 3] + quads[at + 7] + 1) / 2);
  }
  return image;
}

}  // namespace

Result<CameraImage> readImage(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  const auto header = readHeader(reader);
  if (!header) return tl::unexpected(header.error());
  if (reader.rest().size() != header->pixels() * kQuad)
    return robotlink::failure("bhuman.image", "the image's " + std::to_string(reader.rest().size()) +
                                                  " bytes do not suit its size");
  return CameraImage{header->time, fromQuads(*header, reader.rest()), {}};
}

Result<CameraImage> readJpegImage(std::span<const std::uint8_t> payload) {
  ByteReader reader(payload);
  const auto header = readHeader(reader);
  if (!header) return tl::unexpected(header.error());
  reader.take(sizeof(std::int32_t));  // the JPEG's size: the rest
  // The JPEG's header declares Adobe CMYK, but the components are those of a quadruple, not inverted.
  auto jpeg = decodeJpegQuads(reader.rest(), kMaxCameraPixels);
  if (!jpeg) return tl::unexpected(std::move(jpeg.error()));
  if (jpeg->width != header->width || jpeg->height != header->height)
    return robotlink::failure("bhuman.image", "the JPEG differs in size from the image");
  return CameraImage{header->time, fromQuads(*header, jpeg->data), std::move(jpeg->damage)};
}

}  // namespace logplayer::bhuman
