// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <optional>

#include "widgets/View.h"
#include "widgets/objects/PropertiesModel.h"
#include "widgets/sceneedit/SceneEdits.h"
#include "widgets/world/SceneState.h"

class QAction;
class QLabel;
class QTableView;

namespace robotcontrol {
class WorldObject;
class WorldObjects;
}  // namespace robotcontrol

namespace widgets {

class EmptyHint;
class SceneSelection;

/// The properties of the selected object of a simulated scene: its pose now, mass, size, color, friction,
/// noise and what else the scene's files say of it. The pose of movable objects is edited in the
/// simulation; other numbers are changed in the texts of the scene's files, in which the simulation then
/// continues, and are saved on request. If it cannot, they are only written, on request, and hold when the
/// scene is opened again.
///
/// Registered as "scene-properties". GUI thread.
class PropertiesView final : public View {
  Q_OBJECT
 public:
  explicit PropertiesView(ViewContext& context, QWidget* parent = nullptr);
  ~PropertiesView() override;

  void tick() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  const robotcontrol::WorldObject* object() const;
  /// The link and the shapes of a model of one link; else nothing.
  std::vector<const robotcontrol::WorldObject*> parts(const robotcontrol::WorldObject& object) const;
  /// The current pose of the object; unset: not known.
  std::optional<ObjectPose> pose(const robotcontrol::WorldObject& object);
  /// Moves the object.
  void place(int index, double value);
  /// Notes the present pose of the model for the scene's file.
  void keepPose();
  void save();
  void showEdits();
  /// Has the simulation continue with the values that were typed.
  void applyEdits();
  void report(const robotlink::Result<void>& done, const QString& text);
  /// Reports that a change was made, or why not.
  SceneEdits::Told told(const QString& text);
  SceneEdits& edits() const;

  SceneSelection& selection_;
  SceneState scene_;
  PropertiesModel model_;
  QAction *save_ = nullptr, *discard_ = nullptr, *keepPose_ = nullptr;
  QLabel *title_ = nullptr, *outcome_ = nullptr;
  QTableView* table_ = nullptr;
  EmptyHint* hint_ = nullptr;
  /// The objects that were published last; null: none.
  std::shared_ptr<const robotcontrol::WorldObjects> objects_;
};

}  // namespace widgets
