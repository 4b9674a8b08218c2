// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>

#include "colortool/samples/SampleDocument.h"
#include "robotlink/base/Error.h"
#include "widgets/color/ColorBench.h"

// The sources of reference tables. Any thread, unless said otherwise.
namespace widgets {

/// Reads a table from a .c64 file or a format of another team. Cells of several classes get the first one.
/// Fails if the file is no table, with all problems, one per line.
robotlink::Result<ReferenceTable> readReference(const std::filesystem::path& file);
/// Trains a table from samples: about 20 ms with votes, up to a second with other methods.
ReferenceTable trainedReference(const colortool::Samples& samples, const QString& name);
/// The name of the table after `position` steps of the history: "the table after step 3, Stroke: orange".
QString stepName(const colortool::SampleDocument& document, std::size_t position);

/// The current table; trained here if the bench does not have it yet. GUI thread.
ReferenceTable referenceOfNow(const ColorBench& bench);

}  // namespace widgets
