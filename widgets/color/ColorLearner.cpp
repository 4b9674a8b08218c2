// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorLearner.h"

#include <algorithm>
#include <map>
#include <utility>

#include "colortool/ImageCorrector.h"
#include "colortool/TableTrainer.h"

namespace widgets {
namespace {

using colortool::ColorTable;
using colortool::Evaluation;
using colortool::Samples;

/// Adds an image to an evaluation; classes are matched by their names.
void add(Evaluation& evaluation, const LabelledFrame& labelled, const Samples& samples,
         const ColorTable& table) {
  std::array<std::uint8_t, 256> numbers;
  numbers.fill(Evaluation::kIgnored);
  numbers[0] = colortool::ColorClasses::kNone;
  for (std::size_t i = 1; i < std::min<std::size_t>(labelled.classNames.size(), Evaluation::kIgnored); ++i) {
    const std::uint8_t number = samples.classes.index(labelled.classNames[i]);
    // What the table has no class for is background to it.
    numbers[i] = number;
  }
  std::vector<std::uint8_t> labels(labelled.labels.size());
  std::ranges::transform(labelled.labels, labels.begin(), [&](std::uint8_t label) { return numbers[label]; });
  evaluation.add(table, labelled.frame->colors(), labels);
}

}  // namespace

/// What the thread has.
struct ColorLearner::Work {
  colortool::TableTrainer trainer;
  std::optional<colortool::ImageCorrector> corrector;
  std::optional<Samples> samples;  ///< those that `table` is of
  std::shared_ptr<const ColorTable> table;
  std::shared_ptr<const std::vector<std::uint8_t>> margins;  ///< null: not yet known
  std::shared_ptr<const std::vector<LabelledFrame>> scored;

  LearnedColors learn(const ColorTask& task) {
    if (!samples || !(*samples == task.samples)) {
      table = std::make_shared<ColorTable>(trainer.train(task.samples));
      margins.reset();
      samples = task.samples;
    }
    LearnedColors colors{task.number, task.samples, table, task.frame, correct(task), {}, margins};
    if (task.frame) {
      auto classes = std::make_shared<robotlink::Image>();
      table->classify(colors.seen(), *classes);
      colors.classes = std::move(classes);
    }
    return colors;
  }

  /// The frame's image with its camera's correction; null if there is none.
  std::shared_ptr<const robotlink::Image> correct(const ColorTask& task) {
    if (!task.frame) return nullptr;
    const colortool::ColorCorrection wanted = task.samples.correctionOf(task.frame->place().camera);
    if (wanted.none()) return nullptr;
    if (!corrector || !(corrector->correction() == wanted)) corrector.emplace(wanted);
    auto image = std::make_shared<robotlink::Image>();
    corrector->correct(task.frame->view(), *image);
    return image;
  }
};

ColorLearner::ColorLearner(std::function<void()> news) : news_(std::move(news)), thread_([this] { run(); }) {}

ColorLearner::~ColorLearner() {
  {
    const std::lock_guard lock(mutex_);
    quit_ = true;
  }
  wakeUp_.notify_all();
  thread_.join();
}

void ColorLearner::ask(ColorTask task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = std::move(task);
  }
  wakeUp_.notify_all();
}

std::optional<LearnedColors> ColorLearner::takeColors() {
  const std::lock_guard lock(mutex_);
  return std::exchange(colors_, std::nullopt);
}

std::optional<ColorQuality> ColorLearner::takeQuality() {
  const std::lock_guard lock(mutex_);
  return std::exchange(quality_, std::nullopt);
}

bool ColorLearner::idle() const {
  const std::lock_guard lock(mutex_);
  return !task_ && !busy_ && !colors_ && !quality_;
}

bool ColorLearner::newTask() const {
  const std::lock_guard lock(mutex_);
  return quit_ || task_.has_value();
}

void ColorLearner::run() {
  Work work;
  const auto publish = [this](auto& slot, auto value) {
    {
      const std::lock_guard lock(mutex_);
      slot = std::move(value);
    }
    news_();
  };
  while (true) {
    ColorTask task;
    {
      std::unique_lock lock(mutex_);
      busy_ = false;
      wakeUp_.wait(lock, [this] { return quit_ || task_; });
      if (quit_) return;
      task = std::move(*task_);
      task_.reset();
      busy_ = true;
    }
    LearnedColors colors = work.learn(task);
    const bool scored = work.margins && work.scored == task.labelled;
    publish(colors_, colors);
    if (scored || newTask()) continue;
    if (!work.margins) {
      work.margins = std::make_shared<std::vector<std::uint8_t>>(work.trainer.margins());
      colors.margins = work.margins;
      publish(colors_, colors);
    }
    ColorQuality quality{task.number, task.samples.classes, {}};
    if (task.labelled && !task.labelled->empty()) {
      Evaluation evaluation(task.samples.classes.size());
      for (const LabelledFrame& labelled : *task.labelled) {
        if (newTask()) break;
        add(evaluation, labelled, task.samples, *work.table);
      }
      quality.labelled = std::move(evaluation);
    }
    if (newTask()) continue;
    work.scored = task.labelled;
    publish(quality_, std::move(quality));
  }
}

}  // namespace widgets
