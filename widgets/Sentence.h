// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QPainter;
class QWidget;

// Sentences to the user that are painted over a picture.
namespace widgets {

/// The position of the sentence: at the widget's upper edge or in its middle.
enum class SentencePlace : std::uint8_t { kTop, kMiddle };

/// Paints the text on a rounded rectangle in the palette's tooltip colors, wrapped to the widget's width.
/// Does not change the painter's state.
void paintSentence(QPainter& painter, const QWidget& widget, const QString& text, SentencePlace place);

}  // namespace widgets
