// SPDX-License-Identifier: GPL-3.0-or-later
#include "colortool/samples/SampleDocument.h"

#include <algorithm>
#include <iterator>

namespace colortool {
namespace {

constexpr auto kById = [](const StrokePtr& stroke) { return std::pair(stroke->id, stroke.get()); };
constexpr auto kIdOf = [](const StrokePtr& stroke) { return stroke->id; };

/// The strokes that are in `a` but not in `b`, by identity; both are sorted by id.
std::vector<StrokePtr> difference(const std::vector<StrokePtr>& a, const std::vector<StrokePtr>& b) {
  std::vector<StrokePtr> result;
  auto other = b.begin();
  for (const StrokePtr& stroke : a) {
    while (other != b.end() && (*other)->id < stroke->id) ++other;
    if (other == b.end() || *other != stroke) result.push_back(stroke);
  }
  return result;
}

}  // namespace

SampleDocument::Frame SampleDocument::frameOf(const Samples& samples) {
  return {samples.classes, samples.settings, samples.corrections, samples.images};
}

void SampleDocument::apply(Samples& samples, const Frame& frame, const std::vector<StrokePtr>& take,
                           const std::vector<StrokePtr>& put) {
  samples.classes = frame.classes;
  samples.settings = frame.settings;
  samples.corrections = frame.corrections;
  samples.images = frame.images;
  std::vector<StrokePtr> rest;
  std::ranges::set_difference(samples.strokes, take, std::back_inserter(rest), {}, kById, kById);
  samples.strokes.clear();
  std::ranges::merge(rest, put, std::back_inserter(samples.strokes), {}, kIdOf, kIdOf);
}

bool SampleDocument::continues(const std::string& gesture) const {
  return !gesture.empty() && !gestureEnded_ && position_ > 0 && position_ == steps_.size() &&
         steps_.back().gesture == gesture && savedPosition_ != position_;
}

Samples SampleDocument::beforeGesture(const std::string& gesture) const {
  Samples before = samples_;
  if (continues(gesture)) {
    const Step& last = steps_.back();
    apply(before, last.before, last.added, last.removed);
  }
  return before;
}

bool SampleDocument::change(std::string text, Samples next, std::string gesture) {
  if (next == samples_) return false;
  const bool together = continues(gesture);
  if (together) {
    samples_ = beforeGesture(gesture);
    steps_.pop_back();
    --position_;
  }
  if (savedPosition_ && *savedPosition_ > position_) savedPosition_.reset();
  steps_.resize(position_);
  Step step{std::move(text),
            std::move(gesture),
            frameOf(samples_),
            frameOf(next),
            difference(samples_.strokes, next.strokes),
            difference(next.strokes, samples_.strokes)};
  steps_.push_back(std::move(step));
  ++position_;
  samples_ = std::move(next);
  gestureEnded_ = false;
  return !together;
}

Samples SampleDocument::samplesAt(std::size_t position) const {
  Samples samples = samples_;
  for (std::size_t at = position_; at > position; --at)
    apply(samples, steps_[at - 1].before, steps_[at - 1].added, steps_[at - 1].removed);
  for (std::size_t at = position_; at < std::min(position, steps_.size()); ++at)
    apply(samples, steps_[at].after, steps_[at].removed, steps_[at].added);
  return samples;
}

void SampleDocument::undo() {
  if (!canUndo()) return;
  const Step& step = steps_[--position_];
  apply(samples_, step.before, step.added, step.removed);
  gestureEnded_ = true;
}

void SampleDocument::redo() {
  if (!canRedo()) return;
  const Step& step = steps_[position_++];
  apply(samples_, step.after, step.removed, step.added);
  gestureEnded_ = true;
}

}  // namespace colortool
