// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <filesystem>
#include <functional>

#include "robotlink/base/Error.h"

class QAction;
class QHBoxLayout;
class QMenu;
class QWidget;

namespace widgets {

class ColorFiles;

/// The user's actions with the files of a color table: buttons of a view, dialogs that ask for files, and a
/// menu for the less frequent ones. Failures are reported by the bench's signal failed(). GUI thread; owned
/// by the view.
class ColorFileActions final : public QObject {
  Q_OBJECT
 public:
  /// `files` must outlive the actions.
  ColorFileActions(ColorFiles& files, QWidget* view);

  /// Appends the buttons and the menu to a row.
  void addTo(QHBoxLayout* row) const;

 private:
  void createActions();
  void connectSignals();
  void startAnew();
  void open();
  void save();
  void saveAs();
  void merge();
  void exportTable();
  void importReference();
  /// A function that uses the file that was chosen.
  using Use = std::function<robotlink::Result<void>(const std::filesystem::path&)>;
  /// Asks for a file to read and passes it to `use`; does nothing if the dialog is canceled.
  void read(const QString& title, const QString& filter, const Use& use);

  ColorFiles& files_;
  QWidget* view_;
  QAction* new_ = nullptr;
  QAction* open_ = nullptr;
  QAction* save_ = nullptr;
  /// Whether exported cells may be of several classes.
  QAction* several_ = nullptr;
  QMenu* menu_ = nullptr;
};

/// Saves the samples to their file, or asks for one. False: it failed or was canceled.
bool saveSamples(ColorFiles& files, QWidget* parent);

/// Asks whether to save unsaved samples before they are replaced. False: the user canceled, or saving
/// failed, and they must be kept. Asks nothing without unsaved changes.
bool mayLoseSamples(ColorFiles& files, QWidget* parent);

}  // namespace widgets
