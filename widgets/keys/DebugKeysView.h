// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/keys/KeyTreeModel.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QTreeView;

namespace widgets {

class EmptyHint;
class KeyFilter;

/// The debug keys of the selected robot as a tree. A search field filters it, mode and number are edited in
/// place, and presets are stored and loaded by name. Space or Return toggles the current key (or all keys of
/// a group) between off and always; typing in the tree goes to the search field. Changes are sent as requests
/// and confirmed by the next KeyTable; a refusal is shown at its key.
///
/// Registered as "debug-keys". GUI thread.
class DebugKeysView final : public View {
  Q_OBJECT
 public:
  explicit DebugKeysView(ViewContext& context, QWidget* parent = nullptr);
  /// Rebuilds the tree if the robot or its key tables changed since the last tick.
  void tick() override;

 protected:
  /// Handles the keys typed in the tree.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  /// Filters the tree by the words in `text`.
  void search(const QString& text);
  /// Toggles the key at `index`, or all keys of the group at `index`.
  void toggle(const QModelIndex& index);
  /// Requests the modes that are shown of the current key, or of the keys below the current group, from all
  /// other robots.
  void setInAllRobots();
  /// Requests "off" for every key that is not off.
  void allOff();
  /// Requests the mode of one key; a refusal is shown at the key and in the state line.
  void request(const QString& key, const KeyValue& value);
  /// Updates the state line, the hint of an empty tree, and which columns are visible.
  void showState();
  /// Shows a notice above the state until the next action of the user; empty: removes it.
  void notify(const QString& notice);

  /// Fills the combo box with the shipped presets and the user's own.
  void listPresets();
  /// Name of the selected preset if it is a shipped one; empty if it is the user's own.
  QString shippedName() const;
  /// Requests the keys of a preset; all others are switched off.
  void loadPreset(const QString& name);
  /// Stores the keys that are on under the name in the combo box.
  void savePreset();
  /// Deletes the selected preset; shipped ones cannot be deleted.
  void removePreset();

  KeyTreeModel model_;
  KeyFilter* filter_;
  QLineEdit* search_ = nullptr;
  QTreeView* tree_ = nullptr;
  QComboBox* presets_ = nullptr;
  QLabel* state_ = nullptr;
  EmptyHint* hint_ = nullptr;
  QAction* activeOnly_ = nullptr;
  QAction* allOff_ = nullptr;
  QAction* inAllRobots_ = nullptr;
  QAction* savePreset_ = nullptr;
  QAction* removePreset_ = nullptr;
  /// The text set by notify().
  QString notice_;
  /// The robot whose keys the tree shows.
  std::string robot_;
  /// Addresses of the tables that the tree shows, to detect new ones.
  std::vector<const void*> shown_;
};

}  // namespace widgets
