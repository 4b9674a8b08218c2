// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorScorer.h"

#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <utility>

#include "colortool/correction/ImageCorrector.h"
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

/// Counts the suspicious pixels of images, and those with colors of the background. The table sees them with
/// their cameras' corrections.
class UnlabeledCount {
 public:
  explicit UnlabeledCount(const ColorScorer::Task& task)
      : samples_(task.samples),
        meter_(*task.table, {}, colortool::objectClasses(task.samples.classes)),
        background_(task.samples, *task.table) {}

  void add(const ColorFrame& frame, ColorQuality::Others& others) {
    const robotlink::ImageView image = corrected(frame);
    const colortool::Suspicion suspicion = meter_.measure(image);
    background_.add(image);
    others.background = background_.counts();
    others.suspicious.resize(std::max(others.suspicious.size(), suspicion.byClass.size()), 0);
    for (std::size_t i = 0; i < suspicion.byClass.size(); ++i)
      others.suspicious[i] +=
          suspicion.byClass[i].specks + suspicion.byClass[i].enclosed + suspicion.byClass[i].vast;
    others.pixels += static_cast<std::uint64_t>(frame.width()) * static_cast<std::uint64_t>(frame.height());
    ++others.images;
  }

 private:
  robotlink::ImageView corrected(const ColorFrame& frame) {
    const colortool::ColorCorrection correction = samples_.correctionOf(frame.place().camera);
    if (correction.none()) return frame.view();
    if (!corrector_ || !(corrector_->correction() == correction)) corrector_.emplace(correction);
    corrector_->correct(frame.view(), image_);
    return image_.view();
  }

  const colortool::Samples& samples_;
  colortool::SuspicionMeter meter_;
  colortool::BackgroundColors background_;
  std::optional<colortool::ImageCorrector> corrector_;
  /// The image that was corrected last.
  robotlink::Image image_;
};

/// Scores labeled and unlabeled images. False: canceled.
bool scoreImages(const ColorScorer::Task& task, const std::stop_token& stop, ColorQuality& quality) {
  if (task.labeled && !task.labeled->empty()) {
    Evaluation evaluation(task.samples.classes.size()), reference = evaluation;
    for (const LabeledFrame& labeled : *task.labeled) {
      if (stop.stop_requested()) return false;
      add(evaluation, labeled, task, *task.table);
      if (task.reference) add(reference, labeled, task, *task.reference);
    }
    quality.labeled.emplace(std::move(evaluation));
    if (task.reference) quality.referenceLabeled.emplace(std::move(reference));
  }
  quality.others.ofLog = task.othersOfLog;
  UnlabeledCount count(task);
  for (const ColorFramePtr& frame : task.others) {
    if (stop.stop_requested()) return false;
    count.add(*frame, quality.others);
  }
  return true;
}

/// Unset: canceled.
std::optional<ColorQuality> scoredQuality(const ColorScorer::Task& task, const std::stop_token& stop) {
  ColorQuality quality;
  quality.task = task.number;
  quality.classes = task.samples.classes;
  if (!scoreImages(task, stop, quality)) return std::nullopt;
  if (!task.samples.strokes.empty()) {
    quality.strokes = colortool::crossValidate(task.samples, [&stop] { return !stop.stop_requested(); });
    if (!quality.strokes) return std::nullopt;
    if (task.reference) quality.referenceStrokes = colortool::scoreStrokes(task.samples, *task.reference);
  }
  return quality;
}

/// The user waits for the picture, not for the figures. Every thread may lower its own priority.
void lowerPriority() {
  ::setpriority(PRIO_PROCESS, static_cast<id_t>(::gettid()), kNice);
}

}  // namespace

ColorScorer::ColorScorer(std::function<void()> news)
    : worker_(
          [this](const Task& task, const std::stop_token& stop) {
            if (auto quality = scoredQuality(task, stop)) worker_.publish(*std::move(quality));
          },
          {.news = std::move(news), .begin = &lowerPriority}) {}

}  // namespace widgets
