// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QImage;
class QWidget;

namespace widgets {

// What views do with the pictures that they show.

/// Writes a PNG file whole or not at all. What fails is shown over `view`.
bool savePicture(QWidget* view, const QImage& picture, const QString& file);
/// Asks for a file first.
void savePictureAs(QWidget* view, const QImage& picture, const QString& proposal);
void copyPicture(const QImage& picture);

}  // namespace widgets
