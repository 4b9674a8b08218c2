// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <any>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "app/core/platform/PlatformForm.h"
#include "app/core/program/ProgramOverrides.h"
#include "robotlink/base/Error.h"

namespace logplayer {
class Recorder;
}
namespace robotlink {
class Session;
}

namespace app {

class HostingMemory;
class LinkLimitsMemory;
class PlatformFeed;
class Workbench;
struct HeadlessPlatform;

/// The kind of time by which a platform runs. It decides how users can control the platform.
enum class TimeKind : std::uint8_t {
  /// Simulated time: can be paused, stepped, reset and sped up.
  kSimulated,
  /// The timeline of logs: can be played and jumped in.
  kLogged,
  /// Real time: cannot be controlled.
  kReal
};

/// The context in which a platform is made. Session, recorder and memory must outlive the
/// platform.
struct PlatformContext {
  /// The session to which the platform publishes.
  robotlink::Session& session;
  /// The recorder that gets what a log may contain.
  logplayer::Recorder& recorder;
  /// Data that the adapter keeps from one of its platforms to the next; at first empty. In the platform's
  /// thread.
  std::any& memory;
  /// The user's overrides, by robot, from the last time the same sources were open; otherwise empty.
  std::map<std::string, ProgramOverrides> overrides = {};
  /// Call this with the share of PlatformOpening::file that was read; returns false if that is to be
  /// canceled. May be empty.
  std::function<bool(double share)> progress = {};
  /// The user's choices of where programs run; null: nobody has chosen, and nothing is to be remembered.
  HostingMemory* hosting = nullptr;
  /// The user's limits for connections to remote robots; null: nothing is limited.
  const LinkLimitsMemory* limits = nullptr;
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
  /// The file that is read meanwhile, if that may take a while.
  std::filesystem::path file = {};
  /// The same with a token that the user has entered meanwhile, or, if that is empty, as before; unset:
  /// no token is needed. May be called from any thread.
  std::function<PlatformOpening(const std::string& token)> withToken = {};
  /// Returns why the robot refuses the connection while the platform is open, see make(); empty: it does not.
  /// May be called from any thread. Unset: it never does.
  std::function<robotlink::Errors()> refusal = {};
};

/// The user's choice of what to open. A plain value.
struct PlatformChoices {
  /// Files, or one address.
  std::vector<std::string> sources;
  /// Values of the form's fields, except for those that are sources; those that the user left open are
  /// missing. "layout" is a process layout, by its path or the name of a shipped one, for all adapters.
  FormValues values = {};
};

/// A kind of platform that the workbench can open, such as "simulation". It registers itself with one static
/// PlatformRegistration; nothing else has to know that the kind exists: menus, dialogs, commands,
/// options of the command line and `robotctl run` are made from what it declares. A plain value.
struct PlatformAdapter {
  /// A unique name: "simulation".
  const char* name;
  /// The sources that it opens, for users: "a world (.sdf, .world) or a map (.map)".
  const char* sources;
  /// The kind of time of its platforms.
  TimeKind time;
  /// Whether one platform can have several sources, which share a timeline.
  bool severalSources = false;
  /// Whether it opens this file or address. Several adapters may; then the one with the lowest `order` does.
  bool (*opens)(const std::string& source);
  /// The rank in which adapters are asked, lowest first.
  int order = 0;
  /// Prepares the opening of a platform. Fails if the choices are wrong in themselves; problemOf() has found
  /// nothing wrong with single values.
  robotlink::Result<PlatformOpening> (*open)(const PlatformChoices& choices);
  /// The command that opens a source, "simulation.open", and its help; null: only the form's command does.
  const char* command = nullptr;
  const char* commandHelp = nullptr;
  /// The entry of the menu File that opens a file, and the kinds of files that its dialog lists; null: none.
  const char* fileEntry = nullptr;
  const char* fileFilter = nullptr;
  /// The perspective that fits a source; null or "": the one that the user saw last.
  const char* (*perspective)(const std::string& source) = nullptr;
  /// The form that the user fills in before a platform is opened; null: none.
  PlatformForm (*form)() = nullptr;
  /// The runner for `robotctl run`; null: there is none.
  HeadlessPlatform (*headless)() = nullptr;
  /// The command that runs it instead, as a sentence; null: none.
  const char* insteadOfHeadless = nullptr;
  /// Attaches the commands that only platforms of this kind fulfill; null: there are none. Called once for
  /// each workbench, in its thread, whatever is open.
  void (*commands)(Workbench& workbench) = nullptr;
};

/// Returns all adapters, sorted by their order. They are registered before main() and do not change later.
const std::vector<PlatformAdapter>& platformAdapters();
/// Returns the first adapter that opens a file or address; null if none does.
const PlatformAdapter* adapterFor(const std::string& source);
/// The form of an adapter; without fields and name if it has none.
PlatformForm formOf(const PlatformAdapter& adapter);
/// Sorts the arguments of the form's command into sources and values.
PlatformChoices choicesOf(const PlatformForm& form, const std::vector<FormValue>& arguments);
/// Checks the values against the adapter's form, then prepares the opening.
robotlink::Result<PlatformOpening> openingOf(const PlatformAdapter& adapter, const PlatformChoices& choices);
/// Prepares the opening by the adapter that opens the first source; all sources must be its own.
robotlink::Result<PlatformOpening> openingOf(const PlatformChoices& choices);

/// Registers an adapter when it is constructed, which must be before main(): define one as a static constant.
struct [[maybe_unused]] PlatformRegistration {
  explicit PlatformRegistration(PlatformAdapter adapter);
};

}  // namespace app
