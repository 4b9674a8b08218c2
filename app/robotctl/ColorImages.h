// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "colortool/ColorImage.h"
#include "robotlink/base/Error.h"

namespace logplayer {
class LogFile;
}

namespace app {

/// A folder of images (PNG, JPEG, .yuyv) or a log's images, in which the colour commands read. Images of a
/// log are called by their numbers from 0, with three digits: "000", "001"; images of classes are not
/// counted.
///
/// A .yuyv file is 320 x 240 pixels of the bytes Y0 Cb Y1 Cr; a pixel's colour is (Y1, Cb, Cr).
class ColorImages {
 public:
  static robotlink::Result<ColorImages> open(const std::filesystem::path& folderOrLog);

  /// Names of files, or numbers, in their order.
  const std::vector<std::string>& names() const { return names_; }
  /// Loads an image by its name, with or without its ending.
  robotlink::Result<colortool::ColorImage> load(const std::string& name) const;

  /// What an image of a log truly shows, in the numbers of TrueClasses; nothing if that was not recorded, or
  /// if these are files.
  robotlink::Result<std::optional<robotlink::Image>> trueClasses(const std::string& name) const;

  /// A single file.
  static robotlink::Result<colortool::ColorImage> loadFile(const std::filesystem::path& file);
  /// The grey values of a PNG: labels.
  static robotlink::Result<robotlink::Image> loadLabels(const std::filesystem::path& file);

 private:
  struct LogImage {
    std::string stream;
    std::int64_t time = 0;  ///< ns
  };
  static robotlink::Result<ColorImages> openLog(const std::filesystem::path& file);
  robotlink::Result<colortool::ColorImage> loadLogged(const std::string& name) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  std::shared_ptr<logplayer::LogFile> log_;  // null: a folder
  std::map<std::string, LogImage> logged_;
};

}  // namespace app
