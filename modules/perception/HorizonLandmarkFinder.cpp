// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/perception/HorizonLandmarkFinder.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::ImageView;

HorizonLandmarkFinder::HorizonLandmarkFinder(const robotlink::FieldDescription& field,
                                             std::vector<FieldLandmark> landmarks,
                                             colortool::ColorTable table, const Options& options)
    : landmarks_(std::move(landmarks)),
      table_(std::move(table)),
      options_(options),
      geometry_(field, options.geometry),
      wanted_(256, false) {
  for (const FieldLandmark& landmark : landmarks_)
    for (const int colorClass : {landmark.topClass, landmark.bottomClass})
      wanted_[static_cast<std::size_t>(colorClass)] = true;
}

void HorizonLandmarkFinder::scanColumn(const ImageView& image, int column, int top, int bottom) {
  runs_.clear();
  for (int y = top; y < bottom; ++y) {
    const int colorClass = table_.classOf(robotlink::yuyvPixel(image, column, y));
    if (!wanted_[static_cast<std::size_t>(colorClass)]) continue;
    // A single pixel of another color, as at borders, does not end a run.
    if (!runs_.empty() && runs_.back().colorClass == colorClass && y - runs_.back().bottom <= 1)
      runs_.back().bottom = y + 1;
    else
      runs_.push_back({colorClass, y, y + 1});
  }
  std::erase_if(runs_, [this](const Run& run) { return run.bottom - run.top < options_.minimumRun; });
}

void HorizonLandmarkFinder::add(std::size_t landmark, int column, int top, int bottom) {
  for (Cluster& cluster : clusters_) {
    if (cluster.landmark != landmark || column - cluster.lastColumn > 2 * options_.spacing) continue;
    cluster.lastColumn = column;
    ++cluster.lines;
    cluster.topSum += top;
    cluster.bottomSum += bottom;
    return;
  }
  clusters_.push_back({landmark, column, column, 1, static_cast<double>(top), static_cast<double>(bottom)});
}

bool HorizonLandmarkFinder::areBands(const Run& top, const Run& bottom) const {
  if (bottom.top - top.bottom > 2) return false;
  return std::ranges::any_of(landmarks_, [&](const FieldLandmark& landmark) {
    return landmark.kind == FieldLandmark::Kind::kBeacon && landmark.topClass == top.colorClass &&
           landmark.bottomClass == bottom.colorClass;
  });
}

void HorizonLandmarkFinder::readRuns(int column) {
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const Run& run = runs_[i];
    const bool overBand = i + 1 < runs_.size() && areBands(run, runs_[i + 1]);
    const bool underBand = i > 0 && areBands(runs_[i - 1], run);
    for (std::size_t l = 0; l < landmarks_.size(); ++l) {
      const FieldLandmark& landmark = landmarks_[l];
      if (landmark.topClass != run.colorClass) continue;
      if (landmark.kind == FieldLandmark::Kind::kGoal) {
        if (!overBand && !underBand) add(l, column, run.top, run.bottom);
      } else if (overBand && landmark.bottomClass == runs_[i + 1].colorClass) {
        add(l, column, run.top, runs_[i + 1].bottom);
      }
    }
  }
}

std::vector<LandmarkObservation> HorizonLandmarkFinder::measured(const CameraView& view) const {
  std::vector<LandmarkObservation> found;
  for (std::size_t l = 0; l < landmarks_.size(); ++l) {
    const Cluster* widest = nullptr;
    for (const Cluster& cluster : clusters_)
      if (cluster.landmark == l && (widest == nullptr || cluster.lines > widest->lines)) widest = &cluster;
    if (widest == nullptr) continue;
    if (landmarks_[l].kind == FieldLandmark::Kind::kGoal && widest->lines < options_.minimumGoalLines)
      continue;
    // A line represents the columns around it.
    const double half = 0.5 * options_.spacing;
    ImageBox box{widest->firstColumn + 0.5 - half, widest->topSum / widest->lines,
                 widest->lastColumn + 0.5 + half, widest->bottomSum / widest->lines};
    if (box.left < half) box.left = 0;
    if (box.right > view.width - half) box.right = view.width;
    if (auto seen = geometry_.locate(landmarks_[l], box, view)) {
      seen->landmark = l;
      found.push_back(*seen);
    }
  }
  return found;
}

std::vector<LandmarkObservation> HorizonLandmarkFinder::find(const ImageView& image, const CameraView& view) {
  clusters_.clear();
  if (image.empty() || image.format != robotlink::PixelFormat::kYuyv) return {};
  for (int column = options_.spacing / 2; column < image.width; column += std::max(1, options_.spacing)) {
    const auto horizon = view.horizonRow(column + 0.5);
    if (!horizon || std::abs(*horizon) > 10.0 * image.height) continue;
    const int row = static_cast<int>(std::lround(*horizon));
    scanColumn(image, column, std::clamp(row - options_.above, 0, image.height),
               std::clamp(row + options_.below, 0, image.height));
    readRuns(column);
  }
  return measured(view);
}

}  // namespace modules
