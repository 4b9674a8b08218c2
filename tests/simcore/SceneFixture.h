// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>

#include "simcore/Scene.h"
#include "tests/TestFolder.h"

namespace simcore {

/// A temporary folder of scene files: tests write texts and get scenes or errors.
class SceneFolder : public TestFolder {
 public:
  SceneFolder() : TestFolder(Where::kDisk) {}
  /// Writes models/NAME/model.sdf.
  void writeModel(const std::string& name, const std::string& text) const;
  /// Copies the shipped models into the folder "models".
  void copyShippedModels() const;
  /// The errors of a world with this text, one per line, without the folder's path; empty if there are none.
  std::string errorsOf(const std::string& world) const;
};

/// The shipped scene, loaded once for all tests of a program.
std::shared_ptr<const Scene> shippedScene();
/// The text of a world with `contents`.
std::string worldAround(const std::string& contents);
/// `text` with the first `from` replaced by `to`; fails the test if there is none.
std::string replaced(std::string text, const std::string& from, const std::string& to);

/// A model of a box that rotates on a leg; tests damage it by replacing parts.
extern const char* const kSmallModel;

}  // namespace simcore
