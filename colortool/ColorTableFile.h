// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"

namespace colortool {

/// A colour table as a `.c64` file of the GermanTeam and of B-Human holds it: 64 x 64 x 64 cells in the order
/// of ColorTable, written as runs of equal cells, {int32 length, uint8 cell} each, little endian, ended by an
/// int32 0. A file does not say what its classes are called: see NamedColorTable. A plain value.
///
/// What was read is written again to the same bytes, if it was written by its owners' tools (longest runs).
struct ColorTableFile {
  /// A cell with this bit is of several classes at once, as happens while a table is made: bit i stands for
  /// class i + 1.
  static constexpr std::uint8_t kSeveral = 0x80;
  /// Classes that a cell of several can have, and a cell at all.
  static constexpr int kMaxOfSeveral = 7, kMaxClasses = 127;
  static constexpr std::size_t kCellCount = std::size_t{64} * 64 * 64;
  /// Class 0 is none; class n is kBHuman2009Classes[n - 1].
  static constexpr std::array<std::string_view, 8> kBHuman2009Classes = {
      "orange", "yellow", "blue", "white", "green", "black", "red", "robotBlue"};

  std::vector<std::uint8_t> cells = std::vector<std::uint8_t>(kCellCount, 0);

  /// The cells with one class each: of several the one with the lowest number (the ball's orange is the
  /// first).
  std::vector<std::uint8_t> singleClasses() const;
  /// The classes of each cell: bit i for class i + 1. Classes above 16 have no bit.
  std::vector<std::uint16_t> masks() const;

  struct Packed;
  /// A table whose cells may have several classes: of each cell the one that it is of, and all (as masks()
  /// has them; one or none: the cell is of its class alone). Both of kCellCount, or the table is empty.
  static Packed pack(std::span<const std::uint8_t> winners, std::span<const std::uint16_t> masks);

  /// Fails, with the offset, where the runs do not add up to a table. `file` is the name that errors carry.
  static robotlink::Result<ColorTableFile> parse(std::string_view bytes, const std::string& file);
  static robotlink::Result<ColorTableFile> load(const std::filesystem::path& file);

  std::string bytes() const;
  robotlink::Result<void> save(const std::filesystem::path& file) const;

  bool operator==(const ColorTableFile&) const = default;
};

/// A table, and what there was no room for in it.
struct ColorTableFile::Packed {
  ColorTableFile file;
  std::size_t reducedCells = 0;  ///< of several classes, one above kMaxOfSeveral: written as their winner
  std::size_t emptiedCells = 0;  ///< of a class above kMaxClasses: written as none
};

}  // namespace colortool
