// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/remote/ImageCodings.h"

#include "foxglove/Image.pb.h"
#include "logplayer/images/ImageCoding.h"
#include "robotlink/foxglove/session/LinkNames.h"

namespace app {

namespace {

/// Makes messages of what an encoder returns; null if it fails.
template <typename Encode>
robotlink::websocket::ImageEncoder encoderBy(Encode encode) {
  return [encode](const google::protobuf::Message& image) -> robotlink::PackagePtr {
    const auto* raw = dynamic_cast<const foxglove::RawImage*>(&image);
    if (raw == nullptr) return nullptr;
    const auto encoded = encode(*raw);
    return encoded ? *encoded : nullptr;
  };
}

}  // namespace

robotlink::websocket::SessionServer::ImageEncoders imageEncoders() {
  namespace websocket = robotlink::websocket;
  return {{websocket::kJpegChannel, encoderBy(logplayer::jpegImage)},
          {websocket::kPngChannel, encoderBy(logplayer::pngImage)}};
}

robotlink::PackagePtr decodedImage(const robotlink::PackagePtr& package) {
  const auto* image = dynamic_cast<const foxglove::CompressedImage*>(package.get());
  if (image == nullptr) return package;
  const auto decoded = logplayer::rawImage(*image);
  return decoded ? *decoded : package;
}

}  // namespace app
