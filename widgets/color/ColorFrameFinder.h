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

/// Finds the frames in which the colour table of a bench does most that is suspicious: over the whole of the
/// open log that the image worked on is from, or over the history of its stream. What was found is shared by
/// the views of a window. GUI thread; belongs to the bench.
class ColorFrameFinder final : public QObject {
  Q_OBJECT
 public:
  ColorFrameFinder(ViewContext& context, ColorBench& bench);
  ~ColorFrameFinder() override;

  /// Searches anew, with the newest table as soon as it is learned. Fails, with the reason, where there is
  /// nothing to search; what was found before stays then.
  robotlink::Result<void> search();
  void cancel();
  bool busy() const { return wanted_ || (search_ && !progress_.ended); }
  /// Whether a search was begun since the start.
  bool searched() const { return searched_.table != nullptr; }
  const FrameSearch::Progress& progress() const { return progress_; }
  /// "game.mcap, nao/camera/image": where was searched last.
  const QString& place() const { return searched_.place; }
  /// Whether the table is another one than that of the last search.
  bool stale() const;

  SuspiciousFrameModel& model() { return model_; }
  /// The time line goes to a frame of the model.
  void show(int row);

  /// Whether pixels of a class can be suspicious. By default those that things have; of all tables, by name.
  bool looksAt(int colorClass) const;
  void setLooksAt(int colorClass, bool on);
  /// What a person chose, for saved states: names with + or - in front.
  QStringList choices() const;
  void setChoices(const QStringList& choices);

 Q_SIGNALS:
  /// Progress, or what is looked at.
  void changed();

 private:
  struct Place {
    std::variant<LoggedImages, KeptImages> images;
    QString text;
  };
  struct Searched {
    std::shared_ptr<const colortool::ColorTable> table;
    QString place;
    bool logged = false;
  };
  robotlink::Result<Place> findPlace() const;
  std::optional<Place> placeInLogs(const std::string& stream) const;
  std::string streamToSearch() const;
  void start();
  void takeNews();

  ViewContext& context_;
  ColorBench& bench_;
  SuspiciousFrameModel model_;
  std::map<std::string, bool> chosen_;  ///< by class name
  bool wanted_ = false;                 ///< a search, as soon as the table is there
  Searched searched_;
  FrameSearch::Progress progress_;
  std::atomic<bool> told_{false};        ///< that there is news, and it was not yet taken
  std::unique_ptr<FrameSearch> search_;  // last: it uses told_
};

/// That of a window; made when it is first asked for.
ColorFrameFinder& colorFrameFinder(ViewContext& context);

}  // namespace widgets
