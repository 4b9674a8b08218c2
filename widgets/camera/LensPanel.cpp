// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/LensPanel.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QListView>
#include <QSpinBox>

#include "robotlink/calibration/CameraCalibration.h"
#include "widgets/Controls.h"

namespace widgets {
namespace {

constexpr double kMillimeters = 1000;

QSpinBox* makeCount(QWidget* parent, const ControlText& text, int value) {
  auto* count = new QSpinBox(parent);
  describe(*count, text);
  count->setRange(3, 50);
  count->setValue(value);
  return count;
}

QString degrees(double rad) {
  return LensPanel::tr("%1°").arg(rad * 180 / robotlink::kPi, 0, 'f', 1);
}

}  // namespace

LensPanel::LensPanel(QWidget* parent) : QWidget(parent) {
  const robotlink::Chessboard usual;
  columns_ =
      makeCount(this, {"lensColumns", tr("Corners in a row"), tr("Inner corners, where four squares meet")},
                usual.columns);
  rows_ =
      makeCount(this, {"lensRows", tr("Corners in a column"), tr("Inner corners, where four squares meet")},
                usual.rows);
  square_ = new QDoubleSpinBox(this);
  describe(*square_, {"lensSquare", tr("Side of a square"), tr("As printed: measure it")});
  square_->setRange(1, 1000);
  square_->setDecimals(1);
  square_->setSuffix(tr(" mm"));
  square_->setValue(usual.square * kMillimeters);
  take = makeAction(this, "record",
                    {"lensTake", tr("Take"), tr("Captures the current view of the board"), Qt::Key_Space});
  automatic = makeToggle(this, "loop",
                         {"lensAutomatic", tr("Capture automatically"),
                          tr("Captures a view automatically whenever the board has moved"), Qt::Key_T});
  remove = makeAction(this, "remove",
                      {"lensRemove", tr("Remove"), tr("Removes the selected view"), QKeySequence::Delete});
  clear = makeAction(this, "clear", {"lensClear", tr("Remove all"), tr("Removes all views")});
  use = makeAction(
      this, "send",
      {"lensUse", tr("Use"), tr("Sets the opening angles as parameters of the solution of camera-pose")});
  list_ = new QListView(this);
  describe(*list_, {"lensViews", tr("Views of the board"),
                    tr("Each view with its error; remove those that are much worse than the others")});
  list_->setModel(&listed_);
  list_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  result_ = makeNote(this, "lensResult", tr("The lens"));
  result_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  outcome_ = makeNote(this, "lensOutcome", tr("What came of it"));

  auto* form = new QFormLayout;
  form->addRow(columns_->accessibleName(), columns_);
  form->addRow(rows_->accessibleName(), rows_);
  form->addRow(square_->accessibleName(), square_);
  auto* buttons = makeToolRow(this);
  buttons->addWidget(makeLabeledButton(this, take));
  addButtons(buttons, {automatic, remove, clear});
  buttons->addWidget(makeLabeledButton(this, use));
  buttons->addStretch(1);
  auto* layout = makeColumn(this, {6, 6, 6, 6}, 4);
  layout->addLayout(form);
  layout->addWidget(buttons->parentWidget());
  layout->addWidget(list_, 1);
  layout->addWidget(result_);
  layout->addWidget(outcome_);
  show({}, {});
}

robotlink::Chessboard LensPanel::board() const {
  return {columns_->value(), rows_->value(), square_->value() / kMillimeters};
}

void LensPanel::setBoard(const robotlink::Chessboard& board) {
  columns_->setValue(board.columns);
  rows_->setValue(board.rows);
  square_->setValue(board.square * kMillimeters);
}

int LensPanel::selected() const {
  return list_->currentIndex().isValid() ? list_->currentIndex().row() : -1;
}

void LensPanel::show(const BoardViews& views, const std::optional<robotlink::LensFit>& fit) {
  const std::size_t count = views.views().size();
  const bool isOfThese = fit && fit->viewErrors.size() == count;
  QStringList rows;
  for (std::size_t i = 0; i < count; ++i)
    rows << (isOfThese ? tr("View %1: %2 px").arg(i + 1).arg(fit->viewErrors[i], 0, 'f', 2)
                       : tr("View %1").arg(i + 1));
  listed_.setStringList(rows);
  remove->setEnabled(count > 0);
  clear->setEnabled(count > 0);
  use->setEnabled(isOfThese);
  if (!isOfThese) {
    const auto missing = static_cast<int>(robotlink::kMinBoardViews) - static_cast<int>(count);
    result_->setText(missing > 0
                         ? tr("Hold the board in at least %1 different places, near and far, tilted, and "
                              "into the corners of the image; ten are better.")
                               .arg(robotlink::kMinBoardViews)
                         : tr("Computing…"));
    return;
  }
  const robotlink::LensModel& lens = fit->lens;
  QStringList distortion;
  for (const double factor : lens.distortion) distortion << QString::number(factor, 'f', 4);
  result_->setText(
      tr("Opening angles %1 by %2, error %3 px\nFocal lengths %4, %5 px; center %6, %7 px\nDistortion %8")
          .arg(degrees(lens.horizontalAngle()), degrees(lens.verticalAngle()),
               QString::number(fit->error, 'f', 2), QString::number(lens.focalX, 'f', 1),
               QString::number(lens.focalY, 'f', 1), QString::number(lens.centerX, 'f', 1),
               QString::number(lens.centerY, 'f', 1), distortion.join(QStringLiteral(", "))));
}

}  // namespace widgets
