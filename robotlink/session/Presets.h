// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"

namespace robotlink {

class Session;

/// A user's named choices for a robot and the window, in texts as commands take them. A part that is not in
/// it stays as it is when the preset is loaded; what is not in a part gets its default. A plain value.
struct Preset {
  enum Part : std::uint8_t {
    /// Debug keys that are on: "image/camera" -> "every 3".
    kKeys,
    /// Tasks that run another solution than their layout says, or all of them.
    kSolutions,
    /// Parameters that differ from the file's: "walking/gait step.height" -> "0.03".
    kParameters,
    /// "perspective" -> "Play"; "layout" -> JSON.
    kViews,
    /// Settings of the camera that differ from those with which it began: "exposure" -> "0.5".
    kCamera,
    kParts
  };
  static constexpr std::array<std::string_view, kParts> kPartNames{"keys", "solutions", "parameters", "views",
                                                                   "camera"};
  using Values = std::map<std::string, std::string>;

  std::array<std::optional<Values>, kParts> parts = {};
  bool operator==(const Preset&) const = default;
};

/// Returns the differences of two presets in the parts that both have, a line each: "keys: image/camera is
/// off, not always". Layouts of views are not compared.
std::vector<std::string> differences(const Preset& now, const Preset& wanted);

/// The debug keys of the selected robot that are on, and the active solutions of its tasks.
Preset::Values keysThatAreOn(Session& session);
Preset::Values activeSolutions(Session& session);
/// The settings of its camera that differ from those with which it began. None if they are not known: the
/// robot reports them only while the key of their package is on.
std::optional<Preset::Values> cameraSettings(Session& session);

/// Presets as text files with a version, <folder>/<name>.preset.json, written as a whole or not at all. Older
/// files with keys only (KeyPresets.h) are read, too. One thread at a time.
class Presets {
 public:
  explicit Presets(std::filesystem::path folder) : folder_(std::move(folder)) {}

  /// Sorted; empty if the folder does not exist.
  std::vector<std::string> names() const;
  /// Fails if there is no such preset, or with the place of a mistake in its file.
  Result<Preset> load(const std::string& name) const;
  static Result<Preset> loadFile(const std::filesystem::path& file);
  /// Replaces a preset of the same name. Names are those of KeyPresets.
  Result<void> save(const std::string& name, const Preset& preset) const;
  static Result<void> saveFile(const std::filesystem::path& file, const Preset& preset);
  Result<void> remove(const std::string& name) const;
  /// Fails if there is a preset of the new name.
  Result<void> rename(const std::string& from, const std::string& to) const;

 private:
  /// The file of a preset that need not exist.
  Result<std::filesystem::path> fileOf(const std::string& name) const;

  std::filesystem::path folder_;
};

}  // namespace robotlink
