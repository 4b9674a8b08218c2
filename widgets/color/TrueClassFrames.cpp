// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/TrueClassFrames.h"

#include "foxglove/Image.pb.h"
#include "robotlink/packages/Conversions.h"
#include "robotlink/packages/Packages.h"
#include "widgets/Requests.h"
#include "widgets/color/ColorBench.h"
#include "widgets/image/ImageClasses.h"

namespace widgets {
namespace {

constexpr std::chrono::seconds kInterval(1);

}  // namespace

TrueClassFrames::TrueClassFrames(ColorBench& bench, QObject* parent) : QObject(parent), bench_(bench) {}

void TrueClassFrames::ask(const std::string& robot, bool on) {
  robotcontrol::Request request;
  request.mutable_set_key()->set_name("package/" + std::string(robotlink::kOracleClasses.name));
  request.mutable_set_key()->mutable_mode()->set_kind(on ? robotcontrol::KeyMode::ALWAYS
                                                         : robotcontrol::KeyMode::OFF);
  widgets::ask(bench_.session(), robot, std::move(request), this,
               [this](bool accepted, const QString& reason) {
                 if (!accepted && on_)
                   Q_EMIT bench_.failed(tr("The true classes are not published: %1").arg(reason));
               });
}

void TrueClassFrames::setOn(bool on) {
  if (on == on_) return;
  on_ = on;
  if (!on) {
    if (!asked_.empty()) ask(asked_, false);
    asked_.clear();
    frames_.clear();
    bench_.setLabeled({});
  }
  tick();
}

void TrueClassFrames::tick() {
  const std::string& robot = bench_.session().selectedRobot();
  if (!on_ || robot.empty()) return;
  if (asked_ != robot) {
    if (!asked_.empty()) ask(asked_, false);
    frames_.clear();
    last_ = {};
    asked_ = robot;
    ask(robot, true);
  }
  auto& store = bench_.session().store();
  const robotlink::Instant shown = bench_.session().timeline().shown();
  const std::string path = robot + "/" + robotlink::kOracleClasses.name;
  const auto* classes = store.latest(path, shown);
  if (classes == nullptr) return;
  const auto past = classes->time - last_;
  if (!frames_.empty() && past >= -kInterval && past < kInterval) return;
  const auto* camera = store.latest(robot + "/" + robotlink::kCameraImage.name, classes->time);
  const auto labels = std::dynamic_pointer_cast<const foxglove::RawImage>(classes->value);
  auto image =
      camera == nullptr ? nullptr : std::dynamic_pointer_cast<const foxglove::RawImage>(camera->value);
  // Both messages have the timestamp of the image.
  if (!labels || !image || robotlink::instant(labels->timestamp()) != robotlink::instant(image->timestamp()))
    return;
  const robotlink::ImageView view = robotlink::imageView(*labels);
  if (view.empty() || view.width != static_cast<int>(image->width()) ||
      view.height != static_cast<int>(image->height()))
    return;
  LabeledFrame frame{std::make_shared<ColorFrame>(image, camera->path, "", camera->time), {}, {}};
  for (int y = 0; y < view.height; ++y)
    frame.labels.insert(frame.labels.end(), view.row(y), view.row(y) + view.width);
  frame.classNames = classNames(store, path, *labels, classes->time);
  last_ = classes->time;
  frames_.push_back(std::move(frame));
  if (frames_.size() > kMax) frames_.pop_front();
  bench_.setLabeled({frames_.begin(), frames_.end()});
}

}  // namespace widgets
