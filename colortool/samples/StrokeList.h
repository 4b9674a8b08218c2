// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"

namespace colortool {

/// A disc of an image that shows a color class: one line of a list of strokes.
struct DiscStroke {
  /// Name of the image file.
  std::string image;
  /// Name of the class, or kBackground for none of them.
  std::string colorClass;
  /// Center, in pixels of the image scaled to a width of kReferenceWidth; pixel centers are at whole numbers.
  double x = 0, y = 0;
  /// In the same pixels.
  double radius = 0;

  static constexpr std::string_view kBackground = "background";
  static constexpr int kReferenceWidth = 320;
  bool operator==(const DiscStroke&) const = default;
};

/// Reads a list of strokes: CSV with the header `image,class,x,y,radius` (columns in any order). Reports all
/// problems at once, each with its line and column.
tl::expected<std::vector<DiscStroke>, robotlink::Errors> readStrokeList(const std::filesystem::path& file);
/// Parses the same from text; `file` is the name that errors carry.
tl::expected<std::vector<DiscStroke>, robotlink::Errors> parseStrokeList(std::string_view text,
                                                                         const std::string& file);

}  // namespace colortool
