// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneTextEdit.h"

#include <QAbstractItemView>
#include <QCompleter>
#include <QKeyEvent>
#include <QPainter>
#include <QScrollBar>
#include <QStandardItemModel>
#include <QTextBlock>
#include <algorithm>

#include "widgets/Controls.h"
#include "widgets/sceneedit/SceneCompletion.h"
#include "widgets/sceneedit/SceneFile.h"
#include "widgets/sceneedit/XmlColors.h"
#include "widgets/sceneedit/XmlPlace.h"
#include "widgets/sceneedit/XmlText.h"

namespace widgets {
namespace {

constexpr int kTextRole = Qt::UserRole, kBackRole = Qt::UserRole + 1;
constexpr int kLineNumberMargin = 6, kIndentBlanks = 2, kMinProposalWidth = 200;

/// Whether the tag with the word before a position has more behind it, which is to stay.
bool goesOnAt(const QString& text, int position) {
  int end = position;
  while (end < text.size() && text[end] != QLatin1Char('<') && text[end] != QLatin1Char('>')) ++end;
  const bool isComplete = end < text.size() && text[end] == QLatin1Char('>');
  const QString inLine = text.mid(position, end - position).section(QLatin1Char('\n'), 0, 0);
  return isComplete || !inLine.trimmed().isEmpty();
}

}  // namespace

/// The strip with the numbers of the lines.
class SceneTextEdit::LineNumbers final : public QWidget {
 public:
  explicit LineNumbers(SceneTextEdit& edit) : QWidget(&edit), edit_(edit) {
    setObjectName(QStringLiteral("sceneLineNumbers"));
  }

 protected:
  void paintEvent(QPaintEvent* event) override { edit_.paintNumbers(*event); }

 private:
  SceneTextEdit& edit_;
};

SceneTextEdit::SceneTextEdit(std::shared_ptr<const SceneLanguage> language, QWidget* parent)
    : MarkedTextEdit(parent), language_(std::move(language)) {
  describe(*this, {"sceneText", tr("Text of the scene"), {}});
  setTabChangesFocus(false);  // it indents
  // Only what is typed right behind a completed name may be typed over it.
  connect(this, &QPlainTextEdit::cursorPositionChanged, this, [this] { completedEnd_ = -1; });
  colors_ = new XmlColors(*this);
  numbers_ = new LineNumbers(*this);
  proposals_ = new QStandardItemModel(this);
  completer_ = new QCompleter(proposals_, this);
  completer_->setWidget(this);
  completer_->setCompletionMode(QCompleter::PopupCompletion);
  completer_->popup()->setObjectName(QStringLiteral("sceneProposals"));
  connect(completer_, qOverload<const QModelIndex&>(&QCompleter::activated), this, &SceneTextEdit::insert);
  connect(this, &QPlainTextEdit::blockCountChanged, this, &SceneTextEdit::placeNumbers);
  connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& part, int scrolled) {
    if (scrolled != 0)
      numbers_->scroll(0, scrolled);
    else
      numbers_->update(0, part.y(), numbers_->width(), part.height());
  });
  placeNumbers();
}

// The document, which stays, has no colors then; the highlighter must not outlive what it asks for them.
SceneTextEdit::~SceneTextEdit() {
  delete colors_;
}

void SceneTextEdit::showDocument(QTextDocument* document, bool isXml, const std::filesystem::path& file) {
  file_ = file;
  isXml_ = isXml;
  completedEnd_ = -1;
  setMarks({});
  // Only the document that is shown follows the font of the editor.
  document->setDefaultFont(font());
  if (document != this->document()) setDocument(document);
  QTextDocument* colored = isXml ? document : nullptr;
  if (colors_->document() != colored) colors_->setDocument(colored);
  placeNumbers();
}

void SceneTextEdit::goToLine(int line) {
  const QTextBlock block = document()->findBlockByNumber(std::clamp(line, 1, blockCount()) - 1);
  dropPlace();
  setTextCursor(QTextCursor(block));
  centerCursor();
}

void SceneTextEdit::select(int begin, int end) {
  const int last = std::max(0, document()->characterCount() - 1);
  QTextCursor cursor(document());
  cursor.setPosition(std::clamp(end, 0, last));
  cursor.setPosition(std::clamp(begin, 0, last), QTextCursor::KeepAnchor);
  dropPlace();
  setTextCursor(cursor);
  centerCursor();
}

void SceneTextEdit::replaceText(const QString& after) {
  replaceDocumentText(*document(), after);
}

void SceneTextEdit::indentAll() {
  if (!isXml_) return;
  const int line = textCursor().blockNumber();
  replaceText(indentedXml(toPlainText()));
  setTextCursor(QTextCursor(document()->findBlockByNumber(line)));
}

QString SceneTextEdit::tipAt(const QPoint& place) const {
  const QString error = errorAt(place);
  if (!error.isEmpty() || language_ == nullptr || !isXml_) return error;
  const QTextCursor cursor = cursorForPosition(place);
  const QRect gap = cursorRect(cursor);
  // Beside the text of a line is no word.
  if (place.x() > gap.right() + fontMetrics().averageCharWidth()) return {};
  // The gap between characters that is nearest may be behind the one under the mouse.
  return sceneHelpAt(*language_, toPlainText(), cursor.position() - (gap.left() > place.x() ? 1 : 0));
}

// ---- Keys

bool SceneTextEdit::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    // Elsewhere in the window this key pauses what views show.
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Space && key->modifiers() == Qt::ControlModifier) {
      event->accept();
      return true;
    }
  }
  return MarkedTextEdit::event(event);
}

void SceneTextEdit::keyPressEvent(QKeyEvent* event) {
  if (completer_->popup()->isVisible()) {
    switch (event->key()) {
      case Qt::Key_Enter:
      case Qt::Key_Return:
      case Qt::Key_Escape:
      case Qt::Key_Tab:
      case Qt::Key_Backtab:
        event->ignore();  // they are for the list
        return;
      default:
        break;
    }
  }
  if (event->key() == Qt::Key_Space && event->modifiers() == Qt::ControlModifier) return propose();
  if (event->key() == Qt::Key_Backtab) return indentLines(true);
  if (event->key() == Qt::Key_Tab && event->modifiers() == Qt::NoModifier) return indentLines(false);
  if (isXml_ && typeXml(*event)) return;
  MarkedTextEdit::keyPressEvent(event);
  const QString typed = event->text();
  const bool isWord =
      !typed.isEmpty() && (typed[0].isLetterOrNumber() || QStringLiteral("<_: ").contains(typed[0]));
  const bool isListed = completer_->popup()->isVisible();
  if (isXml_ && (isListed || (isWord && typed[0] != QLatin1Char(' ')))) propose();
}

bool SceneTextEdit::typeXml(QKeyEvent& event) {
  const bool isPlain = (event.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) == 0;
  if (!isPlain) return false;
  if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
    breakLine();
    return true;
  }
  if (!event.text().isEmpty() && typeOver(event.text())) return true;
  const bool closes = event.text() == QLatin1String(">"), ends = event.text() == QLatin1String("/");
  if (!closes && !ends) return false;
  completer_->popup()->hide();
  QTextCursor cursor = textCursor();
  const int before = cursor.selectionStart();
  if (ends && before > 0 && document()->characterAt(before - 1) == QLatin1Char('<')) {
    closeElement();
    return true;
  }
  cursor.beginEditBlock();
  cursor.insertText(event.text());
  const int at = cursor.position();
  if (closes) cursor.insertText(closingTagFor(toPlainText(), at));
  cursor.endEditBlock();
  cursor.setPosition(at);
  setTextCursor(cursor);
  return true;
}

bool SceneTextEdit::typeOver(const QString& typed) {
  QTextCursor cursor = textCursor();
  const int at = cursor.position();
  if (cursor.hasSelection()) return false;
  if (at == completedEnd_ && completed_.startsWith(typed)) {
    completed_.remove(0, typed.size());
    if (completed_.isEmpty()) completedEnd_ = -1;
    return true;
  }
  completedEnd_ = -1;
  const QChar next = document()->characterAt(at);
  const bool isQuote = next == QLatin1Char('"') || next == QLatin1Char('\'');
  if (typed != QString(next) || !(isQuote || next == QLatin1Char('>'))) return false;
  const QString text = toPlainText();
  const XmlPlace place = xmlPlaceAt(text, at);
  const bool endsValue = place.kind == XmlPlace::Kind::kAttributeValue && place.prefixBegin > 0 &&
                         text[place.prefixBegin - 1] == next;
  const bool endsTag = place.kind == XmlPlace::Kind::kTagName ||
                       place.kind == XmlPlace::Kind::kAttributeName ||
                       place.kind == XmlPlace::Kind::kClosingName;
  if (isQuote ? !endsValue : !endsTag) return false;
  completer_->popup()->hide();
  cursor.setPosition(at + 1);
  setTextCursor(cursor);
  return true;
}

void SceneTextEdit::closeElement() {
  QTextCursor cursor = textCursor();
  cursor.beginEditBlock();
  cursor.removeSelectedText();
  cursor.deletePreviousChar();
  const XmlClosing closing = closingAt(toPlainText(), cursor.position());
  if (closing.end >= 0) {
    // A line that was begun for it is not needed.
    cursor.setPosition(closing.blankBegin);
    cursor.setPosition(closing.blankEnd, QTextCursor::KeepAnchor);
    cursor.removeSelectedText();
    cursor.setPosition(closing.end - (closing.blankEnd - closing.blankBegin));
  } else {
    cursor.insertText(QStringLiteral("</") + closing.name);
  }
  cursor.endEditBlock();
  setTextCursor(cursor);
  completed_ = closing.name;
  completedEnd_ = closing.name.isEmpty() ? -1 : cursor.position();
}

void SceneTextEdit::breakLine() {
  QTextCursor cursor = textCursor();
  cursor.beginEditBlock();
  cursor.removeSelectedText();
  const XmlNewLine line = newLineAt(toPlainText(), cursor.position());
  cursor.insertText(line.text);
  cursor.endEditBlock();
  cursor.setPosition(cursor.position() - line.back);
  setTextCursor(cursor);
  ensureCursorVisible();
}

void SceneTextEdit::indentLines(bool outwards) {
  QTextCursor cursor = textCursor();
  if (!cursor.hasSelection() && !outwards) {
    cursor.insertText(QString(kIndentBlanks, QLatin1Char(' ')));
    return;
  }
  QTextBlock block = document()->findBlock(cursor.selectionStart());
  QTextBlock last = document()->findBlock(cursor.selectionEnd());
  // Whole lines are selected up to the begin of the one behind them.
  if (last != block && cursor.selectionEnd() == last.position()) last = last.previous();
  cursor.beginEditBlock();
  for (; block.isValid() && block.blockNumber() <= last.blockNumber(); block = block.next()) {
    QTextCursor begin(block);
    if (!outwards) {
      begin.insertText(QString(kIndentBlanks, QLatin1Char(' ')));
      continue;
    }
    for (int i = 0; i < kIndentBlanks && block.text().startsWith(QLatin1Char(' ')); ++i) begin.deleteChar();
  }
  cursor.endEditBlock();
}

// ---- Proposals

void SceneTextEdit::propose() {
  proposals_->clear();
  if (language_ != nullptr && isXml_) {
    const XmlPlace place = xmlPlaceAt(toPlainText(), textCursor().position());
    wordBegin_ = place.prefixBegin;
    for (const SceneProposal& one : sceneProposals(*language_, place, file_)) {
      auto* item = new QStandardItem(one.shown);
      item->setData(one.text, kTextRole);
      item->setData(one.back, kBackRole);
      item->setToolTip(one.help);
      proposals_->appendRow(item);
    }
  }
  if (proposals_->rowCount() == 0) return completer_->popup()->hide();
  // Proposals that do not begin with the word are left out already.
  completer_->setCompletionPrefix(QString());
  completer_->popup()->setCurrentIndex(completer_->completionModel()->index(0, 0));
  QRect place = cursorRect();
  place.translate(numbersWidth(), 0);
  place.setWidth(
      std::max(kMinProposalWidth, completer_->popup()->sizeHintForColumn(0) +
                                      completer_->popup()->verticalScrollBar()->sizeHint().width()));
  completer_->complete(place);
}

void SceneTextEdit::insert(const QModelIndex& proposal) {
  QTextCursor cursor = textCursor();
  const int end = cursor.position();
  const QString whole = proposal.data(kTextRole).toString();
  const bool isTag = whole.contains(QLatin1String("</"));
  const QString text =
      isTag && goesOnAt(toPlainText(), end) ? proposal.data(Qt::DisplayRole).toString() : whole;
  cursor.beginEditBlock();
  cursor.setPosition(std::min(wordBegin_, end));
  cursor.setPosition(end, QTextCursor::KeepAnchor);
  cursor.insertText(text);
  cursor.endEditBlock();
  if (text == whole) cursor.setPosition(cursor.position() - proposal.data(kBackRole).toInt());
  setTextCursor(cursor);
}

// ---- Line numbers

int SceneTextEdit::numbersWidth() const {
  const int digits = std::max(3, static_cast<int>(QString::number(blockCount()).size()));
  return 2 * kLineNumberMargin + digits * fontMetrics().horizontalAdvance(QLatin1Char('9'));
}

void SceneTextEdit::placeNumbers() {
  setViewportMargins(numbersWidth(), 0, 0, 0);
  const QRect inside = contentsRect();
  numbers_->setGeometry(inside.left(), inside.top(), numbersWidth(), inside.height());
}

void SceneTextEdit::paintNumbers(QPaintEvent& event) {
  QPainter painter(numbers_);
  painter.fillRect(event.rect(), palette().color(QPalette::AlternateBase));
  painter.setFont(font());
  painter.setPen(colorOf(Meaning::kMuted, palette()));
  QTextBlock block = firstVisibleBlock();
  double top = blockBoundingGeometry(block).translated(contentOffset()).top();
  while (block.isValid() && top <= event.rect().bottom()) {
    const double height = blockBoundingRect(block).height();
    if (top + height >= event.rect().top()) {
      painter.drawText(QRectF(0, top, numbers_->width() - kLineNumberMargin, height),
                       Qt::AlignRight | Qt::AlignTop, QString::number(block.blockNumber() + 1));
    }
    top += height;
    block = block.next();
  }
}

void SceneTextEdit::resizeEvent(QResizeEvent* event) {
  MarkedTextEdit::resizeEvent(event);
  placeNumbers();
}

void SceneTextEdit::changeEvent(QEvent* event) {
  MarkedTextEdit::changeEvent(event);
  if (event->type() == QEvent::FontChange && numbers_ != nullptr) placeNumbers();
}

}  // namespace widgets
