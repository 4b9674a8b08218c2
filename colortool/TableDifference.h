// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "colortool/CellSet.h"
#include "colortool/ColorClasses.h"
#include "colortool/ColorTable.h"

namespace colortool {

/// Which cells of two tables are of different classes. Classes are the same if their names are, whatever
/// their numbers. Made in about half a millisecond, then immutable; half a megabyte.
class TableDifference {
 public:
  TableDifference(const ColorTable& before, const ColorClasses& classesBefore, const ColorTable& after,
                  const ColorClasses& classesAfter);

  /// Those of the second table, with its numbers and colours, then those that only the first one has.
  const ColorClasses& classes() const { return classes_; }

  /// Cells that were of one class and are of the other; of `classes()`, 0 is none.
  std::uint64_t count(int from, int to) const {
    return counts_[static_cast<std::size_t>(from) * static_cast<std::size_t>(classes_.size()) +
                   static_cast<std::size_t>(to)];
  }
  /// All cells that are of another class.
  std::uint64_t changed() const { return changed_; }

  /// What became of a class, in cells.
  struct OfClass {
    std::uint64_t before = 0, after = 0;
    std::uint64_t gained = 0;  ///< from other classes, none included
    std::uint64_t lost = 0;    ///< to other classes, none included
    bool operator==(const OfClass&) const = default;
  };
  OfClass ofClass(int colorClass) const;

  enum class Change : std::uint8_t { kGained, kLost, kAny };
  /// The cells that a class gained or lost.
  CellSet cells(int colorClass, Change change) const;
  /// All cells that changed.
  CellSet cells() const;

 private:
  ColorClasses classes_;
  ColorTable before_, after_;  // in numbers of classes_
  std::vector<std::uint64_t> counts_;
  std::uint64_t changed_ = 0;
};

}  // namespace colortool
