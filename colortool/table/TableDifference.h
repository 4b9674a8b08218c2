// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "colortool/image/ColorClasses.h"
#include "colortool/table/CellSet.h"
#include "colortool/table/ColorTable.h"

namespace colortool {

/// The cells in which two tables differ. Classes are equal if their names are, whatever their numbers. The
/// constructor takes about half a millisecond; immutable afterward. Half a megabyte.
class TableDifference {
 public:
  TableDifference(const ColorTable& before, const ColorClasses& classesBefore, const ColorTable& after,
                  const ColorClasses& classesAfter);

  /// The classes of the second table, with its numbers and colors, followed by those that only the first one
  /// has.
  const ColorClasses& classes() const { return classes_; }

  /// Number of cells that were of class `from` and are of class `to`, in the numbers of classes(); 0 is none.
  std::uint64_t count(int from, int to) const {
    return counts_[static_cast<std::size_t>(from) * static_cast<std::size_t>(classes_.size()) +
                   static_cast<std::size_t>(to)];
  }
  /// Number of all cells whose class changed.
  std::uint64_t changed() const { return changed_; }

  /// The changes of one class, in cells.
  struct OfClass {
    std::uint64_t before = 0, after = 0;
    /// Cells that the class gained from other classes, none included.
    std::uint64_t gained = 0;
    /// Cells that the class lost to other classes, none included.
    std::uint64_t lost = 0;
    bool operator==(const OfClass&) const = default;
  };
  OfClass ofClass(int colorClass) const;

  /// Selects among the changed cells of a class; kAny: gained or lost.
  enum class Change : std::uint8_t { kGained, kLost, kAny };
  /// The cells that a class gained, lost, or either.
  CellSet cells(int colorClass, Change change) const;
  /// All cells that changed.
  CellSet cells() const;

 private:
  ColorClasses classes_;
  /// In the numbers of classes_.
  ColorTable before_, after_;
  /// See count(); [from * classes + to].
  std::vector<std::uint64_t> counts_;
  std::uint64_t changed_ = 0;
};

}  // namespace colortool
