// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <string>
#include <string_view>

#include "colortool/image/ColorClasses.h"
#include "colortool/table/CellGrid.h"
#include "robotlink/base/Error.h"

namespace colortool {

/// Describes a color table format that consists of nothing but one byte per cell: its size, the order of its
/// cells and the meaning of the bytes. Constant data.
struct NumberedTable {
  /// A byte value and the class that it represents.
  struct Class {
    /// The value in the file.
    std::uint8_t byte;
    /// The name that the team uses.
    std::string_view name;
    /// The color in which views show the class.
    robotlink::Rgb rgb;
  };
  /// The id of errors.
  std::string_view id;
  /// The format's name in errors: "a table of rUNSWift".
  std::string_view title;
  /// Cells along Y and the two chroma channels.
  std::array<int, 3> sides;
  /// Whether Cr comes before Cb.
  bool crFirst;
  /// The byte of cells without a class.
  std::uint8_t none;
  /// All classes of the format; they become our classes 1, 2, ...
  std::span<const Class> known;

  /// The size of a file in this format.
  std::size_t bytes() const { return CellGrid::count(sides); }
  ColorClasses classes() const;
};

// The bytes of these two are numbers of classes.
extern const NumberedTable kRunswiftTable;
extern const NumberedTable kNUbotsTable;
/// The bytes of this one are masks with a bit for each class.
extern const NumberedTable kUPennTable;

/// Fails, with the offset, if the number of bytes is not that of the format, or on a byte that represents no
/// class.
robotlink::Result<CellGrid> parseNumberedTable(const NumberedTable& format, std::string_view bytes,
                                               const std::string& file);

}  // namespace colortool
