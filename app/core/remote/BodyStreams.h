// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace app {

// The streams of a robot that is only a body: its program runs remotely (REMOTE_BODY.md). Sensor readings
// have the names of their packages.
inline constexpr char kBodyOffer[] = "body/offer";        ///< BodyOffer
inline constexpr char kBodyState[] = "body/state";        ///< BodyState
inline constexpr char kBodyCommands[] = "body/commands";  ///< BodyCommands, published by a client

}  // namespace app
