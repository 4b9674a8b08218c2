// SPDX-License-Identifier: GPL-3.0-or-later
// What is marked in the timeline (texts, and what a search found), and steps to where a value changes.
#include <QAction>
#include <QComboBox>
#include <QJsonArray>
#include <QLineEdit>
#include <algorithm>
#include <cmath>

#include "widgets/Controls.h"
#include "widgets/log/TimeMarks.h"
#include "widgets/timeline/TimeLineCanvas.h"
#include "widgets/timeline/TimeLineView.h"

namespace widgets {

using robotlink::Duration;
using robotlink::Instant;

namespace {

constexpr double kMarkGrip = 4;  // the distance in pixels from a mark at which it is still meant
constexpr int kMaxStepValues = 20;

}  // namespace

void TimeLineCanvas::setMarks(std::vector<TimeMark> texts, std::vector<TimeMark> hits) {
  look_.texts = std::make_shared<const std::vector<TimeMark>>(std::move(texts));
  look_.hits = std::make_shared<const std::vector<TimeMark>>(std::move(hits));
  lookAnew();
}

std::vector<TimeMark> TimeLineCanvas::marksNear(double x) const {
  const auto reach = Duration(std::llround(kMarkGrip * look_.scale.nsPerPixel));
  const Instant time = look_.scale.time(x);
  std::vector<TimeMark> found;
  for (const auto& marks : {look_.hits, look_.texts}) {
    if (!marks) continue;
    for (auto at = std::ranges::lower_bound(*marks, time - reach, {}, &TimeMark::from);
         at != marks->end() && at->from <= time + reach; ++at)
      found.push_back(*at);
  }
  return found;
}

Instant TimeLineCanvas::rulerTimeAt(const QPointF& point) const {
  const auto marks = marksNear(point.x());
  if (marks.empty()) return timeAt(point);
  const Instant time = timeAt(point);
  return std::ranges::min_element(marks, {},
                                  [time](const TimeMark& mark) { return std::chrono::abs(mark.from - time); })
      ->from;
}

QString TimeLineCanvas::markToolTip(double x) const {
  constexpr std::size_t kMost = 8;
  QStringList lines;
  for (const TimeMark& mark : marksNear(x)) {
    if (lines.size() == kMost) {
      lines << tr("…");
      break;
    }
    lines << tr("<b>%1 s</b> %2").arg(timeText(mark.from - look_.origin), mark.text.toHtmlEscaped());
  }
  return lines.join(QStringLiteral("<br>"));
}

void TimeLineView::createSteps() {
  stepBy_ = new QComboBox(this);
  describe(*stepBy_,
           {"timeLineStepBy", tr("Value whose changes are stepped through"),
            tr("A value or expression, such as models/ball.position.x > 1; Enter goes to its next change")});
  stepBy_->setEditable(true);
  stepBy_->setInsertPolicy(QComboBox::NoInsert);
  stepBy_->setMinimumContentsLength(18);
  stepBy_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
  stepBy_->lineEdit()->setPlaceholderText(tr("Step by changes of…"));
  stepBy_->lineEdit()->setObjectName(QStringLiteral("timeLineStepByText"));
  changeBack_ = makeAction(this, "previous",
                           {"timeLineChangeBack", tr("Previous change"),
                            tr("Shows when that value changed before"), tr("Ctrl+,")});
  changeOn_ = makeAction(
      this, "next",
      {"timeLineChangeOn", tr("Next change"), tr("Shows when that value changes next"), tr("Ctrl+.")});
  connect(changeBack_, &QAction::triggered, this, [this] { stepChange("previous"); });
  connect(changeOn_, &QAction::triggered, this, [this] { stepChange("next"); });
  connect(stepBy_->lineEdit(), &QLineEdit::returnPressed, this, [this] { stepChange("next"); });
  keep(
      "stepBy", [this] { return QJsonValue(stepBy_->currentText()); },
      [this](const QJsonValue& value) { stepBy_->setCurrentText(value.toString()); }, Names::kObjects);
}

void TimeLineView::stepChange(const char* direction) {
  const QString value = stepBy_->currentText().trimmed();
  if (value.isEmpty()) return stepBy_->setFocus();
  if (stepBy_->findText(value) < 0) {
    stepBy_->insertItem(0, value);
    if (stepBy_->count() > kMaxStepValues) stepBy_->removeItem(kMaxStepValues);
    stepBy_->setCurrentIndex(0);
  }
  run("timeline.step-change", {value.toStdString(), std::string(direction)});
}

void TimeLineView::showMarks() {
  TimeMarks& marks = TimeMarks::of(logs_);
  marks.tick(session());
  if (marksVersion_ == marks.version()) return;
  marksVersion_ = marks.version();
  canvas_->setMarks(marks.texts(), marks.hits());
}

}  // namespace widgets
