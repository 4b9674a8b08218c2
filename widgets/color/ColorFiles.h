// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>
#include <vector>

#include "robotlink/base/Error.h"
#include "widgets/View.h"

class QWidget;

namespace widgets {

class ColorBench;
class ColorRecovery;
class PictureReading;

/// The files of the colour table that is being made: its samples, exported tables, a table to compare with.
/// Knows which file the samples are from and whether they were changed since. Asks nothing: what asks a
/// person is in ColorFileDialogs.
///
/// After startRecovery() samples that are not saved are kept, two seconds after a change, in a file in the
/// user's folder, and come back at the next start if this program does not end well.
///
/// tick() is called 30 times a second. GUI thread; belongs to the bench.
class ColorFiles final : public QObject {
  Q_OBJECT
 public:
  explicit ColorFiles(ColorBench& bench);
  ~ColorFiles() override;

  ColorBench& bench() const { return bench_; }
  /// The file of the samples; empty: they have none yet.
  const std::filesystem::path& file() const { return file_; }
  /// Whether something would be lost.
  bool changed() const;
  /// "game.samples*".
  QString title() const;

  /// Samples of the preset's classes and without strokes. What was there goes.
  void startAnew();
  /// What was there goes. Where only a part can be read, that part is opened without a name, so that it
  /// cannot take the place of the damaged file, and told() says what is wrong.
  robotlink::Result<void> open(const std::filesystem::path& file);
  /// To the file they are from; fails if there is none.
  robotlink::Result<void> save();
  robotlink::Result<void> saveAs(const std::filesystem::path& file);
  /// Adds the samples of another file, as a step that can be undone.
  robotlink::Result<void> merge(const std::filesystem::path& file);
  /// The table as a .c64 file, with the names of its classes beside it. `several`: cells where classes come
  /// close are of all of them.
  robotlink::Result<void> exportTable(const std::filesystem::path& file, bool several);
  /// A table to compare with, of any format that can be imported.
  robotlink::Result<void> importReference(const std::filesystem::path& file);
  /// Reads pictures, from files and folders, to be painted in; beside all else. They are put aside, the first
  /// is shown, and told() or the bench's failed() says what came of it, after some calls of tick().
  void openPictures(const std::vector<std::filesystem::path>& filesOrFolders);
  /// What is not saved may go: nothing of it comes back.
  void discard();

  /// Where files were last read or written, for dialogs.
  const QString& folder() const { return folder_; }
  void setFolder(const QString& folder) { folder_ = folder; }

  /// What was told or failed last, for views that were not there; empty at first.
  struct Message {
    QString text;
    bool bad = false;
  };
  const Message& message() const { return message_; }

  /// Keeps what is not saved in `folder`, and brings back what was left there.
  void startRecovery(const std::filesystem::path& folder);
  void tick();
  /// Writes now what tick() would write later, and waits for it.
  void keepNow();

 Q_SIGNALS:
  void titleChanged(const QString& title);
  /// Something was done, or done in part.
  void told(const QString& text);

 private:
  void followChanges();
  void takePictures();
  void setFile(const std::filesystem::path& file);
  void remember(const std::filesystem::path& file);
  void tell(const QString& text);
  void fail(const QString& reason);
  void show(const robotlink::Errors& problems, const QString& what);

  ColorBench& bench_;
  std::filesystem::path file_;
  QString folder_;
  Message message_;
  std::unique_ptr<ColorRecovery> recovery_;
  std::unique_ptr<PictureReading> pictures_;
  std::vector<std::filesystem::path> nextPictures_;  ///< were asked for while others were read
  int ticksUnkept_ = 0;  ///< since the first change that is not kept; 0: there is none
  bool kept_ = false;    ///< there is something in the recovery's file
};

/// Those of a window; made when they are first asked for.
ColorFiles& colorFiles(ViewContext& context);

}  // namespace widgets
