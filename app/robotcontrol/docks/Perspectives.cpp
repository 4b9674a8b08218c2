// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/Perspectives.h"

#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>
#include <QJsonDocument>
#include <QSplitter>
#include <algorithm>
#include <iterator>

#include "app/core/platform/PlatformFeed.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/RobotDescription.h"

namespace app {
namespace {

using Place = ViewDocks::Place;
constexpr int kVersion = 1;
constexpr int kMaxPerspectives = 200;  // people keep five or ten

/// Sets the sizes in the splitter that contains a dock, from the left or the top.
void setSizes(ads::CDockWidget* dock, const QList<int>& sizes) {
  if (dock == nullptr || dock->dockAreaWidget() == nullptr) return;
  dock->dockManager()->setSplitterSizes(dock->dockAreaWidget(), sizes);
}

/// Sets the widths of the columns of the whole window, from the left.
void setColumns(ads::CDockWidget* dock, const QList<int>& sizes) {
  if (dock == nullptr) return;
  QSplitter* outermost = nullptr;
  for (QWidget* parent = dock->dockAreaWidget(); parent != nullptr && parent != dock->dockManager();
       parent = parent->parentWidget()) {
    if (auto* splitter = qobject_cast<QSplitter*>(parent)) outermost = splitter;
  }
  if (outermost != nullptr) outermost->setSizes(sizes);
}

void buildPlay(ViewDocks& docks) {
  ads::CDockWidget* scene = docks.add(QStringLiteral("scene"), Place::kLeft);
  ads::CDockWidget* keys = docks.add(QStringLiteral("debug-keys"), Place::kLeft);
  ads::CDockWidget* image = docks.add(QStringLiteral("image"), Place::kRight);
  docks.add(QStringLiteral("solutions"), Place::kBottom, keys);
  ads::CDockWidget* field = docks.add(QStringLiteral("field"), Place::kBottom, image);
  ads::CDockWidget* messages = docks.add(QStringLiteral("messages"), Place::kBottom, scene);
  for (const char* id : {"plots", "timing", "processes"}) docks.add(QLatin1String(id), Place::kTab, messages);
  docks.add(QStringLiteral("motion"), Place::kTab, field);
  for (ads::CDockWidget* front : {messages, field}) {
    if (front != nullptr) front->setAsCurrentTab();
  }
  setSizes(scene, {680, 280});
  setSizes(keys, {520, 440});
  setSizes(image, {430, 530});
  setColumns(scene, {340, 760, 500});
}

void buildMotion(ViewDocks& docks) {
  ads::CDockWidget* scene = docks.add(QStringLiteral("scene"), Place::kLeft);
  ads::CDockWidget* motion = docks.add(QStringLiteral("motion"), Place::kRight);
  ads::CDockWidget* plots = docks.add(QStringLiteral("plots"), Place::kBottom, scene);
  ads::CDockWidget* field = docks.add(QStringLiteral("field"), Place::kBottom, motion);
  docks.add(QStringLiteral("joints"), Place::kTab, plots);
  docks.add(QStringLiteral("motion-editor"), Place::kTab, field);
  for (ads::CDockWidget* front : {plots, field}) {
    if (front != nullptr) front->setAsCurrentTab();
  }
  setSizes(motion, {640, 360});
  setColumns(motion, {820, 780});
}

void buildLog(ViewDocks& docks) {
  ads::CDockWidget* image = docks.add(QStringLiteral("image"), Place::kLeft);
  ads::CDockWidget* packages = docks.add(QStringLiteral("replay-packages"), Place::kRight);
  ads::CDockWidget* solutions = docks.add(QStringLiteral("solutions"), Place::kRight);
  for (const char* id : {"log-streams", "bookmarks"}) docks.add(QLatin1String(id), Place::kTab, packages);
  docks.add(QStringLiteral("messages"), Place::kBottom, packages);
  docks.add(QStringLiteral("field"), Place::kBottom, solutions);
  ads::CDockWidget* timeLine = docks.add(QStringLiteral("time-line"), Place::kBottom);
  if (packages != nullptr) packages->setAsCurrentTab();
  setSizes(packages, {400, 220});
  setSizes(solutions, {330, 290});
  setSizes(image, {520, 680, 400});
  setSizes(timeLine, {560, 380});
}

void buildColor(ViewDocks& docks) {
  ads::CDockWidget* image = docks.add(QStringLiteral("color-image"), Place::kLeft);
  ads::CDockWidget* classes = docks.add(QStringLiteral("color-classes"), Place::kRight);
  ads::CDockWidget* space = docks.add(QStringLiteral("color-space"), Place::kBottom, classes);
  ads::CDockWidget* samples = docks.add(QStringLiteral("color-samples"), Place::kBottom, image);
  for (const char* id : {"color-compare", "color-frames", "messages"})
    docks.add(QLatin1String(id), Place::kTab, samples);
  ads::CDockWidget* timeLine = docks.add(QStringLiteral("time-line"), Place::kBottom, samples);
  // The quality of the table is always visible.
  docks.add(QStringLiteral("color-quality"), Place::kRight, samples);
  if (samples != nullptr) samples->setAsCurrentTab();
  setSizes(samples, {640, 540});
  setSizes(space, {500, 460});
  setSizes(timeLine, {620, 230, 110});
  setColumns(image, {1180, 420});
}

/// For robots on wheels: map, surroundings, state, and manual control.
void buildDrive(ViewDocks& docks) {
  ads::CDockWidget* map = docks.add(QStringLiteral("field"), Place::kLeft);
  ads::CDockWidget* radar = docks.add(QStringLiteral("radar"), Place::kRight);
  ads::CDockWidget* state = docks.add(QStringLiteral("base-state"), Place::kRight);
  ads::CDockWidget* messages = docks.add(QStringLiteral("messages"), Place::kBottom, map);
  for (const char* id : {"plots", "packets", "processes"})
    docks.add(QLatin1String(id), Place::kTab, messages);
  docks.add(QStringLiteral("motion"), Place::kBottom, radar);
  ads::CDockWidget* solutions = docks.add(QStringLiteral("solutions"), Place::kBottom, state);
  docks.add(QStringLiteral("debug-keys"), Place::kTab, solutions);
  for (ads::CDockWidget* front : {messages, solutions}) {
    if (front != nullptr) front->setAsCurrentTab();
  }
  setSizes(map, {680, 280});
  setSizes(radar, {580, 380});
  setSizes(state, {600, 360});
  setColumns(map, {740, 460, 400});
}

void buildProcesses(ViewDocks& docks) {
  ads::CDockWidget* processes = docks.add(QStringLiteral("processes"), Place::kLeft);
  docks.add(QStringLiteral("timing"), Place::kBottom, processes);
  ads::CDockWidget* solutions = docks.add(QStringLiteral("solutions"), Place::kRight);
  docks.add(QStringLiteral("messages"), Place::kBottom, solutions);
  setSizes(solutions, {600, 360});
  setColumns(processes, {950, 650});
}

struct Shipped {
  const char* name;
  void (*build)(ViewDocks&);
};
constexpr Shipped kShipped[] = {{"Play", buildPlay},           {"Log", buildLog},
                                {"Colour", buildColor},        {"Motion", buildMotion},
                                {"Processes", buildProcesses}, {"Drive", buildDrive}};

const Shipped* shipped(const QString& name) {
  for (const Shipped& candidate : kShipped) {
    if (name == QLatin1String(candidate.name)) return &candidate;
  }
  return nullptr;
}

}  // namespace

Perspectives::Perspectives(std::filesystem::path file)
    : file_(std::move(file)), current_(QStringLiteral("Play")) {
  load();
}

QString Perspectives::beginningWith(const LoadedPlatform& loaded) {
  if (loaded.isLogged()) return QStringLiteral("Log");
  if (loaded.robots.empty()) return {};
  const bool wheels = std::all_of(loaded.robots.begin(), loaded.robots.end(),
                                  [](const auto& robot) { return robot.second && robot.second->drive; });
  return wheels ? QStringLiteral("Drive") : QStringLiteral("Play");
}

void Perspectives::load() {
  std::error_code error;
  if (!std::filesystem::exists(file_, error)) return;
  const auto text = robotlink::readFile(file_, 16U << 20U);
  QJsonParseError problem{};
  const QJsonObject root =
      text ? QJsonDocument::fromJson(QByteArray::fromStdString(*text), &problem).object() : QJsonObject{};
  const int version = root.value(QStringLiteral("version")).toInt();
  if (version != kVersion) {
    std::filesystem::path aside = file_;
    aside += ".broken";
    std::filesystem::rename(file_, aside, error);
    problems_.push_back(
        {"window.file",
         "the saved window layout cannot be used (" +
             (text ? version > kVersion ? "it is of a newer version" : problem.errorString().toStdString()
                   : text.error().text) +
             "); it was kept as " + aside.filename().string() + ", and the shipped one is shown",
         {},
         {file_.string(), 0, 0}});
    return;
  }
  kept_ = root.value(QStringLiteral("perspectives")).toObject();
  if (const int all = kept_.size(); all > kMaxPerspectives) {
    while (kept_.size() > kMaxPerspectives) kept_.erase(std::prev(kept_.end()));
    problems_.push_back({"window.file",
                         "the saved window layout has " + std::to_string(all) +
                             " perspectives; only the first " + std::to_string(kMaxPerspectives) +
                             " were loaded",
                         {},
                         {file_.string(), 0, 0}});
  }
  window_ = root.value(QStringLiteral("window")).toObject();
  const QString current = root.value(QStringLiteral("current")).toString();
  if (names().contains(current)) current_ = current;
}

QStringList Perspectives::names() const {
  QStringList names;
  for (const Shipped& perspective : kShipped) names.append(QLatin1String(perspective.name));
  for (const QString& name : kept_.keys()) {
    if (!names.contains(name)) names.append(name);
  }
  return names;
}

bool Perspectives::isShipped(const QString& name) const {
  return shipped(name) != nullptr;
}

void Perspectives::show(const QString& name, ViewDocks& docks) {
  if (kept_.contains(name) && docks.restore(kept_.value(name).toObject())) {
    current_ = name;
    return;
  }
  showShipped(name, docks);
}

void Perspectives::showShipped(const QString& name, ViewDocks& docks) {
  const Shipped* perspective = shipped(name);
  if (perspective == nullptr) perspective = &kShipped[0];
  docks.closeAll();
  perspective->build(docks);
  current_ = QLatin1String(perspective->name);
  kept_.remove(current_);
}

void Perspectives::keep(const QString& name, const ViewDocks& docks) {
  kept_.insert(name, docks.save());
  current_ = name;
}

void Perspectives::remove(const QString& name) {
  kept_.remove(name);
}

robotlink::Result<void> Perspectives::save() {
  const QJsonObject root{{QStringLiteral("version"), kVersion},
                         {QStringLiteral("current"), current_},
                         {QStringLiteral("perspectives"), kept_},
                         {QStringLiteral("window"), window_}};
  const QByteArray text = QJsonDocument(root).toJson();
  if (text == saved_) return {};
  auto written = robotlink::writeFileAtomically(
      file_, std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
  if (written) saved_ = text;
  return written;
}

}  // namespace app
