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

/// Whose time a platform goes by, and so what can be done with it.
enum class PlatformTime : std::uint8_t {
  kSimulated,  ///< it can be paused, stepped, set back and sped up
  kLogged,     ///< it can be played and jumped in
  kReal        ///< it goes on by itself
};

/// A kind of platform that the workbench can open: it registers itself with one line (PlatformRegistration),
/// and nothing else needs to know of it.
struct PlatformAdapter {
  const char* name;     ///< "simulation"
  const char* sources;  ///< what it opens, for people: "a world (.sdf, .world) or a map (.map)"
  PlatformTime time;
  bool severalSources = false;  ///< it can have more than one, on one time line
  /// Whether it opens this file or address; of several adapters the one that was asked first by `order`.
  bool (*opens)(const std::string& source);
  int order = 0;
};

/// All adapters, by their order; filled before main(), read-only after.
const std::vector<PlatformAdapter>& platformAdapters();
/// The first adapter that opens it; null: none does.
const PlatformAdapter* adapterFor(const std::string& source);

struct PlatformRegistration {
  explicit PlatformRegistration(PlatformAdapter adapter);
};

/// What is there for a platform that is being opened. What it refers to must outlive the platform.
struct PlatformContext {
  robotlink::Session& session;
  logplayer::Recorder& recorder;
  /// Where the same sources were open before: what a person chose for their robots, by the robots' names.
  std::map<std::string, ProgramOverrides> overrides = {};
};

/// A platform that is to be opened.
struct PlatformOpening {
  using Made = tl::expected<std::unique_ptr<PlatformFeed>, robotlink::Errors>;

  std::string adapter;               ///< its name
  std::vector<std::string> sources;  ///< files, or an address
  std::function<Made(const PlatformContext& context)> make;
};

}  // namespace app
