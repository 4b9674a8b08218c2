// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "widgets/View.h"
#include "widgets/models/KeyTreeModel.h"

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QTreeView;

namespace widgets {

class EmptyHint;
class KeyFilter;

/// The debug keys of the selected robot: a tree with a search field, mode and number edited in place, presets
/// by name, and all off. Space switches the current key (or all keys of a group) between off and always;
/// typing goes to the search field.
class DebugKeysView final : public View {
  Q_OBJECT
 public:
  explicit DebugKeysView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void createActions();
  void createViews();
  void connectSignals();
  void search(const QString& text);
  void toggle(const QModelIndex& index);
  void allOff();
  void request(const QString& key, const KeyValue& value);
  void showState();
  /// Says something above the state until the next thing is done here.
  void notify(const QString& notice);

  void listPresets();
  /// The name of the shipped preset that is chosen; empty for the user's own.
  QString shippedName() const;
  void loadPreset(const QString& name);
  void savePreset();
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
  QAction* savePreset_ = nullptr;
  QAction* removePreset_ = nullptr;
  QString notice_;
  std::string robot_;
  std::vector<const void*> shown_;  // the tables that are shown
};

}  // namespace widgets
