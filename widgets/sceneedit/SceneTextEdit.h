// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/text/MarkedTextEdit.h"

class QCompleter;
class QModelIndex;
class QStandardItemModel;

namespace widgets {

class XmlColors;

/// The text of a scene file: with line numbers, colors, and what an editor of XML does by itself: it proposes
/// elements and attributes, closes tags, and indents. Documents are set by setDocument(), and keep their
/// history; files that are no XML are plain text. GUI thread.
class SceneTextEdit final : public MarkedTextEdit {
  Q_OBJECT
 public:
  /// `language` may be null; then nothing is proposed.
  explicit SceneTextEdit(std::shared_ptr<const SceneLanguage> language, QWidget* parent = nullptr);
  ~SceneTextEdit() override;

  /// Shows another document, which must outlive being shown. `file`: for the models that it can include.
  void showDocument(QTextDocument* document, bool isXml, const std::filesystem::path& file);
  /// Places the cursor at the beginning of a line, from 1, and brings it into view.
  void goToLine(int line);
  /// Selects a part of the text and brings its beginning into view.
  void select(int begin, int end);
  /// Lists what may be written at the cursor.
  void propose();
  /// Indents all lines after the elements around them, as one step of the history.
  void indentAll();
  /// Replaces the whole text as one step of the history; only the part that differs is touched, so that
  /// cursors elsewhere stay.
  void replaceText(const QString& text);

 protected:
  QString tipAt(const QPoint& place) const override;
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  class LineNumbers;
  int numbersWidth() const;
  void placeNumbers();
  void paintNumbers(QPaintEvent& event);
  /// Handles a key that does more than insert its character. False: it does not.
  bool typeXml(QKeyEvent& event);
  /// Passes over what is written already right of the cursor, or was just completed. False: it is something
  /// else that is typed.
  bool typeOver(const QString& typed);
  /// Ends the innermost element after "</" was typed: by its closing tag if that comes next, or a new one.
  void closeElement();
  void breakLine();
  /// Moves the selected lines, or the one with the cursor, by two blanks.
  void indentLines(bool outwards);
  void insert(const QModelIndex& proposal);

  const std::shared_ptr<const SceneLanguage> language_;
  std::filesystem::path file_;
  bool isXml_ = true;
  XmlColors* colors_ = nullptr;
  LineNumbers* numbers_ = nullptr;
  QCompleter* completer_ = nullptr;
  QStandardItemModel* proposals_ = nullptr;
  /// The position at which the word begins that a proposal replaces.
  int wordBegin_ = 0;
  /// The text that was completed left of the cursor, and is not inserted again if it is typed, while the
  /// cursor stays there.
  QString completed_;
  int completedEnd_ = -1;
};

}  // namespace widgets
