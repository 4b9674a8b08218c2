// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/export/ViewExport.h"

#include <QElapsedTimer>
#include <QFileInfo>
#include <QLayout>
#include <exception>
#include <utility>

#include "robotlink/session/Session.h"
#include "widgets/Counted.h"
#include "widgets/export/ExportClock.h"
#include "widgets/log/OpenLogs.h"

namespace widgets {

using robotlink::failure;
using robotlink::Result;

namespace {

/// The time for which pictures are painted in one tick, so that the window stays usable.
constexpr qint64 kExportTickMs = 25;

/// A view that looks like another one, with a picture of this size. It is no window on the screen.
std::unique_ptr<View> copyOf(const View& view, const ViewType& type, ViewContext& context,
                             const QSize& size) {
  std::unique_ptr<View> copy(type.create(context, nullptr));
  copy->setAttribute(Qt::WA_DontShowOnScreen);
  copy->setAttribute(Qt::WA_ShowWithoutActivating);
  copy->setAttribute(Qt::WA_QuitOnClose, false);
  copy->setPalette(view.palette());
  copy->restoreState(view.saveState());
  // Its picture may be smaller than the tools above it allow.
  if (copy->layout() != nullptr) copy->layout()->setSizeConstraint(QLayout::SetNoConstraint);
  copy->setMinimumSize(0, 0);
  copy->resize(size);
  copy->show();
  // The room around the picture depends on its size, too: rows of tools may need another line.
  constexpr int kRounds = 3;
  for (int round = 0; round < kRounds; ++round) copy->resize(copy->size() + size - copy->shownPictureSize());
  return copy;
}

QString nameOf(const ExportPlan& plan) {
  return QFileInfo(QString::fromStdString(plan.target.string())).fileName();
}

}  // namespace

struct ViewExport::Run {
  ExportPlan plan;
  // In this order: the view is destroyed before the clock moves back.
  ExportClock clock;
  FrameWriter writer;
  std::unique_ptr<View> view;
  Step step = Step::kTime;
  /// The number of pictures passed to the writer.
  std::int64_t written = 0;
  QImage picture = {};
};

ViewExport::ViewExport(ViewContext& context, QObject* parent) : QObject(parent), context_(context) {}

ViewExport::~ViewExport() = default;

Result<void> ViewExport::start(const QString& kind, const View& view, const ExportPlan& plan) {
  if (isBusy()) return failure("export.busy", "another export is under way; cancel it first: export.cancel");
  const ViewType* type = ViewRegistry::find(kind.toStdString());
  if (type == nullptr) return failure("view.unknown", "there is no view '" + kind.toStdString() + "'");
  if (auto done = check(plan); !done) return done;
  std::unique_ptr<View> copy;
  try {
    copy = copyOf(view, *type, context_, plan.size);
  } catch (const std::exception& thrown) {
    return failure("export.view", std::string("the view cannot be shown: ") + thrown.what());
  }
  outcome_.reset();
  failure_.reset();
  auto& replay = openLogs(context_).replay();
  run_.reset(new Run{plan, {context_.session, replay}, FrameWriter(plan, freeSpace_), std::move(copy)});
  run_->clock.show(plan.from);
  return {};
}

void ViewExport::tick() {
  QElapsedTimer elapsed;
  elapsed.start();
  while (isBusy() && elapsed.elapsed() < kExportTickMs) {
    if (const auto& problem = run_->writer.problem()) return fail(robotlink::Error(*problem));
    if (const std::string problem = run_->clock.problem(); !problem.empty())
      return fail({"export.ended", "the export has ended: " + problem, {}, {}});
    try {
      if (!advance()) return;
    } catch (const std::exception& thrown) {
      return fail({"export.view", std::string("the view has failed: ") + thrown.what(), {}, {}});
    }
  }
}

bool ViewExport::advance() {
  Run& run = *run_;
  switch (run.step) {
    case Step::kTime:
      if (!run.clock.hasArrived()) return false;
      run.view->tick();
      run.step = Step::kPicture;
      return true;
    case Step::kPicture:
      if (!run.view->isPictureReady()) return false;
      run.picture = run.view->shownPicture();
      run.step = Step::kWrite;
      return true;
    case Step::kWrite:
      return write();
    case Step::kEnd:
      if (!run.writer.isFinished()) return false;
      end({true, false, writtenText(), QString::fromStdString(run.plan.target.string())});
      return true;
  }
  return false;
}

bool ViewExport::write() {
  Run& run = *run_;
  if (run.written == run.plan.frames()) {
    if (!run.writer.tryFinish()) return false;
    run.step = Step::kEnd;
    return true;
  }
  if (!run.writer.tryWrite(run.picture)) return false;
  if (++run.written == run.plan.frames()) return true;
  run.clock.show(run.plan.instant(run.written));
  run.step = Step::kTime;
  return true;
}

QString ViewExport::writtenText() const {
  const ExportPlan& plan = run_->plan;
  const QString pictures = counted(run_->written, tr("1 picture"), tr("%1 pictures"));
  const QString seconds = QString::number(robotlink::seconds(plan.to - plan.from), 'f', 2);
  return plan.kind == ExportPlan::Kind::kVideo
             ? tr("%1: a video of %2, %3 s").arg(nameOf(plan), pictures, seconds)
             : tr("%1: %2 of %3 s").arg(nameOf(plan), pictures, seconds);
}

void ViewExport::end(Outcome outcome) {
  outcome_ = std::move(outcome);
  run_.reset();
}

void ViewExport::fail(const robotlink::Error& error) {
  const QString target = QString::fromStdString(run_->plan.target.string());
  const bool isLeft = run_->plan.kind == ExportPlan::Kind::kImages && run_->written > 0;
  failure_ = error;
  end({false, false,
       tr("The export failed or is incomplete: %1").arg(QString::fromStdString(error.describe())),
       isLeft ? target : QString()});
}

void ViewExport::cancel() {
  if (!isBusy()) return;
  const bool isLeft = run_->plan.kind == ExportPlan::Kind::kImages && run_->written > 0;
  failure_ = robotlink::Error{"export.canceled", "the export was canceled", {}, {}};
  end({false, true,
       isLeft ? tr("Canceled; %1 are in %2")
                    .arg(counted(run_->written, tr("1 picture"), tr("%1 pictures")), nameOf(run_->plan))
              : tr("Canceled; %1 was deleted").arg(nameOf(run_->plan)),
       isLeft ? QString::fromStdString(run_->plan.target.string()) : QString()});
}

QString ViewExport::title() const {
  if (!isBusy()) return {};
  return tr("Writing %1: %2 of %3 pictures")
      .arg(nameOf(run_->plan))
      .arg(run_->written)
      .arg(run_->plan.frames());
}

double ViewExport::share() const {
  if (!isBusy()) return 0;
  return static_cast<double>(run_->written) / static_cast<double>(run_->plan.frames());
}

std::optional<ViewExport::Outcome> ViewExport::takeOutcome() {
  return std::exchange(outcome_, std::nullopt);
}

Result<bool> ViewExport::working() {
  if (const auto failed = std::exchange(failure_, std::nullopt)) return tl::unexpected(*failed);
  return isBusy();
}

}  // namespace widgets
