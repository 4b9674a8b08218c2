// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/camera/PlacePanel.h"

#include <QAction>
#include <QComboBox>
#include <QFormLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTableView>

#include "widgets/Controls.h"
#include "widgets/camera/MarkModel.h"

namespace widgets {
namespace {

QString inDegrees(double rad) {
  return QString::number(rad * 180 / robotlink::kPi, 'f', 1);
}

}  // namespace

PlacePanel::PlacePanel(MarkModel& marks, QWidget* parent) : QWidget(parent) {
  by_ = new QComboBox(this);
  describe(*by_, {"placeBy", tr("Computed from"), tr("Data from which the camera's pose is computed")});
  by_->addItems({tr("Marks of the field"), tr("Board on the ground")});
  take =
      makeAction(this, "record",
                 {"placeTake", tr("Take"),
                  tr("Computes the pose from the visible board, which must lie on the ground"), Qt::Key_P});
  remove = makeAction(
      this, "remove",
      {"placeRemove", tr("Forget"), tr("Clears the click on the selected mark"), QKeySequence::Delete});
  clear = makeAction(this, "clear", {"placeClear", tr("Forget all"), tr("Clears the clicks on all marks")});
  use = makeAction(
      this, "send",
      {"placeUse", tr("Use"), tr("Sets height, tilt and roll as parameters of the solution of camera-pose")});
  table_ = makeTable(this, {"placeMarks", tr("Marks of the field"), {}}, &marks);
  table_->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table_->horizontalHeader()->setSectionResizeMode(MarkModel::kKind, QHeaderView::Stretch);
  result_ = makeNote(this, "placeResult", tr("The place of the camera"));
  result_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  outcome_ = makeNote(this, "placeOutcome", tr("What came of it"));

  auto* form = new QFormLayout;
  form->addRow(by_->accessibleName(), by_);
  auto* buttons = makeToolRow(this);
  buttons->addWidget(makeLabeledButton(this, take));
  addButtons(buttons, {remove, clear});
  buttons->addWidget(makeLabeledButton(this, use));
  buttons->addStretch(1);
  auto* layout = makeColumn(this, {6, 6, 6, 6}, 4);
  layout->addLayout(form);
  layout->addWidget(buttons->parentWidget());
  layout->addWidget(table_, 1);
  layout->addWidget(result_);
  layout->addWidget(outcome_);
  connect(by_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, &PlacePanel::showChoice);
  showChoice();
  show({}, {});
}

PlacePanel::By PlacePanel::by() const {
  return by_->currentIndex() == 0 ? By::kMarks : By::kBoard;
}

void PlacePanel::showChoice() {
  const bool isByMarks = by() == By::kMarks;
  table_->setVisible(isByMarks);
  take->setEnabled(!isByMarks);
  remove->setEnabled(isByMarks);
  clear->setEnabled(isByMarks);
}

int PlacePanel::selected() const {
  return table_->currentIndex().isValid() ? table_->currentIndex().row() : -1;
}

void PlacePanel::select(int row) {
  if (row >= 0) table_->selectRow(row);
}

void PlacePanel::show(const std::optional<robotlink::PlaceFit>& fit, const QString& why) {
  fit_ = fit;
  use->setEnabled(fit.has_value());
  if (!fit) return result_->setText(why);
  QString text = tr("Height %1 m, tilt %2°, roll %3°; error %4 px")
                     .arg(fit->height(), 0, 'f', 3)
                     .arg(inDegrees(fit->tilt()), inDegrees(fit->roll()))
                     .arg(fit->error, 0, 'f', 2);
  if (by() == By::kMarks)
    text += QLatin1Char('\n') + tr("On the field at %1, %2 m, looking along %3°")
                                    .arg(fit->cameraInWorld.translation().x(), 0, 'f', 3)
                                    .arg(fit->cameraInWorld.translation().y(), 0, 'f', 3)
                                    .arg(inDegrees(fit->pan()));
  result_->setText(text);
}

}  // namespace widgets
