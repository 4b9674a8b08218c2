// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace robotlink::websocket {

/// A piece of the argument of a long call. Messages of a WebSocket cannot overtake each other, so that on a
/// slow line STOP would wait for seconds behind a color table. So a long call is sent as several ones with
/// the same ids, to servers that offer it (kCallPartsKey); other calls may go between them. The parts come in
/// order; they are answered once, after the last.
struct CallPart {
  std::size_t offset = 0, total = 0;
  /// The encoding of the whole argument.
  std::string encoding;
  bool operator==(const CallPart&) const = default;
};

/// The key in the metadata of servers that take calls in parts.
inline constexpr char kCallPartsKey[] = "robotcontrol/call-parts";

/// A part as the encoding of its call: "part;4096;262144;protobuf".
std::string toEncoding(const CallPart& part);
/// Returns nothing if the encoding is not that of a part.
std::optional<CallPart> callPartOf(std::string_view encoding);

}  // namespace robotlink::websocket
