// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/image/CompareRow.h"

#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QHBoxLayout>
#include <QJsonObject>
#include <QSlider>
#include <algorithm>

#include "foxglove/Image.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/Controls.h"
#include "widgets/image/StreamSelector.h"

namespace widgets {
namespace {

constexpr double kMaxShift = 600;  // s
constexpr int kMaxGain = 16, kUsualGain = 4;

QSlider* makeSlider(QWidget* parent, const ControlText& text, int min, int max, int value) {
  auto* slider = new QSlider(Qt::Horizontal, parent);
  describe(*slider, text);
  slider->setRange(min, max);
  slider->setValue(value);
  slider->setFixedWidth(84);
  return slider;
}

}  // namespace

std::string drawingRobot(const std::string& path) {
  const auto robot = path.find('/');
  constexpr char kLogged[] = "/logged/";
  const bool isLogged = path.compare(std::min(robot, path.size()), sizeof(kLogged) - 1, kLogged) == 0;
  return path.substr(0, isLogged ? robot + sizeof(kLogged) - 2 : robot);
}

CompareRow::CompareRow(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("imageCompareRow"));
  createControls();
  connectSignals();
  showMode();
}

void CompareRow::createControls() {
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(4, 0, 4, 2);
  row->setSpacing(4);
  mode_ = new QComboBox(this);
  describe(*mode_, {"imageCompareMode", tr("Comparison"), tr("How both images are shown")});
  mode_->addItems({tr("Side by side"), tr("Blend"), tr("Difference")});
  row->addWidget(mode_);
  stream_ = new StreamSelector("foxglove.RawImage", QStringLiteral("*/camera/image"), this);
  describe(*stream_, {"imageCompareStream", tr("Second image"),
                      tr("Images to compare with: another camera, another robot, or the logged ones "
                         "(logged/…) if the program recomputes them")});
  row->addWidget(stream_, 1);
  shift_ = new QDoubleSpinBox(this);
  describe(*shift_, {"imageCompareShift", tr("Time shift"),
                     tr("Time offset of the second image, s: before (-) or after the first one")});
  shift_->setRange(-kMaxShift, kMaxShift);
  shift_->setDecimals(2);
  shift_->setSingleStep(0.1);
  shift_->setSuffix(tr(" s"));
  row->addWidget(shift_);
  hold_ =
      makeToggle(this, "lock",
                 {"imageCompareHold", tr("Hold"),
                  tr("Holds the second image while the first one continues, even across jumps in a log")});
  row->addWidget(makeButton(this, hold_));
  blend_ = makeSlider(
      this, {"imageCompareBlend", tr("Blend"), tr("Left: the first image; right: the second")}, 0, 100, 50);
  gain_ = makeSlider(this,
                     {"imageCompareGain", tr("Amplification"),
                      tr("Gain of the difference; black where both images are the same")},
                     1, kMaxGain, kUsualGain);
  row->addWidget(blend_);
  row->addWidget(gain_);
}

void CompareRow::connectSignals() {
  connect(mode_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this] {
    showMode();
    Q_EMIT changed();
  });
  connect(stream_, &StreamSelector::choiceChanged, this, [this] {
    isChosen_ = true;
    hold_->setChecked(false);
    Q_EMIT changed();
  });
  connect(shift_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, &CompareRow::changed);
  connect(blend_, &QSlider::valueChanged, this, &CompareRow::changed);
  connect(gain_, &QSlider::valueChanged, this, &CompareRow::changed);
  connect(hold_, &QAction::toggled, this, &CompareRow::changed);
}

void CompareRow::showMode() {
  blend_->setVisible(mode() == Mode::kBlend);
  gain_->setVisible(mode() == Mode::kDifference);
}

void CompareRow::propose(const QString& choice) {
  if (isChosen_ || choice == stream_->choice()) return;
  stream_->setChoice(choice);
  isChosen_ = false;
}

void CompareRow::choose(const QString& stream, Mode mode) {
  stream_->setChoice(stream);
  mode_->setCurrentIndex(static_cast<int>(mode));
}

bool CompareRow::update(robotlink::Session& session, robotlink::Instant time) {
  stream_->refresh(session);
  shift_->setEnabled(!isHeld());
  if (isHeld() && image_) return false;
  path_ = stream_->path(session);
  const auto* message = session.store().latest(path_, time + robotlink::fromSeconds(shift_->value()));
  auto image =
      message == nullptr ? nullptr : std::dynamic_pointer_cast<const foxglove::RawImage>(message->value);
  time_ = message == nullptr ? robotlink::Instant() : message->time;
  const bool isOther = image != image_;
  image_ = std::move(image);
  return isOther;
}

CompareRow::Mode CompareRow::mode() const {
  return static_cast<Mode>(std::max(0, mode_->currentIndex()));
}

double CompareRow::share() const {
  return blend_->value() / 100.0;
}

int CompareRow::gain() const {
  return gain_->value();
}

std::string CompareRow::robot() const {
  return drawingRobot(path_);
}

bool CompareRow::isHeld() const {
  return hold_->isChecked();
}

QJsonValue CompareRow::save() const {
  return QJsonObject{{QStringLiteral("stream"), isChosen_ ? stream_->choice() : QString()},
                     {QStringLiteral("mode"), mode_->currentIndex()},
                     {QStringLiteral("shift"), shift_->value()},
                     {QStringLiteral("blend"), blend_->value()},
                     {QStringLiteral("gain"), gain_->value()}};
}

void CompareRow::restore(const QJsonValue& state) {
  const QJsonObject all = state.toObject();
  const QString stream = all[QStringLiteral("stream")].toString();
  if (!stream.isEmpty()) stream_->setChoice(stream);
  mode_->setCurrentIndex(std::clamp(all[QStringLiteral("mode")].toInt(), 0, mode_->count() - 1));
  shift_->setValue(all[QStringLiteral("shift")].toDouble());
  blend_->setValue(all[QStringLiteral("blend")].toInt(50));
  gain_->setValue(all[QStringLiteral("gain")].toInt(kUsualGain));
}

}  // namespace widgets
