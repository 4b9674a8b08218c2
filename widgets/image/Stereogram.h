// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace widgets {

/// A single image random dot stereogram of the same size: looked through, it shows in depth what `near` shows
/// in gray, where bright is near and black is far. The dots are the same for all images of a size, so that
/// moving pictures do not flicker. After H. W. Thimbleby, S. Inglis and I. H. Witten, "Displaying 3D images:
/// algorithms for single-image random-dot stereograms", IEEE Computer 27(10), 1994. Pure.
QImage stereogram(const QImage& near);

/// The image in gray, by its brightness. Pure.
QImage inGray(const QImage& image);

}  // namespace widgets
