// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/solutions/ParameterSlider.h"

#include <QBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <algorithm>
#include <cmath>

#include "widgets/Controls.h"
#include "widgets/solutions/ParameterModel.h"

namespace widgets {
namespace {

constexpr int kParameterSteps = 1000;

/// Rounds to three significant digits of a range: what a hand can choose.
double rounded(double number, double range) {
  if (range <= 0) return number;
  const double unit = std::pow(10, std::floor(std::log10(range / kParameterSteps)));
  return std::round(number / unit) * unit;
}

}  // namespace

ParameterSlider::ParameterSlider(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("parameterSliderRow"));
  slider_ = new QSlider(Qt::Horizontal, this);
  widgets::describe(*slider_, {"parameterSlider", tr("Value of the parameter"),
                               tr("Drag to change the current parameter; it is set on release")});
  slider_->setTracking(false);
  text_ = new QLabel(this);
  text_->setObjectName(QStringLiteral("parameterSliderText"));
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(slider_, 1);
  row->addWidget(text_);
  connect(slider_, &QSlider::sliderMoved, this, &ParameterSlider::describe);
  connect(slider_, &QSlider::valueChanged, this, [this](int position) {
    auto* model = const_cast<QAbstractItemModel*>(index_.model());
    if (index_.isValid()) model->setData(index_, QString::number(numberAt(position), 'g', 9), Qt::EditRole);
    follow();
  });
  hide();
}

void ParameterSlider::show(const QModelIndex& index) {
  disconnect(following_);
  index_ = index.siblingAtColumn(ParameterModel::kValue);
  const QVariant value = index_.data(ParameterModel::kNumberRole);
  setVisible(value.isValid());
  if (!isVisibleTo(parentWidget())) return;
  const double inFile = index.siblingAtColumn(ParameterModel::kDefault).data().toDouble();
  const double builtIn = index.siblingAtColumn(ParameterModel::kBuiltIn).data().toDouble();
  const double largest = std::max({std::abs(value.toDouble()), std::abs(inFile), std::abs(builtIn)});
  const double around = largest > 0 ? 2 * largest : 1;
  const QVariant minimum = index.data(ParameterModel::kMinRole);
  const QVariant maximum = index.data(ParameterModel::kMaxRole);
  low_ = minimum.isValid() && std::isfinite(minimum.toDouble()) ? minimum.toDouble() : -around;
  high_ = maximum.isValid() && std::isfinite(maximum.toDouble()) ? maximum.toDouble()
                                                                 : std::max(around, low_ + around);
  isWhole_ = value.type() != QVariant::Double;
  const double range = high_ - low_;
  const QSignalBlocker silent(slider_);
  slider_->setRange(0, isWhole_ && range < kParameterSteps ? static_cast<int>(range) : kParameterSteps);
  slider_->setAccessibleName(index.data(ParameterModel::kPathRole).toString());
  following_ = connect(index_.model(), &QAbstractItemModel::dataChanged, this, [this] { follow(); });
  follow();
}

void ParameterSlider::follow() {
  const QVariant value = index_.data(ParameterModel::kNumberRole);
  if (!value.isValid()) return hide();
  if (slider_->isSliderDown()) return;
  const double share = std::clamp((value.toDouble() - low_) / (high_ - low_), 0.0, 1.0);
  const QSignalBlocker silent(slider_);
  slider_->setValue(static_cast<int>(std::lround(share * slider_->maximum())));
  text_->setText(index_.data().toString());
}

double ParameterSlider::numberAt(int position) const {
  const double number = low_ + (high_ - low_) * position / std::max(1, slider_->maximum());
  return isWhole_ ? std::round(number) : rounded(number, high_ - low_);
}

void ParameterSlider::describe(int position) {
  text_->setText(QString::number(numberAt(position), 'g', 9));
}

}  // namespace widgets
