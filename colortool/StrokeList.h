// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"

namespace colortool {

/// A disc of an image that shows a colour class, as a line of a list of strokes names it.
struct DiscStroke {
  std::string image;       ///< a file's name
  std::string colorClass;  ///< kBackground: none of the classes
  double x = 0,
         y = 0;  ///< centre; pixels of an image that is kReferenceWidth wide, pixel centres at whole numbers
  double radius = 0;  ///< of the same pixels

  static constexpr std::string_view kBackground = "background";
  static constexpr int kReferenceWidth = 320;
  bool operator==(const DiscStroke&) const = default;
};

/// Reads a list of strokes: CSV with the header `image,class,x,y,radius` (columns in any order). All that is
/// wrong with it is told at once, with line and column.
tl::expected<std::vector<DiscStroke>, robotlink::Errors> readStrokeList(const std::filesystem::path& file);
/// The same from text; `file` is the name that errors carry.
tl::expected<std::vector<DiscStroke>, robotlink::Errors> parseStrokeList(std::string_view text,
                                                                         const std::string& file);

}  // namespace colortool
