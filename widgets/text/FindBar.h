// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextDocument>
#include <QWidget>

class QLabel;
class QLineEdit;
class QPlainTextEdit;
class QToolButton;

namespace widgets {

/// A row below a text for finding and replacing in it. Enter finds the next place, Shift+Enter the one
/// before, Escape closes the row. Hidden until it is opened. GUI thread; the text must outlive it.
class FindBar final : public QWidget {
  Q_OBJECT
 public:
  explicit FindBar(QPlainTextEdit& edit, QWidget* parent = nullptr);

  /// Shows the row, with what is selected in the text as what is sought.
  void open();
  /// Selects the next place behind the cursor, or before it; continues at the other end. False: there is
  /// none.
  bool find(bool backwards);
  /// Replaces what is selected, if it is what is sought, and selects the next place.
  void replace();
  /// Replaces all places as one step of the history; returns how many there were.
  int replaceAll();

 protected:
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void createFields();
  QTextDocument::FindFlags flags() const;
  void report(const QString& text, bool bad);

  QPlainTextEdit& edit_;
  QLineEdit *sought_ = nullptr, *instead_ = nullptr;
  QToolButton* exactCase_ = nullptr;
  QLabel* outcome_ = nullptr;
};

}  // namespace widgets
