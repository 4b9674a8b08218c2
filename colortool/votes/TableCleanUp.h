// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "colortool/table/CellSet.h"
#include "colortool/table/ColorTable.h"

namespace colortool {

/// The steps of the clean-up of a learned table.
struct CleanUpOptions {
  /// Connected cells of a class (26 neighbors) become none if they contain no sample of that class.
  bool removeUnsupported = true;
  /// Cells of none that a single class encloses become that class, unless they contain background samples.
  bool fillHoles = true;
  bool operator==(const CleanUpOptions&) const = default;
};

/// Removes cells of a table that no sample supports, and fills its holes. A hole is a connected set of cells
/// of none (6 neighbors) that does not reach the sides of the cube and whose neighbors are all of one class.
/// Removed cells can become part of a hole.
///
/// The result depends on the arguments only. The cache of the last call makes the next one faster: classes
/// whose cells and samples did not change are skipped. Takes about 0.2 ms after a stroke, 1 ms from scratch.
/// One thread.
class TableCleanUp {
 public:
  /// `sampled`: for each class the cells that contain its samples; class 0 is the background. Classes past
  /// its end have no samples. The result is valid until the next call.
  const ColorTable& clean(const ColorTable& raw, std::span<const CellSet> sampled,
                          const CleanUpOptions& options);
  /// The result of the last call of clean().
  const ColorTable& table() const { return table_; }

 private:
  /// The cached state of one class.
  struct Class {
    /// The cells of the class in the raw table.
    CellSet raw;
    /// The cells that contain samples of the class.
    CellSet sampled;
    /// The supported cells of raw.
    CellSet kept;
    /// Whether raw or sampled changed since kept was computed.
    bool changed = true;
  };
  /// Updates the cached cell sets from the arguments of clean().
  void follow(const ColorTable& raw, std::span<const CellSet> sampled);
  /// Updates the cell sets in one row of cells.
  void followRow(std::size_t row, std::span<const std::uint8_t> cells);
  /// Computes Class::kept of the classes that changed.
  void findSupported(bool removeUnsupported);
  /// removeCells() writes the unsupported cells into table_ as none, fillHoles() the holes.
  void removeCells();
  void fillHoles();

  /// Indexed by class number; 0 is the background.
  std::vector<Class> classes_;
  /// The raw table of the last call.
  std::optional<ColorTable> raw_;
  CleanUpOptions options_;
  ColorTable table_;
};

}  // namespace colortool
