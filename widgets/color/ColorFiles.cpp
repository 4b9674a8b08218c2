// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorFiles.h"

#include <QCoreApplication>
#include <algorithm>
#include <utility>

#include "colortool/samples/SampleFile.h"
#include "colortool/table/ColorTableFile.h"
#include "colortool/table/NamedColorTable.h"
#include "colortool/training/TableTrainer.h"
#include "foxglove/Image.pb.h"
#include "robotlink/session/Session.h"
#include "widgets/color/ColorActions.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorRecovery.h"
#include "widgets/color/ColorReferences.h"
#include "widgets/color/PictureReading.h"

namespace widgets {
namespace {

constexpr int kTicksUntilKept = 60;
/// A cell is of several classes if others have at least this share of the best one's votes.
constexpr double kCloseShare = 0.7;
constexpr std::size_t kMaxProblemsShown = 12;

QString shownPath(const std::filesystem::path& path) {
  return QString::fromStdString(path.string());
}

/// The classes of each cell as ColorTableFile::pack() takes them.
std::vector<std::uint16_t> closeClasses(const colortool::TableTrainer& trainer) {
  const auto winners = trainer.table().cells();
  std::vector<std::uint16_t> masks(winners.size(), 0);
  for (std::size_t cell = 0; cell < winners.size(); ++cell) {
    if (winners[cell] == colortool::ColorClasses::kNone) continue;
    masks[cell] = trainer.votes().classesOf(cell, kCloseShare);
    // A class that cleaning up has assigned may have few votes.
    if (winners[cell] <= 16) masks[cell] |= static_cast<std::uint16_t>(1U << (winners[cell] - 1U));
  }
  return masks;
}

bool correctsColors(const colortool::Samples& samples) {
  return std::ranges::any_of(samples.corrections, [&](const colortool::CameraCorrection& camera) {
    return !samples.correctionOf(camera.camera).none();
  });
}

}  // namespace

ColorFiles::ColorFiles(ColorBench& bench) : QObject(&bench), bench_(bench) {
  setObjectName(QStringLiteral("colorFiles"));
  connect(&bench, &ColorBench::samplesChanged, this, [this] {
    message_ = {};  // the message was about the former samples
    if (ticksUnkept_ == 0) ticksUnkept_ = 1;
  });
  connect(&bench.undoStack(), &QUndoStack::cleanChanged, this, [this] { Q_EMIT titleChanged(title()); });
  connect(qApp, &QCoreApplication::aboutToQuit, this, &ColorFiles::keepNow);
}

ColorFiles::~ColorFiles() = default;

bool ColorFiles::changed() const {
  return !bench_.undoStack().isClean();
}

QString ColorFiles::title() const {
  const QString name = file_.empty() ? tr("unnamed") : shownPath(file_.filename());
  return changed() ? name + QLatin1Char('*') : name;
}

void ColorFiles::setFile(const std::filesystem::path& file) {
  file_ = file;
  std::error_code unknown;
  bench_.setFile(file.empty() ? std::string()
                              : std::filesystem::absolute(file, unknown).lexically_normal().string());
  if (!file.empty()) remember(file);
  discard();
  Q_EMIT titleChanged(title());
}

void ColorFiles::remember(const std::filesystem::path& file) {
  std::error_code error;
  folder_ = shownPath(std::filesystem::absolute(file, error).parent_path());
}

void ColorFiles::discard() {
  if (std::exchange(kept_, false)) recovery_->drop();
  ticksUnkept_ = 0;
}

void ColorFiles::report(const QString& text) {
  message_ = {text, false};
  Q_EMIT reported(text);
}

void ColorFiles::fail(const QString& reason) {
  message_ = {reason, true};
  Q_EMIT bench_.failed(reason);
}

void ColorFiles::startAnew() {
  bench_.setDocument({});
  setFile({});
}

void ColorFiles::show(const robotlink::Errors& problems, const QString& what) {
  robotlink::Errors shown = problems;
  shown.resize(std::min(shown.size(), kMaxProblemsShown));
  QString all = what + QLatin1Char('\n') + QString::fromStdString(robotlink::describe(shown));
  if (shown.size() < problems.size()) all += tr("\n… and %1 more").arg(problems.size() - shown.size());
  fail(all);
}

robotlink::Result<void> ColorFiles::open(const std::filesystem::path& file) {
  auto read = colortool::loadSamples(file);
  if (!read) return tl::unexpected(read.error());
  bench_.setDocument(std::move(read->samples), !read->problems.empty());
  const bool whole = read->problems.empty();
  setFile(whole ? file : std::filesystem::path());
  if (whole) return {};
  remember(file);
  ticksUnkept_ = 1;
  show(read->problems,
       tr("Only a part of %1 could be read. It was opened without a name, so that the file is not "
          "overwritten:")
           .arg(shownPath(file)));
  return {};
}

robotlink::Result<void> ColorFiles::save() {
  if (!file_.empty()) return saveAs(file_);
  return robotlink::failure("color.no-file", "the samples have no file yet; name one: color.save-as FILE");
}

robotlink::Result<void> ColorFiles::saveAs(const std::filesystem::path& file) {
  if (const auto saved = colortool::saveSamples(bench_.samples(), file); !saved) return saved;
  bench_.setSaved();
  setFile(file);
  report(tr("Saved: %1").arg(shownPath(file)));
  return {};
}

robotlink::Result<void> ColorFiles::merge(const std::filesystem::path& file) {
  const auto read = colortool::loadSamples(file);
  if (!read) return tl::unexpected(read.error());
  colortool::Samples next = bench_.samples();
  colortool::merge(next, read->samples);
  const std::size_t more = next.strokes.size() - bench_.samples().strokes.size();
  bench_.change(tr("Merge %1").arg(shownPath(file.filename())), std::move(next));
  remember(file);
  report(tr("%1 came from %2").arg(strokesText(more), shownPath(file.filename())));
  if (!read->problems.empty())
    show(read->problems, tr("Only a part of %1 could be read and was added:").arg(shownPath(file)));
  return {};
}

robotlink::Result<void> ColorFiles::exportTable(const std::filesystem::path& file, bool several) {
  const colortool::Samples& samples = bench_.samples();
  if (samples.strokes.empty()) {
    return robotlink::failure("color.no-strokes",
                              "there are no strokes to make a table of; draw some in an image first");
  }
  colortool::TableTrainer trainer;
  const auto& table = trainer.train(samples);
  const auto masks =
      several ? closeClasses(trainer) : std::vector<std::uint16_t>(colortool::ColorTable::kCellCount);
  auto packed = colortool::ColorTableFile::pack(table.cells(), masks);
  const colortool::NamedColorTable named{std::move(packed.file), samples.classes};
  if (const auto saved = named.save(file); !saved) return saved;
  remember(file);
  QString said = tr("Exported: %1").arg(shownPath(file));
  if (packed.reducedCells > 0) {
    said += tr("\nCells of several classes, one of them above %1, that keep only the best one, because the "
               "format has no room for more: %2")
                .arg(colortool::ColorTableFile::kMaxOfSeveral)
                .arg(packed.reducedCells);
  }
  if (correctsColors(samples))
    said += tr("\nThe corrections of cameras and vignetting are not part of the table");
  report(said);
  return {};
}

robotlink::Result<void> ColorFiles::importReference(const std::filesystem::path& file) {
  auto read = readReference(file);
  if (!read) return tl::unexpected(read.error());
  const colortool::ColorClasses& classes = bench_.samples().classes;
  const std::vector<std::string> names = read->classes.names();
  bench_.setReference(std::move(*read));
  remember(file);
  QStringList unknown;
  for (const std::string& name : names) {
    if (classes.index(name) == colortool::ColorClasses::kNone) unknown << QString::fromStdString(name);
  }
  QString said = tr("Compared with %1").arg(shownPath(file.filename()));
  if (!unknown.isEmpty())
    said +=
        tr("; its classes %1 are not among yours and are ignored").arg(unknown.join(QStringLiteral(", ")));
  report(said);
  return {};
}

void ColorFiles::startRecovery(const std::filesystem::path& folder) {
  recovery_ = std::make_unique<ColorRecovery>(folder, [this](const robotlink::Error& error) {
    const QString reason = QString::fromStdString(error.describe());
    QMetaObject::invokeMethod(
        this, [this, reason] { fail(tr("Changes cannot be backed up: %1").arg(reason)); },
        Qt::QueuedConnection);
  });
  auto left = recovery_->left();
  if (!left) return;
  if (!*left) {
    fail(tr("Unsaved samples could not be restored: %1")
             .arg(QString::fromStdString(left->error().describe())));
    return;
  }
  const std::size_t strokes = (*left)->samples.strokes.size();
  bench_.setDocument(std::move((*left)->samples), true);
  kept_ = true;
  Q_EMIT titleChanged(title());
  const QString said = tr("The program ended without saving last time. Unsaved samples were restored: %1. "
                          "Save them to keep them.")
                           .arg(strokesText(strokes));
  if ((*left)->problems.empty())
    report(said);
  else
    show((*left)->problems, said);
}

void ColorFiles::openPictures(const std::vector<std::filesystem::path>& filesOrFolders) {
  if (filesOrFolders.empty()) return;
  if (pictures_) {
    nextPictures_.insert(nextPictures_.end(), filesOrFolders.begin(), filesOrFolders.end());
    return;
  }
  remember(filesOrFolders.front());
  std::size_t taken = 0;
  for (const CollectedFrame& collected : bench_.collected())
    taken += collected.frame->message()->data().size();
  const std::size_t room = ColorBench::kMaxCollectedBytes - std::min(taken, ColorBench::kMaxCollectedBytes);
  pictures_ = std::make_unique<PictureReading>(filesOrFolders, bench_.session().selectedRobot(), room);
}

void ColorFiles::takePictures() {
  auto read = pictures_->take();
  if (!read) return;
  pictures_.reset();
  if (!*read) return fail(QString::fromStdString(read->error().describe()));
  const auto& frames = read->value().frames;
  if (frames.empty()) return fail(tr("The strip is full; remove some images first (Delete)"));
  bench_.collect(frames);
  Q_EMIT bench_.frameWanted(frames.front());
  QString said = tr("Pictures added: %1").arg(frames.size());
  if (read->value().leftOut > 0)
    said +=
        tr("; there was no room for %1 more, remove some images first (Delete)").arg(read->value().leftOut);
  if (read->value().problems.empty())
    report(said);
  else
    show(read->value().problems, said + tr(". These could not be read:"));
}

void ColorFiles::tick() {
  if (pictures_) takePictures();
  if (!pictures_ && !nextPictures_.empty()) openPictures(std::exchange(nextPictures_, {}));
  if (ticksUnkept_ > 0 && ++ticksUnkept_ > kTicksUntilKept) followChanges();
}

void ColorFiles::followChanges() {
  ticksUnkept_ = 0;
  if (!recovery_) return;
  if (changed()) {
    recovery_->keep(bench_.samples());
    kept_ = true;
  } else if (std::exchange(kept_, false)) {
    recovery_->drop();
  }
}

void ColorFiles::keepNow() {
  if (ticksUnkept_ > 0) followChanges();
  if (recovery_) recovery_->finish();
}

ColorFiles& colorFiles(ViewContext& context) {
  ColorBench& bench = colorBench(context);
  auto* files = bench.findChild<ColorFiles*>(QString(), Qt::FindDirectChildrenOnly);
  return files != nullptr ? *files : *new ColorFiles(bench);
}

}  // namespace widgets
