// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/ColorReferences.h"

#include <QCoreApplication>

#include "colortool/table/TableImport.h"
#include "colortool/training/TableTrainer.h"

namespace widgets {
namespace {

struct ReferenceText {
  Q_DECLARE_TR_FUNCTIONS(widgets::ColorReferences)
};

}  // namespace

robotlink::Result<ReferenceTable> readReference(const std::filesystem::path& file) {
  const auto read = colortool::importTable(file);
  if (!read) return robotlink::failure(read.error().front().id, robotlink::describe(read.error()));
  const colortool::NamedColorTable& named = read->table;
  const auto own = classNumbers(named.classes, named.classes);
  return ReferenceTable{std::make_shared<const colortool::ColorTable>(
                            colortool::ColorTable::translated(named.file.singleClasses(), own)),
                        named.classes, QString::fromStdString(file.filename().string())};
}

ReferenceTable trainedReference(const colortool::Samples& samples, const QString& name) {
  colortool::TableTrainer trainer;
  return {std::make_shared<const colortool::ColorTable>(trainer.train(samples)), samples.classes, name};
}

QString stepName(const colortool::SampleDocument& document, std::size_t position) {
  if (position == 0) return ReferenceText::tr("the table before all steps");
  return ReferenceText::tr("the table after step %1, %2")
      .arg(position)
      .arg(QString::fromStdString(document.text(position - 1)));
}

ReferenceTable referenceOfNow(const ColorBench& bench) {
  const QString name = stepName(bench.document(), bench.document().position());
  if (!bench.upToDate()) return trainedReference(bench.samples(), name);
  return {bench.colors()->table, bench.colors()->samples.classes, name};
}

}  // namespace widgets
