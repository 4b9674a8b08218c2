// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace robotlink::websocket {

// Names that SessionServer and SessionClient share in addition to the protocol.

/// The key in the metadata of servers that offer a session.
inline constexpr char kSessionKey[] = "robotcontrol/session";
/// The group of parameters that exist while a debug key is on only because clients subscribe to what it
/// publishes: "red1/on-demand/ball-percept/disc". Their values are the names of these clients.
inline constexpr char kOnDemandGroup[] = "on-demand";

/// The suffixes of a channel of images for the channels of the same images as JPEG and as PNG.
inline constexpr char kJpegChannel[] = "/jpeg", kPngChannel[] = "/png";

/// The begin of the id of a status by which a server offers a client to send images as JPEG, because its line
/// does not carry raw ones; the topic follows.
inline constexpr char kNarrowStatus[] = "narrow-line/";

}  // namespace robotlink::websocket
