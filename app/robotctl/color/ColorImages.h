// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "colortool/image/ColorImage.h"
#include "robotlink/base/Error.h"

namespace logplayer {
class LogFile;
}

namespace app {

/// The images that color commands read: those of a folder (PNG, JPEG, .yuyv) or of a log. Images of a log are
/// named by their number from 0 with at least three digits: "000", "001"; images of classes are not counted.
/// One thread.
///
/// A .yuyv file contains 320 x 240 pixels of the bytes Y0 Cb Y1 Cr per pixel; the color of a pixel is (Y1,
/// Cb, Cr).
class ColorImages {
 public:
  /// Fails if there is no such folder or log.
  static robotlink::Result<ColorImages> open(const std::filesystem::path& folderOrLog);

  /// The names of all images, sorted.
  const std::vector<std::string>& names() const { return names_; }
  /// Loads an image by its name, with or without its ending.
  robotlink::Result<colortool::ColorImage> load(const std::string& name) const;

  /// The true classes of an image of a log, in the numbers of TrueClasses; empty if they were not recorded,
  /// or for images of a folder.
  robotlink::Result<std::optional<robotlink::Image>> trueClasses(const std::string& name) const;

  /// Loads an image file.
  static robotlink::Result<colortool::ColorImage> loadFile(const std::filesystem::path& file);
  /// Loads the gray values of a PNG: class numbers.
  static robotlink::Result<robotlink::Image> loadLabels(const std::filesystem::path& file);

 private:
  /// The place of an image in the log.
  struct LogImage {
    std::string stream;
    /// In ns.
    std::int64_t time = 0;
  };
  static robotlink::Result<ColorImages> openLog(const std::filesystem::path& file);
  robotlink::Result<colortool::ColorImage> loadLogged(const std::string& name) const;

  std::filesystem::path path_;
  std::vector<std::string> names_;
  /// Null for a folder.
  std::shared_ptr<logplayer::LogFile> log_;
  /// Keyed by name; empty for a folder.
  std::map<std::string, LogImage> logged_;
};

}  // namespace app
