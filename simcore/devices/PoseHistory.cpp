// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/devices/PoseHistory.h"

#include <algorithm>
#include <cmath>

#include "simcore/world/StateStream.h"

namespace simcore {
namespace {

/// The pose between two, `share` of the way from the first to the second.
Pose3 poseBetween(const Pose3& from, const Pose3& to, double share) {
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(from.linear()).slerp(share, Eigen::Quaterniond(to.linear()));
  return Eigen::Translation3d((1 - share) * from.translation() + share * to.translation()) * rotation;
}

}  // namespace

void PoseHistory::reachBack(std::size_t steps) {
  steps_ = std::max(steps_, std::min(steps, kMaxSteps));
}

void PoseHistory::add(std::uint64_t step, std::span<const Pose3> poses) {
  if (!isWanted()) return;
  if (!records_.empty() && records_.back().step >= step) records_.pop_back();
  Record record;
  // The memory of the oldest one is used again.
  if (records_.size() > steps_) {
    record = std::move(records_.front());
    records_.pop_front();
  }
  record.step = step;
  record.poses.assign(poses.begin(), poses.end());
  records_.push_back(std::move(record));
}

void PoseHistory::transfer(StateStream& stream, std::uint64_t step, std::size_t bodies) {
  auto steps = static_cast<std::uint64_t>(steps_);
  stream.upTo(steps, std::uint64_t{kMaxSteps});
  steps_ = steps;
  stream.size(records_, kMaxSteps + 1);
  // Without gaps up to the present, so that a search of it ends soon.
  std::uint64_t expected = step + 1 - std::min<std::uint64_t>(records_.size(), step + 1);
  for (Record& record : records_) {
    stream.raw(record.step);
    stream.require(record.step == expected++);
    if (!stream.good()) break;
    record.poses.resize(bodies, Pose3::Identity());
    for (Pose3& pose : record.poses) stream.pose(pose);
  }
  if (!stream.good()) records_.clear();
}

std::uint64_t PoseHistory::oldest(std::uint64_t step) const {
  return records_.empty() ? step : records_.front().step;
}

std::span<const Pose3> PoseHistory::at(std::uint64_t step) const {
  const auto found = std::ranges::lower_bound(records_, step, {}, &Record::step);
  if (found == records_.end()) return {};
  return found->poses;
}

std::uint64_t PoseHistory::oldestAt(std::uint64_t step) const {
  // add() keeps one more than it reaches back.
  return std::max(oldest(step), step - std::min<std::uint64_t>(step, steps_));
}

void interpolatePoses(double time, const std::function<std::span<const Pose3>(std::uint64_t step)>& posesOf,
                      std::vector<Pose3>& poses) {
  const auto before = static_cast<std::uint64_t>(std::max(0.0, std::floor(time)));
  const double share = time - static_cast<double>(before);
  const auto from = posesOf(before);
  poses.assign(from.begin(), from.end());
  if (share <= 0) return;
  const auto to = posesOf(before + 1);
  for (std::size_t body = 0; body < poses.size(); ++body)
    poses[body] = poseBetween(from[body], to[body], share);
}

}  // namespace simcore
