// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

class QTableWidget;

namespace app {

/// Lists the plug-ins, with what they are for or why they were not loaded, and where the user's are. GUI
/// thread.
class PluginsDialog final : public QDialog {
  Q_OBJECT
 public:
  explicit PluginsDialog(QWidget* parent);

 private:
  void fillTable();

  QTableWidget* table_ = nullptr;
};

}  // namespace app
