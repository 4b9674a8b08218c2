// SPDX-License-Identifier: GPL-3.0-or-later
#include "widgets/color/samples/ColorSamplesView.h"

#include <QAbstractItemModelTester>
#include <QAbstractProxyModel>
#include <QAction>
#include <QApplication>
#include <QDoubleSpinBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QTreeView>
#include <QUndoView>

#include "tests/widgets/CameraBench.h"
#include "tests/widgets/DialogAnswer.h"

Q_DECLARE_METATYPE(widgets::ColorFramePtr)

namespace widgets::test {

/// The list of strokes and the history, by mouse and keys.
class ColorSamplesViewTest : public QObject {
  Q_OBJECT
 private Q_SLOTS:
  void initTestCase() { qRegisterMetaType<ColorFramePtr>("widgets::ColorFramePtr"); }
  void init() {
    world_ = std::make_unique<CameraBench>();
    bench_ = &colorBench(world_->context);
    bench_->setDocument(colortool::emptySamples());
    bench_->setFrame(world_->frame());
    view_ = std::make_unique<ColorSamplesView>(world_->context);
    view_->resize(1000, 320);
    view_->show();
    QVERIFY(QTest::qWaitForWindowActive(view_.get()));
    tree_ = &child<QTreeView>(*view_, "samplesTree");
    testers_.clear();
    auto* source = static_cast<QAbstractProxyModel*>(tree_->model())->sourceModel();
    for (QAbstractItemModel* model : {tree_->model(), source}) {
      testers_.push_back(std::make_unique<QAbstractItemModelTester>(
          model, QAbstractItemModelTester::FailureReportingMode::Fatal));
    }
  }
  void cleanup() {
    testers_.clear();
    view_.reset();
    world_.reset();
  }

  void strokesAreListedWithWhatTheySay() {
    QVERIFY(child<QLabel>(*tree_->viewport(), "emptyHint").isVisible());
    stroke(2, 30, 7);
    stroke(1, 8, 7);
    QVERIFY(!child<QLabel>(*tree_->viewport(), "emptyHint").isVisible());
    QCOMPARE(text(0, StrokeModel::kClass), QStringLiteral("orange"));  // sorted by class
    QCOMPARE(text(1, StrokeModel::kClass), QStringLiteral("green"));
    QCOMPARE(text(0, StrokeModel::kPixels), QStringLiteral("29"));
    QCOMPARE(text(0, StrokeModel::kTool), QStringLiteral("brush"));
    QCOMPARE(text(0, StrokeModel::kCamera), QStringLiteral("red1"));
    QVERIFY(text(0, StrokeModel::kImage).startsWith(QStringLiteral("red1/camera/image")));
    QVERIFY(!index(0, StrokeModel::kClass).data(Qt::DecorationRole).value<QIcon>().isNull());
    QCOMPARE(child<QLabel>(*view_, "samplesCount").text(), QStringLiteral("2 strokes"));
  }

  void aChangedStrokeStaysWhereItIsThoughTheOrderIsAnother() {
    for (int i = 0; i < 12; ++i) stroke(3, 6 + i, 22);
    for (int i = 0; i < 12; ++i) stroke(2, 26 + i, 7);
    for (int i = 0; i < 12; ++i) stroke(3, 6 + i, 24);
    tree_->setCurrentIndex(index(6, StrokeModel::kClass));
    tree_->scrollTo(index(9, StrokeModel::kClass), QAbstractItemView::PositionAtBottom);
    const int top = tree_->visualRect(tree_->currentIndex()).top();
    const std::uint64_t id = bench_->samples().strokes[12 + 6]->id;
    colortool::Samples next = bench_->samples();
    colortool::restate(next, {id}, {3, false, 1});
    bench_->change(QStringLiteral("Class white"), next);
    QVERIFY(tree_->currentIndex().row() > 6);
    QCOMPARE(text(tree_->currentIndex().row(), StrokeModel::kClass), QStringLiteral("white"));
    const int off = tree_->visualRect(tree_->currentIndex()).top() - top;
    QVERIFY2(std::abs(off) < tree_->visualRect(tree_->currentIndex()).height(),
             qPrintable(QString::number(off)));
  }

  void theStrokeUnderTheMouseStaysThereWhileItIsChanged() {
    for (int i = 0; i < 3; ++i) stroke(3, 6 + i, 22);
    for (int i = 0; i < 3; ++i) stroke(1, 8, 7 + i);
    QEvent enters(QEvent::Enter), leaves(QEvent::Leave);
    QCoreApplication::sendEvent(tree_->viewport(), &enters);
    colortool::Samples next = bench_->samples();
    colortool::restate(next, {next.strokes[4]->id},
                       {3, false, 1});  // an orange one, the second row, is white
    bench_->change(QStringLiteral("Class white"), next);
    QCOMPARE(text(1, StrokeModel::kClass), QStringLiteral("white"));
    QCOMPARE(text(0, StrokeModel::kClass), QStringLiteral("orange"));
    QCOMPARE(text(2, StrokeModel::kClass), QStringLiteral("orange"));
    stroke(1, 8, 12);
    QCOMPARE(text(6, StrokeModel::kClass), QStringLiteral("orange"));  // the new one is last
    QCoreApplication::sendEvent(tree_->viewport(), &leaves);
    QCOMPARE(text(1, StrokeModel::kClass), QStringLiteral("orange"));
    QCOMPARE(text(6, StrokeModel::kClass), QStringLiteral("white"));
  }

  void whatDisagreesIsFoundBySortingByIt() {
    for (const double x : {8.0, 10.0, 12.0}) stroke(1, x, 7);
    for (const double x : {28.0, 30.0, 32.0}) stroke(2, x, 7);
    stroke(2, 9, 8);  // by mistake, on what is orange
    QTRY_VERIFY(bench_->quality() != nullptr && bench_->quality()->strokes);
    QTRY_COMPARE(text(6, StrokeModel::kRight), QStringLiteral("0 %"));
    QTest::mouseClick(tree_->header()->viewport(), Qt::LeftButton, {},
                      {tree_->header()->sectionViewportPosition(StrokeModel::kRight) + 10, 8});
    if (tree_->header()->sortIndicatorOrder() == Qt::DescendingOrder)
      tree_->sortByColumn(StrokeModel::kRight, Qt::AscendingOrder);
    QCOMPARE(text(0, StrokeModel::kRight), QStringLiteral("0 %"));
    QCOMPARE(text(0, StrokeModel::kClass), QStringLiteral("green"));
    QCOMPARE(text(1, StrokeModel::kRight), QStringLiteral("100 %"));
    keepPicture(*view_, "color-samples");
  }

  void theKeyDeleteRemovesWhatIsSelected() {
    for (const double x : {8.0, 10.0, 12.0}) stroke(1, x, 7);
    clickCell(0, StrokeModel::kImage);
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, Qt::ControlModifier, center(2, StrokeModel::kImage));
    QTest::keyClick(tree_, Qt::Key_Delete);
    QCOMPARE(bench_->samples().strokes.size(), std::size_t{1});
    QCOMPARE(bench_->samples().strokes[0]->id, std::uint64_t{2});
    QTest::keyClick(tree_, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(bench_->samples().strokes.size(), std::size_t{3});
  }

  void cellsAreEditedForAllThatIsSelected() {
    for (const double x : {8.0, 10.0, 12.0}) stroke(1, x, 7);
    clickCell(0, StrokeModel::kImage);
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, Qt::ControlModifier,
                      center(1, StrokeModel::kWeight));
    QTest::mouseDClick(tree_->viewport(), Qt::LeftButton, Qt::ControlModifier,
                       center(1, StrokeModel::kWeight));
    QTRY_VERIFY(tree_->viewport()->findChild<QDoubleSpinBox*>() != nullptr);
    auto* field = tree_->viewport()->findChild<QDoubleSpinBox*>();
    field->selectAll();
    QTest::keyClicks(field, QStringLiteral("3"));
    QTest::keyClick(field, Qt::Key_Return);
    QTRY_COMPARE(weights(), (std::vector<double>{3, 3, 1}));
    clickCell(2, StrokeModel::kImage);
    const QRect cell = tree_->visualRect(index(2, StrokeModel::kMustNotBe));
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, {}, {cell.left() + 10, cell.center().y()});
    QTRY_VERIFY(bench_->samples().strokes[2]->mustNotBe);
    QVERIFY(!bench_->samples().strokes[0]->mustNotBe);
    bench_->undoStack().undo();
    bench_->undoStack().undo();
    QCOMPARE(weights(), (std::vector<double>{1, 1, 1}));
  }

  void theMenuSaysAnotherClass() {
    stroke(1, 8, 7);
    clickCell(0, StrokeModel::kImage);
    QMenu* menu = openMenu(0);
    child<QAction>(*menu, "class.2").trigger();
    menu->close();
    QCOMPARE(int{bench_->samples().strokes[0]->colorClass}, 2);
    QCOMPARE(text(0, StrokeModel::kClass), QStringLiteral("green"));
  }

  void aWordForTheLightIsThatOfTheImages() {
    stroke(1, 8, 7);
    stroke(2, 30, 7);
    clickCell(0, StrokeModel::kImage);
    DialogAnswer lamp([](QDialog& dialog) {
      auto* field = dialog.findChild<QLineEdit*>();
      field->selectAll();
      QTest::keyClicks(field, QStringLiteral("lamp"));
      DialogAnswer::press(dialog, QDialogButtonBox::AcceptRole);
    });
    click(*view_, "samplesLighting");
    QVERIFY(lamp.asked());
    QCOMPARE(text(0, StrokeModel::kLighting), QStringLiteral("lamp"));
    QCOMPARE(text(1, StrokeModel::kLighting), QStringLiteral("lamp"));  // the same image
  }

  void aDoubleClickShowsTheImage() {
    QSignalSpy wanted(bench_, &ColorBench::frameWanted);
    stroke(1, 8, 7);
    bench_->collect();
    const ColorFramePtr put = bench_->frame();
    doubleClick(0);
    QCOMPARE(wanted.size(), 1);
    QCOMPARE(wanted[0][0].value<ColorFramePtr>(), put);

    // Not put aside, but in the history of the stream.
    bench_->removeCollected(0);
    world_->show();
    world_->advance(5000);
    doubleClick(0);
    QVERIFY(!world_->session.timeline().live());
    QVERIFY(std::abs(robotlink::seconds(world_->session.timeline().shown() - put->time())) < 0.01);

    // Nowhere.
    QStringList reasons;
    connect(bench_, &ColorBench::failed, this, [&](const QString& reason) { reasons << reason; });
    bench_->setDocument(colortool::quarterSamples());
    doubleClick(0);
    QCOMPARE(reasons.size(), 1);
  }

  void aClickInTheHistoryGoesBackAndForth() {
    for (const double x : {8.0, 10.0, 12.0}) stroke(1, x, 7);
    auto* history = &child<QUndoView>(*view_, "samplesHistory");
    QCOMPARE(history->model()->rowCount(), 4);
    const auto step = [history](int row) {
      QTest::mouseClick(history->viewport(), Qt::LeftButton, {},
                        history->visualRect(history->model()->index(row, 0)).center());
    };
    step(1);
    QCOMPARE(bench_->samples().strokes.size(), std::size_t{1});
    step(3);
    QCOMPARE(bench_->samples().strokes.size(), std::size_t{3});
    step(0);
    QVERIFY(bench_->samples().strokes.empty());
  }

 private:
  QModelIndex index(int row, int column) const { return tree_->model()->index(row, column); }
  QString text(int row, int column) const { return index(row, column).data().toString(); }
  QPoint center(int row, int column) const { return tree_->visualRect(index(row, column)).center(); }
  void clickCell(int row, int column) {
    QTest::mouseClick(tree_->viewport(), Qt::LeftButton, {}, center(row, column));
  }
  void doubleClick(int row) {
    clickCell(row, StrokeModel::kTool);
    QTest::mouseDClick(tree_->viewport(), Qt::LeftButton, {}, center(row, StrokeModel::kTool));
  }
  QMenu* openMenu(int row) {
    const QPoint at = center(row, StrokeModel::kTool);
    QContextMenuEvent event(QContextMenuEvent::Mouse, at, tree_->viewport()->mapToGlobal(at));
    QApplication::sendEvent(tree_->viewport(), &event);
    return &child<QMenu>(*view_, "samplesMenu");
  }
  std::vector<double> weights() const {
    std::vector<double> result;
    for (const auto& stroke : bench_->samples().strokes) result.push_back(stroke->weight);
    return result;
  }
  void stroke(int colorClass, double x, double y) {
    bench_->setCurrentClass(colorClass);
    const colortool::ImagePoint at[] = {{x, y}};
    bench_->addStroke(colortool::brushArea(40, 30, at, 3), "brush");
  }

  std::unique_ptr<CameraBench> world_;
  std::unique_ptr<ColorSamplesView> view_;
  std::vector<std::unique_ptr<QAbstractItemModelTester>> testers_;
  ColorBench* bench_ = nullptr;
  QTreeView* tree_ = nullptr;
};

const GuiTest<ColorSamplesViewTest> kColorSamplesViewTest;

}  // namespace widgets::test

#include "ColorSamplesViewTest.moc"
