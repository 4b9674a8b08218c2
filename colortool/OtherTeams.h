// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "colortool/CellGrid.h"
#include "colortool/ColorClasses.h"
#include "robotlink/base/Error.h"

namespace colortool {

/// A colour table that is nothing but its cells, one byte each: how many, in which order, and what the bytes
/// stand for. Constant data.
struct NumberedTable {
  struct Class {
    std::uint8_t byte;
    std::string_view name;  ///< as its team calls it
    robotlink::Rgb rgb;     ///< that views show it in
  };
  std::string_view id;     ///< of errors
  std::string_view title;  ///< "a table of rUNSWift"
  std::array<int, 3> sides;
  bool crFirst;
  std::uint8_t none;
  std::span<const Class> known;  ///< become our classes 1, 2, ...

  std::size_t bytes() const { return CellGrid::count(sides); }
  ColorClasses classes() const;
};

// The bytes of these two are numbers of classes.
extern const NumberedTable kRunswiftTable;
extern const NumberedTable kNUbotsTable;
/// The bytes of this one are masks with a bit for each class.
extern const NumberedTable kUPennTable;

/// Fails, with the offset, where there are not as many bytes as the format has, or a byte that stands for
/// nothing. For tables of numbers.
robotlink::Result<CellGrid> parseNumberedTable(const NumberedTable& format, std::string_view bytes,
                                               const std::string& file);

}  // namespace colortool
