// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionPlayer.h"

#include <algorithm>

#include "robotlink/base/Geometry.h"

namespace robotlink {
namespace {

/// The progress of a key frame, 0 to 1, after a fraction of its time.
double progress(int interpolation, double share) {
  if (interpolation == 0) return 1;
  return interpolation == 1 ? share : 0.5 - 0.5 * std::cos(kPi * share);
}

double share(Duration elapsed, Duration whole) {
  return whole.count() <= 0 ? 1 : std::min(1.0, seconds(elapsed) / seconds(whole));
}

}  // namespace

MotionPlayer::MotionPlayer(std::shared_ptr<const MotionNet> net)
    : net_(std::move(net)),
      none_(net_->find(MotionNet::kEntryName)),
      requested_(none_),
      played_(none_),
      node_(static_cast<std::size_t>(net_->entry)),
      from_(net_->joints.size()),
      angles_(net_->joints.size()),
      hardnessFrom_(net_->joints.size(), 1.0),
      hardnessNow_(net_->joints.size(), 1.0),
      shares_(net_->joints.size(), 1.0),
      released_(net_->joints.size()),
      moved_(net_->joints.size()) {}

void MotionPlayer::start(std::span<const double> angles) {
  std::copy_n(angles.begin(), std::min(angles.size(), angles_.size()), angles_.begin());
  from_ = angles_;
  std::fill(released_.begin(), released_.end(), false);
  std::fill(moved_.begin(), moved_.end(), false);
  std::fill(hardnessNow_.begin(), hardnessNow_.end(), 1.0);
  hardness_ = nullptr;
  setShares();
  frame_ = nullptr;
  node_ = static_cast<std::size_t>(net_->entry);
  requested_ = played_ = none_;
  finished_ = true;
}

bool MotionPlayer::request(std::string_view motion, Repeat repeat) {
  const int found = net_->find(motion);
  if (found < 0) return false;
  if (finished_) played_ = none_;
  requested_ = found;
  repeat_ = repeat;
  if (found != none_) finished_ = false;
  return true;
}

std::string MotionPlayer::motion() const {
  const int playing = net_->nodes[node_].motion;
  return finished_ || playing == none_ ? "" : net_->motions[static_cast<std::size_t>(playing)];
}

MotionNet::Displacement MotionPlayer::displacement() const {
  const auto playing = static_cast<std::size_t>(net_->nodes[node_].motion);
  return finished_ || playing >= net_->displacements.size() ? MotionNet::Displacement()
                                                            : net_->displacements[playing];
}

void MotionPlayer::advance(Duration frame) {
  left_ = frame;
  if (hardness_) {
    hardnessElapsed_ += frame;
    setShares();
  }
  if (!finished_) run();
}

/// Plays until the time of the frame is used up. Also ends in a cycle of transitions without a key frame.
void MotionPlayer::run() {
  for (std::size_t jumps = 0; jumps <= net_->nodes.size();) {
    if (frame_) {
      elapsed_ += left_;
      setAngles();
      if (elapsed_ < frame_->duration) return;
      left_ = elapsed_ - frame_->duration;
      frame_ = nullptr;
      ++node_;
      jumps = 0;
      if (left_.count() == 0) return;
    }
    if (!step(net_->nodes[node_])) return;
    ++jumps;
  }
}

/// Returns false if there is nothing more to play.
bool MotionPlayer::step(const MotionNet::Node& node) {
  if (const auto* transition = std::get_if<MotionNet::Transition>(&node.step)) return take(node, *transition);
  if (const auto* hardness = std::get_if<MotionHardness>(&node.step)) {
    enter(*hardness);
    ++node_;
  } else if (const auto* frame = std::get_if<KeyFrame>(&node.step)) {
    enter(*frame);
  }
  return true;
}

bool MotionPlayer::take(const MotionNet::Node& node, const MotionNet::Transition& transition) {
  const bool inTable = node.motion == none_;
  const bool matches = transition.request == requested_;
  const bool taken = matches || transition.request == MotionJump::kAllMotions;
  const bool again = inTable && matches && repeat_ == Repeat::kOnce && played_ == requested_;
  // The last line of the table leads back to its start: no motion of the table is requested.
  finished_ = again || (taken && inTable && transition.target == net_->entry);
  if (inTable && matches) played_ = requested_;
  node_ = taken ? static_cast<std::size_t>(transition.target) : node_ + 1;
  if (node_ >= net_->nodes.size()) finished_ = true;
  if (finished_) {
    node_ = static_cast<std::size_t>(net_->entry);
    requested_ = none_;
  }
  return !finished_;
}

void MotionPlayer::enter(const KeyFrame& frame) {
  frame_ = &frame;
  elapsed_ = {};
  from_ = angles_;
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    if (frame.joints[i].kind != JointValue::Kind::kKeep) {
      released_[i] = frame.joints[i].kind == JointValue::Kind::kRelease;
      moved_[i] = true;
    }
  }
  setShares();
}

void MotionPlayer::enter(const MotionHardness& hardness) {
  hardness_ = &hardness;
  hardnessElapsed_ = {};
  hardnessFrom_ = hardnessNow_;
  setShares();
}

void MotionPlayer::setAngles() {
  const double part = progress(frame_->interpolation, share(elapsed_, frame_->duration));
  for (std::size_t i = 0; i < angles_.size(); ++i) {
    const JointValue& target = frame_->joints[i];
    if (target.kind == JointValue::Kind::kAngle) angles_[i] = from_[i] + (target.angle - from_[i]) * part;
  }
}

void MotionPlayer::setShares() {
  for (std::size_t i = 0; i < shares_.size(); ++i) {
    if (hardness_) {
      const double target = hardness_->shares[i].value_or(1.0);
      hardnessNow_[i] =
          hardnessFrom_[i] + (target - hardnessFrom_[i]) * share(hardnessElapsed_, hardness_->duration);
    }
    shares_[i] = released_[i] ? 0 : hardnessNow_[i];
  }
}

}  // namespace robotlink
