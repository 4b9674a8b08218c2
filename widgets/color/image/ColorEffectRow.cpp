// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/image/ColorEffectRow.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <algorithm>

#include "widgets/Controls.h"
#include "widgets/Counted.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/image/ColorToolRow.h"

namespace widgets {
namespace {

constexpr std::size_t kMaxOtherImages = 8;
constexpr std::size_t kMaxLossesShown = 3;
/// Losses from this share on are shown as a warning.
constexpr double kLargeLoss = 0.1;

}  // namespace

ColorEffectRow::ColorEffectRow(ColorBench& bench, QWidget* parent) : QWidget(parent), bench_(bench) {
  setObjectName(QStringLiteral("colorEffectRow"));
  text_ = new QLabel(this);
  describe(*text_, {"colorEffect", tr("Pixels that the stroke takes from other classes"), {}});
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  drop_ = new QToolButton(this);
  describe(*drop_, {"colorDropOutliers", tr("Drop outliers"),
                    tr("Removes pixels of other classes from the stroke: what the brush touched next to a "
                       "thin line")});
  drop_->setText(tr("Drop outliers"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(6, 0, 6, 1);
  row->addWidget(text_, 1);
  row->addWidget(drop_);
  // The picture would jump under the brush if the row took its room only while it has something to say.
  for (QWidget* widget : {static_cast<QWidget*>(this), static_cast<QWidget*>(drop_)}) {
    QSizePolicy policy = widget->sizePolicy();
    policy.setRetainSizeWhenHidden(true);
    widget->setSizePolicy(policy);
  }
  connect(drop_, &QToolButton::clicked, this, &ColorEffectRow::dropOutliers);
  connect(&bench_, &ColorBench::samplesChanged, this, &ColorEffectRow::followSamples);
  connect(&bench_, &ColorBench::colorsChanged, this, &ColorEffectRow::update);
  hide();
}

void ColorEffectRow::begin() {
  const auto& strokes = bench_.samples().strokes;
  lastBefore_ = strokes.empty() ? 0 : strokes.back()->id;
  before_ = bench_.colors() == nullptr ? nullptr : bench_.colors()->table;
  stroke_ = 0;
  drawing_ = true;
  hide();
}

void ColorEffectRow::end() {
  drawing_ = false;
  update();
}

void ColorEffectRow::followSamples() {
  if (!before_) return;
  const auto& strokes = bench_.samples().strokes;
  const std::uint64_t last = strokes.empty() ? 0 : strokes.back()->id;
  if (drawing_ && last > lastBefore_) stroke_ = last;
  // The stroke was undone or removed, or another one was added: there is nothing left to report.
  if (!drawing_ && (last != stroke_ || stroke_ == 0)) {
    before_.reset();
    hide();
  }
}

const colortool::Stroke* ColorEffectRow::stroke() const {
  const auto found = std::ranges::find(bench_.samples().strokes, stroke_,
                                       [](const colortool::StrokePtr& each) { return each->id; });
  return stroke_ == 0 || found == bench_.samples().strokes.end() ? nullptr : found->get();
}

std::vector<colortool::ClassLoss> ColorEffectRow::losses() const {
  const LearnedColors& colors = *bench_.colors();
  colortool::StrokeEffect effect(*before_, *colors.table);
  if (colors.frame)
    effect.add(colors.seen(), colors.frame == bench_.frame() ? stroke()->area : colortool::PixelArea{});
  std::size_t others = 0;
  for (const CollectedFrame& collected : bench_.collected()) {
    if (drawing_ || others == kMaxOtherImages) break;
    const bool seenAsItIs = bench_.samples().correctionOf(collected.frame->place().camera).none();
    if (collected.frame == colors.frame || !seenAsItIs) continue;
    effect.add(collected.frame->view());
    ++others;
  }
  return effect.losses();
}

QString ColorEffectRow::textOf(const std::vector<colortool::ClassLoss>& losses) const {
  QStringList parts;
  for (std::size_t i = 0; i < std::min(losses.size(), kMaxLossesShown); ++i) {
    const auto& [from, to, pixels, share] = losses[i];
    const QString was = from == 0 ? tr("pixels without a class") : className(bench_, from);
    parts << tr("%1 % of %2 (now %3)")
                 .arg(std::max(1, qRound(100 * share)))
                 .arg(was, to == 0 ? tr("none") : className(bench_, to));
  }
  return tr("This stroke takes %1").arg(parts.join(QStringLiteral(", ")));
}

void ColorEffectRow::update() {
  if (!before_ || stroke() == nullptr || bench_.colors() == nullptr || !bench_.upToDate()) return;
  const auto found = losses();
  const auto outliers = colortool::contestedPixels(bench_.samples(), *stroke(), *before_);
  const bool large = std::ranges::any_of(
      found, [](const colortool::ClassLoss& loss) { return loss.from != 0 && loss.share >= kLargeLoss; });
  const auto count = static_cast<int>(colortool::pixelCount(outliers));
  QString text = found.empty() ? QString() : textOf(found);
  if (count > 0) {
    if (!text.isEmpty()) text += QStringLiteral(". ");
    text += counted(static_cast<qulonglong>(count), tr("1 of its pixels was of another class"),
                    tr("%1 of its pixels were of other classes"));
  }
  showOutcome(*text_, large ? QStringLiteral("⚠ ") + text : text, large);
  text_->setToolTip(text);
  drop_->setVisible(count > 0 && !drawing_);
  setVisible(!text.isEmpty());
}

void ColorEffectRow::dropOutliers() {
  if (!before_ || stroke() == nullptr) return;
  colortool::Samples next = bench_.samples();
  colortool::erasePart(next, stroke_, colortool::contestedPixels(next, *stroke(), *before_));
  bench_.change(tr("Drop outliers"), std::move(next));
}

}  // namespace widgets
