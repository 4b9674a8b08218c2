// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPlainTextEdit>
#include <QTextCursor>
#include <optional>
#include <vector>

#include "widgets/Theme.h"
#include "widgets/text/TextPlace.h"

namespace widgets {

/// A remark about a part of a text. The cursor's selection is the part; it moves with the text
/// as that is edited.
struct TextMark {
  QTextCursor part;
  QString text;
  Meaning meaning = Meaning::kBad;
};

/// A text in a font of fixed width, whose line with the cursor is highlighted. Parts of it are underlined
/// in the color of what they mean; the mouse over them shows what is said. Tab leaves it, unless a derived
/// class uses that key. GUI thread.
class MarkedTextEdit : public QPlainTextEdit {
  Q_OBJECT
 public:
  explicit MarkedTextEdit(QWidget* parent = nullptr);

  /// Replaces all marks. Only the first ones are shown if there are very many.
  void setMarks(std::vector<TextMark> marks);
  /// The errors at a place of the viewport, a line each; empty: none.
  QString errorAt(const QPoint& place) const;

  TextPlace place() const;
  /// Goes back to a place, as near as the text permits. An editor that is not visible yet scrolls there as
  /// soon as it is.
  void setPlace(const TextPlace& place);

 Q_SIGNALS:
  /// place() changed while the editor is visible.
  void placeChanged();

 protected:
  /// The tooltip at a place: by default errorAt().
  virtual QString tipAt(const QPoint& place) const { return errorAt(place); }
  bool viewportEvent(QEvent* event) override;
  void changeEvent(QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  /// Call this when another place is to be shown than that of setPlace().
  void dropPlace() { unscrolled_.reset(); }

 private:
  void showMarks();
  void connectPlace();
  /// Scrolls to where setPlace() was to.
  void scrollToPlace();

  std::vector<TextMark> marks_;
  /// The place to scroll to once the editor is visible; unset: none.
  std::optional<TextPlace> unscrolled_;
};

}  // namespace widgets
