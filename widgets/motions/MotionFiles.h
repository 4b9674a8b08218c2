// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <filesystem>
#include <memory>

#include "robotlink/base/Error.h"
#include "widgets/View.h"

class QWidget;

namespace widgets {

class MotionBench;
class RecoveryFile;

/// The file of the motion that is edited, and whether it has unsaved changes. Motions of other teams are
/// imported: they are open without a file, and unsaved. It opens no dialogs but those of the functions below.
///
/// After startRecovery(), an unsaved motion is written to a recovery file in the user's folder two seconds
/// after a change, and is restored at the next start if this program does not end properly.
///
/// tick() is called 30 times a second. GUI thread; owned by the bench.
class MotionFiles final : public QObject {
  Q_OBJECT
 public:
  explicit MotionFiles(MotionBench& bench);
  ~MotionFiles() override;

  MotionBench& bench() const { return bench_; }
  /// Empty: the motion has none yet.
  const std::filesystem::path& file() const { return file_; }
  /// Whether there are unsaved changes.
  bool changed() const;
  /// "kick-left.mof*"; the star stands for unsaved changes. Empty: there is no motion.
  QString title() const;
  /// The folder of the last file that was read or written, at first that of the robots' motions; where
  /// dialogs start.
  std::filesystem::path folder() const;

  /// Replaces the motion by a new one with the joints of the selected robot; unsaved changes are lost. Fails
  /// if it is no name.
  robotlink::Result<void> startAnew(const std::string& name);
  /// Replaces the motion by that of a file (.mof, or one to import: .pos, .mot); unsaved changes are lost. A
  /// text with errors is opened, too: it is edited.
  robotlink::Result<void> open(const std::filesystem::path& file);
  /// Replaces the motion by one that the selected robot's program has; it has no file then.
  robotlink::Result<void> openFromRobot(const std::string& name);
  /// Writes the motion to its file; fails if there is none.
  robotlink::Result<void> save();
  /// Writes the motion to a file, which is its own from then on.
  robotlink::Result<void> saveAs(const std::filesystem::path& file);
  /// Reads the file again, or starts over without a motion if there is none.
  robotlink::Result<void> discardChanges();
  /// The unsaved motion may be lost: deletes its recovery file.
  void forget();

  /// Keeps recovery files in `folder` from now on, and restores what was left there.
  void startRecovery(const std::filesystem::path& folder);
  void tick();
  /// Writes unsaved changes to the recovery file now and waits until that is done.
  void keepNow();

 Q_SIGNALS:
  /// title() changed.
  void titleChanged();
  /// Something was done; or could not be done.
  void reported(const QString& text, bool bad);

 private:
  void setMotion(std::string text, const std::filesystem::path& file, bool changed);

  MotionBench& bench_;
  std::filesystem::path file_, folder_;
  /// Null before startRecovery().
  std::unique_ptr<RecoveryFile> recovery_;
  /// Ticks since the first change that is not in the recovery file; 0: there is none.
  int ticksUnkept_ = 0;
  bool isKept_ = false;
};

/// The files of a window, created on the first call.
MotionFiles& motionFiles(ViewContext& context);

// Dialogs. Each returns whether it was done; what fails is reported.
/// Saves the motion, and asks for a file if it has none.
bool saveMotion(MotionFiles& files, QWidget* parent);
bool saveMotionAs(MotionFiles& files, QWidget* parent);
bool openMotion(MotionFiles& files, QWidget* parent);
/// Asks whether unsaved changes shall be saved; false: the user wants to continue editing.
bool mayLoseMotion(MotionFiles& files, QWidget* parent);

}  // namespace widgets
