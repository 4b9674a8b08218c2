// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/training/TableTrainer.h"

#include <cmath>

#include "colortool/training/Suspicion.h"

namespace colortool {

ColorTable learnedTable(ColorVotes& votes, const TrainingSettings& settings) {
  switch (settings.method) {
    case TrainingMethod::kGaussians:
      return gaussianTable(votes.samples(), settings.gaussians);
    case TrainingMethod::kSupportVectors:
      return supportVectorTable(votes.samples(), settings.supportVectors);
    case TrainingMethod::kVotes:
      break;
  }
  return votes.update();
}

bool TableTrainer::sameGround(const Samples& samples) const {
  return last_ && last_->classes.size() == samples.classes.size() &&
         last_->corrections == samples.corrections &&
         last_->settings.correctVignetting == samples.settings.correctVignetting &&
         last_->settings.correctCameras == samples.settings.correctCameras;
}

void TableTrainer::follow(const Samples& samples) {
  if (!sameGround(samples)) {
    votes_ = ColorVotes(samples.classes.size(), samples.settings.votes);
    learned_.clear();
  } else if (last_->settings.votes != samples.settings.votes) {
    votes_.setOptions(samples.settings.votes);
  }
  votes_.setThings(objectClasses(samples.classes));
  for (auto& [key, learned] : learned_) learned.current = false;
  for (const StrokePtr& stroke : samples.strokes) {
    const auto [learned, isNew] = learned_.try_emplace(stroke.get());
    learned->second.current = true;
    if (!isNew) continue;
    learned->second.stroke = stroke;
    learned->second.cells = strokeCells(samples, *stroke);
    addTo(votes_, learned->second.cells, stroke->colorClass);
  }
  std::erase_if(learned_, [&](const auto& entry) {
    const Learned& learned = entry.second;
    if (!learned.current) addTo(votes_, learned.cells, learned.stroke->colorClass, -1);
    return !learned.current;
  });
}

const ColorTable& TableTrainer::train(const Samples& samples) {
  if (last_ && samples == *last_) return table_;
  follow(samples);
  const TrainingSettings& settings = samples.settings;
  table_ = cleanUp_.clean(learnedTable(votes_, settings), votes_.sampledCells(), settings.cleanUp);
  last_ = samples;
  return table_;
}

std::vector<std::uint8_t> TableTrainer::margins() const {
  std::vector<std::uint8_t> margins(ColorTable::kCellCount);
  for (std::size_t cell = 0; cell < margins.size(); ++cell)
    margins[cell] = static_cast<std::uint8_t>(std::lround(255 * votes_.margin(cell)));
  return margins;
}

}  // namespace colortool
