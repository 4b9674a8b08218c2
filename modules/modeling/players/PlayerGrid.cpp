// SPDX-License-Identifier: GPL-3.0-or-later
#include "modules/modeling/players/PlayerGrid.h"

#include <algorithm>
#include <cmath>

namespace modules {

using robotlink::Vector2;

namespace {

/// The distance by which the grid extends beyond the field, m.
constexpr double kGridMargin = 0.2;
/// The evidence below which there is none.
constexpr double kNoEvidence = 0.005;

}  // namespace

PlayerGrid::PlayerGrid(double length, double width, const Options& options)
    : options_(options),
      origin_(-0.5 * length - kGridMargin, -0.5 * width - kGridMargin),
      columns_(static_cast<int>(std::ceil((length + 2 * kGridMargin) / kCell))),
      rows_(static_cast<int>(std::ceil((width + 2 * kGridMargin) / kCell))) {}

Vector2 PlayerGrid::center(int column, int row) const {
  return origin_ + kCell * Vector2(column + 0.5, row + 0.5);
}

PlayerGrid::Layer& PlayerGrid::layerOf(const std::string& team) {
  const auto known = std::ranges::find(layers_, team, &Layer::team);
  if (known != layers_.end()) return *known;
  layers_.push_back({team, std::vector<double>(static_cast<std::size_t>(columns_ * rows_), 0)});
  return layers_.back();
}

void PlayerGrid::fade(const SeenSector& sector, double seconds) {
  const double unseen = std::exp2(-seconds / options_.halfLife);
  const double seen = std::exp2(-seconds / options_.seenHalfLife);
  for (Layer& layer : layers_) {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        double& evidence = layer.evidence[static_cast<std::size_t>(row * columns_ + column)];
        if (evidence == 0) continue;
        evidence *= sector.contains(center(column, row)) ? seen : unseen;
        if (evidence < kNoEvidence) evidence = 0;
      }
    }
  }
}

void PlayerGrid::add(const PlayerSight& sight, const PlayerFrame& frame) {
  const Vector2 place = frame.robotInField * sight.positionInRobot;
  const double distance = sight.positionInRobot.norm();
  const double deviation = std::hypot(options_.deviationNear + options_.deviationPerMeter * distance,
                                      std::min(0.3, frame.headingDeviation * distance));
  Layer& layer = layerOf(sight.team);
  const int reach = static_cast<int>(std::ceil(2 * deviation / kCell));
  const int column = static_cast<int>(std::floor((place.x() - origin_.x()) / kCell));
  const int row = static_cast<int>(std::floor((place.y() - origin_.y()) / kCell));
  for (int y = std::max(0, row - reach); y <= std::min(rows_ - 1, row + reach); ++y) {
    for (int x = std::max(0, column - reach); x <= std::min(columns_ - 1, column + reach); ++x) {
      const double off = (center(x, y) - place).norm() / deviation;
      double& evidence = layer.evidence[static_cast<std::size_t>(y * columns_ + x)];
      evidence = 1 - (1 - evidence) * (1 - 0.4 * sight.confidence * std::exp(-0.5 * off * off));
    }
  }
}

void PlayerGrid::addPeak(const Layer& layer, int column, int row, std::vector<TrackedPlayer>& peaks) const {
  const auto at = [&](int x, int y) {
    if (x < 0 || y < 0 || x >= columns_ || y >= rows_) return 0.0;
    return layer.evidence[static_cast<std::size_t>(y * columns_ + x)];
  };
  const double evidence = at(column, row);
  if (evidence < options_.minimumPeak) return;
  Vector2 sum = Vector2::Zero();
  double weights = 0;
  for (int dy = -1; dy <= 1; ++dy) {
    for (int dx = -1; dx <= 1; ++dx) {
      const double other = at(column + dx, row + dy);
      if (other > evidence) return;
      sum += other * center(column + dx, row + dy);
      weights += other;
    }
  }
  peaks.push_back({layer.team, sum / weights, evidence});
}

void PlayerGrid::findPeaks() {
  players_.clear();
  for (const Layer& layer : layers_) {
    std::vector<TrackedPlayer> peaks;
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) addPeak(layer, column, row, peaks);
    std::ranges::stable_sort(peaks, std::ranges::greater(), &TrackedPlayer::confidence);
    const std::size_t before = players_.size();
    for (const TrackedPlayer& peak : peaks) {
      const auto same = [&](const TrackedPlayer& other) {
        return other.team == peak.team &&
               (other.positionInField - peak.positionInField).norm() < options_.apart;
      };
      if (players_.size() - before < static_cast<std::size_t>(std::max(0, options_.maximumPlayers)) &&
          std::ranges::none_of(players_, same))
        players_.push_back(peak);
    }
  }
  std::ranges::stable_sort(players_, std::ranges::greater(), &TrackedPlayer::confidence);
}

void PlayerGrid::update(const PlayerFrame& frame) {
  fade(frame.sector, began_ ? std::max(0.0, frame.time - updatedAt_) : 0);
  updatedAt_ = frame.time;
  began_ = true;
  for (const PlayerSight& sight : frame.seen) add(sight, frame);
  findPeaks();
}

std::vector<PlayerGrid::Cell> PlayerGrid::cells(double minimum) const {
  std::vector<Cell> cells;
  for (const Layer& layer : layers_) {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const double evidence = layer.evidence[static_cast<std::size_t>(row * columns_ + column)];
        if (evidence > minimum) cells.push_back({layer.team, center(column, row), evidence});
      }
    }
  }
  return cells;
}

}  // namespace modules
