// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonArray>
#include <QJsonObject>
#include <QStringList>
#include <filesystem>

#include "robotlink/base/Error.h"

namespace app {

class ViewDocks;
struct LoadedPlatform;

/// Named window layouts, stored in a JSON file of the user: modified versions of the shipped perspectives
/// (Play, Motion, Processes, Drive, ...) and the user's own. The original of a shipped one is always
/// available. GUI thread.
///
/// If the file cannot be read, it is renamed and reported, and the shipped perspectives are used.
class Perspectives {
 public:
  /// Loads the file, if it exists; see problems().
  explicit Perspectives(std::filesystem::path file);

  /// The shipped perspective that fits what is loaded: Log for logs, Drive for robots on wheels, Play for
  /// other robots; empty if nothing is loaded.
  static QString beginningWith(const LoadedPlatform& loaded);

  /// Problems with the file; empty if there were none.
  const robotlink::Errors& problems() const { return problems_; }

  /// All perspectives, the shipped ones first.
  QStringList names() const;
  bool isShipped(const QString& name) const;
  /// The name of the perspective that is shown.
  const QString& current() const { return current_; }

  /// Shows a perspective as the user left it, or else as it is shipped; the first shipped one if the name is
  /// unknown.
  void show(const QString& name, ViewDocks& docks);
  /// Shows a perspective as it is shipped and discards the user's changes.
  void showShipped(const QString& name, ViewDocks& docks);
  /// Stores the current state of the docks under a name, which becomes the current one.
  void keep(const QString& name, const ViewDocks& docks);
  /// Removes a perspective of the user, or the user's changes of a shipped one.
  void remove(const QString& name);

  /// Writes a kept perspective to a file of its own, which others can read with read(). Fails if there is
  /// none of this name, or it cannot be written.
  robotlink::Result<void> write(const QString& name, const std::filesystem::path& file) const;
  /// Keeps what write() wrote, under its name, or with a number after it where there is one already. Returns
  /// the name, or what is wrong with the file.
  robotlink::Result<QString> read(const std::filesystem::path& file);

  /// The perspective that the user has chosen while this was open; empty: none, or it no longer exists.
  QString chosenFor(const std::string& source) const;
  /// Remembers the current one, for the kMaxSources opened last.
  void chooseFor(const std::string& source);
  static constexpr int kMaxSources = 100;

  /// Keeps the open views of a scene, with what each of them shows, for the kMaxScenes kept last.
  void keepFor(const std::string& scene, const ViewDocks& docks);
  /// Shows the views of a scene as they were kept. False: there are none, or they cannot be used.
  bool showFor(const std::string& scene, ViewDocks& docks);
  /// Whether the views that show() restored are those of a scene, as after a restart with the scene that was
  /// open last; false after the views of a scene were kept, since the shown ones may be different now.
  bool hasRestoredFor(const std::string& scene) const;
  static constexpr int kMaxScenes = 30;

  /// The state of the window itself (geometry, toolbars, recent files), stored in the same file.
  QJsonObject window() const { return window_; }
  void setWindow(QJsonObject window) { window_ = std::move(window); }

  /// Replaces the file atomically if anything changed since the last save.
  robotlink::Result<void> save();

 private:
  /// Reads the file; called once.
  void load();

  std::filesystem::path file_;
  /// The results of ViewDocks::save() by name.
  QJsonObject kept_;
  QJsonObject window_;
  /// Pairs of a scene, log or robot and the name of the perspective that was chosen for it, the newest last.
  QJsonArray chosen_;
  /// Triples of a scene, the name of its perspective and its views, the newest last.
  QJsonArray scenes_;
  QString current_;
  /// The views that show() has restored; empty: none, or they may have changed.
  QJsonObject restored_;
  /// The contents of the file at the last save.
  QByteArray saved_;
  robotlink::Errors problems_;
};

}  // namespace app
