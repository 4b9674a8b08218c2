// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/actions/ManualWindow.h"

#include <qtadvanceddocking/DockWidget.h>
#include <QDir>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QScreen>
#include <QSplitter>
#include <QTextBrowser>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>
#include <vector>

#include "widgets/Controls.h"

namespace app {
namespace {

constexpr char kFirst[] = "index", kSuffix[] = ".md";
constexpr QSize kManualSize{960, 720};

QString nameIn(const QUrl& url) {
  QString name = url.fileName();
  if (name.endsWith(QLatin1String(kSuffix))) name.chop(static_cast<int>(sizeof kSuffix) - 1);
  return name;
}

/// The first heading of a page.
QString titleIn(const QString& text, const QString& fallback) {
  for (const QString& line : text.split(QLatin1Char('\n'))) {
    if (line.startsWith(QLatin1String("# "))) return line.mid(2).trimmed();
  }
  return fallback;
}

}  // namespace

QString manualPageOf(const QWidget* widget) {
  for (const QObject* object = widget; object != nullptr; object = object->parent()) {
    if (qobject_cast<const ads::CDockWidget*>(object) != nullptr)
      return object->objectName().section(QLatin1Char('#'), 0, 0);
  }
  return QLatin1String(kFirst);
}

ManualWindow::ManualWindow(const QString& folder, QWidget* window) : QDialog(window) {
  setObjectName(QStringLiteral("manual"));
  setWindowTitle(tr("Manual of RobotControl"));
  setWindowFlag(Qt::WindowMaximizeButtonHint);
  readPages(folder);
  createWidgets(folder);
  filter({});
  resize(kManualSize.boundedTo(window->screen()->availableSize() * 0.9));
}

void ManualWindow::readPages(const QString& folder) {
  const QStringList files = QDir(folder).entryList({QLatin1Char('*') + QLatin1String(kSuffix)}, QDir::Files);
  for (const QString& name : files) {
    QFile file(folder + QLatin1Char('/') + name);
    if (!file.open(QIODevice::ReadOnly)) continue;
    Page page{{}, QString::fromUtf8(file.readAll())};
    const QString key = nameIn(QUrl::fromLocalFile(name));
    page.title = titleIn(page.text, key);
    pages_.emplace(key, std::move(page));
  }
}

void ManualWindow::createWidgets(const QString& folder) {
  search_ = widgets::makeSearchField(
      this, {"manualSearch", tr("Search"), tr("Lists only pages that contain these words")});
  list_ = new QListWidget(this);
  widgets::describe(*list_, {"manualPages", tr("Pages"), {}});
  browser_ = new QTextBrowser(this);
  widgets::describe(*browser_, {"manualText", tr("Page of the manual"), {}});
  browser_->setSearchPaths({folder});
  browser_->setOpenExternalLinks(true);
  auto* back = widgets::makeAction(
      this, "previous",
      {"manualBack", tr("Back"), tr("Shows the previous page"), QKeySequence(QStringLiteral("Alt+Left"))});
  auto* forward = widgets::makeAction(
      this, "next",
      {"manualForward", tr("Forward"), tr("Shows the next page"), QKeySequence(QStringLiteral("Alt+Right"))});
  back->setEnabled(false);
  forward->setEnabled(false);
  connect(back, &QAction::triggered, browser_, &QTextBrowser::backward);
  connect(forward, &QAction::triggered, browser_, &QTextBrowser::forward);
  connect(browser_, &QTextBrowser::backwardAvailable, back, &QAction::setEnabled);
  connect(browser_, &QTextBrowser::forwardAvailable, forward, &QAction::setEnabled);
  connect(browser_, &QTextBrowser::sourceChanged, this, [this](const QUrl& url) {
    shown_ = nameIn(url);
    followPage();
  });
  connect(search_, &QLineEdit::textChanged, this, &ManualWindow::filter);
  connect(list_, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item != nullptr) showPage(item->data(Qt::UserRole).toString());
  });
  auto* row = new QHBoxLayout;
  row->addWidget(widgets::makeButton(this, back));
  row->addWidget(widgets::makeButton(this, forward));
  row->addWidget(search_, 1);
  auto* layout = new QVBoxLayout(this);
  layout->addLayout(row);
  layout->addWidget(
      widgets::makeSplitter(this, "manualSplitter", Qt::Horizontal, {{list_, 1}, {browser_, 3}}), 1);
}

void ManualWindow::filter(const QString& words) {
  const QStringList wanted = words.split(QLatin1Char(' '), Qt::SkipEmptyParts);
  const QSignalBlocker silent(list_);
  list_->clear();
  const auto add = [&](const QString& name, const Page& page) {
    for (const QString& word : wanted) {
      if (!page.text.contains(word, Qt::CaseInsensitive)) return;
    }
    auto* item = new QListWidgetItem(page.title, list_);
    item->setData(Qt::UserRole, name);
  };
  const auto first = pages_.find(QLatin1String(kFirst));
  if (first != pages_.end()) add(first->first, first->second);
  std::vector<decltype(pages_)::const_iterator> others;
  for (auto page = pages_.begin(); page != pages_.end(); ++page) {
    if (page != first) others.push_back(page);
  }
  std::ranges::sort(others, {}, [](const auto& page) { return page->second.title; });
  for (const auto& page : others) add(page->first, page->second);
  followPage();
}

void ManualWindow::showPage(const QString& name) {
  const QString known = pages_.contains(name) ? name : QLatin1String(kFirst);
  const auto isListed = [this, &known] {
    for (int row = 0; row < list_->count(); ++row)
      if (list_->item(row)->data(Qt::UserRole).toString() == known) return true;
    return false;
  };
  // An earlier search must not hide the requested page.
  if (!isListed()) search_->clear();
  if (shown_ == known) return;
  browser_->setSource(QUrl(known + QLatin1String(kSuffix)), QTextDocument::MarkdownResource);
}

void ManualWindow::followPage() {
  const QSignalBlocker silent(list_);
  list_->setCurrentItem(nullptr);
  for (int row = 0; row < list_->count(); ++row) {
    if (list_->item(row)->data(Qt::UserRole).toString() == shown_) list_->setCurrentRow(row);
  }
}

}  // namespace app
