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

/// The files of the color tool: samples, exported tables, reference tables, pictures. It knows the file of
/// the samples and whether they have unsaved changes. It opens no dialogs; ColorFileActions does.
///
/// After startRecovery(), unsaved samples are written to a recovery file in the user's folder two seconds
/// after a change, and are restored at the next start if this program does not end properly.
///
/// tick() is called 30 times a second. GUI thread; owned by the bench. Failing functions return errors that
/// name the file; damage reports and successes are signals.
class ColorFiles final : public QObject {
  Q_OBJECT
 public:
  explicit ColorFiles(ColorBench& bench);
  ~ColorFiles() override;

  ColorBench& bench() const { return bench_; }
  /// The file of the samples; empty: they have none yet.
  const std::filesystem::path& file() const { return file_; }
  /// Whether there are unsaved changes.
  bool changed() const;
  /// "game.samples*"; the star stands for unsaved changes.
  QString title() const;

  /// Replaces the samples by an empty set with the classes of the first preset; unsaved changes are lost.
  void startAnew();
  /// Replaces the samples by those of a file; unsaved changes are lost. If only a part can be read, it is
  /// opened without a name, so that saving cannot overwrite the damaged file, and the bench's failed() gives
  /// the damage report.
  robotlink::Result<void> open(const std::filesystem::path& file);
  /// Writes the samples to their file; fails if there is none.
  robotlink::Result<void> save();
  /// Writes the samples to a file, which is theirs from then on.
  robotlink::Result<void> saveAs(const std::filesystem::path& file);
  /// Adds the samples of another file, as one step that can be undone.
  robotlink::Result<void> merge(const std::filesystem::path& file);
  /// Writes the table as a .c64 file, with a file of the names of its classes. `several`: cells in which
  /// other classes have at least 70 % of the best one's votes belong to all of them.
  robotlink::Result<void> exportTable(const std::filesystem::path& file, bool several);
  /// Reads a table of any format that can be imported and makes it the reference.
  robotlink::Result<void> importReference(const std::filesystem::path& file);
  /// Reads pictures from files and folders in a thread. When they are read (some calls of tick() later) they
  /// are collected, the first is shown, and reported() or the bench's failed() reports the result. Further
  /// calls are queued.
  void openPictures(const std::vector<std::filesystem::path>& filesOrFolders);
  /// The unsaved samples may be lost: deletes their recovery file.
  void discard();

  /// The folder of the last file that was read or written; where dialogs start.
  const QString& folder() const { return folder_; }
  /// Sets the folder of dialogs as long as no file was read or written.
  void proposeFolder(const QString& folder) {
    if (folder_.isEmpty()) folder_ = folder;
  }

  /// The last text of reported() or of the bench's failed(), for views that are opened later; empty at first.
  struct Message {
    QString text;
    bool bad = false;
  };
  const Message& message() const { return message_; }

  /// Keeps recovery files in `folder` from now on, and restores what was left there.
  void startRecovery(const std::filesystem::path& folder);
  void tick();
  /// Writes unsaved changes to the recovery file now and waits until that is done.
  void keepNow();

 Q_SIGNALS:
  /// title() changed.
  void titleChanged(const QString& title);
  /// Something was done, or done in part.
  void reported(const QString& text);

 private:
  /// Writes or deletes the recovery file.
  void followChanges();
  /// Takes over pictures that were read.
  void takePictures();
  /// Sets the file of the samples (which match it now) and drops the recovery file.
  void setFile(const std::filesystem::path& file);
  /// Sets folder().
  void remember(const std::filesystem::path& file);
  void report(const QString& text);
  void fail(const QString& reason);
  /// Reports the first dozen problems by the bench's failed().
  void show(const robotlink::Errors& problems, const QString& what);

  ColorBench& bench_;
  std::filesystem::path file_;
  QString folder_;
  Message message_;
  /// Null before startRecovery().
  std::unique_ptr<ColorRecovery> recovery_;
  /// Null while no pictures are being read.
  std::unique_ptr<PictureReading> pictures_;
  /// Requested while others are being read.
  std::vector<std::filesystem::path> nextPictures_;
  /// Ticks since the first change that is not in the recovery file; 0: there is none.
  int ticksUnkept_ = 0;
  /// Whether the recovery file holds something.
  bool kept_ = false;
};

/// The files of a window, created on the first call.
ColorFiles& colorFiles(ViewContext& context);

}  // namespace widgets
