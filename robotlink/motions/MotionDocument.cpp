// SPDX-License-Identifier: GPL-3.0-or-later
#include "robotlink/motions/MotionDocument.h"

#include <algorithm>
#include <utility>

namespace robotlink {

MotionDocument::MotionDocument(std::string text, std::string path)
    : text_(std::move(text)), path_(std::move(path)) {
  parse();
}

void MotionDocument::parse() {
  parse_ = parseMotion(text_, path_, joints_);
}

void MotionDocument::setPath(std::string path) {
  path_ = std::move(path);
  parse();
}

void MotionDocument::setJoints(std::vector<std::string> joints) {
  if (joints == joints_) return;
  joints_ = std::move(joints);
  parse();
}

MotionDocument::Step MotionDocument::difference(const std::string& before, const std::string& after) {
  const std::size_t shorter = std::min(before.size(), after.size());
  const auto begin =
      std::mismatch(before.begin(), before.begin() + static_cast<std::ptrdiff_t>(shorter), after.begin());
  Step step;
  step.at = static_cast<std::size_t>(begin.first - before.begin());
  std::size_t end = 0;
  while (end < shorter - step.at && before[before.size() - 1 - end] == after[after.size() - 1 - end]) ++end;
  step.before = before.substr(step.at, before.size() - end - step.at);
  step.after = after.substr(step.at, after.size() - end - step.at);
  return step;
}

bool MotionDocument::continues(const std::string& gesture) const {
  return !gesture.empty() && !gestureEnded_ && position_ > 0 && position_ == steps_.size() &&
         steps_.back().gesture == gesture && savedPosition_ != position_;
}

bool MotionDocument::change(std::string what, std::string next, std::string gesture) {
  if (next == text_) return false;
  const bool together = continues(gesture);
  if (together) {
    const Step& last = steps_.back();
    text_.replace(last.at, last.after.size(), last.before);
    steps_.pop_back();
    --position_;
  }
  if (savedPosition_ && *savedPosition_ > position_) savedPosition_.reset();
  steps_.resize(position_);
  Step step = difference(text_, next);
  step.what = std::move(what);
  step.gesture = std::move(gesture);
  steps_.push_back(std::move(step));
  ++position_;
  text_ = std::move(next);
  gestureEnded_ = false;
  parse();
  return !together;
}

void MotionDocument::undo() {
  if (!canUndo()) return;
  const Step& step = steps_[--position_];
  text_.replace(step.at, step.after.size(), step.before);
  gestureEnded_ = true;
  parse();
}

void MotionDocument::redo() {
  if (!canRedo()) return;
  const Step& step = steps_[position_++];
  text_.replace(step.at, step.before.size(), step.after);
  gestureEnded_ = true;
  parse();
}

void MotionDocument::setSaved() {
  savedPosition_ = position_;
  gestureEnded_ = true;
}

}  // namespace robotlink
