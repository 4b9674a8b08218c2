// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QJsonObject>
#include <QStringList>
#include <filesystem>

#include "robotlink/base/Error.h"

namespace app {

class ViewDocks;
struct LoadedPlatform;

/// Named window layouts, in a text file of the user's: what he made of the shipped ones, and his own. The
/// shipped ones (Play, Motion, Processes, Drive, ...) can always be had again. GUI thread.
///
/// A file that cannot be understood is set aside under another name and reported; the shipped ones are used
/// then.
class Perspectives {
 public:
  explicit Perspectives(std::filesystem::path file);

  /// The shipped one in which people begin with what is loaded: Log for logs, Drive for robots on wheels,
  /// Play for others; empty for nothing.
  static QString beginningWith(const LoadedPlatform& loaded);

  /// What was wrong with the file, if anything.
  const robotlink::Errors& problems() const { return problems_; }

  QStringList names() const;
  bool isShipped(const QString& name) const;
  const QString& current() const { return current_; }

  /// Shows a perspective: as it was left, or as it is shipped.
  void show(const QString& name, ViewDocks& docks);
  /// As it is shipped, forgetting what the user made of it.
  void showShipped(const QString& name, ViewDocks& docks);
  /// Keeps the docks' present state under a name, which becomes the current one.
  void keep(const QString& name, const ViewDocks& docks);
  void remove(const QString& name);

  /// The window's own state (geometry, toolbars), kept along.
  QJsonObject window() const { return window_; }
  void setWindow(QJsonObject window) { window_ = std::move(window); }

  /// Writes the file if anything has changed since the last time.
  robotlink::Result<void> save();

 private:
  void load();

  std::filesystem::path file_;
  QJsonObject kept_;  // name -> ViewDocks::save()
  QJsonObject window_;
  QString current_;
  QByteArray saved_;
  robotlink::Errors problems_;
};

}  // namespace app
