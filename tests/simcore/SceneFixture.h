// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "simcore/Scene.h"

namespace simcore {

/// A folder of scene files that goes away with its test: texts in, scenes or errors out.
class SceneFolder {
 public:
  SceneFolder();
  ~SceneFolder();
  SceneFolder(const SceneFolder&) = delete;
  SceneFolder& operator=(const SceneFolder&) = delete;

  /// Writes a file, making its folders; gives its path.
  std::filesystem::path write(const std::string& name, const std::string& text) const;
  /// Writes models/NAME/model.sdf.
  void writeModel(const std::string& name, const std::string& text) const;
  /// Puts the shipped models into models.
  void copyShippedModels() const;
  /// What is wrong with a world of this text, a line an error, without the folder's path; empty if nothing
  /// is.
  std::string errorsOf(const std::string& world) const;

 private:
  std::filesystem::path path_;
};

/// The shipped scene, loaded once for all tests of a program.
std::shared_ptr<const Scene> shippedScene();
/// A world around `contents`.
std::string worldAround(const std::string& contents);
/// `text` with the first `from` replaced by `to`; fails the test if there is none.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// A model of a box that turns on a leg; broken by replacing parts of it.
extern const char* const kSmallModel;

}  // namespace simcore
