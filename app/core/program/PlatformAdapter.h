// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/program/ProgramOverrides.h"
#include "robotlink/base/Error.h"

namespace logplayer {
class Recorder;
}
namespace robotlink {
class Session;
}

namespace app {

class PlatformFeed;

/// The kind of time that a platform goes by. It decides how users can control the platform.
enum class PlatformTime : std::uint8_t {
  /// Simulated time: can be paused, stepped, reset and sped up.
  kSimulated,
  /// The time line of logs: can be played and jumped in.
  kLogged,
  /// Real time: cannot be controlled.
  kReal
};

/// A kind of platform that the workbench can open, such as "simulation". It registers itself with one static
/// PlatformRegistration; nothing else has to know that the kind exists. A plain value.
struct PlatformAdapter {
  /// A unique name: "simulation".
  const char* name;
  /// What it opens, for users: "a world (.sdf, .world) or a map (.map)".
  const char* sources;
  /// The kind of time of its platforms.
  PlatformTime time;
  /// Whether one platform can have several sources, which share a time line.
  bool severalSources = false;
  /// Whether it opens this file or address. Several adapters may; then the one with the lowest `order` does.
  bool (*opens)(const std::string& source);
  /// The rank in which adapters are asked, lowest first.
  int order = 0;
};

/// Returns all adapters, sorted by their order. They are registered before main() and do not change later.
const std::vector<PlatformAdapter>& platformAdapters();
/// Returns the first adapter that opens a file or address; null if none does.
const PlatformAdapter* adapterFor(const std::string& source);

/// Registers an adapter when it is constructed, which must be before main(): define one as a static constant.
struct PlatformRegistration {
  explicit PlatformRegistration(PlatformAdapter adapter);
};

/// What a platform needs from the workbench when it is made. Session and recorder must outlive the platform.
struct PlatformContext {
  /// The session to which the platform publishes.
  robotlink::Session& session;
  /// The recorder that gets what a log may contain.
  logplayer::Recorder& recorder;
  /// The user's overrides, by robot, from the last time the same sources were open; otherwise empty.
  std::map<std::string, ProgramOverrides> overrides = {};
};

/// A platform that is to be opened, as a value that can be passed to the platform's thread.
struct PlatformOpening {
  using Made = tl::expected<std::unique_ptr<PlatformFeed>, robotlink::Errors>;

  /// The name of its PlatformAdapter.
  std::string adapter;
  /// Files, or one address. Equal adapters and sources mean the same platform, whose overrides are kept.
  std::vector<std::string> sources;
  /// Makes the platform, or returns all reasons why that is impossible. Called once, in the platform's
  /// thread.
  std::function<Made(const PlatformContext& context)> make;
};

}  // namespace app
