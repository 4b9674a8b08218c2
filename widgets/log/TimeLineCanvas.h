// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractScrollArea>
#include <QPixmap>
#include <functional>

#include "widgets/log/TimeLineLayout.h"

class QLineEdit;

namespace widgets {

/// A time line that a person works on. It shows what it is given and says what is wanted; it changes none of
/// it itself, but for what is seen (zoom, pan, scrolling). GUI thread.
///
/// Mouse: in the ruler and on the images, press and drag move the play head at once; elsewhere a click moves
/// it (to the nearest message of the row), and dragging selects a range, with Shift everywhere. The ends of
/// the range, bookmarks and a band's offset are dragged. The wheel zooms at the cursor, with Shift it pans,
/// over the names it scrolls; the middle button pans. A double click edits a bookmark's text or an offset in
/// place, or chooses a stream whose messages are stepped. Keys: F2 edits and Delete removes the chosen
/// bookmark, Escape drops the range; what is not used goes on to the parent.
class TimeLineCanvas final : public QAbstractScrollArea {
  Q_OBJECT
 public:
  explicit TimeLineCanvas(QWidget* parent = nullptr);

  void setBands(std::vector<TimeLineBand> bands);
  const std::vector<TimeLineBand>& bands() const { return bands_; }
  /// Of all logs; the first one is fitted.
  void setExtent(robotlink::Instant begin, robotlink::Instant end);
  /// What is shown as 0 s.
  void setOrigin(robotlink::Instant time);
  void setShown(robotlink::Instant time);
  void setRange(std::optional<std::pair<robotlink::Instant, robotlink::Instant>> range);
  void setSteppedStream(int band, const std::string& path);
  /// The play head stays in sight.
  void setFollow(bool on);
  void chooseBookmark(int band, std::uint64_t id);

  const TimeLineLook& look() const { return look_; }
  TimeLineLayout layout() const { return layOut(bands_, look_); }
  void fit();
  void zoom(double factor);
  void showRange(robotlink::Instant from, robotlink::Instant to);
  void editBookmark(int band, std::uint64_t id);
  /// Times of the images that are seen and not yet there, for a log's reader.
  std::vector<robotlink::Instant> missingThumbnails(int band) const;

 Q_SIGNALS:
  void jumpWanted(robotlink::Instant time);
  void rangeWanted(robotlink::Instant from, robotlink::Instant to);
  void rangeDropped();
  void streamChosen(int band, const std::string& path);
  void bookmarkChosen(int band, std::uint64_t id);
  void bookmarkWanted(int band, robotlink::Instant time);
  void bookmarkChanged(int band, const logplayer::Bookmark& bookmark);
  void bookmarkDropped(int band, std::uint64_t id);
  void offsetWanted(int band, robotlink::Duration offset);
  void collapseWanted(int band, bool collapsed);
  /// Other times are seen.
  void looked();

 protected:
  bool viewportEvent(QEvent* event) override;
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void mouseDoubleClickEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;
  void scrollContentsBy(int dx, int dy) override;

 private:
  /// What a press of the left button began.
  enum class Drag : std::uint8_t { kNone, kScrub, kPan, kSelect, kRangeEdge, kBookmark, kOffset };
  struct Hit {
    Drag drag = Drag::kNone;
    int band = -1;
    std::uint64_t bookmark = 0;
    bool upper = false;  ///< of kRangeEdge: the later one
  };

  TimeLineBand& band(int index) { return bands_[static_cast<std::size_t>(index)]; }
  const TimeLineBand& band(int index) const { return bands_[static_cast<std::size_t>(index)]; }
  void measure();
  void lookAnew();
  void setFrom(robotlink::Instant from);
  void updateScrollBars();
  void keepShownInSight();
  robotlink::Instant timeAt(const QPointF& point) const;
  robotlink::Instant snappedTimeAt(const QPointF& point) const;
  Hit hitAt(const QPointF& point, Qt::KeyboardModifiers modifiers) const;
  std::uint64_t bookmarkAt(const TimeLineLayout::Lane& lane, const QPointF& point) const;
  void pressGutter(const TimeLineLayout::Lane& lane, const QPointF& point);
  void dragBookmark(const QPointF& point);
  void releaseSelection(const QPointF& point);
  void editOffset(int band);
  QLineEdit* openEditor(const char* name, const QRect& where, const QString& text,
                        std::function<void(const QString&)> done);
  QString toolTipAt(const QPointF& point) const;
  QString timeToolTip(robotlink::Instant time) const;
  QString saidNear(const TimeLineBand& of, robotlink::Instant time) const;
  QString bookmarkToolTip(const TimeLineBand& of, const logplayer::Bookmark& bookmark) const;
  void updateCursor(const QPointF& point, Qt::KeyboardModifiers modifiers);

  std::vector<TimeLineBand> bands_;
  TimeLineLook look_;
  QPixmap still_;  // all but the play head; null: to be painted anew
  bool extentKnown_ = false;
  bool settingBars_ = false;
  bool fitted_ = true;  // until somebody zooms or pans
  bool follow_ = true;
  Hit held_;
  bool moved_ = false;
  QPointF pressedAt_, lastAt_;
  logplayer::Bookmark heldBookmark_;  // as it was when it was pressed
  robotlink::Duration heldOffset_{0};
};

}  // namespace widgets
