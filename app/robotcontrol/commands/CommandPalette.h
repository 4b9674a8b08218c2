// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>
#include <QPointer>
#include <QStringList>
#include <functional>
#include <vector>

#include "app/robotcontrol/commands/PaletteEntries.h"

class QLabel;
class QLineEdit;
class QListView;

namespace widgets {
class CommandLog;
}

namespace app {

class CommandActions;

/// A field over the window in which a person finds commands and menu entries by their words. Return runs the
/// chosen one; a command that takes arguments continues in the same line, with what each of them can be. What
/// goes wrong is shown below the line, which stays. Escape, or a click elsewhere, closes the palette, and the
/// focus returns to where it was.
///
/// GUI thread; the parts must outlive it.
class CommandPalette final : public QFrame {
  Q_OBJECT
 public:
  struct Parts {
    /// Asked before a command is run, see CommandActions::setGuard().
    const CommandActions& actions;
    const robotlink::CommandTable& commands;
    widgets::CommandLog& log;
    /// The open views; their lines are the names with which `go` brings one to the front and gives it the
    /// focus.
    std::function<std::vector<PaletteEntry>()> views;
    std::function<void(const QString& name)> go;
  };
  /// The number of entries and lines that are remembered.
  static constexpr int kMaxRecent = 30;

  CommandPalette(const Parts& parts, QWidget* window);

  void open();
  /// The same with the open views instead of commands.
  void openViews();
  /// The ids of the entries run last, the newest at the end, to be kept over restarts.
  const QStringList& recent() const { return recent_; }
  void setRecent(const QStringList& recent);

 protected:
  /// Handles the keys of the field, and follows the size of the window.
  bool eventFilter(QObject* watched, QEvent* event) override;
  /// Returns the focus.
  void hideEvent(QHideEvent* event) override;

 private:
  void show(std::vector<PaletteEntry> entries, bool areViews);
  void createViews();
  void connectSignals();
  /// Lies in the middle of the window, at its top.
  void place();
  bool press(int key);
  /// Shows what fits the text.
  void refresh();
  /// The name of the command whose arguments are typed; empty: none is.
  QString begunCommand() const;
  void showArguments();
  /// Entries for recently run lines that are not among the entries.
  std::vector<PaletteEntry> recentLines() const;
  void move(int rows);
  /// Return: runs what is chosen, or takes the chosen argument.
  void accept();
  void complete();
  void take(const QString& candidate);
  void run(const PaletteEntry& entry);
  void runLine(const QString& line);
  void remember(const QString& id);
  void showHint(const QString& html, bool isBad = false);

  Parts parts_;
  PaletteModel model_;
  std::vector<PaletteEntry> entries_;
  bool areViews_ = false;
  QStringList recent_;
  QLineEdit* input_ = nullptr;
  QListView* list_ = nullptr;
  QLabel* hint_ = nullptr;
  /// The widget that had the focus.
  QPointer<QWidget> before_;
};

}  // namespace app
