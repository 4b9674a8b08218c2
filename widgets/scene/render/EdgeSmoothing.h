// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace widgets {

/// Smooths jagged edges after T. Lottes, "FXAA" (NVIDIA, 2009): where brightness changes steeply, the ends of
/// the edge are searched along it, and pixels are mixed with their neighbors across the edge by their
/// distance from these ends. Flat areas and edges along rows and columns are unchanged.
///
/// For pictures that are drawn in software: it costs a tenth of drawing with several samples per pixel.
/// Format_RGB32; any thread.
QImage smoothEdges(const QImage& picture);

}  // namespace widgets
