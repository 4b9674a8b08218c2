// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/arcos/stream/OpenStream.h"

#include "robotlink/arcos/stream/SerialStream.h"
#include "robotlink/arcos/stream/StreamUrl.h"
#include "robotlink/arcos/stream/TcpStream.h"

namespace robotlink::arcos {

Result<std::unique_ptr<ByteStream>> open(const std::string& url, Duration timeLimit) {
  const auto parsed = parseUrl(url);
  if (!parsed) return tl::unexpected(parsed.error());
  if (const auto* serial = std::get_if<SerialAddress>(&*parsed)) return openSerial(*serial);
  return openTcp(std::get<TcpAddress>(*parsed), timeLimit);
}

}  // namespace robotlink::arcos
