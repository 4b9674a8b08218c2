// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "colortool/ColorVotes.h"
#include "colortool/Samples.h"
#include "colortool/StrokeCells.h"
#include "colortool/TableCleanUp.h"

namespace colortool {

/// The table that the method of the settings makes of all that `votes` was told; not cleaned up.
ColorTable learnedTable(ColorVotes& votes, const TrainingSettings& settings);

/// Keeps a table up to date with samples that are being edited: what did not change since the last call costs
/// nothing, so that a stroke takes less than a millisecond with votes. The table depends on the samples only,
/// not on the way they came about. One thread.
class TableTrainer {
 public:
  /// The table of these samples, cleaned up as their settings say. With TrainingMethod::kVotes incremental,
  /// else made anew from all of them (0.1 to 1 s). Valid until the next call.
  const ColorTable& train(const Samples& samples);
  const ColorTable& table() const { return table_; }
  const ColorVotes& votes() const { return votes_; }

  /// How sure the last table is of each cell, by ColorTable::cellOf: 255 where no other class has a vote, 0
  /// where another one has as many. Cells of none have the margin of the background against the best class,
  /// 255 where nothing has a vote. Of the votes, whatever the method. About 3 ms.
  std::vector<std::uint8_t> margins() const;

 private:
  struct Learned {
    StrokePtr stroke;  // kept, so that its address is not that of another one
    std::vector<StrokeCell> cells;
    bool current = true;
  };
  /// Whether what was learned of the strokes still holds.
  bool sameGround(const Samples& samples) const;
  void follow(const Samples& samples);

  ColorVotes votes_{1};
  std::unordered_map<const Stroke*, Learned> learned_;
  TableCleanUp cleanUp_;
  ColorTable table_;
  std::optional<Samples> last_;  // what table_ is of
};

}  // namespace colortool
