// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QPainter;
class QWidget;

namespace widgets {

enum class SentencePlace : std::uint8_t { kTop, kMiddle };

/// Paints a sentence to the user over a picture, on a plate in the palette's colours, wrapped to the widget's
/// width.
void paintSentence(QPainter& painter, const QWidget& widget, const QString& text, SentencePlace place);

}  // namespace widgets
