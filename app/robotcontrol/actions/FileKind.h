// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>

namespace app {

/// The kinds of files, by the action of the workbench when one is opened or dropped.
enum class FileKind {
  kScene,       ///< a world or the map of a building: simulate it
  kLayout,      ///< a process layout: run it
  kPictures,    ///< a picture, or a folder of pictures: paint in them
  kColorTable,  ///< a color table of ours or of another team: give it to the selected robot
  kMotion,      ///< a key-frame motion of ours or of another team: open it in the editor
  kLog,         ///< anything else: open it as a log
};

/// Decides by the suffix, in capitals or not, and by whether it is a folder. The file need not exist.
FileKind kindOfFile(const std::filesystem::path& file);

}  // namespace app
