// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractScrollArea>
#include <QPixmap>
#include <functional>

#include "widgets/timeline/TimeLineLayout.h"

class QLineEdit;

namespace widgets {

/// Paints a timeline and turns mouse and keys into signals. It changes nothing of what it shows but the
/// visible part (zoom, pan, scrolling). Bands are numbered from 0 in the order of setBands(). Times in
/// signals are those of the timeline unless said otherwise. GUI thread.
///
/// Mouse: in the ruler and on the images, pressing and dragging moves the play head at once; elsewhere a
/// click moves it (to the nearest message of the row), and dragging selects a range, with Shift everywhere.
/// The ends of the range, bookmarks and a band's offset can be dragged. The wheel zooms at the cursor, with
/// Shift it pans, over the names it scrolls; the middle button pans. A double click edits a bookmark's text
/// or an offset in place, or chooses the stream whose messages are stepped. Keys: F2 edits and Delete removes
/// the chosen bookmark, Escape drops the range; other keys go to the parent.
///
/// TimeLineMouse.cpp defines the reaction to mouse and keys, TimeLineMarks.cpp what is marked in the ruler.
class TimeLineCanvas final : public QAbstractScrollArea {
  Q_OBJECT
 public:
  explicit TimeLineCanvas(QWidget* parent = nullptr);

  /// The logs; repainted only if something changed.
  void setBands(std::vector<TimeLineBand> bands);
  const std::vector<TimeLineBand>& bands() const { return bands_; }
  /// Beginning and end of all logs. The first extent is fitted.
  void setExtent(robotlink::Instant begin, robotlink::Instant end);
  /// The instant shown as 0 s.
  void setOrigin(robotlink::Instant time);
  /// The position of the play head; ignored while it is dragged.
  void setShown(robotlink::Instant time);
  /// The selected range; unset: none. Ignored while it is dragged.
  void setRange(std::optional<std::pair<robotlink::Instant, robotlink::Instant>> range);
  /// The stream whose messages are stepped.
  void setSteppedStream(int band, const std::string& path);
  /// Whether the play head is kept in sight.
  void setFollow(bool on);
  /// Whether the play head can be dragged everywhere, since there are no ranges to be selected.
  void setScrubsEverywhere(bool on);
  /// Marks in the ruler where texts are, and what a search found, each in order of time.
  void setMarks(std::vector<TimeMark> texts, std::vector<TimeMark> hits);
  /// Marks a bookmark as the chosen one.
  void chooseBookmark(int band, std::uint64_t id);

  const TimeLineLook& look() const { return look_; }
  TimeLineLayout layout() const { return layOut(bands_, look_); }
  /// Shows all logs, and keeps them fitted until the user zooms or pans.
  void fit();
  /// Zooms around the play head if it is in sight, else around the middle.
  void zoom(double factor);
  /// Shows these times with a small margin.
  void showRange(robotlink::Instant from, robotlink::Instant to);
  /// Opens an editor for a bookmark's text.
  void editBookmark(int band, std::uint64_t id);
  /// The time of the nearest message in the row at a point of the viewport, else of the point.
  robotlink::Instant snappedTimeAt(const QPointF& point) const;
  /// Times of the visible thumbnails that are missing, in the log's own times.
  std::vector<robotlink::Instant> missingThumbnails(int band) const;

 Q_SIGNALS:
  /// The user moved the play head.
  void jumpWanted(robotlink::Instant time);
  /// The user selected or dropped a range.
  void rangeWanted(robotlink::Instant from, robotlink::Instant to);
  void rangeDropped();
  /// The user chose the stream whose messages are stepped.
  void streamChosen(int band, const std::string& path);
  /// The user wants a new bookmark at a time.
  void bookmarkWanted(int band, robotlink::Instant time);
  /// The user moved a bookmark or edited its text; times are the log's own.
  void bookmarkChanged(int band, const logplayer::Bookmark& bookmark);
  /// The user wants to remove a bookmark.
  void bookmarkDropped(int band, std::uint64_t id);
  /// The user dragged or edited the offset of a log.
  void offsetWanted(int band, robotlink::Duration offset);
  /// The user wants to show or hide a log's streams.
  void collapseWanted(int band, bool collapsed);
  /// Other times are visible.
  void looked();
  /// Values were dropped, to be shown as curves: the texts of their sources.
  void tracksDropped(const QStringList& sources);

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
  /// The action that a press of the left button has begun.
  enum class Drag : std::uint8_t { kNone, kScrub, kPan, kSelect, kRangeEdge, kBookmark, kOffset };
  /// The object at a point of the canvas.
  struct Hit {
    Drag drag = Drag::kNone;
    int band = -1;
    std::uint64_t bookmark = 0;
    /// For kRangeEdge, whether it is the later end.
    bool upper = false;
  };

  TimeLineBand& band(int index) { return bands_[static_cast<std::size_t>(index)]; }
  const TimeLineBand& band(int index) const { return bands_[static_cast<std::size_t>(index)]; }
  /// Adapts sizes to the font.
  void measure();
  /// Drops the cached picture and repaints.
  void lookAnew();
  /// Sets the time at the left edge; a part of the logs always stays visible.
  void setFrom(robotlink::Instant from);
  void updateScrollBars();
  /// Scrolls by a page if the play head is not visible.
  void keepShownInSight();
  robotlink::Instant timeAt(const QPointF& point) const;
  /// The marks of the ruler at an x.
  std::vector<TimeMark> marksNear(double x) const;
  /// The time at a point of the ruler: of the nearest mark if there is one.
  robotlink::Instant rulerTimeAt(const QPointF& point) const;
  QString markToolTip(double x) const;
  /// The value of a track at a time.
  QString trackToolTip(const TimeLineBand& of, const std::string& source, robotlink::Instant time) const;
  /// The action that a press at a point would begin.
  Hit hitAt(const QPointF& point, Qt::KeyboardModifiers modifiers) const;
  /// Id of the bookmark at a point of a lane; 0: none.
  std::uint64_t bookmarkAt(const TimeLineLayout::Lane& lane, const QPointF& point) const;
  /// A press on the names: collapses or chooses a stream.
  void pressGutter(const TimeLineLayout::Lane& lane, const QPointF& point);
  /// Moves the dragged bookmark.
  void dragBookmark(const QPointF& point);
  /// Ends the selection of a range; without a movement it was a click.
  void releaseSelection(const QPointF& point);
  /// Opens an editor for a log's offset.
  void editOffset(int band);
  /// Opens an editor in place; `done` gets the text that is entered.
  QLineEdit* openEditor(const char* name, const QRect& where, const QString& text,
                        std::function<void(const QString&)> done);
  QString toolTipAt(const QPointF& point) const;
  QString timeToolTip(robotlink::Instant time) const;
  /// About the gap of a robot's line at a point; empty if there is none.
  QString gapToolTip(const TimeLineBand& of, const QPointF& point) const;
  /// The tooltip about where the messages of a live robot are at a point.
  QString keptToolTip(const TimeLineBand& of, const QPointF& point) const;
  /// Text of the warnings and errors near a time.
  QString saidNear(const TimeLineBand& of, robotlink::Instant time) const;
  QString bookmarkToolTip(const TimeLineBand& of, const logplayer::Bookmark& bookmark) const;
  /// Shows by the mouse cursor what a press would do.
  void updateCursor(const QPointF& point, Qt::KeyboardModifiers modifiers);

  std::vector<TimeLineBand> bands_;
  TimeLineLook look_;
  /// Cached picture of everything but the play head; null: to be painted again.
  QPixmap still_;
  /// Whether an extent that is not empty was set.
  bool extentKnown_ = false;
  /// Whether updateScrollBars() is running, whose signals are ignored.
  bool settingBars_ = false;
  /// Whether all logs are kept fitted; until the user zooms or pans.
  bool fitted_ = true;
  bool follow_ = true;
  bool scrubsEverywhere_ = false;
  /// The object that is being dragged.
  Hit held_;
  /// Whether the mouse has moved since the press.
  bool moved_ = false;
  QPointF pressedAt_, lastAt_;
  /// The dragged bookmark as it was at the press.
  logplayer::Bookmark heldBookmark_;
  /// The dragged offset as it was at the press.
  robotlink::Duration heldOffset_{0};
};

}  // namespace widgets
