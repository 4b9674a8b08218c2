// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"

namespace app {

/// A change of one element in a file of a scene. The steps to it are those of robotcontrol.WorldProperty:
/// names of elements, perhaps with the value of their attribute "name" in brackets ("link[body]"), perhaps
/// with alternatives ("lidar|ray"); a last one of several names, separated by commas ("ixx,iyy,izz"), is for
/// as many values, separated by blanks, each in an element of its own. The first one is "model", the first
/// model of the file, or "instance[NAME]", the model of this name or the <include> that has it, or
/// "light[NAME]".
struct SceneFileChange {
  std::string file;
  std::vector<std::string> element;
  /// The text of the element from now on.
  std::string value;
};

/// Returns the text of a file with one element changed, and everything else of it, such as comments and
/// layout, as it was. Elements that are missing on the way are added, each on a line of its own, except for
/// the first two steps. Fails, naming the line where there is one, if there is no such element, if the text
/// cannot be read as XML, or if the element is a pose in other units or another frame.
robotlink::Result<std::string> withElement(const std::string& text, const std::string& file,
                                           const std::vector<std::string>& element, const std::string& value);

/// Whether a file is one of a scene that may be changed: its own, one in its folder, or a model in `models`.
bool isFileOfScene(const std::filesystem::path& file, const std::filesystem::path& scene,
                   const std::filesystem::path& models);

/// Writes changes into the files of a scene, each file completely or not at all; unchanged files stay
/// untouched. Only files of the scene are written: its own, those in its folder, and the models in `models`.
/// If a change is impossible, nothing is written.
robotlink::Result<void> writeSceneChanges(const std::filesystem::path& scene,
                                          const std::filesystem::path& models,
                                          const std::vector<SceneFileChange>& changes);

}  // namespace app
