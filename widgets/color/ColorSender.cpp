// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorSender.h"

#include <QPointer>
#include <chrono>

#include "robotcontrol/Debugging.pb.h"
#include "robotcontrol/Perception.pb.h"
#include "robotcontrol/Requests.pb.h"
#include "robotlink/packages/Checksum.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/session/Session.h"
#include "widgets/color/ColorBench.h"

namespace widgets {
namespace {

constexpr std::chrono::seconds kPatience(5);

void assignCorrection(robotcontrol::ColorCorrection& to, const colortool::ColorCorrection& from) {
  const colortool::Vignetting& lens = from.vignetting;
  to.set_luma_r2(lens.luma[0]);
  to.set_luma_r4(lens.luma[1]);
  to.set_blue_r2(lens.blue[0]);
  to.set_blue_r4(lens.blue[1]);
  to.set_red_r2(lens.red[0]);
  to.set_red_r4(lens.red[1]);
  const auto line = [](robotcontrol::ColorCorrection::ChannelLine& channel,
                       const colortool::ChannelLine& value) {
    channel.set_gain(value.gain);
    channel.set_offset(value.offset);
  };
  line(*to.mutable_y(), from.channels[0]);
  line(*to.mutable_cb(), from.channels[1]);
  line(*to.mutable_cr(), from.channels[2]);
}

QString hex(std::uint64_t checksum) {
  return QStringLiteral("%1").arg(checksum, 16, 16, QLatin1Char('0')).left(8);
}

}  // namespace

ColorSender::ColorSender(ColorBench& bench) : QObject(&bench), bench_(bench) {
  patience_.setSingleShot(true);
  connect(&patience_, &QTimer::timeout, this, [this] {
    ++asked_;  // later replies are ignored
    report(State::kFailed,
           tr("%1 does not answer; is its program running?").arg(QString::fromStdString(robot_)));
  });
  connect(&bench_, &ColorBench::colorsChanged, this, &ColorSender::sendNew);
}

void ColorSender::setAutoSend(bool on) {
  if (on == autoSend_) return;
  autoSend_ = on;
  Q_EMIT changed();
  sendNew();
}

void ColorSender::sendNew() {
  const LearnedColors* colors = bench_.colors();
  if (autoSend_ && colors != nullptr && colors->table != sent_) send();
}

void ColorSender::tick() {
  if (state_ != State::kFailed) return;
  const LearnedColors* colors = bench_.colors();
  const bool sameTable = colors == nullptr || colors->table == sent_ || sent_ == nullptr;
  if (sameTable && bench_.session().selectedRobot() == robot_) return;
  report(State::kIdle, {});
}

void ColorSender::send() {
  const LearnedColors* colors = bench_.colors();
  if (colors == nullptr) return;
  if (state_ == State::kSending) {
    again_ = true;
    return;
  }
  robotlink::Session& session = bench_.session();
  robot_ = session.selectedRobot();
  if (robot_.empty()) return report(State::kFailed, tr("There is no robot to send it to"));
  sent_ = colors->table;
  robotcontrol::Request request;
  request.set_robot(robot_);
  robotcontrol::ColorTable& table = *request.mutable_set_color_table()->mutable_table();
  const auto& classes = colors->samples.classes;
  for (int i = 1; i < classes.size(); ++i) table.add_class_names(classes.name(i));
  const auto cells = colors->table->cells();
  table.set_cells(cells.data(), cells.size());
  // Samples identify cameras by their robots' names.
  const colortool::ColorCorrection correction = colors->samples.correctionOf(robot_);
  if (!correction.none()) assignCorrection(*table.mutable_correction(), correction);
  describeSource(table);
  expected_ = robotlink::checksum(table);
  report(State::kSending, tr("Sending it to %1…").arg(QString::fromStdString(robot_)));
  patience_.start(kPatience);
  session.request(std::move(request), [guard = QPointer<ColorSender>(this),
                                       number = ++asked_](const robotcontrol::RequestResult& result) {
    if (guard && guard->asked_ == number) guard->take(result);
  });
}

/// Describes the table for users who look later at what the robot uses.
void ColorSender::describeSource(robotcontrol::ColorTable& table) const {
  const bool saved = !bench_.file().empty() && bench_.undoStack().isClean();
  table.set_source(saved ? bench_.file() : tr("painted, not saved").toStdString());
  robotlink::assign(*table.mutable_loaded(),
                    robotlink::Instant(std::chrono::system_clock::now().time_since_epoch()));
}

void ColorSender::take(const robotcontrol::RequestResult& result) {
  patience_.stop();
  const QString robot = QString::fromStdString(robot_);
  if (!result.accepted())
    report(State::kFailed, tr("%1 refuses it: %2").arg(robot, QString::fromStdString(result.reason())));
  else if (result.checksum() != expected_)
    report(State::kFailed, tr("%1 received something else (%2 instead of %3); send it again")
                               .arg(robot, hex(result.checksum()), hex(expected_)));
  else
    report(State::kConfirmed, tr("%1 uses it (%2)").arg(robot, hex(expected_)));
  if (std::exchange(again_, false)) send();
  sendNew();
}

void ColorSender::report(State state, const QString& text) {
  state_ = state;
  text_ = text;
  Q_EMIT changed();
}

ColorSender& colorSender(ColorBench& bench) {
  auto* sender = bench.findChild<ColorSender*>(QString(), Qt::FindDirectChildrenOnly);
  return sender != nullptr ? *sender : *new ColorSender(bench);
}

}  // namespace widgets
