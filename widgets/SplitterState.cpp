// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/SplitterState.h"

#include <QByteArray>
#include <QSplitter>
#include <QString>
#include <QtEndian>
#include <algorithm>

namespace widgets {
namespace {

constexpr quint32 kSplitterMarker = 0xff;
constexpr int kSizesAt = 12;         // behind the marker, the version and the number of sizes
constexpr qint32 kMaxPart = 10'000;  // pixels; -1 stands for a part that nobody sized

}  // namespace

QJsonValue splitterState(const QSplitter& splitter) {
  return QString::fromLatin1(splitter.saveState().toBase64());
}

void restoreSplitter(QSplitter& splitter, const QJsonValue& state) {
  const QByteArray saved = QByteArray::fromBase64(state.toString().toLatin1());
  const int count = splitter.count(), sizesEnd = kSizesAt + 4 * count;
  if (saved.size() < sizesEnd || qFromBigEndian<quint32>(saved.constData()) != kSplitterMarker ||
      qFromBigEndian<qint32>(saved.constData() + 8) != count)
    return;
  QByteArray own = splitter.saveState();
  if (own.size() < sizesEnd) return;
  for (int at = kSizesAt; at < sizesEnd; at += 4) {
    const auto size = qFromBigEndian<qint32>(saved.constData() + at);
    qToBigEndian(std::clamp(size, -1, kMaxPart), own.data() + at);
  }
  splitter.restoreState(own);
}

}  // namespace widgets
