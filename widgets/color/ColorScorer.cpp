// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorScorer.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "colortool/training/Suspicion.h"

namespace widgets {
namespace {

constexpr int kNice = 10;

using colortool::Evaluation;

/// The image's colors with its camera's correction, as the table sees them.
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

/// Adds an image to an evaluation. Classes are matched by their names; classes that the table does not have
/// count as background.
void add(Evaluation& evaluation, const LabeledFrame& labeled, const ColorScorer::Task& task,
         const colortool::ColorTable& table) {
  std::array<std::uint8_t, 256> numbers;
  numbers.fill(Evaluation::kIgnored);
  numbers[0] = colortool::ColorClasses::kNone;
  const auto names = std::min<std::size_t>(labeled.classNames.size(), Evaluation::kIgnored);
  for (std::size_t i = 1; i < names; ++i) numbers[i] = task.samples.classes.index(labeled.classNames[i]);
  std::vector<std::uint8_t> labels(labeled.labels.size());
  std::ranges::transform(labeled.labels, labels.begin(), [&](std::uint8_t label) { return numbers[label]; });
  evaluation.add(table, seen(*labeled.frame, task.samples), labels);
}

/// Adds the pixels of an image that are suspicious.
void add(ColorQuality::Others& others, colortool::SuspicionMeter& meter, const ColorFrame& frame) {
  const colortool::Suspicion suspicion = meter.measure(frame.view());
  others.suspicious.resize(std::max(others.suspicious.size(), suspicion.byClass.size()), 0);
  for (std::size_t i = 0; i < suspicion.byClass.size(); ++i)
    others.suspicious[i] +=
        suspicion.byClass[i].specks + suspicion.byClass[i].enclosed + suspicion.byClass[i].vast;
  others.pixels += static_cast<std::uint64_t>(frame.width()) * static_cast<std::uint64_t>(frame.height());
  ++others.images;
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

bool ColorScorer::scoreImages(const Task& task, ColorQuality& quality) const {
  if (task.labeled && !task.labeled->empty()) {
    Evaluation evaluation(task.samples.classes.size()), reference = evaluation;
    for (const LabeledFrame& labeled : *task.labeled) {
      if (!goOn()) return false;
      add(evaluation, labeled, task, *task.table);
      if (task.reference) add(reference, labeled, task, *task.reference);
    }
    quality.labeled = std::move(evaluation);
    if (task.reference) quality.referenceLabeled = std::move(reference);
  }
  colortool::SuspicionMeter meter(*task.table, {}, colortool::objectClasses(task.samples.classes));
  for (const ColorFramePtr& frame : task.others) {
    if (!goOn()) return false;
    add(quality.others, meter, *frame);
  }
  return true;
}

std::optional<ColorQuality> ColorScorer::score(const Task& task) const {
  ColorQuality quality;
  quality.task = task.number;
  quality.classes = task.samples.classes;
  if (!scoreImages(task, quality)) return std::nullopt;
  if (!task.samples.strokes.empty()) {
    quality.strokes = colortool::crossValidate(task.samples, [this] { return goOn(); });
    if (!quality.strokes) return std::nullopt;
    if (task.reference) quality.referenceStrokes = colortool::scoreStrokes(task.samples, *task.reference);
  }
  return quality;
}

void ColorScorer::run() {
  // The user waits for the picture, not for the figures. Every thread may lower its own priority.
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
