// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "robotlink/base/Error.h"

namespace colortool {

/// A color table as stored in a `.c64` file of the GermanTeam and of B-Human: 64 x 64 x 64 cells in the order
/// of ColorTable, written as runs of equal cells, each {int32 length, uint8 cell}, little endian, terminated
/// by an int32 0. The file does not contain the names of the classes, see NamedColorTable. A plain value.
///
/// A file that its owners' tools wrote (with runs as long as possible) is reproduced byte by byte.
struct ColorTableFile {
  /// Set in a cell that belongs to several classes at once, as happens while a table is being made: then bit
  /// i means class i + 1.
  static constexpr std::uint8_t kSeveral = 0x80;
  /// Classes that a cell of several can have, and a cell at all.
  static constexpr int kMaxOfSeveral = 7, kMaxClasses = 127;
  static constexpr std::size_t kCellCount = std::size_t{64} * 64 * 64;

  /// The bytes of the file, one per cell; kCellCount of them.
  std::vector<std::uint8_t> cells = std::vector<std::uint8_t>(kCellCount, 0);

  /// The cells with one class each: a cell of several classes gets the one with the lowest number (the orange
  /// of the ball is the first).
  std::vector<std::uint8_t> singleClasses() const;
  /// The classes of each cell as a bit mask, bit i for class i + 1. Classes above 16 have no bit.
  std::vector<std::uint16_t> masks() const;

  struct Packed;
  /// Builds a file whose cells may have several classes. `winners` holds the main class of each cell, `masks`
  /// all its classes as masks() returns them; a mask with at most one bit means the winner alone. Both must
  /// have kCellCount elements, or the table is empty.
  static Packed pack(std::span<const std::uint8_t> winners, std::span<const std::uint16_t> masks);

  /// Fails, with the offset, if the runs do not add up to a table. `file` is the name that errors carry.
  static robotlink::Result<ColorTableFile> parse(std::string_view bytes, const std::string& file);
  static robotlink::Result<ColorTableFile> load(const std::filesystem::path& file);

  /// The contents of the file.
  std::string bytes() const;
  /// Replaces the file atomically: it is written completely or not at all.
  robotlink::Result<void> save(const std::filesystem::path& file) const;

  bool operator==(const ColorTableFile&) const = default;
};

/// A packed table together with what did not fit into the format.
struct ColorTableFile::Packed {
  ColorTableFile file;
  std::size_t reducedCells = 0;  ///< of several classes, one above kMaxOfSeveral: written as their winner
  std::size_t emptiedCells = 0;  ///< of a class above kMaxClasses: written as none
};

}  // namespace colortool
