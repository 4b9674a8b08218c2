// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <functional>
#include <iosfwd>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/core/platform/ExitStatus.h"
#include "app/core/platform/FieldOptions.h"
#include "app/core/platform/PlatformAdapter.h"
#include "app/core/platform/RecordOptions.h"
#include "app/core/spread/SpreadOptions.h"
#include "robotlink/base/Error.h"
#include "robotlink/debugging/DebugRoutes.h"

namespace robotlink {
struct Preset;
}

namespace app {

/// The user's choices for a run without a window. A plain value.
struct HeadlessChoices {
  /// "log:game.mcap" or "tcp://localhost:8101".
  std::string platform;
  /// A process layout, by its path or the name of a shipped one; empty: that of the platform.
  std::string layout = {};
  /// Maps tasks to solutions, instead of the layout's.
  std::map<std::string, std::string> solutions = {};
  /// A preset with which the programs additionally start; null: none.
  std::shared_ptr<const robotlink::Preset> preset = nullptr;
  /// The solutions that run in shadow mode, in all programs that have their tasks.
  std::vector<robotlink::ShadowName> shadows = {};
  RecordOptions record = {};
  /// The program of the layout to run; without one, all processes run.
  SpreadOptions spread = {};
  /// The options that only some kinds of platforms have.
  FieldOptions options = {};
};

/// The program that runs it; all functions are set.
struct HeadlessConsole {
  /// The stream for lines to the user that are not the result.
  std::ostream& errors;
  /// Whether the user wants it to end.
  std::function<bool()> interrupted;
  /// Shows which share is done; returns false if the user wants it to end.
  std::function<bool(double share)> progress;
  /// The file of a source: that file, or for "-" a copy of standard input, which exists until the run ends.
  std::function<robotlink::Result<std::filesystem::path>(const std::string& source)> input;
};

/// The result of a run: a summary for other programs, the same for users, and the exit status of the program.
struct HeadlessSummary {
  std::string json, text;
  ExitStatus status = kDone;
};

/// A platform that is to be opened without a window, for others to watch and steer.
struct HeadlessServing {
  PlatformOpening opening;
  /// Seconds of the platform's time after which it ends; empty: when the user wants it to.
  std::optional<double> seconds = {};
  /// Whether the programs' text messages are printed.
  bool texts = false;
};

/// The runner of platforms of one kind without a window. A plain value.
struct HeadlessPlatform {
  /// Blocks until the run has ended by itself or was interrupted. Fails with all reasons why it cannot begin
  /// or had to end.
  using Run = std::function<tl::expected<HeadlessSummary, robotlink::Errors>(const HeadlessConsole& console)>;

  /// The syntax for such a platform: in the help, and in the error about something that no platform runs.
  const char* help;
  const char* usage;
  /// Whether it is one of them; null: whatever the adapter opens is.
  bool (*runs)(const std::string& platform) = nullptr;
  /// The options that belong to this kind; problemOf() has found nothing wrong with their single values.
  std::vector<PlatformField> options;
  /// The sentence about these options with another kind of platform, which is refused; null: they are
  /// ignored there.
  const char* optionsAreMine = nullptr;
  /// Prepares the run. Fails if the choices are wrong in themselves.
  std::function<robotlink::Result<Run>(const HeadlessChoices& choices)> prepare;
  /// Prepares the same platform, with the same choices, for others to watch and steer; unset: that is not
  /// possible.
  std::function<robotlink::Result<HeadlessServing>(const HeadlessChoices& choices,
                                                   const HeadlessConsole& console)>
      prepareServing = {};
  /// The file of the layout that these choices mean; unset: programs of layouts cannot be run one by one.
  std::function<std::filesystem::path(const HeadlessChoices& choices)> layoutOf = {};
  /// Prepares the run of one of the layout's programs that has neither the debug process nor the platform.
  std::function<robotlink::Result<Run>(const HeadlessChoices& choices)> prepareOther = {};
};

/// The runners of all adapters that have one. The adapter that is asked last is the first, since it takes
/// the most.
std::vector<HeadlessPlatform> headlessPlatforms();
/// The one that runs what was chosen. Fails if none does, or if an option was given that belongs to another.
robotlink::Result<HeadlessPlatform> headlessPlatformFor(const HeadlessChoices& choices);

}  // namespace app
