// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/platforms/simulated/scenetext/SceneText.h"

#include <stdlib.h>

#include <algorithm>
#include <map>
#include <string_view>

#include "robotlink/base/AtomicFile.h"
#include "simcore/Scene.h"
#include "simcore/SceneFileKind.h"
#include "simcore/Simulation.h"
#include "simcore/sdf/ModelSearch.h"

namespace app {
namespace fs = std::filesystem;
using robotlink::Error;

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

/// The text with each <uri> replaced by the whole path that it means in its file, in the same line, since the
/// text is checked in another folder.
std::string withWholePaths(const std::string& text, const fs::path& file, const ModelFolders& folders) {
  constexpr std::string_view kOpen = "<uri>", kClose = "</uri>";
  const fs::path whole = fs::absolute(file);
  const simcore::ModelSearch search(whole, folders);
  std::string result;
  std::size_t done = 0;
  for (std::size_t at = text.find(kOpen); at != std::string::npos; at = text.find(kOpen, done)) {
    const std::size_t begin = at + kOpen.size(), end = text.find(kClose, begin);
    if (end == std::string::npos) break;
    const std::string uri = text.substr(begin, end - begin);
    const auto place = search.find(uri, whole);
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

/// The errors of a scene's file, also those that show only when it begins to run; if there are none, what is
/// left out of `own`; what is left out of other files is not about this text.
std::vector<SceneTextFinding> findingsOfScene(const fs::path& file, const fs::path& own,
                                              const ModelFolders& folders) {
  std::vector<SceneTextFinding> findings;
  const auto scene = simcore::Scene::load(file, {}, {}, folders);
  if (!scene) {
    for (const Error& error : scene.error()) findings.push_back({false, error});
    return findings;
  }
  const auto simulation = simcore::Simulation::create(*scene, {});
  if (!simulation) return {{false, simulation.error()}};
  for (const simcore::LeftOuts* leftOut : {&(*scene)->leftOut(), &(*simulation)->overlaps()}) {
    for (const simcore::LeftOut& one : *leftOut) {
      if (!one.where.file.empty() && one.where.file != own.string()) continue;
      const std::string object = one.object.empty() ? "" : one.object + ": ";
      findings.push_back(
          {true, {"scene.left-out", object + one.what + ": " + one.why, {one.what}, one.where}});
    }
  }
  return findings;
}

}  // namespace

std::vector<SceneTextFinding> checkSceneText(const std::string& text, const fs::path& file,
                                             const ModelFolders& folders) {
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
  auto written = robotlink::writeFileAtomically(copy, isMap ? text : withWholePaths(text, file, folders));
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
  findings = findingsOfScene(isAlone ? around : copy, isAlone ? fs::path(real) : copy, folders);
  for (SceneTextFinding& one : findings) {
    for (std::string* part : {&one.error.text, &one.error.where.file}) {
      for (const std::string& name : {real, copy.string(), around.string()})
        replaceAll(*part, name, file.string());
    }
  }
  return findings;
}

std::optional<fs::path> sceneModelFile(const std::string& uri, const fs::path& file,
                                       const ModelFolders& folders) {
  const fs::path whole = fs::absolute(file);
  return simcore::ModelSearch(whole, folders).findModel(uri, whole);
}

std::vector<SceneModelFile> sceneModels(const fs::path& file, const ModelFolders& folders) {
  std::map<std::string, SceneModelFile> all;
  const fs::path whole = fs::absolute(file);
  const simcore::ModelSearch search(whole, folders);
  std::error_code unknown;
  for (const fs::path& models : search.folders()) {
    for (const auto& entry : fs::directory_iterator(models, unknown)) {
      const std::string name = entry.path().filename().string();
      if (all.contains(name) || !entry.is_directory(unknown)) continue;
      const auto model = search.findModel(entry.path().string(), whole);
      if (!model) continue;
      const auto text = robotlink::readFile(*model, kMaxSceneBytes);
      const bool isRobot = text && text->find("<robotcontrol:robot>") != std::string::npos;
      all[name] = {name, std::string(kModelScheme) + name, *model, isRobot};
    }
  }
  std::vector<SceneModelFile> result;
  for (auto& [name, model] : all) result.push_back(std::move(model));
  return result;
}

}  // namespace app
