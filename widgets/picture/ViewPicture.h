// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

class QImage;
class QPainter;
class QWidget;

// Functions that save and copy the pictures that views show. GUI thread.
namespace widgets {

/// Returns a picture as large as the widget in device pixels, black where `paint` paints nothing.
QImage paintedPicture(const QWidget& widget, const std::function<void(QPainter&)>& paint);
/// Writes a PNG file, whole or not at all. False, after a message box over `view`, if the picture is null or
/// the file cannot be written.
bool savePicture(QWidget* view, const QImage& picture, const QString& file);
/// Asks for the file with a dialog, then does the same. `proposal` is the suggested file name.
void savePictureAs(QWidget* view, const QImage& picture, const QString& proposal);
/// Puts the picture on the clipboard.
void copyPicture(const QImage& picture);

}  // namespace widgets
