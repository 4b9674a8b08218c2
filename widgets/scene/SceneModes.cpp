// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/scene/SceneModes.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QSignalBlocker>
#include <algorithm>

#include "widgets/Controls.h"
#include "widgets/scene/ObjectLooks.h"

namespace widgets {
namespace {

constexpr std::array<const char*, kSceneLayers> kLayerNames{
    "visuals", "solids", "forces", "joints", "frames", "centers", "sensors", "names", "shadows"};

bool isShownAtFirst(SceneLayer layer) {
  return layer == SceneLayer::kVisuals || layer == SceneLayer::kShadows;
}

}  // namespace

const char* nameOfLayer(SceneLayer layer) {
  return kLayerNames[static_cast<std::size_t>(layer)];
}

std::optional<SceneLayer> layerNamed(const std::string& name) {
  const auto found = std::ranges::find(kLayerNames, name);
  if (found == kLayerNames.end()) return std::nullopt;
  return static_cast<SceneLayer>(found - kLayerNames.begin());
}

SceneModes::SceneModes(QWidget* view) : QObject(view) {
  createSurfaces(view);
  createLayers(view);
}

void SceneModes::createSurfaces(QWidget* view) {
  surfaceActions_ = {
      makeToggle(view, "scene",
                 {"sceneShaded", tr("Shaded"), tr("Draws surfaces with soft light"), tr("Shift+W")}, true),
      makeToggle(view, "color-surfaces",
                 {"sceneFlat", tr("Flat"), tr("Draws each triangle in one color"), tr("Alt+W")}),
      makeToggle(view, "wireframe",
                 {"sceneHiddenLines", tr("Edges, hidden ones left out"),
                  tr("Draws the edges that no surface hides"), tr("Ctrl+Alt+W")}),
      makeToggle(
          view, "wireframe",
          {"sceneWireFrame", tr("Wire frame"), tr("Draws all edges, also the hidden ones"), Qt::Key_W})};
  surfaces_ = new QMenu(view);
  surfaces_->setObjectName(QStringLiteral("sceneSurfaces"));
  for (std::size_t i = 0; i < surfaceActions_.size(); ++i) {
    QAction* action = surfaceActions_[i];
    surfaces_->addAction(action);
    // Switching off a mode returns to shaded surfaces.
    connect(action, &QAction::triggered, this,
            [this, i](bool on) { setSurface(on ? static_cast<Surface>(i) : Surface::kShaded); });
  }
}

void SceneModes::createLayers(QWidget* view) {
  layerActions_ = {
      makeToggle(view, "eye", {"sceneVisuals", tr("Visible shapes"), tr("Shows what cameras see")}, true),
      makeToggle(
          view, "select-area",
          {"sceneSolids", tr("Solids"),
           tr("Shows what collides: as edges over the visible shapes, or in place of these"), tr("Shift+P")}),
      makeToggle(
          view, "send",
          {"sceneForces", tr("Contacts and forces"),
           tr("Shows where objects touch, and forces as arrows of 1 cm for 1 N: of contacts orange, of "
              "joints blue, by hand green"),
           tr("Shift+C")}),
      makeToggle(
          view, "joints",
          {"sceneJoints", tr("Joints"),
           tr("Shows the axes of joints, and the names of those of the selected object"), tr("Shift+J")}),
      makeToggle(view, "point",
                 {"sceneFrames", tr("Frames"),
                  tr("Shows the axes of models and links: x red, y green, z blue"), tr("Shift+F")}),
      makeToggle(view, "quality",
                 {"sceneCenters", tr("Centers of mass"),
                  tr("Shows the center of mass of each link, larger if heavier"), tr("Shift+M")}),
      makeToggle(view, "sonar",
                 {"sceneSimulatedSensors", tr("Sensors"),
                  tr("Shows what simulated cameras see, sonars reach, and rays hit"), tr("Shift+S")}),
      makeToggle(view, "labels",
                 {"sceneObjectNames", tr("Names of objects"),
                  tr("Shows the names of all models, not only of robots"), tr("Shift+L")}),
      makeToggle(view, "light", {"sceneShadows", tr("Shadows"), tr("Shows shadows on the ground")}, true)};
  layers_ = new QMenu(view);
  layers_->setObjectName(QStringLiteral("sceneLayers"));
  for (QAction* action : layerActions_) {
    layers_->addAction(action);
    connect(action, &QAction::toggled, this, &SceneModes::changed);
  }
}

Surface SceneModes::surface() const {
  for (std::size_t i = 0; i < surfaceActions_.size(); ++i)
    if (surfaceActions_[i]->isChecked()) return static_cast<Surface>(i);
  return Surface::kShaded;
}

void SceneModes::setSurface(Surface surface) {
  for (std::size_t i = 0; i < surfaceActions_.size(); ++i)
    surfaceActions_[i]->setChecked(static_cast<Surface>(i) == surface);
  Q_EMIT changed();
}

bool SceneModes::shows(SceneLayer layer) const {
  return layerActions_[static_cast<std::size_t>(layer)]->isChecked();
}

void SceneModes::setShown(SceneLayer layer, bool shown) {
  layerActions_[static_cast<std::size_t>(layer)]->setChecked(shown);
}

QJsonObject SceneModes::state() const {
  QJsonObject state{{QStringLiteral("surface"), QLatin1String(nameOfSurface(surface()))}};
  for (int i = 0; i < kSceneLayers; ++i) {
    const auto layer = static_cast<SceneLayer>(i);
    state.insert(QLatin1String(nameOfLayer(layer)), shows(layer));
  }
  return state;
}

void SceneModes::restore(const QJsonObject& state) {
  const auto surface = surfaceNamed(state.value(QStringLiteral("surface")).toString().toStdString());
  for (int i = 0; i < kSceneLayers; ++i) {
    const auto layer = static_cast<SceneLayer>(i);
    setShown(layer, state.value(QLatin1String(nameOfLayer(layer))).toBool(isShownAtFirst(layer)));
  }
  setSurface(surface.value_or(Surface::kShaded));
}

}  // namespace widgets
