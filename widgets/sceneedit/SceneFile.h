// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "robotlink/base/Error.h"
#include "widgets/sceneedit/SceneLanguage.h"
#include "widgets/text/TextPlace.h"

class QTextDocument;

namespace widgets {

/// A scene file that is open in the editor: its text with its history, and what was found wrong in it. A text
/// that was never saved has a path of where it is to be, or none. GUI thread.
class SceneFile final : public QObject {
  Q_OBJECT
 public:
  static constexpr std::size_t kMaxBytes = 16U << 20U;

  explicit SceneFile(QObject* parent);

  /// The document, for a QPlainTextEdit. Undo and redo are its own.
  QTextDocument& document() { return *document_; }
  QString text() const;
  const std::filesystem::path& path() const { return path_; }
  /// Otherwise it is plain text: the map of a building.
  bool isXml() const;
  bool isChanged() const;
  /// The name of the file, also of one that is not there yet: "room.sdf".
  QString name() const;
  /// "room.sdf*"; the star stands for unsaved changes.
  QString title() const;
  /// The name of the model in the running scene that this file is edited for; empty: any.
  const QString& instance() const { return instance_; }
  void setInstance(const QString& instance) { instance_ = instance; }

  /// Reads a file; fails if it cannot be read or is no text in UTF-8.
  robotlink::Result<void> read(const std::filesystem::path& path);
  /// A text that is not in the file. `name`: what a text without a path is called.
  void setUnsaved(const QString& text, const std::filesystem::path& path, const QString& name = {});
  /// Writes the text as a whole or not at all; it is the file's from then on. Fails if another program has
  /// changed the file since it was read, which would be lost.
  robotlink::Result<void> write(const std::filesystem::path& path);
  /// Whether another program has changed the file since it was read or written here.
  bool isChangedOutside() const;
  /// Reads the file again if another program has changed it and the text has no unsaved changes, as one step
  /// of the history; `looks` also if its time is the same. Returns whether it was changed since the last
  /// call.
  bool follow(bool looks);
  /// The text that the file has now, which write() replaces from then on.
  robotlink::Result<QString> readAgain();
  /// Has write() replace what the file has now, whatever that is.
  void allowOverwriting();

  /// Replaces the text as one step of the history of the document; only the part that differs is touched.
  void replaceText(const QString& text);

  /// The problems found by the last check; the first one is for this text if isChecked().
  const std::vector<SceneProblem>& problems() const { return problems_; }
  bool isChecked() const { return checkedRevision_ == revision_; }
  /// Counts the changes of the text.
  int revision() const { return revision_; }
  /// Sets the problems that a check found in the text at a revision.
  void setProblems(std::vector<SceneProblem> problems, int revision);

  /// The place of the editor in the text when it was last shown.
  const TextPlace& place() const { return place_; }
  void setPlace(const TextPlace& place) { place_ = place; }

 Q_SIGNALS:
  void textChanged();
  /// title() changed.
  void titleChanged();
  void problemsChanged();

 private:
  void setText(const QString& text, bool changed);
  void noteSaved(const QString& text);

  QTextDocument* document_;
  std::filesystem::path path_;
  QString name_, instance_;
  /// The text as it is in the file; null: there is none yet.
  QString saved_;
  /// The text that was found in the file last, by whomever it was written.
  QString outside_;
  /// Whether the next write() may overwrite a file that cannot be read as a text.
  bool mayOverwrite_ = false;
  /// When the file was written, as far as that is known.
  std::optional<std::filesystem::file_time_type> savedTime_;
  std::vector<SceneProblem> problems_;
  TextPlace place_;
  int revision_ = 0, checkedRevision_ = -1;
};

/// Replaces the text of a document as one step of its history; only the part that differs is touched, so
/// that cursors elsewhere stay.
void replaceDocumentText(QTextDocument& document, const QString& text);

}  // namespace widgets
