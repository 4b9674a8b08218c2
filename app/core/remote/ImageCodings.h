// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "robotlink/foxglove/session/SessionServer.h"
#include "robotlink/process/Link.h"

namespace app {

// Images on links, for SessionServer and SessionClient::Options::convert. Any thread.

/// Returns the encoders for JPEG and PNG.
robotlink::websocket::SessionServer::ImageEncoders imageEncoders();
/// A compressed image decoded, as views know images; anything else, or what cannot be decoded, as it is.
robotlink::PackagePtr decodedImage(const robotlink::PackagePtr& package);

}  // namespace app
