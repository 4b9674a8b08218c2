// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"

// Files of pictures: PNG, JPEG, and .yuyv, which is 320 x 240 pixels of the bytes Y0 Cb Y1 Cr (640 Y values
// per row). All functions can be called from any thread.
namespace logplayer {

/// Whether a file is a picture, by its extension only.
bool isPictureFile(const std::filesystem::path& file);

/// The choice of the pixels of a .yuyv file that are read.
enum class YuyvPixels {
  kSquare,  ///< 320 x 240: the second Y of each pair; two neighbors share the mean of their Cb and Cr
  kAll,     ///< 640 x 240: every Y
};
/// Reads a picture; errors name the file. `yuyv` matters for .yuyv files only.
robotlink::Result<robotlink::Image> readPicture(const std::filesystem::path& file,
                                                YuyvPixels yuyv = YuyvPixels::kSquare);
/// These files, and the pictures in these folders sorted by name (not in subfolders). Fails if there is no
/// picture or a folder cannot be read.
robotlink::Result<std::vector<std::filesystem::path>> pictureFiles(
    const std::vector<std::filesystem::path>& filesOrFolders);

}  // namespace logplayer
