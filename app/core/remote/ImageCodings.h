// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/process/Link.h"

namespace app {

// Images on links, for SessionServer::setImageEncoder() and SessionClient::Options::convert. Any thread.

/// An image as JPEG; null if it cannot be encoded.
robotlink::PackagePtr jpegOf(const google::protobuf::Message& image);
/// A compressed image decoded, as views know images; anything else, or what cannot be decoded, as it is.
robotlink::PackagePtr decodedImage(const robotlink::PackagePtr& package);

}  // namespace app
