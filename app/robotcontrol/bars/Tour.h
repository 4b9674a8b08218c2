// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QTimer>
#include <functional>
#include <vector>

class QLabel;
class QMainWindow;
class QPushButton;

namespace app {

class ViewDocks;

/// A short tour of the window: a panel over its lower edge that explains one part after the other, and a
/// frame around the part that it is about. The window can be used meanwhile; Esc ends the tour. GUI thread.
class Tour final : public QFrame {
  Q_OBJECT
 public:
  /// The docks must outlive it. It is a child of the window, and hidden until start().
  Tour(QMainWindow& window, ViewDocks& docks);

  /// Shows the first part.
  void start();
  void stop();
  /// The number of the part that is shown, from 0.
  int step() const { return step_; }
  int stepCount() const { return static_cast<int>(steps_.size()); }

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  /// Follows the size of the window.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  /// The subject of a step, and its widget; null if nothing of the window shows it now.
  struct Step {
    QString title, text;
    std::function<QWidget*()> target;
  };
  void createSteps(QMainWindow& window, ViewDocks& docks);
  /// Shows a part; the last one is followed by the end.
  void show(int step);
  /// Puts panel and frame where they belong.
  void place();

  std::vector<Step> steps_;
  int step_ = 0;
  QLabel* title_ = nullptr;
  QLabel* text_ = nullptr;
  QLabel* count_ = nullptr;
  QPushButton* back_ = nullptr;
  QPushButton* next_ = nullptr;
  /// A sibling, over the part.
  QWidget* mark_ = nullptr;
  /// Docks move without telling.
  QTimer placing_;
};

}  // namespace app
