// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorFrameFinder.h"

#include <algorithm>
#include <filesystem>

#include "foxglove/Image.pb.h"
#include "robotlink/debugging/Streams.h"
#include "robotlink/session/Session.h"
#include "widgets/TypedStreams.h"
#include "widgets/log/OpenLogs.h"

namespace widgets {
namespace {

bool isImageType(const std::string& type) {
  return type == foxglove::RawImage::descriptor()->full_name() ||
         type == foxglove::CompressedImage::descriptor()->full_name();
}

}  // namespace

ColorFrameFinder::ColorFrameFinder(ViewContext& context, ColorBench& bench)
    : QObject(&bench), context_(context), bench_(bench) {
  setObjectName(QStringLiteral("colorFrameFinder"));
  connect(&bench, &ColorBench::colorsChanged, this, [this] {
    if (wanted_) start();
    Q_EMIT changed();
  });
}

ColorFrameFinder::~ColorFrameFinder() = default;

// The place of the search.

std::string ColorFrameFinder::streamToSearch() const {
  if (bench_.frame()) return bench_.frame()->stream();
  OpenLogs::Log* log = openLogs(context_).current();
  if (log == nullptr) return {};
  const auto streams = log->overview->imageStreams();
  return streams.empty() ? std::string() : OpenLogs::sessionPath(*log, streams.front());
}

std::optional<ColorFrameFinder::Place> ColorFrameFinder::placeInLogs(const std::string& stream) const {
  for (const auto& log : openLogs(context_).logs()) {
    for (const auto& logged : log->overview->streams) {
      if (!isImageType(logged.type) || OpenLogs::sessionPath(*log, logged.path) != stream) continue;
      const std::filesystem::path file(log->path);
      return Place{LoggedImages{file, logged.path, log->offset},
                   QStringLiteral("%1, %2").arg(QString::fromStdString(file.filename().string()),
                                                QString::fromStdString(stream))};
    }
  }
  return std::nullopt;
}

std::optional<LoggedImages> ColorFrameFinder::loggedImages() const {
  const auto place = placeInLogs(streamToSearch());
  return place ? std::optional(std::get<LoggedImages>(place->images)) : std::nullopt;
}

robotlink::Result<ColorFrameFinder::Place> ColorFrameFinder::findPlace() const {
  const std::string stream = streamToSearch();
  if (stream.empty()) {
    return robotlink::failure(
        "color.no-images",
        tr("There are no images to search: open a log, or show images of a robot in the view "
           "Color image")
            .toStdString());
  }
  if (auto place = placeInLogs(stream)) return *std::move(place);
  const auto* history = bench_.session().store().find(stream);
  if (history == nullptr || history->messages.empty()) {
    return robotlink::failure("color.no-images",
                              tr("There are no images of %1 in the logs and in the history")
                                  .arg(QString::fromStdString(stream))
                                  .toStdString());
  }
  return Place{KeptImages(history->messages.begin(), history->messages.end()),
               tr("history of %1").arg(QString::fromStdString(stream))};
}

// The search.

robotlink::Result<void> ColorFrameFinder::search() {
  const auto place = findPlace();
  if (!place) return tl::unexpected(place.error());
  search_.reset();
  progress_ = {};
  wanted_ = true;
  start();
  Q_EMIT changed();
  return {};
}

void ColorFrameFinder::start() {
  const LearnedColors* colors = bench_.colors();
  // The margins arrive shortly after the table.
  if (!bench_.upToDate() || !colors->margins) return;
  wanted_ = false;
  auto place = findPlace();
  if (!place) return;
  const auto& classes = colors->samples.classes;
  FrameQuery query{std::move(place->images),
                   colors->table,
                   colors->margins,
                   {},
                   colors->samples.correctionOf(robotlink::streams::robotOf(streamToSearch()))};
  for (int i = 0; i < classes.size(); ++i) query.things.push_back(looksAt(i));
  searched_ = {colors->table, place->text, std::holds_alternative<LoggedImages>(query.images)};
  model_.clear(classes);
  progress_ = {};
  search_ = std::make_unique<FrameSearch>(std::move(query), [this] {
    if (!reported_.exchange(true))
      QMetaObject::invokeMethod(this, &ColorFrameFinder::takeNews, Qt::QueuedConnection);
  });
}

void ColorFrameFinder::takeNews() {
  reported_ = false;
  if (!search_) return;
  progress_ = search_->progress();
  model_.add(search_->take());
  Q_EMIT changed();
}

void ColorFrameFinder::cancel() {
  if (wanted_) progress_.ended = progress_.canceled = true;
  wanted_ = false;
  if (search_) search_->cancel();
  Q_EMIT changed();
}

bool ColorFrameFinder::stale() const {
  const LearnedColors* colors = bench_.colors();
  return searched() && colors != nullptr && colors->table != searched_.table &&
         !(*colors->table == *searched_.table);
}

void ColorFrameFinder::show(int row) {
  if (row < 0 || row >= model_.rowCount()) return;
  const robotlink::Instant time = model_.row(row).time;
  Q_EMIT bench_.followWanted();
  if (searched_.logged) {
    bench_.session().history().goLive();
    openLogs(context_).replay().jumpTo(time);
  } else {
    bench_.session().history().show(time);
  }
}

// The classes that are examined.

bool ColorFrameFinder::looksAt(int colorClass) const {
  const auto& classes = bench_.samples().classes;
  if (colorClass <= 0 || colorClass >= classes.size()) return false;
  const auto chosen = chosen_.find(classes.name(colorClass));
  return chosen != chosen_.end() ? chosen->second : colortool::isThingColor(classes.shownColor(colorClass));
}

void ColorFrameFinder::setLooksAt(int colorClass, bool on) {
  if (looksAt(colorClass) == on) return;
  chosen_[bench_.samples().classes.name(colorClass)] = on;
  Q_EMIT changed();
}

QStringList ColorFrameFinder::choices() const {
  QStringList choices;
  for (const auto& [name, on] : chosen_)
    choices << (on ? QStringLiteral("+") : QStringLiteral("-")) + QString::fromStdString(name);
  return choices;
}

void ColorFrameFinder::setChoices(const QStringList& choices) {
  chosen_.clear();
  for (const QString& choice : choices) {
    if (choice.startsWith(QLatin1Char('+')) || choice.startsWith(QLatin1Char('-')))
      chosen_[choice.mid(1).toStdString()] = choice.startsWith(QLatin1Char('+'));
  }
  Q_EMIT changed();
}

ColorFrameFinder& colorFrameFinder(ViewContext& context) {
  ColorBench& bench = colorBench(context);
  auto* finder = bench.findChild<ColorFrameFinder*>(QString(), Qt::FindDirectChildrenOnly);
  return finder != nullptr ? *finder : *new ColorFrameFinder(context, bench);
}

}  // namespace widgets
