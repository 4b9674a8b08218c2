// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QToolButton>
#include <vector>

class QHBoxLayout;
class QMenu;

namespace widgets {

/// A flat button of a row of tools, which can be left out where the row has no room for it.
class RowButton final : public QToolButton {
  Q_OBJECT

 public:
  explicit RowButton(QWidget* parent);

  /// Lets the row shrink below what the button needs; until then it keeps its width.
  void setInToolRow();
  /// Width in pixels that it needs where it is not left out.
  [[nodiscard]] int neededWidth() const;
  [[nodiscard]] bool isLeftOut() const { return isLeftOut_; }
  /// A button that is left out has no width and cannot be reached by Tab.
  void setLeftOut(bool leftOut);
  /// Empty while it is left out, so that layouts give it no room.
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 private:
  bool isInToolRow_ = false;
  bool isLeftOut_ = false;
};

/// Keeps a row of tools usable in a narrow view: the last buttons for which there is no room are left out,
/// and offered by a button » at the row's end. Lives as long as the row's widget; GUI thread.
class ToolRow final : public QObject {
  Q_OBJECT

 public:
  /// `row`: the layout of a widget of its own, whose RowButtons may be left out.
  explicit ToolRow(QHBoxLayout& row);

  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  [[nodiscard]] std::vector<RowButton*> buttons() const;
  /// Width in pixels that the row needs with all of its buttons.
  [[nodiscard]] int neededWidth(const std::vector<RowButton*>& buttons) const;
  /// Leaves out as many buttons as have no room in this width.
  void fit(int width);
  void fillMenu();

  QHBoxLayout& row_;
  QToolButton* more_;
  int margin_;  // on the right, without the button »
};

}  // namespace widgets
