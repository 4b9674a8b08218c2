// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorBench.h"

#include <algorithm>

#include "colortool/image/ClassPresets.h"
#include "foxglove/Image.pb.h"
#include "robotlink/config/FieldDescription.h"
#include "widgets/controls/HistoryStep.h"
#include "widgets/image/ImagePixels.h"

namespace widgets {
namespace {

constexpr int kThumbnailHeight = 72;
/// The number of seen images that are kept to try the table on, and their minimum distance.
constexpr std::size_t kMaxOthers = 12;
constexpr std::chrono::seconds kMinApart(1);

/// The classes of the preset that fits a field; null: none.
colortool::ColorClasses classesFor(const robotlink::FieldDescription* field) {
  std::vector<std::string> colors;
  if (field != nullptr) {
    for (const auto& color : field->palette) colors.push_back(color.name);
  }
  return colortool::presetFor(colors).classes();
}

}  // namespace

ColorBench::ColorBench(const ViewContext& context, QObject* parent)
    : QObject(parent), session_(context.session), labeled_(std::make_shared<std::vector<LabeledFrame>>()) {
  colortool::Samples samples;
  samples.classes = usual_ = classesFor(context.field.get());
  document_ = colortool::SampleDocument(std::move(samples));
  learner_ = std::make_unique<ColorLearner>(
      [this] { QMetaObject::invokeMethod(this, &ColorBench::takeNews, Qt::QueuedConnection); });
  ask();
}

void ColorBench::setField(const robotlink::FieldDescription* field) {
  const colortool::ColorClasses before = std::exchange(usual_, classesFor(field));
  const colortool::Samples& now = samples();
  if (usual_ == before || undo_.count() > 0 || !now.strokes.empty() || !(now.classes == before)) return;
  setDocument({}, false);
}

ColorBench::~ColorBench() {
  learner_.reset();
}

void ColorBench::change(const QString& text, colortool::Samples next, const std::string& gesture) {
  const std::size_t before = document_.position();
  if (next == document_.samples()) return;
  const bool step = document_.change(text.toStdString(), std::move(next), gesture);
  // A continued gesture has its place on the stack already.
  if (step || document_.position() != before)
    undo_.push(new HistoryStep(text, document_, [this] { changed(); }));
  else
    changed();
}

void ColorBench::setDocument(colortool::Samples samples, bool changed) {
  if (samples.classes.size() < 2) samples.classes = usual_;
  document_ = colortool::SampleDocument(std::move(samples));
  undo_.clear();
  if (changed) undo_.resetClean();
  currentClass_ = std::min(currentClass_, document_.samples().classes.size() - 1);
  this->changed();
  Q_EMIT meaningChanged();
}

void ColorBench::setSaved() {
  document_.setSaved();
  undo_.setClean();
}

void ColorBench::changed() {
  if (currentClass_ >= samples().classes.size()) {
    currentClass_ = samples().classes.size() - 1;
    Q_EMIT meaningChanged();
  }
  ask();
  if (reference_ && referenceClasses_ != samples().classes) numberReference();
  Q_EMIT samplesChanged();
}

void ColorBench::setCurrentClass(int colorClass) {
  if (colorClass < 0 || colorClass >= samples().classes.size() || colorClass == currentClass_) return;
  currentClass_ = colorClass;
  Q_EMIT meaningChanged();
}

void ColorBench::setMustNotBe(bool mustNotBe) {
  if (mustNotBe_ == mustNotBe) return;
  mustNotBe_ = mustNotBe;
  Q_EMIT meaningChanged();
}

void ColorBench::setWeight(double weight) {
  weight = std::clamp(weight, colortool::Stroke::kMinWeight, colortool::Stroke::kMaxWeight);
  if (weight_ == weight) return;
  weight_ = weight;
  Q_EMIT meaningChanged();
}

void ColorBench::addStroke(const colortool::PixelArea& area, const std::string& tool,
                           const std::string& gesture) {
  if (!frame_) return;
  const auto colorClass = static_cast<std::uint8_t>(currentClass_);
  const bool notBackground = mustNotBe_ && currentClass_ != 0;
  const QString name =
      currentClass_ == 0 ? tr("background") : QString::fromStdString(samples().classes.name(currentClass_));
  colortool::Samples next = document_.beforeGesture(gesture);
  colortool::addStroke(next, frame_->place(), frame_->colors(), area,
                       {colorClass, notBackground, weight_, tool});
  change(notBackground ? tr("Not %1").arg(name) : tr("Stroke: %1").arg(name), std::move(next), gesture);
}

void ColorBench::erase(const colortool::PixelArea& area, const std::string& gesture) {
  if (!frame_) return;
  colortool::Samples next = document_.beforeGesture(gesture);
  colortool::erase(next, frame_->place(), area);
  change(tr("Erase"), std::move(next), gesture);
}

void ColorBench::setFrame(ColorFramePtr frame) {
  if (frame == frame_) return;
  frame_ = std::move(frame);
  rememberFrame();
  ask();
  Q_EMIT frameChanged();
}

void ColorBench::rememberFrame() {
  if (!frame_) return;
  const bool near = std::ranges::any_of(others_, [this](const ColorFramePtr& other) {
    return other->stream() == frame_->stream() && other->file() == frame_->file() &&
           std::chrono::abs(other->time() - frame_->time()) < kMinApart;
  });
  if (near) return;
  if (others_.size() >= kMaxOthers) others_.erase(others_.begin());
  others_.push_back(frame_);
}

void ColorBench::setLogImages(std::vector<ColorFramePtr> images) {
  if (images.empty() && logImages_.empty()) return;
  logImages_ = std::move(images);
  ask();
}

void ColorBench::collect() {
  if (!frame_) return;
  const bool there = std::ranges::any_of(
      collected_, [this](const CollectedFrame& each) { return each.frame->place() == frame_->place(); });
  if (!there && collect({frame_}) == 0)
    Q_EMIT failed(tr("The strip is full; remove some images first (Delete)"));
}

std::size_t ColorBench::collect(const std::vector<ColorFramePtr>& frames) {
  std::size_t bytes = 0, added = 0;
  for (const CollectedFrame& collected : collected_) bytes += collected.frame->message()->data().size();
  for (const ColorFramePtr& frame : frames) {
    const auto isThis = [&frame](const ColorFrame& other) { return other.place() == frame->place(); };
    const bool there =
        std::ranges::any_of(collected_, [&](const CollectedFrame& each) { return isThis(*each.frame); });
    if (there || bytes > kMaxCollectedBytes) continue;
    const bool counted = frame == frame_ || std::ranges::any_of(others_, [&](const ColorFramePtr& each) {
                           return isThis(*each);
                         });
    if (!counted && others_.size() < kMaxOthers) others_.push_back(frame);
    bytes += frame->message()->data().size();
    const QImage image = toQImage(frame->view());
    collected_.push_back({frame, image.scaledToHeight(kThumbnailHeight, Qt::SmoothTransformation)});
    ++added;
  }
  if (added > 0) Q_EMIT collectedChanged();
  return added;
}

void ColorBench::removeCollected(std::size_t index) {
  if (index >= collected_.size()) return;
  collected_.erase(collected_.begin() + static_cast<std::ptrdiff_t>(index));
  Q_EMIT collectedChanged();
}

std::vector<robotlink::Rgb> ColorBench::classColors() const {
  std::vector<robotlink::Rgb> colors;
  const auto& classes = samples().classes;
  for (int i = 0; i < classes.size(); ++i) colors.push_back(classes.shownColor(i));
  return colors;
}

void ColorBench::setReference(std::shared_ptr<const colortool::ColorTable> table, const QString& name) {
  setReference({std::move(table), samples().classes, name});
}

void ColorBench::setReference(ReferenceTable reference) {
  givenReference_ = reference.table ? std::move(reference) : ReferenceTable{};
  numberReference();
}

void ColorBench::numberReference() {
  const ReferenceTable& given = givenReference_;
  referenceClasses_ = samples().classes;
  if (!given.table || given.classes == referenceClasses_) {
    reference_ = given.table;
  } else {
    reference_ = std::make_shared<const colortool::ColorTable>(colortool::ColorTable::translated(
        given.table->cells(), classNumbers(given.classes, referenceClasses_)));
  }
  ask();
  Q_EMIT referenceChanged();
}

void ColorBench::setLabeled(std::vector<LabeledFrame> labeled) {
  labeled_ = std::make_shared<const std::vector<LabeledFrame>>(std::move(labeled));
  ask();
}

void ColorBench::select(const colortool::CellSet& cells) {
  selection_ = cells;
  selected_ = true;
  Q_EMIT selectionChanged();
}

void ColorBench::clearSelection() {
  if (!selected_) return;
  selected_ = false;
  selection_ = {};
  Q_EMIT selectionChanged();
}

void ColorBench::setPointed(const std::optional<robotlink::YCbCr>& color) {
  if (color == pointed_) return;
  pointed_ = color;
  Q_EMIT pointedChanged();
}

void ColorBench::ask() {
  const bool ofLog = !logImages_.empty();
  learner_->ask(
      {++asked_, document_.samples(), frame_, labeled_, reference_, ofLog ? logImages_ : others_, ofLog});
}

void ColorBench::takeNews() {
  if (auto colors = learner_->takeColors()) {
    colors_ = std::move(colors);
    Q_EMIT colorsChanged();
  }
  if (auto quality = learner_->takeQuality()) {
    quality_ = std::move(quality);
    Q_EMIT qualityChanged();
  }
}

ColorBench& colorBench(ViewContext& context) {
  if (context.colors == nullptr) context.colors = std::make_shared<ColorBench>(context);
  return *context.colors;
}

}  // namespace widgets
