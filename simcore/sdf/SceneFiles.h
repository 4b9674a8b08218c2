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

/// An <include> of a world: which model file, under which name, where and in which team's colour.
struct SceneInclude {
  std::filesystem::path file;
  std::string name;  ///< empty: the model's own
  double pose[6] = {};
  bool isStatic = false;
  std::string team;  ///< a colour of the palette; empty: none
  int line = 0;
};

/// A world's text and those of the models that it includes, each read and checked once, as XML with line
/// numbers. libsdformat would parse an included file again for each <include>, and gives no line for many
/// errors; so includes are resolved here, and worldText is the world's text with its <include> elements
/// blanked out, lines kept.
struct SceneFiles {
  std::string worldText;
  std::vector<SceneInclude> includes;
  std::map<std::filesystem::path, std::string> models;  ///< text by file
  Palette palette;                                      ///< of the world and of all models

  /// Reads `file` and what it includes. What is wrong goes to `errors`.
  static SceneFiles read(const std::filesystem::path& file, const SdfSpec& spec, robotlink::Errors& errors);

  /// Reads a model besides, as model://NAME in the world file `scene` would be found. Its file; none, with
  /// errors noted, if there is no such model.
  std::optional<std::filesystem::path> addModel(const std::string& name, const std::filesystem::path& scene,
                                                const SdfSpec& spec, robotlink::Errors& errors);
};

}  // namespace simcore
