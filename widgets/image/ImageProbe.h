// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QPointF>
#include <QSizeF>
#include <vector>

#include "widgets/drawings/DrawingTip.h"
#include "widgets/image/ImagePainter.h"

namespace widgets {

/// The drawings of a picture that are painted at a place of a widget of this size, the topmost first, with
/// the texts and places of their parts, in pixels of the image. Drawings without an id are left out.
std::vector<DrawingHit> drawingsAt(const ImagePicture& picture, const ImageViewport& viewport,
                                   const QSizeF& widget, const QPointF& at);

}  // namespace widgets
