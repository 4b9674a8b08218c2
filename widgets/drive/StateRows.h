// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QGroupBox>
#include <QString>
#include <map>
#include <string>
#include <vector>

#include "widgets/models/Theme.h"

class QGridLayout;
class QLabel;

namespace widgets {

/// Named values of one kind below each other, each with its title; a value that means something good or bad
/// says so in words and wears the colour of it. Its labels' object names are those of the rows.
class StateRows final : public QGroupBox {
  Q_OBJECT
 public:
  StateRows(const QString& title, const char* name, QWidget* parent = nullptr);
  void addRow(const char* name, const QString& title, const QString& toolTip);
  /// A widget of its own instead of a text.
  void addRow(const QString& title, const QString& toolTip, QWidget* widget);
  /// Over the whole width.
  void addWidget(QWidget* widget);
  /// Over the whole width, wrapped.
  void addText(const char* name, const QString& title);
  /// An empty text shows as a dash, or hides a text over the whole width.
  void set(const char* name, const QString& text) { set(name, text, Meaning::kMuted, false); }
  void set(const char* name, const QString& text, Meaning meaning) { set(name, text, meaning, true); }
  /// What is shown is not of now: all values are grey, whatever they mean.
  void setStale(bool stale);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  struct Value {
    QLabel* label = nullptr;
    bool wide = false;
    bool colored = false;
    Meaning meaning = Meaning::kMuted;
  };
  QLabel* addTitle(const QString& title, const QString& toolTip);
  void set(const char* name, const QString& text, Meaning meaning, bool colored);
  void color(const Value& value) const;
  void mute(QLabel& title) const;

  QGridLayout* grid_;
  std::map<std::string, Value> values_;
  std::vector<QLabel*> titles_;
  bool stale_ = false;
};

}  // namespace widgets
