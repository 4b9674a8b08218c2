// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/NewSceneDialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>

#include "widgets/Controls.h"
#include "widgets/sceneedit/SceneLanguage.h"

namespace widgets {

NewSceneDialog::NewSceneDialog(const SceneLanguage& language, std::filesystem::path file, QWidget* parent)
    : QDialog(parent), language_(language), file_(std::move(file)) {
  setObjectName(QStringLiteral("newSceneDialog"));
  setWindowTitle(tr("New scene"));
  auto* form = new QFormLayout(this);
  name_ = new QLineEdit(QStringLiteral("room"), this);
  describe(*name_,
           {"newSceneName", tr("Name"), tr("Name of the world and its file: letters, digits, - and _")});
  name_->selectAll();
  form->addRow(tr("Name"), name_);
  const RoomChoice usual;
  width_ = addLength(*form, "newSceneWidth", tr("Width"), usual.width, 2, 50);
  depth_ = addLength(*form, "newSceneDepth", tr("Depth"), usual.depth, 2, 50);
  height_ = addLength(*form, "newSceneHeight", tr("Height of the walls"), usual.wallHeight, 0.1, 5);
  doorway_ = new QCheckBox(tr("Wall across the middle with a doorway"), this);
  describe(*doorway_,
           {"newSceneDoorway", doorway_->text(), tr("The doorway is 1 m wide; a door fits into it")});
  form->addRow(QString(), doorway_);
  robot_ = new QComboBox(this);
  describe(*robot_, {"newSceneRobot", tr("Robot"), tr("The robot that stands in the room")});
  robot_->addItem(tr("none"), QString());
  for (const SceneModelChoice& model : language_.models(file_)) {
    const QString name = QString::fromStdString(model.name);
    if (model.isRobot) robot_->addItem(name, name);
  }
  if (robot_->count() > 1) robot_->setCurrentIndex(1);
  form->addRow(tr("Robot"), robot_);
  refusal_ = makeNote(this, "newSceneRefusal", tr("Why the scene cannot be made"));
  form->addRow(refusal_);
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
  form->addRow(buttons);
  connect(buttons, &QDialogButtonBox::accepted, this, &NewSceneDialog::accept);
  connect(buttons, &QDialogButtonBox::rejected, this, &NewSceneDialog::reject);
}

QDoubleSpinBox* NewSceneDialog::addLength(QFormLayout& form, const char* name, const QString& label,
                                          double value, double least, double most) {
  auto* box = new QDoubleSpinBox(this);
  describe(*box, {name, label, {}});
  box->setRange(least, most);
  box->setDecimals(2);
  box->setSingleStep(0.5);
  box->setSuffix(QStringLiteral(" m"));
  box->setValue(value);
  form.addRow(label, box);
  return box;
}

QString NewSceneDialog::name() const {
  return name_->text().trimmed();
}

void NewSceneDialog::accept() {
  RoomChoice room;
  room.name = name().toStdString();
  room.width = width_->value();
  room.depth = depth_->value();
  room.wallHeight = height_->value();
  room.doorway = doorway_->isChecked();
  room.robot = robot_->currentData().toString().toStdString();
  const auto text = language_.newRoom(room, file_);
  if (!text) return showOutcome(*refusal_, QString::fromStdString(text.error().text), true);
  text_ = QString::fromStdString(*text);
  QDialog::accept();
}

}  // namespace widgets
