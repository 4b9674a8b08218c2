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
    : scorer_(news),
      work_(std::make_unique<Work>()),
      worker_([this](const ColorTask& task, const std::stop_token& stop) { learn(task, stop); },
              {.news = std::move(news)}) {}

ColorLearner::~ColorLearner() = default;

void ColorLearner::learn(const ColorTask& task, const std::stop_token& stop) {
  LearnedColors colors = work_->learn(task);
  worker_.publish(colors);
  askForScore(task);
  if (work_->margins || stop.stop_requested()) return;
  work_->margins = std::make_shared<std::vector<std::uint8_t>>(work_->trainer.margins());
  colors.margins = work_->margins;
  worker_.publish(std::move(colors));
}

void ColorLearner::askForScore(const ColorTask& task) {
  if (work_->scoredTable == work_->table && work_->scoredImages == task.labeled &&
      work_->scoredReference == task.reference && work_->scoredOthers == task.others)
    return;
  work_->scoredTable = work_->table;
  work_->scoredImages = task.labeled;
  work_->scoredReference = task.reference;
  work_->scoredOthers = task.others;
  scorer_.ask(
      {task.number, task.samples, work_->table, task.labeled, task.reference, task.others, task.othersOfLog});
}

}  // namespace widgets
