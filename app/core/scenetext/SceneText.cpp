// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/core/scenetext/SceneText.h"

#include <stdlib.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "simcore/Scene.h"
#include "simcore/SceneFileKind.h"
#include "simcore/Simulation.h"

namespace app {
namespace fs = std::filesystem;
using robotlink::Error;
using robotlink::Errors;
using robotlink::failure;
using robotlink::Result;

namespace {

constexpr std::string_view kModelScheme = "model://";
constexpr std::size_t kMaxSceneBytes = 16U << 20U;

/// A folder that is removed with all that is in it.
class ScratchFolder {
 public:
  ScratchFolder() {
    std::error_code unknown;
    std::string name = (fs::temp_directory_path(unknown) / "robotcontrol-scene-XXXXXX").string();
    if (::mkdtemp(name.data()) != nullptr) path_ = name;
  }
  ~ScratchFolder() {
    std::error_code ignored;
    if (!path_.empty()) fs::remove_all(path_, ignored);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  /// Empty: it could not be made.
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

void replaceAll(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

/// The file or folder of a URI, without what is shipped.
std::optional<fs::path> ownPlace(const std::string& uri, const fs::path& file) {
  const fs::path folder = fs::absolute(file).parent_path();
  std::vector<fs::path> candidates;
  if (uri.starts_with(kModelScheme)) {
    const fs::path name = uri.substr(kModelScheme.size());
    if (!name.empty()) candidates = {folder / name, folder / "models" / name};
  } else if (!uri.empty() && uri.find("://") == std::string::npos) {
    candidates = {folder / uri};
  }
  std::error_code unknown;
  for (const fs::path& candidate : candidates) {
    if (fs::exists(candidate, unknown)) return candidate.lexically_normal();
  }
  return std::nullopt;
}

/// The text with each <uri> that is looked for beside its file replaced by the whole path, in the same line.
std::string withWholePaths(const std::string& text, const fs::path& file) {
  constexpr std::string_view kOpen = "<uri>", kClose = "</uri>";
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = text.find(kOpen); at != std::string::npos; at = text.find(kOpen, done)) {
    const std::size_t begin = at + kOpen.size(), end = text.find(kClose, begin);
    if (end == std::string::npos) break;
    const std::string uri = text.substr(begin, end - begin);
    const auto place = ownPlace(uri, file);
    result += text.substr(done, begin - done) + (place ? place->string() : uri);
    done = end;
  }
  return result + text.substr(done);
}

/// The places of tags of a text that are not in comments or CDATA, each with its line.
template <typename Found>
void forEachTag(std::string_view text, Found found) {
  int line = 1;
  std::size_t counted = 0;
  for (std::size_t at = text.find('<'); at != std::string_view::npos; at = text.find('<', at + 1)) {
    const std::string_view rest = text.substr(at);
    const bool isComment = rest.starts_with("<!--"), isData = rest.starts_with("<![CDATA[");
    if (isComment || isData) {
      at = text.find(isComment ? "-->" : "]]>", at);
      if (at == std::string_view::npos) return;
      continue;
    }
    line += static_cast<int>(std::count(text.begin() + static_cast<std::ptrdiff_t>(counted),
                                        text.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
    counted = at;
    const std::size_t end = std::min(rest.find_first_of(" \t\r\n/>", 1), rest.size());
    found(std::string(rest.substr(1, end - 1)), line);
  }
}

/// Elements that the reader passes over because they are for other simulators.
void addWarnings(const std::string& text, const fs::path& file, std::vector<SceneTextFinding>& findings) {
  forEachTag(text, [&](const std::string& name, int line) {
    const bool isForeign = name.find(':') != std::string::npos && !name.starts_with("robotcontrol:");
    if (name != "plugin" && !isForeign) return;
    findings.push_back({true,
                        {"scene.unsupported",
                         "<" + name + "> is for other simulators; this one ignores it",
                         {name},
                         {file.string(), line, 0}}});
  });
}

bool describesWorld(const std::string& text) {
  bool has = false;
  forEachTag(text, [&](const std::string& name, int) { has = has || name == "world"; });
  return has;
}
bool describesModel(const std::string& text) {
  bool has = false;
  forEachTag(text, [&](const std::string& name, int) { has = has || name == "model"; });
  return has;
}

/// The errors of a scene's file, also those that show only when it begins to run.
Errors errorsOfScene(const fs::path& file) {
  const auto scene = simcore::Scene::load(file);
  if (!scene) return scene.error();
  if (const auto simulation = simcore::Simulation::create(*scene, {}); !simulation)
    return {simulation.error()};
  return {};
}

}  // namespace

std::vector<SceneTextFinding> checkSceneText(const std::string& text, const fs::path& file) {
  const ScratchFolder folder;
  const fs::path copy = folder.path() / file.filename(), around = folder.path() / "around" / "world.sdf";
  std::vector<SceneTextFinding> findings;
  const auto fail = [&](Error error) { findings.push_back({false, std::move(error)}); };
  if (folder.path().empty()) {
    fail({"scene.check", "no temporary file can be written, so the text cannot be checked", {}, {}});
    return findings;
  }
  const bool isMap = simcore::isMapFile(file);
  const bool isAlone = !isMap && describesModel(text) && !describesWorld(text);
  auto written = robotlink::writeFileAtomically(copy, isMap ? text : withWholePaths(text, file));
  if (written && isAlone) {
    written =
        robotlink::writeFileAtomically(around, "<sdf version=\"1.9\"><world name=\"check\"><include><uri>" +
                                                   copy.string() + "</uri></include></world></sdf>");
  }
  if (!written) {
    fail(written.error());
    return findings;
  }
  std::error_code unknown;
  const std::string real = fs::weakly_canonical(copy, unknown).string();
  for (Error error : errorsOfScene(isAlone ? around : copy)) {
    for (std::string* part : {&error.text, &error.where.file}) {
      for (const std::string& name : {real, copy.string(), around.string()})
        replaceAll(*part, name, file.string());
    }
    fail(std::move(error));
  }
  if (!isMap) addWarnings(text, file, findings);
  return findings;
}

std::optional<fs::path> sceneModelFile(const std::string& uri, const fs::path& file) {
  auto place = ownPlace(uri, file);
  std::error_code unknown;
  if (!place && uri.starts_with(kModelScheme)) {
    const fs::path shipped = robotlink::resource("scenes/models") / uri.substr(kModelScheme.size());
    if (fs::exists(shipped, unknown)) place = shipped;
  }
  if (!place) return std::nullopt;
  const fs::path model = fs::is_directory(*place, unknown) ? *place / "model.sdf" : *place;
  return fs::is_regular_file(model, unknown) ? std::optional(model) : std::nullopt;
}

std::vector<SceneModelFile> sceneModels(const fs::path& file) {
  std::map<std::string, SceneModelFile> all;
  const fs::path folder = fs::absolute(file).parent_path();
  std::error_code unknown;
  for (const fs::path& models : {folder, folder / "models", robotlink::resource("scenes/models")}) {
    for (const auto& entry : fs::directory_iterator(models, unknown)) {
      const fs::path model = entry.path() / "model.sdf";
      const std::string name = entry.path().filename().string();
      if (all.contains(name) || !fs::is_regular_file(model, unknown)) continue;
      const auto text = robotlink::readFile(model, kMaxSceneBytes);
      const bool isRobot = text && text->find("<robotcontrol:robot>") != std::string::npos;
      all[name] = {name, std::string(kModelScheme) + name, model, isRobot};
    }
  }
  std::vector<SceneModelFile> result;
  for (auto& [name, model] : all) result.push_back(std::move(model));
  return result;
}

}  // namespace app
