// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/motion/HeadPanel.h"

#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <cmath>

#include "robotlink/base/Geometry.h"
#include "robotlink/config/RobotDescription.h"
#include "widgets/Controls.h"

namespace widgets {
namespace {

constexpr int kPerDegree = 10;

int toSlider(double angle) {
  return static_cast<int>(std::lround(robotlink::degrees(angle) * kPerDegree));
}

}  // namespace

HeadPanel::HeadPanel(QWidget* parent) : QGroupBox(tr("Head"), parent) {
  setObjectName(QStringLiteral("headPanel"));
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(6, 6, 6, 6);
  layout->setVerticalSpacing(2);
  layout->setColumnStretch(1, 1);
  mode_ = new QComboBox(this);
  describe(*mode_, {"headMode", tr("Head mode"), tr("What the head does while you steer")});
  mode_->addItems({tr("look ahead"), tr("search ball"), tr("track ball"), tr("look around"), tr("angles")});
  layout->addWidget(new QLabel(tr("Mode"), this), 0, 0);
  layout->addWidget(mode_, 0, 1, 1, 2);
  createSlider(kTilt, "headTilt", tr("Tilt"));
  createSlider(kPan, "headPan", tr("Pan"));
  createSlider(kRoll, "headRoll", tr("Roll"));
  createSlider(kMouth, "headMouth", tr("Mouth"));
  setRobot(nullptr);
}

void HeadPanel::createSlider(Joint joint, const char* name, const QString& text) {
  auto* slider = new QSlider(Qt::Horizontal, this);
  describe(*slider, {name, text, tr("Angle in degrees")});
  slider->setSingleStep(kPerDegree);
  slider->setPageStep(10 * kPerDegree);
  auto* value = new QLabel(this);
  value->setObjectName(QString::fromLatin1(name) + QStringLiteral("Value"));
  value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  value->setMinimumWidth(fontMetrics().horizontalAdvance(QStringLiteral("-90.0°")));
  auto* layout = static_cast<QGridLayout*>(this->layout());
  layout->addWidget(new QLabel(text, this), joint + 1, 0);
  layout->addWidget(slider, joint + 1, 1);
  layout->addWidget(value, joint + 1, 2);
  sliders_[joint] = slider;
  values_[joint] = value;
  connect(slider, &QSlider::valueChanged, this, [this, joint] {
    showValue(joint);
    mode_->setCurrentIndex(static_cast<int>(HeadTarget::Kind::kAngles));
  });
}

void HeadPanel::setRobot(const robotlink::RobotDescription* robot) {
  for (int i = 0; i < kJoints; ++i) {
    const auto joint = static_cast<Joint>(i);
    const int index =
        robot != nullptr ? robot->jointIndex(kHeadJoints[static_cast<std::size_t>(i)].joint) : -1;
    const QSignalBlocker quiet(sliders_[joint]);
    if (index >= 0) {
      const auto& limits = robot->joints[static_cast<std::size_t>(index)];
      sliders_[joint]->setRange(toSlider(limits.minimum), toSlider(limits.maximum));
    } else {
      sliders_[joint]->setRange(-90 * kPerDegree, 90 * kPerDegree);
    }
    sliders_[joint]->setEnabled(robot == nullptr || index >= 0);
    showValue(joint);
  }
}

void HeadPanel::showValue(Joint joint) {
  values_[joint]->setText(
      QStringLiteral("%1°").arg(sliders_[joint]->value() / double(kPerDegree), 0, 'f', 1));
}

HeadTarget HeadPanel::target() const {
  const auto angle = [this](Joint joint) {
    return robotlink::radians(sliders_[joint]->value() / double(kPerDegree));
  };
  return {static_cast<HeadTarget::Kind>(mode_->currentIndex()), angle(kTilt), angle(kPan), angle(kRoll),
          angle(kMouth)};
}

void HeadPanel::setTarget(const HeadTarget& target) {
  const double angles[] = {target.tilt, target.pan, target.roll, target.mouth};
  for (int i = 0; i < kJoints; ++i) sliders_[static_cast<std::size_t>(i)]->setValue(toSlider(angles[i]));
  mode_->setCurrentIndex(static_cast<int>(target.kind));
}

}  // namespace widgets
