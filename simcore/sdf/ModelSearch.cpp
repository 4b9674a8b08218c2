// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/sdf/ModelSearch.h"

#include <tinyxml2.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/Resources.h"
#include "simcore/sdf/SdfOwnElements.h"
#include "simcore/sdf/SdfPaths.h"

namespace simcore {
namespace fs = std::filesystem;

namespace {

constexpr std::size_t kMaxConfigBytes = 1U << 20U, kMaxModelBytes = 16U << 20U;
constexpr const char* kVariables[] = {"GZ_SIM_RESOURCE_PATH", "IGN_GAZEBO_RESOURCE_PATH", "SDF_PATH",
                                      "GAZEBO_MODEL_PATH"};

bool isPresent(const fs::path& path) {
  std::error_code error;
  return fs::exists(path, error);
}

fs::path resolved(const fs::path& path) {
  std::error_code error;
  const fs::path result = fs::weakly_canonical(path, error);
  return error ? path : result;
}

/// The version of a <sdf> in a model.config; its text is a number like 1.6.
double versionOf(const tinyxml2::XMLElement& sdf) {
  return sdf.Attribute("version") != nullptr ? std::atof(sdf.Attribute("version")) : 0;
}

/// The newest file that a folder's model.config names; model.sdf if there is none.
fs::path modelIn(const fs::path& folder) {
  const fs::path fallback = folder / "model.sdf";
  const auto text = robotlink::readFile(folder / "model.config", kMaxConfigBytes);
  tinyxml2::XMLDocument config;
  if (!text || config.Parse(text->data(), text->size()) != tinyxml2::XML_SUCCESS || !config.RootElement())
    return fallback;
  const tinyxml2::XMLElement* newest = nullptr;
  for (const auto* sdf = config.RootElement()->FirstChildElement("sdf"); sdf != nullptr;
       sdf = sdf->NextSiblingElement("sdf")) {
    if (newest == nullptr || versionOf(*sdf) > versionOf(*newest)) newest = sdf;
  }
  const fs::path named = folder / trimmedText(newest);
  return newest != nullptr && !trimmedText(newest).empty() && isPresent(named) ? named : fallback;
}

/// Whether the first model in a file is a robot of this kind.
bool describesRobot(const fs::path& file, const std::string& kind) {
  const auto text = robotlink::readFile(file, kMaxModelBytes);
  // Most files need not be parsed.
  if (!text || text->find(kind) == std::string::npos) return false;
  tinyxml2::XMLDocument document;
  if (document.Parse(text->data(), text->size()) != tinyxml2::XML_SUCCESS || !document.RootElement())
    return false;
  useOwnPrefix(*document.RootElement());
  const tinyxml2::XMLElement* model = document.RootElement()->FirstChildElement("model");
  return model != nullptr && childText(*model, "robotcontrol:robot") == kind;
}

}  // namespace

bool isNetworkUri(const std::string& uri) {
  return uri.starts_with("http://") || uri.starts_with("https://");
}

ModelSearch::ModelSearch(const fs::path& scene, std::vector<fs::path> folders)
    : folders_(std::move(folders)) {
  const fs::path folder = scene.parent_path();
  folders_.insert(folders_.end(), {folder, folder / "models"});
  for (const char* variable : kVariables) {
    const char* const value = std::getenv(variable);
    std::istringstream list(value != nullptr ? value : "");
    for (std::string one; std::getline(list, one, ':');) {
      if (!one.empty()) folders_.emplace_back(one);
    }
  }
  folders_.push_back(robotlink::resource("scenes/models"));
}

std::optional<fs::path> ModelSearch::find(const std::string& uri, const fs::path& from) const {
  if (uri.empty() || isNetworkUri(uri)) return std::nullopt;
  std::string rest = uri;
  std::vector<fs::path> candidates;
  const auto strip = [&](std::string_view scheme) {
    if (!rest.starts_with(scheme)) return false;
    rest = rest.substr(scheme.size());
    return true;
  };
  if (strip("model://") || strip("package://")) {
    if (fs::path(rest).is_absolute()) return std::nullopt;
    for (const fs::path& folder : folders_) candidates.push_back(folder / rest);
    // A model names its own files by its folder's name; its neighbors are next to it. A few levels are
    // enough.
    fs::path above = from.parent_path();
    for (int level = 0; level < 4 && above.has_parent_path(); ++level) {
      above = above.parent_path();
      candidates.push_back(above / rest);
    }
  } else {
    strip("file://");
    if (rest.find("://") != std::string::npos) return std::nullopt;
    candidates.push_back(from.parent_path() / rest);
    for (const fs::path& folder : folders_) candidates.push_back(folder / rest);
  }
  const auto found = std::ranges::find_if(candidates, isPresent);
  if (found == candidates.end()) return std::nullopt;
  return resolved(*found);
}

std::optional<fs::path> ModelSearch::findModel(const std::string& uri, const fs::path& from) const {
  const auto found = find(uri, from);
  if (!found) return std::nullopt;
  std::error_code error;
  const fs::path file = fs::is_directory(*found, error) ? modelIn(*found) : *found;
  if (!fs::is_regular_file(file, error)) return std::nullopt;
  return resolved(file);
}

std::optional<fs::path> ModelSearch::findRobot(const std::string& kind) const {
  for (const fs::path& folder : folders_) {
    std::vector<fs::path> models;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder.empty() ? "." : folder, error)) {
      if (entry.is_directory(error)) models.push_back(modelIn(entry.path()));
    }
    std::ranges::sort(models);
    const auto found =
        std::ranges::find_if(models, [&](const fs::path& model) { return describesRobot(model, kind); });
    if (found != models.end()) return resolved(*found);
  }
  return std::nullopt;
}

std::string ModelSearch::describe() const {
  std::string text;
  for (const fs::path& folder : folders_) {
    const std::string name = folder.empty() ? "." : folder.string();
    text += (text.empty() ? "" : ", ") + name;
  }
  return text;
}

}  // namespace simcore
