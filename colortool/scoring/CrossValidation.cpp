// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/scoring/CrossValidation.h"

#include <algorithm>
#include <map>

#include "colortool/training/StrokeCells.h"
#include "colortool/training/Suspicion.h"
#include "colortool/training/TableTrainer.h"
#include "colortool/votes/TableCleanUp.h"

namespace colortool {
namespace {

/// The most folds for methods that learn from scratch each time.
constexpr std::size_t kMaxFolds = 5;

/// A stroke with its cells and its score.
struct Candidate {
  const Stroke* stroke = nullptr;
  std::vector<StrokeCell> cells;
  double right = 0;
};
using Fold = std::vector<Candidate*>;

/// Sorts the strokes by class. Strokes of one class are close to each other in color space, so that the step
/// from one to the next changes only a small part of the table.
std::vector<std::vector<Candidate*>> byClass(std::vector<Candidate>& candidates, int classes) {
  std::vector<std::vector<Candidate*>> sorted(static_cast<std::size_t>(classes));
  for (Candidate& candidate : candidates) {
    if (candidate.stroke->colorClass < sorted.size())
      sorted[candidate.stroke->colorClass].push_back(&candidate);
  }
  return sorted;
}

std::vector<Fold> foldsOf(const std::vector<std::vector<Candidate*>>& sorted, TrainingMethod method) {
  std::vector<Fold> folds;
  if (method == TrainingMethod::kVotes) {
    for (const auto& strokes : sorted) {
      for (Candidate* candidate : strokes) folds.push_back({candidate});
    }
    return folds;
  }
  // In each class the strokes are dealt out in turn, so that a fold takes a like share from all of them.
  folds.resize(kMaxFolds);
  for (const auto& strokes : sorted) {
    for (std::size_t i = 0; i < strokes.size(); ++i) folds[i % kMaxFolds].push_back(strokes[i]);
  }
  std::erase_if(folds, [](const Fold& fold) { return fold.empty(); });
  return folds;
}

/// Adds the pixels of a stroke by the class found, as shares of one stroke.
void addShares(Evaluation& evaluation, std::uint8_t label, const std::map<std::uint8_t, std::uint64_t>& found,
               std::uint64_t all) {
  std::uint64_t left = StrokeQuality::kStroke;
  for (const auto& [colorClass, pixels] : found) {
    const bool last = colorClass == found.rbegin()->first;
    const std::uint64_t share = last ? left : StrokeQuality::kStroke * pixels / all;
    evaluation.add(label, colorClass, share);
    left -= share;
  }
}

void score(Candidate& candidate, const ColorTable& table, StrokeQuality& quality) {
  const Stroke& stroke = *candidate.stroke;
  std::uint64_t right = 0, all = 0;
  std::map<std::uint8_t, std::uint64_t> counts;
  for (const StrokeCell& cell : candidate.cells) {
    const std::uint8_t found = table.cells()[cell.cell];
    const bool same = found == stroke.colorClass;
    all += cell.pixels;
    right += same != stroke.mustNotBe ? cell.pixels : 0;
    counts[stroke.mustNotBe && !same ? ColorClasses::kNone : found] += cell.pixels;
  }
  candidate.right = all == 0 ? 0 : static_cast<double>(right) / static_cast<double>(all);
  if (all == 0 || (stroke.mustNotBe && stroke.colorClass == ColorClasses::kNone)) return;
  const std::uint8_t label = stroke.mustNotBe ? ColorClasses::kNone : stroke.colorClass;
  addShares(quality.evaluation, label, counts, all);
  if (label < quality.strokesOf.size()) ++quality.strokesOf[label];
}

std::vector<std::uint8_t> aloneIn(const std::vector<std::vector<Candidate*>>& sorted) {
  std::vector<std::uint8_t> alone;
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    if (std::ranges::count_if(sorted[i], [](const Candidate* c) { return !c->stroke->mustNotBe; }) == 1)
      alone.push_back(static_cast<std::uint8_t>(i));
  }
  return alone;
}

}  // namespace

Evaluation scoreStrokes(const Samples& samples, const ColorTable& table) {
  StrokeQuality quality{Evaluation(samples.classes.size()), {}, {}, {}};
  for (const StrokePtr& stroke : samples.strokes) {
    Candidate candidate{stroke.get(), strokeCells(samples, *stroke)};
    score(candidate, table, quality);
  }
  return std::move(quality.evaluation);
}

std::optional<StrokeQuality> crossValidate(const Samples& samples, const std::function<bool()>& proceed) {
  const TrainingSettings& settings = samples.settings;
  std::vector<Candidate> candidates;
  ColorVotes votes(samples.classes.size(), settings.votes);
  votes.setThings(objectClasses(samples.classes));
  for (const StrokePtr& stroke : samples.strokes) {
    candidates.push_back({stroke.get(), strokeCells(samples, *stroke)});
    addTo(votes, candidates.back().cells, stroke->colorClass);
  }
  const auto sorted = byClass(candidates, samples.classes.size());
  StrokeQuality quality{Evaluation(samples.classes.size()),
                        std::vector<int>(static_cast<std::size_t>(samples.classes.size()), 0),
                        {},
                        aloneIn(sorted)};
  TableCleanUp cleanUp;
  for (const Fold& fold : foldsOf(sorted, settings.method)) {
    if (proceed && !proceed()) return std::nullopt;
    for (const Candidate* candidate : fold) addTo(votes, candidate->cells, candidate->stroke->colorClass, -1);
    const ColorTable& table =
        cleanUp.clean(learnedTable(votes, settings), votes.sampledCells(), settings.cleanUp);
    for (Candidate* candidate : fold) score(*candidate, table, quality);
    for (const Candidate* candidate : fold) addTo(votes, candidate->cells, candidate->stroke->colorClass);
  }
  for (const Candidate& candidate : candidates)
    quality.strokes.push_back({candidate.stroke->id, candidate.right});
  return quality;
}

}  // namespace colortool
