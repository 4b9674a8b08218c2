// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>

#include "robotlink/foxglove/client/Connector.h"
#include "robotlink/session/StreamMessage.h"

namespace robotlink::websocket {

/// The options for putting one server's robots into a session. A plain value.
struct SessionClientOptions {
  Connector::Options connection;
  /// Whether a name of a robot is in use in the session, by others than this object. Empty: none is.
  std::function<bool(const std::string&)> isTaken = {};
  /// The newest time of the platform or connection that leads; zero if it has none yet. Empty, or nothing:
  /// this one leads.
  std::function<std::optional<Instant>()> leadingTime = {};
  /// Makes another package of one that came, such as a foxglove.RawImage of a compressed one. Called in the
  /// link's thread. Empty: packages stay as they are.
  std::function<PackagePtr(const PackagePtr&)> convert = {};
  /// Streams, by their paths in the session, that are wanted in addition to those that the session needs.
  std::function<bool(const std::string& path)> alsoWanted = {};
  /// Whether only these are wanted: no view shows the session.
  bool wantsNothingElse = false;
  /// Called by tick() with each message that goes into the session.
  std::function<void(const StreamMessage&)> passed = {};
};
/// A stretch of the session's time in which the connection was lost.
struct SessionGap {
  Instant from;
  /// The end of the gap; unset while it lasts.
  std::optional<Instant> to = {};
  /// Why: a sentence.
  std::string reason = {};
  bool operator==(const SessionGap&) const = default;
};
/// A channel of the server.
struct RemoteStream {
  /// The path in the session.
  std::string path;
  std::string topic, type, encoding;
  bool isSubscribed = false;
  /// Messages of other encodings ("flatbuffer") are kept as bytes, and not shown.
  bool isDecoded = false;
  std::uint64_t messages = 0, bytes = 0;
  /// The counts of the server, if it has any: messages replaced by newer ones, and messages lost.
  std::optional<std::uint64_t> thinned = {}, dropped = {};
};

/// The form in which images are sent.
enum class RemoteImages {
  kAutomatic,  ///< raw, and as JPEG from when the server finds that the line does not carry raw ones
  kRaw,
  kJpeg,  ///< as JPEG, where the server offers it; `convert` makes them raw again
  kPng    ///< the same, without losses
};
}  // namespace robotlink::websocket
