// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <string>

#include "widgets/View.h"
#include "widgets/objects/SceneTreeModel.h"
#include "widgets/ports/PortSubscription.h"

class QAction;
class QLabel;
class QLineEdit;
class QMenu;
class QSortFilterProxyModel;
class QTreeView;

namespace widgets {

class ActuatorPanel;
class EmptyHint;
class SceneSelection;

/// All objects of a simulated scene as a tree, with search: models, links, joints, shapes, sensors with their
/// values, actuators with sliders, and lights. From here a sensor is plotted, shown as columns or as an
/// image. The selected object is the one that is selected in the scene, and vice versa. Sensors are
/// read while they are in view.
///
/// Registered as "scene-tree". GUI thread.
class SceneTreeView final : public View {
  Q_OBJECT
 public:
  explicit SceneTreeView(ViewContext& context, QWidget* parent = nullptr);
  ~SceneTreeView() override;

  void tick() override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Shows another scene; what was unfolded stays so.
  void showObjects();
  /// Asks for the sensors whose rows are in view.
  void readShown();
  /// Selects in the tree what is selected elsewhere.
  void followSelection();
  /// Adapts actions and sliders to the selected row.
  void showSelected();
  void showMenu(const QPoint& at);
  /// Whether an object, or what it belongs to, is somewhere in the scene.
  bool hasPlace(const robotcontrol::WorldObject& object) const;
  /// Offers to show the selected object again if a view of the scene hides it, or parts of it.
  void showHidden();
  /// The selected object; null: none.
  const robotcontrol::WorldObject* selected() const;
  void plot();
  void showColumns();
  void showImage(const char* mode);
  void createSceneActions();
  /// Creates what changes the text of the scene, with the keys of the view of the scene.
  void createEditActions();
  /// Asks for another name of the selected object.
  void rename();
  /// Adds to a menu how views of the scene show the object.
  void addSceneEntries(QMenu& menu);
  /// Runs a command with the path of the selected object and more words.
  void runForObject(const char* command, std::vector<std::string> words);
  /// Runs a command, and says what went wrong; whether it was done.
  bool run(const char* command, const std::vector<std::string>& words);
  /// Says what went wrong; whether it was done.
  bool report(const robotlink::Result<void>& done);
  /// Shows the opacity of the selected object.
  void showOpacity(double opacity);
  /// The paths of unfolded objects.
  std::set<std::string> unfolded() const;
  void unfold(const std::set<std::string>& paths);

  SceneSelection& selection_;
  SceneTreeModel model_;
  QSortFilterProxyModel* filtered_;
  PortSubscription subscription_;
  QAction *plot_ = nullptr, *columns_ = nullptr, *image_ = nullptr, *gray_ = nullptr;
  QAction *alone_ = nullptr, *around_ = nullptr, *hide_ = nullptr, *showAgain_ = nullptr;
  QAction *follow_ = nullptr, *turnWith_ = nullptr, *lookOut_ = nullptr;
  QAction *stereogram_ = nullptr, *properties_ = nullptr, *copyPath_ = nullptr;
  QAction *goToText_ = nullptr, *duplicate_ = nullptr, *erase_ = nullptr, *rename_ = nullptr;
  QLineEdit* search_ = nullptr;
  QTreeView* tree_ = nullptr;
  ActuatorPanel* actuators_ = nullptr;
  QLabel* outcome_ = nullptr;
  EmptyHint* hint_ = nullptr;
  /// The message that is shown, to detect another one.
  robotlink::PackagePtr objects_;
  /// The objects unfolded in a saved state, until there are objects.
  std::set<std::string> wanted_;
  int ticks_ = 0;
};

}  // namespace widgets
