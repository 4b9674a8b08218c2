// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/StallWatch.h"

#include <sys/resource.h>

#include <QAbstractEventDispatcher>
#include <QCoreApplication>
#include <QLabel>
#include <QMetaEnum>
#include <QStatusBar>
#include <QTimer>
#include <algorithm>
#include <cstdlib>
#include <ctime>

namespace app {

using std::chrono::duration_cast;
using std::chrono::microseconds;

namespace {

constexpr int kShowMs = 500;

/// The number of page faults of this thread so far.
std::int64_t pageFaults() {
#ifdef RUSAGE_THREAD
  rusage usage{};
  if (getrusage(RUSAGE_THREAD, &usage) == 0) return usage.ru_minflt;
#endif
  return 0;
}

double milliseconds(microseconds time) {
  return static_cast<double>(time.count()) / 1000;
}

}  // namespace

StallWatch::StallWatch(QObject* parent, QStatusBar* bar) : QObject(parent) {
  auto* dispatcher = QAbstractEventDispatcher::instance();
  connect(dispatcher, &QAbstractEventDispatcher::awake, this, &StallWatch::begin);
  connect(dispatcher, &QAbstractEventDispatcher::aboutToBlock, this, &StallWatch::end);
  // Dispatchers wait and then deliver events between these two signals, so that only the first event tells
  // when the wait was over.
  QCoreApplication::instance()->installEventFilter(this);
  if (bar == nullptr) return;
  label_ = new QLabel;
  label_->setObjectName(QStringLiteral("stalls"));
  toolTip_ = tr("Stalls of the window: number longer than %1 ms, and the longest one").arg(kLimit.count());
  bar->addPermanentWidget(label_);
  auto* timer = new QTimer(this);
  connect(timer, &QTimer::timeout, this, &StallWatch::show);
  timer->start(kShowMs);
  show();
}

bool StallWatch::isWanted() {
#ifdef NDEBUG
  return std::getenv("ROBOTCONTROL_STALLS") != nullptr;
#else
  return true;
#endif
}

StallWatch::Moment StallWatch::now() {
  timespec cpu{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &cpu);
  return {std::chrono::steady_clock::now(),
          std::chrono::seconds(cpu.tv_sec) + std::chrono::nanoseconds(cpu.tv_nsec), pageFaults()};
}

void StallWatch::reset() {
  stalls_ = {};
  begun_.reset();
}

bool StallWatch::eventFilter(QObject* watched, QEvent* event) {
  if (!begun_) begin();
  const Moment moment = now();
  endDelivery(moment);
  deliveryBegun_ = moment;
  delivery_ = {watched->metaObject()->className(), watched->objectName(), event->type(), {}};
  ++deliveries_;
  return QObject::eventFilter(watched, event);
}

void StallWatch::begin() {
  end();  // a loop that found new events at once did not wait
  begun_ = now();
  deliveryBegun_ = *begun_;
  delivery_ = longestDelivery_ = {};
  deliveries_ = 0;
}

void StallWatch::endDelivery(const Moment& moment) {
  delivery_.cpu = moment.cpu - deliveryBegun_.cpu;
  if (delivery_.cpu > longestDelivery_.cpu) longestDelivery_ = delivery_;
}

QString StallWatch::Delivery::describe() const {
  const char* event = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
  return QStringLiteral("%1 \"%2\" %3: %4 ms")
      .arg(QLatin1String(receiver), name, QLatin1String(event != nullptr ? event : "event"))
      .arg(milliseconds(duration_cast<microseconds>(cpu)), 0, 'f', 1);
}

void StallWatch::end() {
  if (!begun_) return;
  const Moment moment = now();
  endDelivery(moment);
  const auto wall = duration_cast<microseconds>(moment.wall - begun_->wall);
  stalls_.longest = std::max(stalls_.longest, wall);
  if (const auto cpu = duration_cast<microseconds>(moment.cpu - begun_->cpu); cpu > stalls_.longestCpu) {
    stalls_.longestCpu = cpu;
    stalls_.cause = tr("%1, of %2 events with %3 page faults")
                        .arg(longestDelivery_.describe())
                        .arg(deliveries_)
                        .arg(moment.pageFaults - begun_->pageFaults);
  }
  if (wall > kLimit) ++stalls_.count;
  begun_.reset();
}

void StallWatch::show() {
  if (stalls_ == shown_ && !label_->text().isEmpty()) return;
  shown_ = stalls_;
  label_->setText(tr("stalls: %1, longest %2 ms (CPU %3 ms)")
                      .arg(stalls_.count)
                      .arg(milliseconds(stalls_.longest), 0, 'f', 0)
                      .arg(milliseconds(stalls_.longestCpu), 0, 'f', 0));
  label_->setToolTip(toolTip_ + QLatin1Char('\n') + stalls_.cause);
}

}  // namespace app
