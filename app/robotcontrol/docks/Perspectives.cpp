// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/docks/Perspectives.h"

#include <qtadvanceddocking/DockAreaWidget.h>
#include <qtadvanceddocking/DockManager.h>
#include <qtadvanceddocking/DockWidget.h>
#include <QJsonDocument>
#include <QSplitter>
#include <algorithm>
#include <iterator>
#include <map>
#include <string_view>
#include <vector>

#include "app/core/platform/PlatformFeed.h"
#include "app/robotcontrol/docks/ViewDocks.h"
#include "robotlink/base/AtomicFile.h"
#include "robotlink/config/RobotDescription.h"

namespace app {
namespace {

using Place = ViewDocks::Place;
constexpr int kVersion = 1;
constexpr int kMaxPerspectives = 200;         // people keep five or ten
constexpr std::size_t kMaxFile = 16U << 20U;  // bytes

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

/// A dock of a shipped perspective. If it shares its area with other tabs, it is the one in front.
struct ShippedDock {
  /// The type of its view.
  const char* view;
  Place place;
  /// The view next to which the dock is placed; empty: the whole window.
  const char* beside = "";
  /// The sizes in the splitter that contains it; empty: as they come.
  QList<int> sizes = {};
  /// The widths of the columns of the whole window, given at one dock only.
  QList<int> columns = {};
};

struct Shipped {
  const char* name;
  std::vector<ShippedDock> docks;
};

const std::vector<Shipped>& allShipped() {
  using enum ViewDocks::Place;
  static const std::vector<Shipped> kAll{
      {"Play",
       {{"scene", kLeft, "", {680, 280}, {340, 760, 500}},
        {"debug-keys", kLeft, "", {520, 440}},
        {"image", kRight, "", {430, 530}},
        {"solutions", kBottom, "debug-keys"},
        {"field", kBottom, "image"},
        {"messages", kBottom, "scene"},
        {"plots", kTab, "messages"},
        {"timing", kTab, "messages"},
        {"processes", kTab, "messages"},
        {"motion", kTab, "field"}}},
      {"Log",
       {{"image", kLeft, "", {520, 680, 400}},
        {"replay-packages", kRight, "", {400, 220}},
        {"solutions", kRight, "", {330, 290}},
        {"log-streams", kTab, "replay-packages"},
        {"bookmarks", kTab, "replay-packages"},
        {"messages", kBottom, "replay-packages"},
        {"field", kBottom, "solutions"},
        {"time-line", kBottom, "", {560, 380}}}},
      {"Colour",
       {{"color-image", kLeft, "", {}, {1180, 420}},
        {"color-classes", kRight},
        {"color-space", kBottom, "color-classes", {500, 460}},
        {"color-samples", kBottom, "color-image", {640, 540}},
        {"color-compare", kTab, "color-samples"},
        {"color-frames", kTab, "color-samples"},
        {"messages", kTab, "color-samples"},
        {"time-line", kBottom, "color-samples", {620, 230, 110}},
        // The quality of the table is always visible.
        {"color-quality", kRight, "color-samples"}}},
      {"Motion",
       {{"scene", kLeft},
        {"motion", kRight, "", {640, 360}, {820, 780}},
        {"plots", kBottom, "scene"},
        {"joints", kTab, "plots"},
        {"field", kBottom, "motion"},
        {"motion-editor", kTab, "field"}}},
      {"Processes",
       {{"processes", kLeft, "", {}, {950, 650}},
        {"timing", kBottom, "processes"},
        {"solutions", kRight, "", {600, 360}},
        {"messages", kBottom, "solutions"}}},
      // For robots on wheels: map, surroundings, state, and manual control.
      {"Drive",
       {{"field", kLeft, "", {680, 280}, {740, 460, 400}},
        {"radar", kRight, "", {580, 380}},
        {"base-state", kRight, "", {600, 360}},
        {"messages", kBottom, "field"},
        {"plots", kTab, "messages"},
        {"packets", kTab, "messages"},
        {"processes", kTab, "messages"},
        {"motion", kBottom, "radar"},
        {"solutions", kBottom, "base-state"},
        {"debug-keys", kTab, "solutions"}}}};
  return kAll;
}

void build(const Shipped& perspective, ViewDocks& docks) {
  std::map<std::string_view, ads::CDockWidget*> made;
  for (const ShippedDock& dock : perspective.docks)
    made[dock.view] = docks.add(QLatin1String(dock.view), dock.place, made[dock.beside]);
  for (const ShippedDock& dock : perspective.docks) {
    ads::CDockWidget* front = dock.place == Place::kTab ? made[dock.beside] : nullptr;
    if (front != nullptr) front->setAsCurrentTab();
  }
  for (const ShippedDock& dock : perspective.docks)
    if (!dock.sizes.isEmpty()) setSizes(made[dock.view], dock.sizes);
  for (const ShippedDock& dock : perspective.docks)
    if (!dock.columns.isEmpty()) setColumns(made[dock.view], dock.columns);
}

tl::unexpected<robotlink::Error> fileFailure(std::string text, const std::filesystem::path& file) {
  return tl::unexpected(robotlink::Error{"window.perspective", std::move(text), {}, {file.string(), 0, 0}});
}

const Shipped* shipped(const QString& name) {
  const auto found = std::ranges::find_if(
      allShipped(), [&](const Shipped& candidate) { return name == QLatin1String(candidate.name); });
  return found == allShipped().end() ? nullptr : &*found;
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
  const auto text = robotlink::readFile(file_, kMaxFile);
  QJsonParseError problem{};
  const QJsonObject root =
      text ? QJsonDocument::fromJson(QByteArray::fromStdString(*text), &problem).object() : QJsonObject{};
  const int version = root.value(QStringLiteral("version")).toInt();
  if (version != kVersion) {
    std::filesystem::path aside = file_;
    aside += ".broken";
    std::filesystem::rename(file_, aside, error);
    problems_.push_back({"window.file",
                         "the saved window layout cannot be used (" +
                             (text ? version > kVersion ? "it was written by a newer version"
                                                        : problem.errorString().toStdString()
                                   : text.error().text) +
                             "); it was kept as " + aside.filename().string() +
                             ", and the shipped one is shown",
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
  chosen_ = root.value(QStringLiteral("chosen")).toArray();
  scenes_ = root.value(QStringLiteral("scenes")).toArray();
  while (scenes_.size() > kMaxScenes) scenes_.removeFirst();
  const QString current = root.value(QStringLiteral("current")).toString();
  if (names().contains(current)) current_ = current;
}

QStringList Perspectives::names() const {
  QStringList names;
  for (const Shipped& perspective : allShipped()) names.append(QLatin1String(perspective.name));
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
    restored_ = kept_.value(name).toObject();
    return;
  }
  showShipped(name, docks);
}

void Perspectives::showShipped(const QString& name, ViewDocks& docks) {
  const Shipped* perspective = shipped(name);
  if (perspective == nullptr) perspective = &allShipped().front();
  docks.closeAll();
  build(*perspective, docks);
  current_ = QLatin1String(perspective->name);
  restored_ = {};
  kept_.remove(current_);
}

void Perspectives::keep(const QString& name, const ViewDocks& docks) {
  kept_.insert(name, docks.save());
  current_ = name;
}

void Perspectives::remove(const QString& name) {
  kept_.remove(name);
}

robotlink::Result<void> Perspectives::write(const QString& name, const std::filesystem::path& file) const {
  if (!kept_.contains(name)) return fileFailure("there is no perspective " + name.toStdString(), file);
  const QJsonObject root{{QStringLiteral("version"), kVersion},
                         {QStringLiteral("perspective"), name},
                         {QStringLiteral("docks"), kept_.value(name)}};
  const QByteArray text = QJsonDocument(root).toJson();
  return robotlink::writeFileAtomically(
      file, std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
}

robotlink::Result<QString> Perspectives::read(const std::filesystem::path& file) {
  const auto text = robotlink::readFile(file, kMaxFile);
  if (!text) return tl::unexpected(text.error());
  QJsonParseError problem{};
  const QJsonObject root = QJsonDocument::fromJson(QByteArray::fromStdString(*text), &problem).object();
  const QString wanted = root.value(QStringLiteral("perspective")).toString().trimmed();
  const int version = root.value(QStringLiteral("version")).toInt();
  if (problem.error != QJsonParseError::NoError)
    return fileFailure("it is no perspective: " + problem.errorString().toStdString() + " at byte " +
                           std::to_string(problem.offset),
                       file);
  if (version > kVersion) return fileFailure("it was written by a newer version of RobotControl", file);
  const QJsonValue docks = root.value(QStringLiteral("docks"));
  if (version < 1 || wanted.isEmpty() || !docks.isObject())
    return fileFailure("it is no perspective; Window > Export perspective writes one", file);
  if (kept_.size() >= kMaxPerspectives)
    return fileFailure("there are " + std::to_string(kept_.size()) + " perspectives; delete one first", file);
  QString name = wanted;
  for (int number = 2; names().contains(name); ++number)
    name = wanted + QStringLiteral(" ") + QString::number(number);
  kept_.insert(name, docks);
  return name;
}

QString Perspectives::chosenFor(const std::string& source) const {
  const QString wanted = QString::fromStdString(source);
  for (const QJsonValue& pair : chosen_) {
    const QString name = pair.toArray().at(1).toString();
    if (pair.toArray().at(0).toString() == wanted) return names().contains(name) ? name : QString();
  }
  return {};
}

void Perspectives::chooseFor(const std::string& source) {
  const QString wanted = QString::fromStdString(source);
  for (int i = chosen_.size() - 1; i >= 0; --i) {
    if (chosen_.at(i).toArray().at(0).toString() == wanted) chosen_.removeAt(i);
  }
  chosen_.append(QJsonArray{wanted, current_});
  while (chosen_.size() > kMaxSources) chosen_.removeFirst();
}

void Perspectives::keepFor(const std::string& scene, const ViewDocks& docks) {
  const QString kept = QString::fromStdString(scene);
  for (int i = scenes_.size() - 1; i >= 0; --i)
    if (scenes_.at(i).toArray().at(0).toString() == kept) scenes_.removeAt(i);
  scenes_.append(QJsonArray{kept, current_, docks.save()});
  restored_ = {};
  while (scenes_.size() > kMaxScenes) scenes_.removeFirst();
}

bool Perspectives::showFor(const std::string& scene, ViewDocks& docks) {
  const QString wanted = QString::fromStdString(scene);
  for (const QJsonValue& value : scenes_) {
    const QJsonArray kept = value.toArray();
    if (kept.at(0).toString() != wanted) continue;
    const QString name = kept.at(1).toString();
    if (!names().contains(name) || !docks.restore(kept.at(2).toObject())) return false;
    current_ = name;
    restored_ = {};
    return true;
  }
  return false;
}

bool Perspectives::hasRestoredFor(const std::string& scene) const {
  const QString wanted = QString::fromStdString(scene);
  return !restored_.isEmpty() && std::ranges::any_of(scenes_, [&](const QJsonValue& value) {
    return value.toArray() == QJsonArray{wanted, current_, restored_};
  });
}

robotlink::Result<void> Perspectives::save() {
  const QJsonObject root{{QStringLiteral("version"), kVersion},   {QStringLiteral("current"), current_},
                         {QStringLiteral("perspectives"), kept_}, {QStringLiteral("chosen"), chosen_},
                         {QStringLiteral("scenes"), scenes_},     {QStringLiteral("window"), window_}};
  const QByteArray text = QJsonDocument(root).toJson();
  if (text == saved_) return {};
  auto written = robotlink::writeFileAtomically(
      file_, std::string_view(text.constData(), static_cast<std::size_t>(text.size())));
  if (written) saved_ = text;
  return written;
}

}  // namespace app
