// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QString>
#include <QStringList>
#include <map>

class QLineEdit;
class QListWidget;
class QTextBrowser;

namespace app {

/// The manual: the pages of resources/manual, which are Markdown, with a list of them, search, and back and
/// forward. It stays open beside the window. GUI thread.
class ManualWindow final : public QDialog {
  Q_OBJECT
 public:
  /// `folder` has the pages; index.md is the first.
  ManualWindow(const QString& folder, QWidget* window);

  /// Shows a page, "plots", or the first one if there is none of this name.
  void showPage(const QString& name);

 private:
  /// A page of the manual.
  struct Page {
    QString title, text;
  };
  void readPages(const QString& folder);
  void createWidgets(const QString& folder);
  /// Lists the pages that have all words.
  void filter(const QString& words);
  /// Selects the page that is shown, which a link may have changed.
  void followPage();

  /// Keyed by their names, "plots".
  std::map<QString, Page> pages_;
  /// The name of the page that is shown.
  QString shown_;
  QLineEdit* search_ = nullptr;
  QListWidget* list_ = nullptr;
  QTextBrowser* browser_ = nullptr;
};

/// The name of the manual's page for a widget: the id of the view that it belongs to, or "index".
QString manualPageOf(const QWidget* widget);

}  // namespace app
