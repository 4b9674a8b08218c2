// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorScorer.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

namespace widgets {
namespace {

constexpr int kNice = 10;

using colortool::Evaluation;

/// The image's colours as the table sees them: with its camera's correction.
colortool::ColorImage seen(const ColorFrame& frame, const colortool::Samples& samples) {
  colortool::ColorImage image = frame.colors();
  const auto correction = samples.correctionOf(frame.place().camera);
  if (correction.none()) return image;
  auto pixel = image.pixels.begin();
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x, ++pixel)
      *pixel = correction.apply(*pixel, x, y, image.width, image.height);
  }
  return image;
}

/// Adds an image to an evaluation; classes are matched by their names, and what the table has no class for is
/// background to it.
void add(Evaluation& evaluation, const LabelledFrame& labelled, const ColorScorer::Task& task) {
  std::array<std::uint8_t, 256> numbers;
  numbers.fill(Evaluation::kIgnored);
  numbers[0] = colortool::ColorClasses::kNone;
  const auto names = std::min<std::size_t>(labelled.classNames.size(), Evaluation::kIgnored);
  for (std::size_t i = 1; i < names; ++i) numbers[i] = task.samples.classes.index(labelled.classNames[i]);
  std::vector<std::uint8_t> labels(labelled.labels.size());
  std::ranges::transform(labelled.labels, labels.begin(), [&](std::uint8_t label) { return numbers[label]; });
  evaluation.add(*task.table, seen(*labelled.frame, task.samples), labels);
}

}  // namespace

ColorScorer::ColorScorer(std::function<void()> news) : news_(std::move(news)), thread_([this] { run(); }) {}

ColorScorer::~ColorScorer() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  wakeUp_.notify_all();
  thread_.join();
}

void ColorScorer::ask(Task task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = std::move(task);
  }
  wakeUp_.notify_all();
}

std::optional<ColorQuality> ColorScorer::take() {
  const std::lock_guard lock(mutex_);
  return std::exchange(quality_, std::nullopt);
}

bool ColorScorer::idle() const {
  const std::lock_guard lock(mutex_);
  return !task_ && !busy_ && !quality_;
}

bool ColorScorer::goOn() const {
  const std::lock_guard lock(mutex_);
  return !quit_ && !task_;
}

std::optional<ColorQuality> ColorScorer::score(const Task& task) const {
  ColorQuality quality{task.number, task.samples.classes, {}, {}};
  if (task.labelled && !task.labelled->empty()) {
    Evaluation evaluation(task.samples.classes.size());
    for (const LabelledFrame& labelled : *task.labelled) {
      if (!goOn()) return std::nullopt;
      add(evaluation, labelled, task);
    }
    quality.labelled = std::move(evaluation);
  }
  if (!task.samples.strokes.empty()) {
    quality.strokes = colortool::crossValidate(task.samples, [this] { return goOn(); });
    if (!quality.strokes) return std::nullopt;
  }
  return quality;
}

void ColorScorer::run() {
  // The picture is waited for, figures are not. A thread may always become nicer.
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
  std::unique_lock lock(mutex_);
  while (true) {
    busy_ = false;
    wakeUp_.wait(lock, [this] { return quit_ || task_; });
    if (quit_) return;
    const Task task = *std::exchange(task_, std::nullopt);
    busy_ = true;
    lock.unlock();
    auto quality = score(task);
    lock.lock();
    if (!quality) continue;
    quality_ = std::move(quality);
    lock.unlock();
    news_();
    lock.lock();
  }
}

}  // namespace widgets
