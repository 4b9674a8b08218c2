// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/robotcontrol/bars/ToolBarState.h"

#include <QDataStream>

namespace app {
namespace {

constexpr quint8 kDocksMarker = 0xfd, kToolBarsMarker = 0xfc;
constexpr int kSizeAndCorners = 24;  // bytes: the size of the middle, and whose each corner is
constexpr int kPlaceOfToolBar = 17;  // bytes: whether it is shown, its position, size and rectangle
constexpr qint32 kMaxToolBars = 100;

/// Goes over a list that begins with its length, of which `skipOne` skips an entry.
template <typename Skip>
bool skipList(QDataStream& stream, Skip skipOne) {
  qint32 count = 0;
  stream >> count;
  if (stream.status() != QDataStream::Ok || count < 0 || count > kMaxToolBars) return false;
  for (qint32 i = 0; i < count; ++i) {
    if (!skipOne()) return false;
  }
  return true;
}

bool skipToolBar(QDataStream& stream) {
  quint32 nameBytes = 0;
  stream >> nameBytes;
  const auto left = static_cast<quint64>(stream.device()->bytesAvailable());
  if (stream.status() != QDataStream::Ok || quint64{nameBytes} + kPlaceOfToolBar > left) return false;
  const int bytes = static_cast<int>(nameBytes) + kPlaceOfToolBar;
  return stream.skipRawData(bytes) == bytes;
}

bool skipLine(QDataStream& stream) {
  qint32 side = 0;
  stream >> side;
  return side >= 0 && side < 4 && skipList(stream, [&] { return skipToolBar(stream); });
}

}  // namespace

bool isToolBarState(const QByteArray& state) {
  QDataStream stream(state);
  qint32 marker = 0, version = 0, docks = -1;
  quint8 docksMarker = 0, toolBarsMarker = 0;
  stream >> marker >> version >> docksMarker >> docks;
  if (docksMarker != kDocksMarker || docks != 0) return false;
  if (stream.skipRawData(kSizeAndCorners) != kSizeAndCorners) return false;
  stream >> toolBarsMarker;
  return toolBarsMarker == kToolBarsMarker && skipList(stream, [&] { return skipLine(stream); }) &&
         stream.atEnd();
}

}  // namespace app
