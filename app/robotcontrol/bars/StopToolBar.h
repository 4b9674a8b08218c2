// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolBar>

class QToolButton;

namespace app {

/// The button that stops all robots, at the right edge of the window: apart from all other buttons, and never
/// squeezed out by them. GUI thread.
class StopToolBar : public QToolBar {
  Q_OBJECT
 public:
  /// `stop` is what it triggers and shows; it must outlive this.
  StopToolBar(QAction& stop, QWidget* parent);

  QSize minimumSizeHint() const override;

 private:
  QToolButton* button_;
};

}  // namespace app
