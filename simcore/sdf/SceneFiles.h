// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "simcore/sdf/SdfReader.h"

namespace simcore {

/// An <include> of a world: the model's file, name, pose and team color.
struct SceneInclude {
  std::filesystem::path file;
  /// Empty: the model's own name.
  std::string name;
  /// As in SDFormat: x y z roll pitch yaw, m and rad.
  double pose[6] = {};
  bool isStatic = false;
  /// A color of the palette; empty if there is no team.
  std::string team;
  /// Line of the <include>, for error messages.
  int line = 0;
};

/// The text of a world and those of the models that it includes, each read and checked once as XML with line
/// numbers. libsdformat would parse an included file again for each <include>, and reports many errors
/// without a line. Therefore includes are resolved here, and worldText is the world's text with the <include>
/// elements blanked out, so that line numbers stay the same.
struct SceneFiles {
  std::string worldText;
  std::vector<SceneInclude> includes;
  /// Text by file.
  std::map<std::filesystem::path, std::string> models;
  /// The palette of the world and all models.
  Palette palette;

  /// Reads `file` and everything that it includes; appends problems to `errors`.
  static SceneFiles read(const std::filesystem::path& file, const SdfSpec& spec, robotlink::Errors& errors);

  /// Reads a further model, found as model://NAME would be found in the world file `scene`. Returns its file;
  /// nothing, after adding errors, if there is no such model.
  std::optional<std::filesystem::path> addModel(const std::string& name, const std::filesystem::path& scene,
                                                const SdfSpec& spec, robotlink::Errors& errors);
};

}  // namespace simcore
