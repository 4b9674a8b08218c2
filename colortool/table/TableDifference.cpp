// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/table/TableDifference.h"

namespace colortool {
namespace {

ColorTable numberedAs(const ColorClasses& classes, const ColorTable& table, const ColorClasses& own) {
  return ColorTable::translated(table.cells(), classNumbers(own, classes));
}

/// The cells for which `holds(before, after)` is true.
template <typename Holds>
CellSet cellsWhere(const ColorTable& before, const ColorTable& after, const Holds& holds) {
  const auto was = before.cells(), is = after.cells();
  CellSet cells;
  for (std::size_t row = 0; row < CellSet::kRows; ++row) {
    CellSet::Row bits = 0;
    for (std::size_t i = 0; i < 64; ++i) {
      const std::size_t cell = row * 64 + i;
      if (was[cell] != is[cell] && holds(was[cell], is[cell])) bits |= CellSet::Row{1} << i;
    }
    cells.row(row) = bits;
  }
  return cells;
}

}  // namespace

TableDifference::TableDifference(const ColorTable& before, const ColorClasses& classesBefore,
                                 const ColorTable& after, const ColorClasses& classesAfter)
    : classes_(unite(classesAfter, classesBefore)),
      before_(numberedAs(classes_, before, classesBefore)),
      after_(numberedAs(classes_, after, classesAfter)) {
  const auto size = static_cast<std::size_t>(classes_.size());
  counts_.resize(size * size);
  const auto was = before_.cells(), is = after_.cells();
  for (std::size_t cell = 0; cell < was.size(); ++cell) {
    ++counts_[was[cell] * size + is[cell]];
    changed_ += was[cell] != is[cell] ? 1 : 0;
  }
}

TableDifference::OfClass TableDifference::ofClass(int colorClass) const {
  OfClass sum;
  for (int other = 0; other < classes_.size(); ++other) {
    sum.before += count(colorClass, other);
    sum.after += count(other, colorClass);
  }
  const std::uint64_t kept = count(colorClass, colorClass);
  sum.lost = sum.before - kept;
  sum.gained = sum.after - kept;
  return sum;
}

CellSet TableDifference::cells(int colorClass, Change change) const {
  return cellsWhere(before_, after_, [&](std::uint8_t was, std::uint8_t is) {
    return (change != Change::kGained && was == colorClass) || (change != Change::kLost && is == colorClass);
  });
}

CellSet TableDifference::cells() const {
  return cellsWhere(before_, after_, [](std::uint8_t, std::uint8_t) { return true; });
}

}  // namespace colortool
