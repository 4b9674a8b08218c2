// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

#include "colortool/samples/Samples.h"
#include "colortool/training/StrokeCells.h"
#include "colortool/votes/ColorVotes.h"
#include "colortool/votes/TableCleanUp.h"

namespace colortool {

/// The table that the method of the settings learns from the samples in `votes`, without clean-up.
ColorTable learnedTable(ColorVotes& votes, const TrainingSettings& settings);

/// Keeps a table up to date with samples that are being edited. Unchanged strokes cost nothing, so that
/// training by votes takes less than a millisecond per stroke. The table depends on the samples only, not on
/// the order of the edits. One thread.
class TableTrainer {
 public:
  /// Returns the table of these samples, cleaned up as their settings say. Incremental with
  /// TrainingMethod::kVotes; the other methods start from scratch (0.1 to 1 s). Valid until the next call.
  const ColorTable& train(const Samples& samples);
  /// The result of the last call of train().
  const ColorTable& table() const { return table_; }
  /// The votes of the last call of train(), whatever the method.
  const ColorVotes& votes() const { return votes_; }

  /// The confidence of the last table per cell, indexed by ColorTable::cellOf(): 255 where no other class has
  /// votes, 0 where another one has as many. Cells of none have the margin of the background over the best
  /// class, 255 where nothing has votes. Computed from the votes, whatever the method. Takes about 3 ms.
  std::vector<std::uint8_t> margins() const;

 private:
  /// A stroke that is part of the votes.
  struct Learned {
    /// Owned, so that no other stroke can get its address while it is a key of learned_.
    StrokePtr stroke;
    /// The votes that were added for the stroke, so that exactly these can be removed.
    std::vector<StrokeCell> cells;
    /// Whether the stroke is still among the samples; used by follow().
    bool current = true;
  };
  /// Whether number of classes and corrections are unchanged, so that an incremental update is possible.
  bool sameGround(const Samples& samples) const;
  /// Adds new strokes to the votes and removes those that are gone.
  void follow(const Samples& samples);

  ColorVotes votes_{1};
  std::unordered_map<const Stroke*, Learned> learned_;
  TableCleanUp cleanUp_;
  ColorTable table_;
  /// The samples of table_.
  std::optional<Samples> last_;
};

}  // namespace colortool
