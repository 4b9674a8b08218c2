// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/ScenePalette.h"

#include <QMimeData>

#include "widgets/View.h"
#include "widgets/sceneedit/SceneBench.h"
#include "widgets/sceneedit/SceneLanguage.h"

namespace widgets {
namespace {

constexpr char kPaletteType[] = "application/x-robotcontrol-scene-object";

}  // namespace

std::vector<ScenePalette::Entry> ScenePalette::entries(const SceneBench& bench) {
  std::vector<Entry> all{
      {QStringLiteral("box"), tr("Box")},           {QStringLiteral("ball"), tr("Ball")},
      {QStringLiteral("cylinder"), tr("Cylinder")}, {QStringLiteral("wall"), tr("Wall")},
      {QStringLiteral("lamp"), tr("Lamp")},         {QStringLiteral("camera"), tr("Camera")}};
  const auto file = bench.runningScene();
  if (bench.context().sceneLanguage == nullptr || file.empty()) return all;
  for (const SceneModelChoice& model : bench.context().sceneLanguage->models(file)) {
    const QString name = QString::fromStdString(model.name);
    const bool isTaken =
        std::any_of(all.begin(), all.end(), [&](const Entry& one) { return one.kind == name; });
    if (!isTaken) all.push_back({name, model.isRobot ? tr("%1 (robot)").arg(name) : name});
  }
  return all;
}

QString ScenePalette::kindIn(const QMimeData& data) {
  return QString::fromUtf8(data.data(QLatin1String(kPaletteType))).left(200);
}

ScenePalette::ScenePalette(QWidget* parent) : QListWidget(parent) {
  setObjectName(QStringLiteral("scenePalette"));
  setWindowFlag(Qt::Tool);
  setWindowTitle(tr("Add objects"));
  setToolTip(tr("Drag an object to its place in the scene, or double click it"));
  setDragEnabled(true);
  setDragDropMode(QAbstractItemView::DragOnly);
  resize(200, 320);
  connect(this, &QListWidget::itemActivated, this,
          [this](const QListWidgetItem* item) { Q_EMIT chosen(item->data(Qt::UserRole).toString()); });
}

void ScenePalette::fill(const SceneBench& bench) {
  clear();
  for (const Entry& entry : entries(bench)) {
    auto* item = new QListWidgetItem(entry.title, this);
    item->setData(Qt::UserRole, entry.kind);
  }
}

QStringList ScenePalette::mimeTypes() const {
  return {QLatin1String(kPaletteType)};
}

QMimeData* ScenePalette::mimeData(const QList<QListWidgetItem*> items) const {
  if (items.isEmpty()) return nullptr;
  auto* data = new QMimeData;
  data->setData(QLatin1String(kPaletteType), items.front()->data(Qt::UserRole).toString().toUtf8());
  return data;
}

}  // namespace widgets
