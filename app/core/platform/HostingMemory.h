// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "app/core/platform/HostingChoices.h"
#include "robotlink/base/Error.h"
#include "robotlink/session/Settings.h"

namespace robotcontrol {
class HostProgram;
}

namespace app {

/// The layouts and solutions that were chosen in a scene. A plain value.
struct TeamPrograms {
  /// Layouts by kind of robot.
  std::map<std::string, std::filesystem::path> layouts;
  /// Layouts of robots and teams, by their names, which may also be those of kinds.
  std::map<std::string, std::filesystem::path> robotLayouts;
  /// The chosen solutions of robots and teams, by their names and by task.
  std::map<std::string, std::map<std::string, std::string>> solutions;

  bool operator==(const TeamPrograms&) const = default;
};

/// The HostingChoices of each kind of platform, and the folders in which the models of scenes are searched
/// first, and the TeamPrograms of scenes, kept in a file from one run of the workbench to the next. Any
/// thread.
class HostingMemory {
 public:
  explicit HostingMemory(std::filesystem::path file);

  /// Keyed by the name of the PlatformAdapter; the default if nothing was chosen yet.
  HostingChoices choices(const std::string& adapter) const;
  void choose(const std::string& adapter, const HostingChoices& choices);
  std::vector<std::filesystem::path> modelFolders() const;
  void chooseModelFolders(const std::vector<std::filesystem::path>& folders);
  /// Unset if nothing was chosen in that scene yet.
  std::optional<TeamPrograms> teamPrograms(const std::filesystem::path& scene) const;
  void chooseTeamPrograms(const std::filesystem::path& scene, const TeamPrograms& programs);
  /// Writes the file if something was chosen since the last time. Fails once for each change.
  robotlink::Result<void> save();

 private:
  /// Protects the other members.
  mutable std::mutex mutex_;
  robotlink::Settings settings_;
  bool hasChanged_ = false;
};

/// The choices for a platform that is opened: the requested ones if they are processes of their own,
/// otherwise the remembered ones. Without a memory, only the former.
HostingChoices hostingAtOpening(const HostingChoices& asked, const HostingMemory* memory,
                                const std::string& adapter);
/// Remembers where programs run now that a request was fulfilled, if it chose that. Without a memory,
/// nothing.
void rememberHosting(HostingMemory* memory, const std::string& adapter,
                     const robotcontrol::HostProgram& fulfilled, const HostingChoices& now);

}  // namespace app
