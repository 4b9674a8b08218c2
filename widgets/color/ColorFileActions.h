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

/// What a person does with the files of a colour table: actions of a view that ask for files, and a menu of
/// those without a button. What fails is told by the bench. GUI thread; belongs to the view.
class ColorFileActions final : public QObject {
  Q_OBJECT
 public:
  ColorFileActions(ColorFiles& files, QWidget* view);

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
  using Use = std::function<robotlink::Result<void>(const std::filesystem::path&)>;
  /// Asks for a file to read; nothing happens without one.
  void read(const QString& title, const QString& filter, const Use& use);

  ColorFiles& files_;
  QWidget* view_;
  QAction* new_ = nullptr;
  QAction* open_ = nullptr;
  QAction* save_ = nullptr;
  QAction* several_ = nullptr;
  QMenu* menu_ = nullptr;
};

/// Saves the samples to their file, or asks for one. False: that did not work, or nobody wanted it.
bool saveSamples(ColorFiles& files, QWidget* parent);

/// Asks whether samples that are not saved should be, before something takes their place. False: that must
/// not happen. Without changes nobody is asked.
bool mayLoseSamples(ColorFiles& files, QWidget* parent);

}  // namespace widgets
