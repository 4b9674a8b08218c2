// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/ImageCodings.h"

#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"

namespace app {

robotlink::PackagePtr jpegOf(const google::protobuf::Message& image) {
  const auto* raw = dynamic_cast<const foxglove::RawImage*>(&image);
  if (raw == nullptr) return nullptr;
  const auto encoded = logplayer::jpegImage(*raw);
  return encoded ? *encoded : nullptr;
}

robotlink::PackagePtr decodedImage(const robotlink::PackagePtr& package) {
  const auto* image = dynamic_cast<const foxglove::CompressedImage*>(package.get());
  if (image == nullptr) return package;
  const auto decoded = logplayer::rawImage(*image);
  return decoded ? *decoded : package;
}

}  // namespace app
