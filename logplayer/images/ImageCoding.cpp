// SPDX-License-Identifier: GPL-3.0-or-later
#include "logplayer/images/ImageCoding.h"

#include "foxglove/Image.pb.h"
#include "robotlink/packages/Conversions.h"

namespace logplayer {
namespace {

using foxglove::CompressedImage;
using foxglove::RawImage;
using robotlink::Image;
using robotlink::ImageView;
using robotlink::Result;

Result<Image> decode(const CompressedImage& image) {
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(image.data().data());
  const std::span<const std::uint8_t> data(bytes, image.data().size());
  if (image.format() == "jpeg" || image.format() == "jpg") return decodeJpeg(data);
  if (image.format() == "png") return decodePng(data);
  return robotlink::failure("image.format",
                            "images of format '" + image.format() + "' cannot be read; jpeg and png can", {},
                            {image.format()});
}

Result<std::shared_ptr<CompressedImage>> compressed(
    const RawImage& image, const char* format,
    Result<std::vector<std::uint8_t>> (*encode)(const ImageView&)) {
  const ImageView view = robotlink::imageView(image);
  if (view.empty())
    return robotlink::failure("image.raw",
                              "an image of encoding '" + image.encoding() +
                                  "' cannot be coded: size, step and encoding do not fit its data, or the "
                                  "encoding is not yuyv, rgb8 or mono8",
                              {}, {image.encoding()});
  auto data = encode(view);
  if (!data) return tl::unexpected(std::move(data.error()));
  auto result = std::make_shared<CompressedImage>();
  if (image.has_timestamp()) *result->mutable_timestamp() = image.timestamp();
  result->set_frame_id(image.frame_id());
  result->set_format(format);
  result->set_data(data->data(), data->size());
  return result;
}

}  // namespace

Result<std::shared_ptr<RawImage>> rawImage(const CompressedImage& image) {
  const auto pixels = decode(image);
  if (!pixels) return tl::unexpected(pixels.error());
  auto result = std::make_shared<RawImage>();
  robotlink::assign(*result, pixels->view(), robotlink::instant(image.timestamp()), image.frame_id());
  if (image.has_timestamp())
    *result->mutable_timestamp() = image.timestamp();
  else
    result->clear_timestamp();
  return result;
}

Result<std::shared_ptr<CompressedImage>> jpegImage(const RawImage& image) {
  return compressed(image, "jpeg", [](const ImageView& view) { return encodeJpeg(view); });
}

Result<std::shared_ptr<CompressedImage>> pngImage(const RawImage& image) {
  return compressed(image, "png", [](const ImageView& view) { return encodePng(view); });
}

}  // namespace logplayer
