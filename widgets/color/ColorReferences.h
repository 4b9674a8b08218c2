// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <filesystem>

#include "colortool/SampleDocument.h"
#include "robotlink/base/Error.h"
#include "widgets/color/ColorBench.h"

namespace widgets {

// Where tables to compare with come from. Any thread, unless they say otherwise.

/// A table in a file, a `.c64` or one of another team. Cells of several classes are of the first. Fails where
/// the file is no table, with all that is wrong, a line each.
robotlink::Result<ReferenceTable> readReference(const std::filesystem::path& file);
/// What samples make: about 20 ms with votes, up to a second with other methods.
ReferenceTable trainedReference(const colortool::Samples& samples, const QString& name);
/// What a table is called that is of the samples after so many steps: "the table after step 3, Stroke:
/// orange".
QString stepName(const colortool::SampleDocument& document, std::size_t position);

/// The table as it is now; made here if the bench does not yet have it. GUI thread.
ReferenceTable referenceOfNow(const ColorBench& bench);

}  // namespace widgets
