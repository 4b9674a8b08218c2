// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/sceneedit/SceneFile.h"

#include <QPlainTextDocumentLayout>
#include <QTextCursor>
#include <QTextDocument>
#include <algorithm>
#include <utility>

#include "robotlink/base/AtomicFile.h"
#include "robotlink/base/FileSuffix.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

namespace {

Result<QString> textOfFile(const std::filesystem::path& path) {
  const auto bytes = robotlink::readFile(path, SceneFile::kMaxBytes);
  if (!bytes) return tl::unexpected(bytes.error());
  const QByteArray read(bytes->data(), static_cast<int>(bytes->size()));
  QString text = QString::fromUtf8(read);
  if (text.toUtf8() != read)
    return failure("scene.encoding",
                   "the file is not UTF-8 text, so it cannot be edited here; save it in UTF-8 with another "
                   "program, or write another text over it",
                   {path.string(), 0, 0});
  text.remove(QLatin1Char('\r'));
  return text;
}

std::optional<std::filesystem::file_time_type> timeOfFile(const std::filesystem::path& path) {
  std::error_code unknown;
  const auto time = std::filesystem::last_write_time(path, unknown);
  return unknown ? std::nullopt : std::optional(time);
}

}  // namespace

SceneFile::SceneFile(QObject* parent) : QObject(parent), document_(new QTextDocument(this)) {
  document_->setDocumentLayout(new QPlainTextDocumentLayout(document_));
  connect(document_, &QTextDocument::contentsChange, this, [this](int, int removed, int added) {
    if (removed == 0 && added == 0) return;
    ++revision_;
    Q_EMIT textChanged();
  });
  connect(document_, &QTextDocument::modificationChanged, this, &SceneFile::titleChanged);
}

QString SceneFile::text() const {
  return document_->toPlainText();
}

bool SceneFile::isXml() const {
  return robotlink::fileSuffix(path_) != ".map";
}

bool SceneFile::isChanged() const {
  return document_->isModified();
}

QString SceneFile::name() const {
  if (!path_.empty()) return QString::fromStdString(path_.filename().string());
  return name_.isEmpty() ? tr("unnamed.sdf") : name_;
}

QString SceneFile::title() const {
  return isChanged() ? name() + QLatin1Char('*') : name();
}

void SceneFile::setText(const QString& text, bool changed) {
  document_->setPlainText(text);
  document_->setModified(changed);
  Q_EMIT titleChanged();
}

Result<void> SceneFile::read(const std::filesystem::path& path) {
  const auto text = textOfFile(path);
  if (!text) return tl::unexpected(text.error());
  path_ = path;
  noteSaved(*text);
  setText(*text, false);
  return {};
}

void SceneFile::noteSaved(const QString& text) {
  saved_ = outside_ = text;
  savedTime_ = timeOfFile(path_);
}

void SceneFile::allowOverwriting() {
  if (!readAgain()) mayOverwrite_ = true;
}

Result<QString> SceneFile::readAgain() {
  auto text = textOfFile(path_);
  if (text) noteSaved(*text);
  return text;
}

bool SceneFile::isChangedOutside() const {
  if (saved_.isNull() || !timeOfFile(path_)) return false;
  const auto text = textOfFile(path_);
  return !text || *text != saved_;
}

bool SceneFile::follow(bool looks) {
  const auto time = timeOfFile(path_);
  // A text that was found while there were unsaved changes is read once there are none.
  const bool isDue = !isChanged() && outside_ != saved_;
  if (saved_.isNull() || !time || (!looks && !isDue && time == savedTime_)) return false;
  savedTime_ = time;
  const auto text = textOfFile(path_);
  if (!text) return false;
  const bool isNew = std::exchange(outside_, *text) != *text;
  if (*text == saved_) return false;
  if (isChanged()) return isNew;
  saved_ = *text;
  replaceText(*text);
  return true;
}

void SceneFile::setUnsaved(const QString& text, const std::filesystem::path& path, const QString& name) {
  path_ = path;
  name_ = name;
  setText(text, true);
}

Result<void> SceneFile::write(const std::filesystem::path& path) {
  const bool mayOverwrite = std::exchange(mayOverwrite_, false);
  if (path == path_ && !mayOverwrite && isChangedOutside())
    return failure("scene.changed-outside",
                   "the file was changed by another program since it was read here; save under another name "
                   "(scene.save FILE), or discard the changes to reload it",
                   {path.string(), 0, 0});
  const QByteArray bytes = text().toUtf8();
  const std::string_view contents(bytes.constData(), static_cast<std::size_t>(bytes.size()));
  if (const auto done = robotlink::writeFileAtomically(path, contents); !done) return done;
  path_ = path;
  noteSaved(text());
  document_->setModified(false);
  Q_EMIT titleChanged();
  return {};
}

void SceneFile::replaceText(const QString& text) {
  replaceDocumentText(*document_, text);
  // A text that equals the saved one again needs no question.
  if (!saved_.isNull() && text == saved_) document_->setModified(false);
}

void replaceDocumentText(QTextDocument& document, const QString& after) {
  const QString before = document.toPlainText();
  const int shorter = std::min(after.size(), before.size());
  int same = 0, sameEnd = 0;
  while (same < shorter && after[same] == before[same]) ++same;
  while (sameEnd < shorter - same && after[after.size() - 1 - sameEnd] == before[before.size() - 1 - sameEnd])
    ++sameEnd;
  QTextCursor cursor(&document);
  cursor.beginEditBlock();
  cursor.setPosition(same);
  cursor.setPosition(before.size() - sameEnd, QTextCursor::KeepAnchor);
  cursor.insertText(after.mid(same, after.size() - same - sameEnd));
  cursor.endEditBlock();
}

void SceneFile::setProblems(std::vector<SceneProblem> problems, int revision) {
  checkedRevision_ = revision;
  if (problems == problems_) return;
  problems_ = std::move(problems);
  Q_EMIT problemsChanged();
}

}  // namespace widgets
