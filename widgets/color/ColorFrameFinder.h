// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QString>
#include <atomic>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "robotlink/base/Error.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/FrameSearch.h"
#include "widgets/color/SuspiciousFrameModel.h"

namespace widgets {

/// Finds the frames with the most suspicious segmentation by the bench's color table: in the whole open log
/// from which the current image is, or in the history of its stream. The result is shared by the views of a
/// window. GUI thread; owned by the bench. The context must outlive it.
class ColorFrameFinder final : public QObject {
  Q_OBJECT
 public:
  ColorFrameFinder(ViewContext& context, ColorBench& bench);
  /// Waits for the image that the search is looking at.
  ~ColorFrameFinder() override;

  /// Starts a new search, with the newest table as soon as it is trained. Fails, with the reason, if there is
  /// nothing to search; earlier results are kept then.
  robotlink::Result<void> search();
  /// Ends the search; what was found is kept.
  void cancel();
  /// Whether a search is running or waits for the table.
  bool busy() const { return wanted_ || (search_ && !progress_.ended); }
  /// Whether a search has begun since the program started.
  bool searched() const { return searched_.table != nullptr; }
  const FrameSearch::Progress& progress() const { return progress_; }
  /// The place of the last search: "game.mcap, nao/camera/image".
  const QString& place() const { return searched_.place; }
  /// Whether the table has changed since the last search.
  bool stale() const;

  /// The frames that were found.
  SuspiciousFrameModel& model() { return model_; }
  /// The images in a log that it would search; unset if they are in none.
  std::optional<LoggedImages> loggedImages() const;
  /// The stream of the current image, else the first image stream of the log; empty if there is none.
  std::string streamToSearch() const;
  /// Moves the timeline, or the play head of the replay, to a frame of the model.
  void show(int row);

  /// Whether pixels of a class can be suspicious: the user's choice for the class's name, else whether things
  /// have its color.
  bool looksAt(int colorClass) const;
  void setLooksAt(int colorClass, bool on);
  /// The user's choices for saved states: names with a leading + or -.
  QStringList choices() const;
  void setChoices(const QStringList& choices);

 Q_SIGNALS:
  /// Progress, results, or choices changed.
  void changed();

 private:
  /// The place to search.
  struct Place {
    std::variant<LoggedImages, KeptImages> images;
    /// See place().
    QString text;
  };
  /// The last search.
  struct Searched {
    /// Null: none.
    std::shared_ptr<const colortool::ColorTable> table;
    QString place;
    /// Whether a log was searched.
    bool logged = false;
  };
  /// The log or history that contains streamToSearch(); an error if there is none.
  robotlink::Result<Place> findPlace() const;
  /// The open log that contains a stream; unset if none does.
  std::optional<Place> placeInLogs(const std::string& stream) const;
  /// Begins the search if the table and its margins are ready.
  void start();
  /// Takes results and progress from the search.
  void takeNews();

  ViewContext& context_;
  ColorBench& bench_;
  SuspiciousFrameModel model_;
  /// The user's choices, by class name.
  std::map<std::string, bool> chosen_;
  /// A search waits for the table.
  bool wanted_ = false;
  Searched searched_;
  FrameSearch::Progress progress_;
  /// Whether a call of takeNews() is queued; set in the search's thread.
  std::atomic<bool> reported_{false};
  /// Destroyed first, since its thread uses told_.
  std::unique_ptr<FrameSearch> search_;
};

/// The finder of a window, created on the first call.
ColorFrameFinder& colorFrameFinder(ViewContext& context);

}  // namespace widgets
