// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "simcore/sdf/ModelSearch.h"
#include "simcore/world/LeftOut.h"
#include "simcore/world/Palette.h"

namespace tinyxml2 {
class XMLDocument;
class XMLElement;
}  // namespace tinyxml2

namespace simcore {

class SdfSpec;

/// An <include> of a world: the model's file, name, pose and team color.
struct SceneInclude {
  std::filesystem::path file;
  /// Empty: the model's own name.
  std::string name;
  /// The pose as in SDFormat: x y z roll pitch yaw, m and rad; unset: the model's own.
  std::optional<std::array<double, 6>> pose;
  /// Unset: as the model says.
  std::optional<bool> isStatic;
  /// A color of the palette; empty if there is no team.
  std::string team;
  /// See SceneRobot::layout; empty: as the model says.
  std::string layout;
  /// See SceneRobot::role.
  std::string role;
  /// The text of its <robotcontrol:motion> and of the latter's attribute `objects`; empty if it has none.
  std::string motion, motionAtObjects;
  /// Line of the <include>, for error messages.
  int line = 0;
};

/// The files of a scene: a world, or a model alone, and all models that they include, each read and checked
/// once however often it is included. URDF files are converted by libsdformat. One thread at a time.
class SceneFiles {
 public:
  /// Texts that count instead of files, by whole paths with links resolved (simcore::SceneTexts).
  using Texts = std::map<std::filesystem::path, std::string>;

  /// Reads `file` and everything that it includes; appends problems to `errors`. `folders` are searched for
  /// models first.
  SceneFiles(const std::filesystem::path& file, const std::vector<std::filesystem::path>& folders,
             Texts texts, const SdfSpec& spec, robotlink::Errors& errors);
  ~SceneFiles();
  SceneFiles(SceneFiles&&) noexcept;
  SceneFiles& operator=(SceneFiles&&) noexcept;
  SceneFiles(const SceneFiles&) = delete;
  SceneFiles& operator=(const SceneFiles&) = delete;

  /// For scenes that are no SDFormat files or were read before, to which models are added.
  explicit SceneFiles(const std::filesystem::path& file,
                      const std::vector<std::filesystem::path>& folders = {}, Palette palette = {});

  const std::filesystem::path& file() const { return file_; }
  /// Null if the file describes a model alone.
  const tinyxml2::XMLElement* world() const;
  /// The <model> of a file that was read; null if it is not sound.
  const tinyxml2::XMLElement* model(const std::filesystem::path& file) const;
  /// The file that an <include> of a document names; null if there is none.
  const std::filesystem::path* fileOf(const tinyxml2::XMLElement& include) const;
  /// The world's own includes.
  const std::vector<SceneInclude>& includes() const { return includes_; }
  /// The palette of the world and all models.
  const Palette& palette() const { return palette_; }
  const ModelSearch& search() const { return search_; }
  const LeftOuts& leftOut() const { return leftOut_; }

  /// Reads a further model, found as model://NAME would be found in the scene. Returns its file; nothing,
  /// after adding errors, if there is no such model.
  std::optional<std::filesystem::path> addModel(const std::string& name, const SdfSpec& spec,
                                                robotlink::Errors& errors);
  /// Reads a further model: a URI or a file, the name of a model's folder on the search path, or a kind of
  /// robot of which there is a model there. Returns its file; nothing, after adding errors, if there is none.
  std::optional<std::filesystem::path> addModelOf(const std::string& source, const SdfSpec& spec,
                                                  robotlink::Errors& errors);

 private:
  /// Reads and checks a file once; null, after adding errors, if it is no sound XML.
  tinyxml2::XMLDocument* read(const std::filesystem::path& file, const SdfSpec& spec,
                              robotlink::Errors& errors);
  /// Reads the models that are included anywhere below an element.
  void readIncludes(tinyxml2::XMLElement& parent, const std::filesystem::path& file, const SdfSpec& spec,
                    robotlink::Errors& errors);
  /// Returns false if the element is to be removed.
  bool readInclude(tinyxml2::XMLElement& include, const std::filesystem::path& file, const SdfSpec& spec,
                   robotlink::Errors& errors);
  /// The light that a file describes instead of a model; null if it describes none.
  const tinyxml2::XMLElement* lightOf(const std::filesystem::path& file, const SdfSpec& spec,
                                      robotlink::Errors& errors);
  void readModel(const std::filesystem::path& model, const robotlink::FilePosition& where,
                 const SdfSpec& spec, robotlink::Errors& errors);

  std::filesystem::path file_;
  Texts texts_;
  std::map<std::filesystem::path, std::unique_ptr<tinyxml2::XMLDocument>> documents_;
  std::set<std::filesystem::path> modelsRead_;
  std::map<const tinyxml2::XMLElement*, std::filesystem::path> included_;
  std::vector<SceneInclude> includes_;
  Palette palette_;
  ModelSearch search_;
  LeftOuts leftOut_;
};

}  // namespace simcore
