// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorLearner.h"

#include <utility>

#include "colortool/correction/ImageCorrector.h"
#include "colortool/training/TableTrainer.h"

namespace widgets {
namespace {

using colortool::ColorTable;
using colortool::Samples;

}  // namespace

/// State of the thread, kept from one task to the next.
struct ColorLearner::Work {
  colortool::TableTrainer trainer;
  std::optional<colortool::ImageCorrector> corrector;
  std::optional<Samples> samples;  ///< the samples from which `table` was trained
  std::shared_ptr<const ColorTable> table;
  std::shared_ptr<const std::vector<std::uint8_t>> margins;  ///< null: not computed yet
  std::shared_ptr<const ColorTable> scoredTable;             ///< what the scorer was given last
  std::shared_ptr<const std::vector<LabeledFrame>> scoredImages;
  std::shared_ptr<const ColorTable> scoredReference;
  std::vector<ColorFramePtr> scoredOthers;

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

ColorLearner::ColorLearner(std::function<void()> news)
    : news_(std::move(news)), scorer_(news_), thread_([this] { run(); }) {}

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
  return scorer_.take();
}

bool ColorLearner::idle() const {
  const std::lock_guard lock(mutex_);
  return !task_ && !busy_ && !colors_ && scorer_.idle();
}

bool ColorLearner::newTask() const {
  const std::lock_guard lock(mutex_);
  return quit_ || task_.has_value();
}

void ColorLearner::run() {
  Work work;
  const auto publish = [this](LearnedColors colors) {
    {
      const std::lock_guard lock(mutex_);
      colors_ = std::move(colors);
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
    publish(colors);
    if (work.scoredTable != work.table || work.scoredImages != task.labeled ||
        work.scoredReference != task.reference || work.scoredOthers != task.others) {
      work.scoredTable = work.table;
      work.scoredImages = task.labeled;
      work.scoredReference = task.reference;
      work.scoredOthers = task.others;
      scorer_.ask({task.number, task.samples, work.table, task.labeled, task.reference, task.others});
    }
    if (work.margins || newTask()) continue;
    work.margins = std::make_shared<std::vector<std::uint8_t>>(work.trainer.margins());
    colors.margins = work.margins;
    publish(std::move(colors));
  }
}

}  // namespace widgets
