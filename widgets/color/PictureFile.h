// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "robotlink/base/Image.h"

namespace widgets {

// Pictures in files: PNG, JPEG, and .yuyv, which is 320 x 240 pixels of the bytes Y0 Cb Y1 Cr. All functions
// from any thread.

inline constexpr int kYuyvWidth = 320, kYuyvHeight = 240;  ///< of a .yuyv, in pixels with two Y each

/// Returns the ending of a file's name in small letters, ".png".
std::string endingOf(const std::filesystem::path& file);
bool isPictureFile(const std::filesystem::path& file);
/// Errors name the file. Of a .yuyv's pixels the second Y is shown, so that they are square; two of them
/// share the mean of their Cb and Cr.
robotlink::Result<robotlink::Image> readPicture(const std::filesystem::path& file);
/// All of these, and those in these folders, by their names; files that are no pictures are left out of
/// folders. Fails where there is none, or a folder cannot be read.
robotlink::Result<std::vector<std::filesystem::path>> pictureFiles(
    const std::vector<std::filesystem::path>& filesOrFolders);

}  // namespace widgets
