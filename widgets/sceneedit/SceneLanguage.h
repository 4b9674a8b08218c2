// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace widgets {

/// An attribute that an element of a scene file may have. Texts are English, as the specification is.
struct SceneAttribute {
  std::string name, type, initial, help;
  bool required = false;
};

/// An element of a scene file.
struct SceneElement {
  std::string name;
  /// Type and default of its value; empty if it has children instead.
  std::string type, initial;
  std::string help;
  bool required = false;
  bool repeated = false;
  std::vector<SceneAttribute> attributes;
};

/// Something that is wrong in a file, or that the simulator passes over.
struct SceneProblem {
  bool isWarning = false;
  std::string text;
  std::string file;
  /// From 1; 0: it is about the whole file.
  int line = 0;
  /// The names of two models of which one starts inside the other: the scene cannot be opened so, but can be
  /// continued where they are elsewhere now. Empty: it is about something else.
  std::vector<std::string> inside = {};
  bool operator==(const SceneProblem&) const = default;
};

/// A model that can be included.
struct SceneModelChoice {
  std::string name, uri;
  bool isRobot = false;
};

/// The objects that can be added in addition to models: their names in commands.
inline constexpr std::array kSceneObjectKinds{"box", "ball", "cylinder", "lamp", "camera"};

/// The properties of a new room; lengths in m.
struct RoomChoice {
  std::string name;
  double width = 6, depth = 4, wallHeight = 1;
  bool doorway = false;
  /// The name of a model; empty: none.
  std::string robot;
};

/// The simulator's knowledge of scene files, for their editor, which must not depend on the simulator. All
/// functions may be called by any thread; check() and newRoom() block for some 100 ms, or longer for large
/// scenes.
class SceneLanguage {
 public:
  /// The names of elements from the root on.
  using Path = std::vector<std::string>;

  virtual ~SceneLanguage() = default;
  /// The elements that may be in the last one of the path; for an empty path the root.
  virtual std::vector<SceneElement> children(const Path& path) const = 0;
  /// The last element of the path; nothing if it may not be there.
  virtual std::optional<SceneElement> element(const Path& path) const = 0;
  /// The problems of a text that is to be saved in a file, which need not exist.
  virtual std::vector<SceneProblem> check(const std::string& text,
                                          const std::filesystem::path& file) const = 0;
  /// The models that this file can include.
  virtual std::vector<SceneModelChoice> models(const std::filesystem::path& file) const = 0;
  /// The file of what this file includes by a URI.
  virtual std::optional<std::filesystem::path> modelFile(const std::string& uri,
                                                         const std::filesystem::path& file) const = 0;
  /// The text of a file with the content of one element changed, and nothing else of it; the steps are those
  /// of SceneFileEdit.
  virtual robotlink::Result<std::string> withElement(const std::string& text,
                                                     const std::filesystem::path& file,
                                                     const std::vector<std::string>& element,
                                                     const std::string& value) const = 0;
  /// The elements of a new object for a world in `file`, which stands on the ground at x and y (m). `kind`:
  /// one of kSceneObjectKinds, or the name of a model.
  virtual robotlink::Result<std::string> newObject(const std::string& kind, const std::string& name, double x,
                                                   double y, const std::filesystem::path& file) const = 0;
  /// The text of a new world with a room, to be saved in this file.
  virtual robotlink::Result<std::string> newRoom(const RoomChoice& room,
                                                 const std::filesystem::path& file) const = 0;
};

}  // namespace widgets
