// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/data/ImageThumbnails.h"

#include "foxglove/Image.pb.h"
#include "widgets/image/RawPicture.h"

namespace widgets {
namespace {

constexpr std::uint64_t kTicksKept = 8;  // about four pictures a second

}  // namespace

QImage imageOf(const google::protobuf::Message& message) {
  if (const auto* raw = dynamic_cast<const foxglove::RawImage*>(&message)) return rawPicture(*raw);
  if (const auto* compressed = dynamic_cast<const foxglove::CompressedImage*>(&message)) {
    return QImage::fromData(reinterpret_cast<const uchar*>(compressed->data().data()),
                            static_cast<int>(compressed->data().size()));
  }
  return {};
}

QImage ImageThumbnails::of(const std::string& stream, const robotlink::PackagePtr& message, int height) {
  if (message == nullptr) return {};
  Kept& kept = kept_[stream];
  const bool isRecent = kept.message != nullptr && ticks_ < kept.madeAt + kTicksKept;
  if (kept.message == message || isRecent) return kept.image;
  const QImage image = imageOf(*message);
  kept = {message, image.isNull() ? image : image.scaledToHeight(height, Qt::SmoothTransformation), ticks_};
  return kept.image;
}

}  // namespace widgets
