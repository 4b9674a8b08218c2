// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "widgets/View.h"
#include "widgets/log/LogJob.h"
#include "widgets/log/OpenLogs.h"

class QAction;
class QComboBox;
class QLabel;
class QMenu;
class QToolButton;

namespace widgets {

class EmptyHint;
class LogDamageBar;
class LogJobBar;
class TimeLineCanvas;

/// The replay's logs over time: images, messages, warnings and errors, bookmarks, the play head and a range,
/// which can be played in a loop, cut into a new log, or exported. What is long is done in threads, with
/// progress and cancel.
class TimeLineView final : public View {
  Q_OBJECT
 public:
  explicit TimeLineView(ViewContext& context, QWidget* parent = nullptr);
  void tick() override;
  QJsonObject saveState() const override;
  void restoreState(const QJsonObject& state) override;

 protected:
  void keyPressEvent(QKeyEvent* event) override;
  void contextMenuEvent(QContextMenuEvent* event) override;

 private:
  void createActions();
  void createRangeActions();
  void createViews();
  QWidget* createBar();
  void connectSignals();
  void connectBookmarks();
  OpenLogs::Log* logAt(int band);
  void showBands();
  void showRange();
  void showImageStreams();
  void showDamage();
  void wantThumbnails();
  void chooseStream(int band, const std::string& path);
  void showSteppedStream();
  void addBookmark(int band, robotlink::Instant time);
  void loopRange();
  void cut();
  void exportImages();
  void exportTable();
  void exportTexts();
  void repair(const QString& log);
  /// The range in a log's own times.
  std::optional<std::pair<robotlink::Instant, robotlink::Instant>> rangeOf(const OpenLogs::Log& log) const;
  QString suggested(const OpenLogs::Log& log, const QString& suffix) const;
  /// `folder`: asks for one, instead of a file.
  struct FileQuestion {
    const char* name;
    QString title, suggestion, filter;
    bool folder = false;
  };
  void askForFile(const FileQuestion& question, std::function<void(const QString&)> chosen);

  OpenLogs& logs_;
  TimeLineCanvas* canvas_ = nullptr;
  EmptyHint* hint_ = nullptr;
  LogJobBar* job_ = nullptr;
  LogDamageBar* damage_ = nullptr;
  QComboBox* images_ = nullptr;
  QLabel* range_ = nullptr;
  QAction* bookmark_ = nullptr;
  QAction* undo_ = nullptr;
  QAction* redo_ = nullptr;
  QAction* zoomIn_ = nullptr;
  QAction* zoomOut_ = nullptr;
  QAction* fit_ = nullptr;
  QAction* follow_ = nullptr;
  QAction* loop_ = nullptr;
  QAction* cut_ = nullptr;
  QAction* export_ = nullptr;
  QAction* clear_ = nullptr;
  QMenu* exportMenu_ = nullptr;
  std::uint64_t shownVersion_ = 0;
};

}  // namespace widgets
