// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/SceneSpecification.h"

#include "app/platforms/simulated/scenetext/SceneFileText.h"
#include "app/platforms/simulated/scenetext/SceneText.h"
#include "simcore/sdf/SdfGlossary.h"

namespace app {
namespace {

widgets::SceneElement elementOf(const simcore::SdfElementHelp& help) {
  widgets::SceneElement element{help.name,     help.type, help.initial, help.help, help.required,
                                help.repeated, {}};
  for (const auto& one : help.attributes)
    element.attributes.push_back({one.name, one.type, one.initial, one.help, one.required});
  return element;
}

}  // namespace

SceneSpecification::SceneSpecification(std::function<std::vector<std::filesystem::path>()> folders)
    : folders_(std::move(folders)) {}
SceneSpecification::~SceneSpecification() = default;

const simcore::SdfGlossary& SceneSpecification::glossary() const {
  std::call_once(once_, [this] { glossary_ = std::make_unique<simcore::SdfGlossary>(); });
  return *glossary_;
}

std::vector<widgets::SceneElement> SceneSpecification::children(const Path& path) const {
  std::vector<widgets::SceneElement> all;
  for (const auto& help : glossary().children(path)) all.push_back(elementOf(help));
  return all;
}

std::optional<widgets::SceneElement> SceneSpecification::element(const Path& path) const {
  const auto help = glossary().element(path);
  return help ? std::optional(elementOf(*help)) : std::nullopt;
}

std::vector<widgets::SceneProblem> SceneSpecification::check(const std::string& text,
                                                             const std::filesystem::path& file) const {
  std::vector<widgets::SceneProblem> problems;
  for (const SceneTextFinding& one : checkSceneText(text, file, folders_())) {
    const robotlink::Error& error = one.error;
    const bool isOverlap = error.id == "scene.overlap";
    problems.push_back({one.isWarning, error.text, error.where.file, error.where.line,
                        isOverlap ? error.arguments : std::vector<std::string>()});
  }
  return problems;
}

std::vector<widgets::SceneModelChoice> SceneSpecification::models(const std::filesystem::path& file) const {
  std::vector<widgets::SceneModelChoice> all;
  for (const SceneModelFile& model : sceneModels(file, folders_()))
    all.push_back({model.name, model.uri, model.isRobot});
  return all;
}

std::optional<std::filesystem::path> SceneSpecification::modelFile(const std::string& uri,
                                                                   const std::filesystem::path& file) const {
  return sceneModelFile(uri, file, folders_());
}

robotlink::Result<std::string> SceneSpecification::withElement(const std::string& text,
                                                               const std::filesystem::path& file,
                                                               const std::vector<std::string>& element,
                                                               const std::string& value) const {
  return app::withElement(text, file.string(), element, value);
}

robotlink::Result<std::string> SceneSpecification::newObject(const std::string& kind, const std::string& name,
                                                             double x, double y,
                                                             const std::filesystem::path& file) const {
  return newObjectText(kind, name, x, y, file, folders_());
}

robotlink::Result<std::string> SceneSpecification::newRoom(const widgets::RoomChoice& room,
                                                           const std::filesystem::path& file) const {
  return newRoomText({.name = room.name,
                      .width = room.width,
                      .depth = room.depth,
                      .wallHeight = room.wallHeight,
                      .doorway = room.doorway,
                      .robot = room.robot},
                     file, folders_());
}

}  // namespace app
