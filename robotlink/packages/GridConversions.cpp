// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/packages/GridConversions.h"

#include <cmath>
#include <optional>

#include "foxglove/Grid.pb.h"
#include "robotlink/packages/Conversions.h"

namespace robotlink {
namespace {

constexpr int kOccupied = 50, kFull = 100;
constexpr std::size_t kMaxPoints = 4'000'000;

/// The cells of a message whose sizes were checked.
struct Cells {
  std::size_t columns = 0, rows = 0, rowStride = 0, cellStride = 0, offset = 0;
  const std::string* data = nullptr;

  bool occupied(std::size_t column, std::size_t row) const {
    const auto value = static_cast<std::int8_t>((*data)[row * rowStride + column * cellStride + offset]);
    return value >= kOccupied && value <= kFull;
  }
};

std::optional<Cells> cellsOf(const foxglove::Grid& grid) {
  const double x = grid.cell_size().x(), y = grid.cell_size().y();
  if (!(x > 0 && std::isfinite(x) && y > 0 && std::isfinite(y))) return std::nullopt;
  for (const foxglove::PackedElementField& field : grid.fields()) {
    if (field.type() != foxglove::PackedElementField::INT8 || field.name() != "occupancy") continue;
    const Cells cells{grid.column_count(), grid.row_stride() > 0 ? grid.data().size() / grid.row_stride() : 0,
                      grid.row_stride(),   grid.cell_stride(),
                      field.offset(),      &grid.data()};
    const bool fits = cells.offset < cells.cellStride && cells.columns * cells.cellStride <= cells.rowStride;
    if (fits) return cells;
  }
  return std::nullopt;
}

}  // namespace

void forOccupiedRuns(const foxglove::Grid& grid, const std::function<bool(const GridRun&)>& use) {
  const std::optional<Cells> cells = cellsOf(grid);
  if (!cells) return;
  const double x = grid.cell_size().x(), y = grid.cell_size().y();
  for (std::size_t row = 0; row < cells->rows; ++row) {
    for (std::size_t column = 0; column < cells->columns; ++column) {
      const std::size_t begin = column;
      while (column < cells->columns && cells->occupied(column, row)) ++column;
      if (column == begin) continue;
      const GridRun run{{static_cast<double>(begin) * x, static_cast<double>(row) * y},
                        static_cast<double>(column - begin) * x,
                        y};
      if (!use(run)) return;
    }
  }
}

Result<GroundMap> groundMap(const foxglove::Grid& grid) {
  GroundMap map;
  const double cell = grid.cell_size().x();
  const Pose2 gridInMap = groundPose(pose3(grid.pose()));
  bool tooLarge = false;
  forOccupiedRuns(grid, [&](const GridRun& run) {
    const long count = std::lround(run.length / cell);
    for (long i = 0; i < count; ++i) {
      const auto at = (static_cast<double>(i) + 0.5) * cell;
      map.points.push_back(gridInMap * Vector2(run.low + Vector2(at, 0.5 * run.width)));
    }
    tooLarge = map.points.size() > kMaxPoints;
    return !tooLarge;
  });
  if (tooLarge)
    return failure("map.too-large", "the map has more than 4 million occupied cells: use larger cells");
  if (map.points.empty()) return failure("map.empty", "the map is still empty: drive the robot around");
  map.resolution = cell;
  return map;
}

}  // namespace robotlink
