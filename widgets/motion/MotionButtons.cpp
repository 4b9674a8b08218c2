// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/MotionButtons.h"

#include <QDir>
#include <QGridLayout>
#include <QPushButton>

#include "robotlink/base/Resources.h"
#include "widgets/Controls.h"
#include "widgets/Icon.h"
#include "widgets/motion/MotionCommander.h"

namespace widgets {
namespace {

constexpr int kColumns = 2;

}  // namespace

MotionButtons::MotionButtons(QWidget* parent) : QGroupBox(tr("Motions"), parent) {
  setObjectName(QStringLiteral("motionButtons"));
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setSpacing(4);
  int place = 0;
  const QStringList motions = shippedMotions();
  for (const QString& motion : motions) add(motion, place++);
  add(QString::fromLatin1(MotionCommander::kGetUp), place);
}

QStringList MotionButtons::shippedMotions() {
  const QDir folder(QString::fromStdString(robotlink::resource("motions").string()));
  QStringList motions;
  const auto files = folder.entryInfoList({QStringLiteral("*.mof")}, QDir::Files, QDir::Name);
  for (const QFileInfo& file : files) {
    const QString name = file.completeBaseName();
    // "extern" is the exit of the motions' grammar, and getting up is a request of its own kind.
    if (name != QLatin1String("extern") && !name.startsWith(QLatin1String(MotionCommander::kGetUp)))
      motions << name;
  }
  return motions;
}

void MotionButtons::add(const QString& motion, int place) {
  auto* button =
      new QPushButton(icon(motion.startsWith(QLatin1String("kick")) ? "kick" : "motion"), motion, this);
  const QByteArray name = "motion-" + motion.toLatin1();
  describe(*button, {name.constData(), motion, tr("Plays this motion once, while you steer")});
  button->setCheckable(true);
  button->setFocusPolicy(Qt::TabFocus);  // a click must not take the focus away from the walk pad
  static_cast<QGridLayout*>(layout())->addWidget(button, place / kColumns, place % kColumns);
  connect(button, &QPushButton::clicked, this, [this, motion, button] {
    button->setChecked(false);  // checked by showPlaying() when the robot reports that it plays
    Q_EMIT chosen(motion);
  });
}

void MotionButtons::showPlaying(const QString& motion) {
  const auto buttons = findChildren<QPushButton*>();
  for (QPushButton* button : buttons) {
    const bool plays = !motion.isEmpty() && button->objectName() == QStringLiteral("motion-") + motion;
    if (button->isChecked() != plays) button->setChecked(plays);
  }
}

}  // namespace widgets
