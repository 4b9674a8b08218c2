// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/picture/MeasureTool.h"

#include <QAction>
#include <QApplication>
#include <QClipboard>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>

#include "widgets/Controls.h"

namespace widgets {
namespace {

constexpr double kMeasureSlack = 4;  // pixels that a hand moves during a click
constexpr std::size_t kMaxMeasured = 3;

bool isEscape(const QEvent& event) {
  return static_cast<const QKeyEvent&>(event).key() == Qt::Key_Escape;
}

}  // namespace

MeasureTool::MeasureTool(QWidget& view, QWidget& canvas, const char* name, Scale scale)
    : QObject(&view), view_(view), canvas_(canvas), scale_(std::move(scale)) {
  const QByteArray toggleName = QByteArray(name) + "Measure", copyName = QByteArray(name) + "MeasureCopy";
  toggle_ = makeToggle(
      &view, "measure",
      {toggleName.constData(), tr("Measure"),
       tr("Measures distances and angles: click two or three points, or drag. Esc ends it"), Qt::Key_L});
  copy_ = makeAction(&view, "copy",
                     {copyName.constData(), tr("Copy measurement"), tr("Copies what was measured, as text"),
                      QKeySequence(QStringLiteral("Ctrl+Alt+C"))});
  copy_->setEnabled(false);
  createBar(name);
  connect(toggle_, &QAction::toggled, this, [this](bool on) {
    clear();
    bar_->setVisible(on);
    if (on) canvas_.setFocus();
    on ? canvas_.setCursor(Qt::CrossCursor) : canvas_.unsetCursor();
    Q_EMIT toggled(on);
  });
  connect(copy_, &QAction::triggered, this, [this] { QApplication::clipboard()->setText(text_->text()); });
  canvas_.installEventFilter(this);
}

void MeasureTool::createBar(const QByteArray& name) {
  bar_ = new QWidget(&view_);
  bar_->setObjectName(QString::fromLatin1(name + "MeasureBar"));
  auto* row = new QHBoxLayout(bar_);
  row->setContentsMargins(6, 1, 6, 1);
  text_ = new QLabel(bar_);
  text_->setObjectName(QString::fromLatin1(name + "MeasureText"));
  text_->setAccessibleName(tr("Measurement"));
  text_->setTextFormat(Qt::PlainText);
  // There is a single line, so that the picture stays where it is; the tooltip has the rest.
  text_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  text_->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  row->addWidget(text_, 1);
  row->addWidget(makeButton(bar_, copy_), 0, Qt::AlignTop);
  bar_->hide();
}

bool MeasureTool::isOn() const {
  return toggle_->isChecked();
}

void MeasureTool::clear() {
  points_.clear();
  pressed_.reset();
  refresh();
}

void MeasureTool::refresh() {
  canvas_.update();
  if (!isOn()) return;
  copy_->setEnabled(points_.size() > 1);
  text_->setText(points_.empty()
                     ? tr("Click a point of the picture, then another one; a third gives an angle.")
                     : scale_.describe(points_).line);
}

std::vector<QPointF> MeasureTool::shownPoints() const {
  std::vector<QPointF> points = points_;
  if (hover_ && !points.empty() && points.size() < kMaxMeasured) points.push_back(*hover_);
  return points;
}

void MeasureTool::paint(QPainter& painter) const {
  if (!isOn() || points_.empty()) return;
  const std::vector<QPointF> points = shownPoints();
  const QTransform toCanvas = scale_.toCanvas();
  std::vector<QPointF> mapped;
  for (const QPointF& point : points) mapped.push_back(toCanvas.map(point));
  paintMeasurement(painter, mapped, scale_.describe(points), canvas_.size(), canvas_.palette());
}

void MeasureTool::press(const QMouseEvent& event) {
  const auto place = scale_.place(event.localPos());
  if (!place) return;
  if (points_.size() >= kMaxMeasured) points_.clear();
  points_.push_back(*place);
  pressed_ = event.localPos();
  hover_.reset();
  refresh();
}

void MeasureTool::move(const QMouseEvent& event) {
  hover_ = scale_.place(event.localPos());
  canvas_.update();
}

void MeasureTool::release(const QMouseEvent& event) {
  const auto place = scale_.place(event.localPos());
  const bool isDrag = (event.localPos() - *pressed_).manhattanLength() >= kMeasureSlack;
  pressed_.reset();
  if (!isDrag || !place) return refresh();
  // A drag measures from its begin to its end; a later point was only moved.
  if (points_.size() == 1) {
    points_.push_back(*place);
  } else {
    points_.back() = *place;
  }
  hover_.reset();
  refresh();
}

void MeasureTool::escape() {
  points_.empty() ? toggle_->setChecked(false) : clear();
}

bool MeasureTool::eventFilter(QObject* watched, QEvent* event) {
  if (!isOn()) return QObject::eventFilter(watched, event);
  const auto mouse = [event]() -> const QMouseEvent& { return static_cast<const QMouseEvent&>(*event); };
  switch (event->type()) {
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonDblClick:
      if (mouse().button() != Qt::LeftButton) return false;
      press(mouse());
      return true;
    case QEvent::MouseMove:
      move(mouse());
      return pressed_.has_value();
    case QEvent::MouseButtonRelease:
      if (mouse().button() != Qt::LeftButton) return false;
      if (pressed_) release(mouse());
      return true;
    case QEvent::Leave:
      hover_.reset();
      canvas_.update();
      return false;
    case QEvent::ShortcutOverride:
      // Accepted, so that Esc does not trigger another action now.
      if (isEscape(*event)) event->accept();
      return false;
    case QEvent::KeyPress:
      if (!isEscape(*event)) return false;
      escape();
      return true;
    default:
      return false;
  }
}

}  // namespace widgets
