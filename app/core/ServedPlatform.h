// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <ostream>

#include "app/core/platform/PlatformAdapter.h"
#include "app/core/remote/ListenAccess.h"
#include "robotlink/foxglove/server/ListenAddress.h"
#include "robotlink/foxglove/session/Steering.h"

namespace app {

class BodyInbox;
class ProgramTroubles;

/// The options of serving a platform. A plain value.
struct ServeOptions {
  robotlink::websocket::ListenAddress address = {};
  /// Times real time; 0 is as fast as possible. A real robot has its own.
  double speed = 1;
  /// Seconds of the platform's time after which it ends; empty: when the user wants it to.
  std::optional<double> seconds = {};
  /// A simulation waits until a client starts it.
  bool isPaused = false;
  /// Prints the programs' text messages.
  bool texts = false;
  /// The folder where clients may record, and fetch recordings from (RecordingServices); empty: none.
  std::filesystem::path recordings = {};
  /// The robot's resource folder, in which clients may replace files (DeployServices); empty: none.
  std::filesystem::path resources = {};
  /// The conditions under which clients may connect.
  AccessOptions access = {};
  /// Not null: the robots are only bodies, and remote programs command them by this (REMOTE_BODY.md).
  std::shared_ptr<BodyInbox> bodies = nullptr;
  /// Gets what goes wrong with the robots' programs, and prints it; null: only clients see it.
  std::shared_ptr<ProgramTroubles> troubles = nullptr;
  /// The limits after which a robot stops because the client that steers it is silent.
  robotlink::websocket::Steering::Limits steering = {};
};

/// Opens a platform without a window, with the programs of its robots, and lets clients of the Foxglove
/// WebSocket protocol watch and steer it (robotlink/foxglove/FOXGLOVE.md). Prints where, and who was refused.
/// Blocks until the time is over or `interrupted` returns true. Returns the reasons why it could not begin.
/// `recorder` gets what a log may contain; it may be one that records nothing.
robotlink::Errors serve(PlatformOpening opening, const ServeOptions& options, logplayer::Recorder& recorder,
                        const std::function<bool()>& interrupted, std::ostream& out);

}  // namespace app
