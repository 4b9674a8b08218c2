// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>

namespace widgets {

/// The picture with its jagged edges smoothed, after T. Lottes, "FXAA" (NVIDIA, 2009): where brightness
/// changes steeply, the ends of the edge are looked for along it, and pixels are mixed with the one across it
/// by how far away these are. What is flat and what is straight along rows and columns stays as it is.
///
/// For pictures that a processor draws: it costs a tenth of what drawing with several samples a pixel does.
/// Format_RGB32; any thread.
QImage smoothEdges(const QImage& picture);

}  // namespace widgets
