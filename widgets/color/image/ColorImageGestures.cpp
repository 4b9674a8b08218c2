// SPDX-License-Identifier: GPL-3.0-or-later
// The part of ColorImageView that turns gestures in the images into strokes and selections.
#include <QAction>
#include <QMenu>

#include "colortool/table/ColorTable.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/image/ColorEffectRow.h"
#include "widgets/color/image/ColorImageView.h"
#include "widgets/color/image/ColorToolRow.h"

namespace widgets {
namespace {

colortool::ImagePoint imagePoint(const QPointF& at) {
  // Coordinates of samples begin at the center of the upper left pixel.
  return {at.x() - 0.5, at.y() - 0.5};
}

}  // namespace

void ColorImageView::applyTool() {
  for (ColorCanvas* canvas : {left_, right_}) canvas->setTool(toolRow_->tool(), toolRow_->radius());
}

void ColorImageView::beginGesture(const QPointF& at) {
  if (!bench_.frame()) return;
  gesture_.emplace(bench_.frame()->colors(), toolRow_->options(), imagePoint(at));
  ++gestures_;
  if (gesture_->tool() != ColorTool::kEraser && gesture_->tool() != ColorTool::kSelect) effect_->begin();
  if (isLive(gesture_->tool())) commitGesture();
}

void ColorImageView::moveGesture(const QPointF& at) {
  if (!gesture_ || !bench_.frame()) return;
  gesture_->moveTo(bench_.frame()->colors(), imagePoint(at));
  if (isLive(gesture_->tool()))
    commitGesture();
  else
    showPreview();
}

void ColorImageView::endGesture() {
  if (!gesture_) return;
  if (!isLive(gesture_->tool())) commitGesture();
  gesture_.reset();
  effect_->end();
  showPreview();
}

void ColorImageView::cancelGesture() {
  if (!gesture_) return bench_.clearSelection();
  if (isLive(gesture_->tool()) && bench_.document().continues(std::to_string(gestures_)))
    bench_.undoStack().undo();
  gesture_.reset();
  effect_->end();
  showPreview();
}

void ColorImageView::commitGesture() {
  const std::string name = std::to_string(gestures_);
  switch (gesture_->tool()) {
    case ColorTool::kEraser:
      return bench_.erase(gesture_->area(), name);
    case ColorTool::kSelect: {
      colortool::CellSet cells;
      const robotlink::ImageView image = seen();
      for (const colortool::PixelRun& run : gesture_->area()) {
        for (int x = run.begin; x < run.end; ++x)
          cells.set(colortool::ColorTable::cellOf(robotlink::pixelYCbCr(image, x, run.y)));
      }
      return cells.empty() ? bench_.clearSelection() : bench_.select(cells);
    }
    default:
      return bench_.addStroke(gesture_->area(), toolName(gesture_->tool()), name);
  }
}

void ColorImageView::showPreview() {
  const robotlink::Rgb color = bench_.samples().classes.shownColor(bench_.currentClass());
  const bool wanted = gesture_ && !isLive(gesture_->tool());
  const QColor shown = bench_.currentClass() == 0 || (wanted && gesture_->tool() == ColorTool::kSelect)
                           ? QColor(255, 255, 255)
                           : QColor(color.r, color.g, color.b);
  for (ColorCanvas* canvas : {left_, right_})
    canvas->setPreview(wanted ? outlineOf(gesture_->area()) : QVector<QLineF>(), shown);
}

void ColorImageView::addClassChoices(QMenu& menu, const colortool::PixelArea& area, const char* tool,
                                     bool mustNotBe) {
  for (int i = mustNotBe ? 1 : 0; i < bench_.samples().classes.size(); ++i) {
    menu.addAction(classSwatch(bench_, i), className(bench_, i), this, [this, area, tool, i, mustNotBe] {
      const int before = bench_.currentClass();
      const bool said = bench_.mustNotBe();
      bench_.setCurrentClass(i);
      bench_.setMustNotBe(mustNotBe);
      bench_.addStroke(area, tool);
      bench_.setMustNotBe(said);
      bench_.setCurrentClass(before);
    });
  }
}

void ColorImageView::openMenu(bool segmented, const QPoint& pixel, const QPoint& global) {
  const ColorFramePtr frame = bench_.frame();
  if (!frame) return;
  const colortool::ImagePoint at[] = {{static_cast<double>(pixel.x()), static_cast<double>(pixel.y())}};
  const auto around = colortool::brushArea(frame->width(), frame->height(), at, toolRow_->radius());
  auto* menu = new QMenu(this);
  menu->setObjectName(QStringLiteral("colorPixelMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  addClassChoices(*menu->addMenu(tr("This is")), around, "point", false);
  addClassChoices(*menu->addMenu(tr("This must not be")), around, "point", true);
  const LearnedColors* colors = bench_.colors();
  if (segmented && colors != nullptr && colors->classes && colors->frame == frame)
    addClassChoices(*menu->addMenu(tr("The whole spot is")),
                    colortool::spotArea(colors->classes->view(), pixel.x(), pixel.y()), "spot", false);
  menu->addSeparator();
  menu->addActions({copyAction(), copyNumbersAction(), saveAction()});
  menu->popup(global);
}

}  // namespace widgets
