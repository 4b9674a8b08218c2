// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "robotlink/base/Error.h"

class QImage;
class QWidget;

namespace widgets {

/// Writes a PNG file, whole or not at all. Fails if the picture is null, the file is not named
/// .png, or it cannot be written. GUI
/// thread.
robotlink::Result<void> writePicture(const QImage& picture, const QString& file);

/// Writes what a widget shows as SVG, whole or not at all: what it paints as lines and texts stays so, images
/// are in it as pixels. Fails if it cannot be written. GUI thread.
robotlink::Result<void> writeVectorPicture(QWidget& shown, const QString& file);

}  // namespace widgets
