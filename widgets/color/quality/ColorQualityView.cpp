// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/quality/ColorQualityView.h"

#include <QAction>
#include <QBoxLayout>
#include <QFileDialog>
#include <QLabel>
#include <QSplitter>
#include <QToolButton>
#include <algorithm>
#include <set>

#include "colortool/training/Suspicion.h"
#include "widgets/Controls.h"
#include "widgets/Theme.h"
#include "widgets/color/ColorBench.h"
#include "widgets/color/ColorFrameFinder.h"
#include "widgets/color/LabeledFolder.h"
#include "widgets/color/quality/ConfusionModel.h"
#include "widgets/color/quality/ConfusionPanel.h"

namespace widgets {
namespace {

const ViewRegistration kColorQualityViewRegistration{
    {"color-quality", QT_TRANSLATE_NOOP("View", "Quality"),
     QT_TRANSLATE_NOOP("View", "Shows how good the color table is: recall, confusion and false colors."),
     "quality", false, create<ColorQualityView>}};

/// The width of the place for labeled images while there are none, in pixels.
constexpr int kEmptyWidth = 200;
/// The number of strokes of a class below which its figures mean little.
constexpr int kFewStrokes = 5;

/// A smaller share of the background that a class takes is not reported.
constexpr double kMinTaken = 0.01;
/// A larger share of all pixels of one class is reported.
constexpr double kMajority = 0.5;

/// The camera of the strokes' images if they all have the same one.
std::string onlyCamera(const colortool::Samples& samples) {
  std::set<std::string> cameras;
  for (const colortool::SampleImage& image : samples.images) cameras.insert(image.camera);
  return cameras.size() == 1 ? *cameras.begin() : std::string();
}

}  // namespace

ColorQualityView::ColorQualityView(ViewContext& context, QWidget* parent)
    : View(context, parent),
      bench_(colorBench(context)),
      history_(addColorActions(*this, "colorQuality", bench_)),
      trueClasses_(bench_) {
  setObjectName(QStringLiteral("colorQualityView"));
  createActions();
  createViews();
  connectSignals();
  keep(
      "folder", [this] { return folder_; }, [this](const QJsonValue& value) { folder_ = value.toString(); });
  keep("splitter", splitter_);
  showQuality();
}

ColorQualityView::~ColorQualityView() = default;

void ColorQualityView::createActions() {
  open_ = makeAction(this, "open",
                     {"qualityOpen", tr("Labeled images…"),
                      tr("Scores the table on a folder of images with labels: gray PNGs of the same name "
                         "with the numbers of the classes")});
  simulated_ = makeToggle(this, "simulation",
                          {"qualitySimulated", tr("Simulator's classes"),
                           tr("Scores the table against the simulated camera's true classes")});
  close_ =
      makeAction(this, "close", {"qualityClose", tr("Without images"), tr("Removes the labeled images")});
}

void ColorQualityView::createViews() {
  QHBoxLayout* row = makeToolRow(this);
  addButtons(row, {history_.undo, history_.redo});
  row->addSpacing(6);
  for (QAction* action : {open_, simulated_}) row->addWidget(makeLabeledButton(row->parentWidget(), action));
  addButtons(row, {close_});
  state_ = new QLabel(row->parentWidget());
  describe(*state_, {"qualityState", tr("State of the labeled images"), {}});
  row->addSpacing(8);
  row->addWidget(state_, 1);
  strokes_ = new ConfusionPanel("strokes", tr("Your strokes"), this);
  labeled_ = new ConfusionPanel("labeled", tr("Labeled images"), this);
  splitter_ = makeSplitter(this, "qualitySplitter", Qt::Horizontal, {{strokes_}, {labeled_}});
  auto* layout = makeColumn(this, {4, 2, 4, 4}, 3);
  layout->addWidget(row->parentWidget());
  layout->addWidget(splitter_, 1);
}

void ColorQualityView::connectSignals() {
  connect(open_, &QAction::triggered, this, &ColorQualityView::openFolder);
  connect(close_, &QAction::triggered, this, &ColorQualityView::closeImages);
  connect(simulated_, &QAction::toggled, this, [this](bool on) {
    reading_.reset();
    if (!on) return closeImages();
    bench_.setLabeled({});
    trueClasses_.setOn(true);
    showQuality();
  });
  connect(&bench_, &ColorBench::qualityChanged, this, &ColorQualityView::showQuality);
  connect(&bench_, &ColorBench::samplesChanged, this, &ColorQualityView::showQuality);
  connect(&bench_, &ColorBench::referenceChanged, this, &ColorQualityView::showQuality);
}

void ColorQualityView::openFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Folder of images with labels"), folder_);
  if (folder.isEmpty()) return;
  simulated_->setChecked(false);
  folder_ = folder;
  problem_.clear();
  reading_ = std::make_unique<LabeledFolder>(folder.toStdString(), onlyCamera(bench_.samples()));
}

void ColorQualityView::closeImages() {
  problem_.clear();
  reading_.reset();
  trueClasses_.setOn(false);
  if (simulated_->isChecked()) return simulated_->setChecked(false);
  bench_.setLabeled({});
  say({});
  showQuality();
}

void ColorQualityView::takeRead() {
  say(tr("Reading… %1 %").arg(qRound(100 * reading_->progress())));
  auto read = reading_->take();
  if (!read) return;
  reading_.reset();
  if (!*read) {
    problem_ = QString::fromStdString(read->error().describe());
    say(tr("No labeled images"), true);
    state_->setToolTip(problem_);
    showQuality();
    return Q_EMIT bench_.failed(problem_);  // here there may be no room for it
  }
  const auto count = static_cast<int>((*read)->frames.size());
  const auto problems = static_cast<int>((*read)->problems.size());
  Q_EMIT bench_.settled();
  bench_.setLabeled(std::move((*read)->frames));
  QString text = tr("Labeled images: %1").arg(count);
  if (problems > 0) text += tr("; %1 could not be read").arg(problems);
  say(text, problems > 0);
  if (problems > 0) state_->setToolTip(QString::fromStdString(robotlink::describe((*read)->problems)));
  showQuality();
}

void ColorQualityView::tick() {
  trueClasses_.tick();
  followLog();
  if (reading_) takeRead();
  if (simulated_->isChecked()) say(tr("Images of the simulation: %1").arg(trueClasses_.count()));
  close_->setEnabled(!bench_.labeled().empty() || reading_ != nullptr);
}

void ColorQualityView::followLog() {
  const ColorFrameFinder& finder = colorFrameFinder(context());
  if (auto log = finder.loggedImages(); log != log_) {
    logImages_ = log ? std::make_unique<LogImages>(*log, finder.streamToSearch()) : nullptr;
    log_ = std::move(log);
    bench_.setLogImages({});
  }
  if (!logImages_) return;
  auto images = logImages_->take();
  if (!images) return;
  logImages_.reset();
  bench_.setLogImages(*std::move(images));
}

void ColorQualityView::showQuality() {
  showStrokes();
  showLabeled();
}

QString ColorQualityView::countNote() const {
  const colortool::StrokeQuality& strokes = *bench_.quality()->strokes;
  int all = 0, fewest = 0;
  for (std::size_t i = 0; i < strokes.strokesOf.size(); ++i) {
    const int count = strokes.strokesOf[i];
    all += count;
    if (i > 0 && count > 0 && (fewest == 0 || count < fewest)) fewest = count;
  }
  const int background = strokes.strokesOf.empty() ? 0 : strokes.strokesOf[0];
  QString text = tr("Based on %1, at least %2 per class and %3 of the background; each counts the same, "
                    "regardless of size.")
                     .arg(strokesText(static_cast<std::size_t>(all)))
                     .arg(fewest)
                     .arg(background);
  if (fewest < kFewStrokes || background < kFewStrokes)
    text += tr(" That is not much: the figures are only a rough guide.");
  return text;
}

QString ColorQualityView::referenceNote(const colortool::Evaluation& own,
                                        const std::optional<colortool::Evaluation>& reference,
                                        const std::vector<std::uint8_t>& alone) const {
  if (!reference) return {};
  ConfusionModel mine, theirs;
  mine.setEvaluation(bench_.quality()->classes, own, alone);
  theirs.setEvaluation(bench_.quality()->classes, *reference, alone);
  const auto figure = [](std::optional<double> share) {
    return share ? QStringLiteral("%1 %").arg(100 * *share, 0, 'f', 2) : QStringLiteral("–");
  };
  const double recall = mine.meanRecall().value_or(0) - theirs.meanRecall().value_or(0),
               wrong = mine.falseColors().value_or(0) - theirs.falseColors().value_or(0);
  const QString better = recall >= 0 && wrong <= 0
                             ? (recall > 0 || wrong < 0 ? tr("yours is better") : tr("both are equal"))
                         : recall <= 0 && wrong >= 0 ? tr("that one is better")
                         : recall > 0                ? tr("your table finds more, but has more false colors")
                                      : tr("your table finds less, but has fewer false colors");
  return tr("%1: mean recall %2, false colors %3; %4.")
      .arg(bench_.referenceName(), figure(theirs.meanRecall()), figure(theirs.falseColors()), better);
}

QString ColorQualityView::othersNote() const {
  const ColorQuality::Others& others = bench_.quality()->others;
  if (others.images < 2 || others.pixels == 0) return {};
  std::uint64_t all = 0;
  for (const std::uint64_t pixels : others.suspicious) all += pixels;
  const auto share = [&](std::uint64_t pixels) {
    return QString::number(100 * static_cast<double>(pixels) / static_cast<double>(others.pixels), 'f', 2);
  };
  const QString where = (others.ofLog ? tr("In %1 images spread over the log") : tr("In the %1 images seen"))
                            .arg(others.images);
  QString text = tr("%1 no color is in an impossible place.").arg(where);
  if (all > 0) {
    const auto most = std::ranges::max_element(others.suspicious);
    const auto colorClass = static_cast<int>(most - others.suspicious.begin());
    text = tr("%1 %2 % of the pixels have the color of an object where none can be, mostly %3 (%4 %); the "
              "view Find frames shows where.")
               .arg(where, share(all), QString::fromStdString(bench_.quality()->classes.name(colorClass)),
                    share(*most));
  }
  return text + othersBackgroundNote();
}

QString ColorQualityView::sharesOf(std::span<const std::uint64_t> pixels, std::uint64_t all, double min,
                                   std::vector<bool> leftOut) const {
  QStringList shares;
  leftOut.resize(pixels.size());
  for (std::size_t i = 1; i < pixels.size() && all > 0; ++i) {
    const double share = static_cast<double>(pixels[i]) / static_cast<double>(all);
    if (share >= min && !leftOut[i])
      shares << tr("%1 % %2")
                    .arg(qRound(100 * share))
                    .arg(QString::fromStdString(bench_.quality()->classes.name(static_cast<int>(i))));
  }
  return shares.join(QStringLiteral(", "));
}

QString ColorQualityView::othersBackgroundNote() const {
  const auto& counts = bench_.quality()->others.background;
  QString text;
  if (const QString taken = sharesOf(counts.taken, counts.background, kMinTaken); !taken.isEmpty())
    text += tr(" Of the background's colors there it takes for a class: %1.").arg(taken);
  if (const QString most = sharesOf(counts.covered, counts.pixels, kMajority); !most.isEmpty())
    text += tr(" Most of their pixels are of one class: %1.").arg(most);
  return text;
}

QString ColorQualityView::backgroundNote(const colortool::Evaluation& evaluation) const {
  std::vector<std::uint64_t> found;
  for (int i = 0; i < evaluation.classes(); ++i) found.push_back(evaluation.count(0, i));
  const QString taken =
      sharesOf(found, evaluation.labeled(0), kMinTaken, colortool::objectClasses(bench_.quality()->classes));
  return taken.isEmpty() ? QString() : tr("Of the background it takes for a class: %1.").arg(taken);
}

QString ColorQualityView::strokesNote() const {
  const ColorQuality& quality = *bench_.quality();
  QStringList notes, alone;
  if (quality.labeled) notes << tr("The labeled images next to this are more reliable.");
  notes << countNote();
  for (const std::uint8_t colorClass : quality.strokes->alone) {
    if (colorClass != 0) alone << QString::fromStdString(quality.classes.name(colorClass));
  }
  if (!alone.isEmpty())
    notes << tr("Not enough strokes to judge %1: draw a second one, to test one against the other.")
                 .arg(alone.join(QStringLiteral(", ")));
  if (quality.strokes->evaluation.labeled(0) == 0)
    notes << tr("No stroke of the background: false colors are not known.");
  else if (std::ranges::find(quality.strokes->alone, 0) != quality.strokes->alone.end())
    notes << tr("A single stroke of the background: false colors are not known; draw a second one.");
  const QString reference =
      referenceNote(quality.strokes->evaluation, quality.referenceStrokes, quality.strokes->alone);
  for (const QString& note : {backgroundNote(quality.strokes->evaluation), reference, othersNote()}) {
    if (!note.isEmpty()) notes << note;
  }
  return notes.join(QLatin1Char(' '));
}

void ColorQualityView::showStrokes() {
  const ColorQuality* quality = bench_.quality();
  if (bench_.samples().strokes.empty())
    return strokes_->showNothing(
        tr("There are no strokes yet. Draw at least two of each class, and some of the background."));
  if (quality == nullptr || !quality->strokes) return strokes_->showNothing(tr("Finding out…"));
  strokes_->show(quality->classes, quality->strokes->evaluation, quality->strokes->alone, strokesNote());
}

void ColorQualityView::showLabeled() {
  const bool some = !bench_.labeled().empty();
  // Without images the panel of the strokes gets the room; with the first ones both get the same.
  const bool narrow = labeled_->maximumWidth() == kEmptyWidth;
  labeled_->setMaximumWidth(some ? QWIDGETSIZE_MAX : kEmptyWidth);
  if (some && narrow) splitter_->setSizes({width() / 2, width() / 2});
  if (!some) {
    return labeled_->showNothing(
        !problem_.isEmpty() ? problem_
        : simulated_->isChecked()
            ? tr("Waiting for the simulated camera. Only a simulated robot, or its log, has true classes.")
            : tr("No labeled images. Open a folder of them, or use those of the simulator."));
  }
  const ColorQuality* quality = bench_.quality();
  if (quality == nullptr || !quality->labeled) return labeled_->showNothing(tr("Finding out…"));
  QStringList notes{backgroundNote(*quality->labeled),
                    referenceNote(*quality->labeled, quality->referenceLabeled, {})};
  notes.removeAll({});
  labeled_->show(quality->classes, *quality->labeled, {}, notes.join(QLatin1Char(' ')));
}

void ColorQualityView::say(const QString& text, bool bad) {
  showOutcome(*state_, text, bad);
  state_->setToolTip({});
}

}  // namespace widgets
