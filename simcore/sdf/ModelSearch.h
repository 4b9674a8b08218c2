// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace simcore {

/// Finds the files that scenes name by URIs: models and meshes. A plain value; reads the environment once,
/// when it is made.
///
/// model://NAME/REST and package://NAME/REST are searched, in this order, below the folders given, below the
/// scene's folder and its folder `models`, below those of the environment variables GZ_SIM_RESOURCE_PATH,
/// IGN_GAZEBO_RESOURCE_PATH, SDF_PATH and GAZEBO_MODEL_PATH (separated by colons), among the shipped models,
/// and in the four folders above that of the file that names it. file://PATH and plain paths are taken from
/// the file that names them, then from the folders above. Nothing is fetched from the network.
class ModelSearch {
 public:
  /// `scene` is the file of the scene.
  explicit ModelSearch(const std::filesystem::path& scene, std::vector<std::filesystem::path> folders = {});

  /// The file or folder of a URI in the file `from`; nothing if it does not exist.
  std::optional<std::filesystem::path> find(const std::string& uri, const std::filesystem::path& from) const;
  /// The model's file: as find(), and for a folder the file that its model.config names, or model.sdf.
  std::optional<std::filesystem::path> findModel(const std::string& uri,
                                                 const std::filesystem::path& from) const;
  /// The file of the first model in these folders that is a robot of this kind (<robotcontrol:robot>), by the
  /// models' names; nothing if there is none. Looks into all of them.
  std::optional<std::filesystem::path> findRobot(const std::string& kind) const;
  const std::vector<std::filesystem::path>& folders() const { return folders_; }
  /// The folders that are searched, for messages: "a, b, c".
  std::string describe() const;

 private:
  std::vector<std::filesystem::path> folders_;
};

/// Whether a URI is one of the network: http://, https://.
bool isNetworkUri(const std::string& uri);

}  // namespace simcore
