// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QString>
#include <map>
#include <string>
#include <vector>

#include "widgets/Theme.h"

class QGridLayout;
class QLabel;

namespace widgets {

/// A group of named values in rows, each with a title. Values with a meaning say it in words and have its
/// color. The labels' object names are the names of the rows. GUI thread.
class StateRows final : public QGroupBox {
  Q_OBJECT
 public:
  /// `name` is the object name of the group.
  StateRows(const QString& title, const char* name, QWidget* parent = nullptr);
  /// Appends a row with a text, which is a dash at first.
  void addRow(const char* name, const QString& title, const QString& toolTip);
  /// Appends a row with any widget instead of a text.
  void addRow(const QString& title, const QString& toolTip, QWidget* widget);
  /// Appends a widget over the whole width.
  void addWidget(QWidget* widget);
  /// Appends a wrapped text over the whole width, hidden while it is empty.
  void addText(const char* name, const QString& title);
  /// Sets a text. An empty one is shown as a dash, or hides a text over the whole width. `name` must be that
  /// of a row.
  void set(const char* name, const QString& text) { set(name, text, Meaning::kMuted, false); }
  /// Sets a text in the color of a meaning.
  void set(const char* name, const QString& text, Meaning meaning) { set(name, text, meaning, true); }
  /// Whether the values are outdated: then all are gray, whatever they mean.
  void setStale(bool stale);

 protected:
  /// Applies a new palette.
  void changeEvent(QEvent* event) override;

 private:
  /// The text of a row.
  struct Value {
    QLabel* label = nullptr;
    /// Over the whole width.
    bool wide = false;
    /// In the color of `meaning`.
    bool colored = false;
    Meaning meaning = Meaning::kMuted;
  };
  QLabel* addTitle(const QString& title, const QString& toolTip);
  void set(const char* name, const QString& text, Meaning meaning, bool colored);
  /// Applies the color of a value.
  void color(const Value& value) const;

  QGridLayout* grid_;
  /// Keyed by the names of the rows.
  std::map<std::string, Value> values_;
  std::vector<QLabel*> titles_;
  bool stale_ = false;
};

}  // namespace widgets
