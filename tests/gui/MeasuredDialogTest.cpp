// Columns of measured files: listed, seen, chosen by hand, and chosen anew for a signal that is there already.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAccessible>
#include <QAction>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QFile>
#include <QLabel>
#include <QMenu>
#include <QPointer>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTest>
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <set>

#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "render/SyntheticResult.h"
#include "results/Hdf5.h"
#include "studio/common/MessageBar.h"
#include "studio/common/Theme.h"
#include "studio/project/ProjectKeeper.h"
#include "studio/project/RunReader.h"
#include "studio/runs/MeasuredDialog.h"
#include "studio/runs/RunsPanel.h"

namespace squat::studio {
namespace {

constexpr int samples = 2000;
constexpr double rate = 5000;  // [Hz]
constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

using Column = std::function<double(int row)>;  // not-a-number: an empty field

double timeAt(int row) { return row / rate; }

// Samples of their own are the largest values: 70 m/s2 at 0.2 s, 20 m/s2 at 0.25 s. What comes before shows the decimal
// commas in the lines that the layout is found from.
double strike(double peak, double since) {
  return since < 0 ? 0.01 * std::sin(2000 * since) : peak * std::exp(-80 * since) * std::cos(1900 * since);
}
double left(int row) { return strike(70, timeAt(row) - 0.2); }
double right(int row) { return strike(20, timeAt(row) - 0.25); }

double largest(const std::vector<double>& values) {
  double found = 0;
  for (const double value : values) found = std::max(found, std::abs(value));
  return found;
}

class MeasuredColumns : public testing::Test {
 protected:
  void SetUp() override {
    const auto result = std::make_shared<const results::RunResult>(tests::syntheticResult());
    window_.store().add({result, "run", QString(), false});
    window_.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&window_));
  }
  // Semicolons and decimal commas.
  QString write(const QString& name, const QByteArray& head, const std::vector<Column>& columns) const {
    QFile file(folder_.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(head + '\n');
    for (int row = 0; row < samples; ++row) {
      QByteArray line;
      for (std::size_t c = 0; c < columns.size(); ++c) {
        const double value = columns[c](row);
        if (c > 0) line += ';';
        if (!std::isnan(value)) line += QByteArray::number(value, 'g', 12).replace('.', ',');
      }
      file.write(line + '\n');
    }
    return file.fileName();
  }
  QString writeArrays() const {
    results::ArrayTree tree;
    const auto add = [&](const std::string& path, const Column& column, const std::string& unit) {
      std::vector<double> values(samples);
      for (int row = 0; row < samples; ++row) values[static_cast<std::size_t>(row)] = column(row);
      tree.add(path, values, unit);
    };
    for (const std::string group : {"/left", "/right"}) {
      add(group + "/time", timeAt, "s");
      add(group + "/aba", group == "/left" ? left : right, "m/s2");
    }
    QFile file(folder_.filePath("boxes.h5"));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly));
    const auto bytes = results::encodeHdf5(tree, file.fileName().toStdString());
    file.write(reinterpret_cast<const char*>(bytes.data()), static_cast<qint64>(bytes.size()));
    return file.fileName();
  }
  // By the menu, with keys.
  void overlay(const QString& path) {
    tests::FileDialogTyping typing(path);
    tests::press(window_, Qt::Key_M, Qt::ControlModifier);
    ASSERT_TRUE(typing.done());
  }
  void openColumnsOf(int row) {
    QMenu menu;
    window_.findChild<RunsPanel*>()->fillMenu(menu, row);
    auto* columns = menu.findChild<QAction*>("runColumns");
    ASSERT_NE(columns, nullptr);
    columns->trigger();
    findDialog();
  }
  void findDialog() {
    dialog_ = window_.findChild<MeasuredDialog*>();
    ASSERT_TRUE(dialog_);
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog_));
  }
  QComboBox* list(const char* name) const { return dialog_->findChild<QComboBox*>(name); }
  QTableWidget* table() const { return dialog_->findChild<QTableWidget*>("measuredHead"); }
  QPushButton* button() const { return dialog_->findChild<QPushButton*>("takeMeasured"); }
  QString message() const { return dialog_->findChild<QLabel*>("measuredMessage")->text(); }
  bool isRead() const {
    return tests::passes([this] { return button()->isEnabled(); }, 20000);
  }
  bool isRefused(const QString& words) const {
    return tests::passes([&] { return message().contains(words); }, 20000) && !button()->isEnabled();
  }
  // The entry that begins so, with keys alone.
  void choose(const char* name, const QString& beginning) {
    QComboBox* entries = list(name);
    ASSERT_TRUE(entries->isVisible() && entries->isEnabled()) << name;
    entries->setFocus();
    tests::press(*dialog_, Qt::Key_Home);
    for (int i = 0; i < entries->count() && !entries->currentText().startsWith(beginning); ++i)
      tests::press(*dialog_, Qt::Key_Down);
    ASSERT_TRUE(entries->currentText().startsWith(beginning)) << entries->currentText().toStdString();
  }
  void typeInto(const char* name, const QString& words) {
    dialog_->findChild<QDoubleSpinBox*>(name)->setFocus();
    tests::press(*dialog_, Qt::Key_A, Qt::ControlModifier);
    tests::type(*dialog_, words);
    tests::press(*dialog_, Qt::Key_Return);
  }
  void take() {
    ASSERT_TRUE(isRead()) << message().toStdString();
    tests::click(*button());
    ASSERT_TRUE(tests::passes([this] { return !dialog_; }));
  }
  // [m/s²] of the curve that is drawn; -1: there is none.
  double tallest() const {
    const auto* figure = dialog_->findChild<plots::Figure*>();
    double found = -1;
    for (int i = 0; i < figure->graphCount(); ++i)
      for (const QCPGraphData& point : *figure->graph(i)->data()) found = std::max(found, std::abs(point.value));
    return found;
  }
  const StoredRun& measured(int row = 1) { return window_.store().at(row); }
  double peak(int row = 1) { return largest(*measured(row).record->signal("aba")); }

  QTemporaryDir folder_;
  MainWindow window_{tests::services()};
  QPointer<MeasuredDialog> dialog_;
};

// The column aba was taken, and another one is the right one.
TEST_F(MeasuredColumns, areChangedInPlaceAndComeBackInAProject) {
  const QString path = write("boxes.csv", "time [s];aba [m/s2];right box [m/s2]", {timeAt, left, right});
  ASSERT_TRUE(window_.openMeasured(path)) << window_.messages()->text().toStdString();
  RunStore& store = window_.store();
  store.rename(1, "north rail");
  store.setColour(1, QColor(200, 30, 60));
  project::MeasuredReading laid = measured().reading;
  laid.impact = 0.05, laid.gain = 0.5, laid.isAutomatic = false;
  store.setMeasured(1, project::realigned({measured().record, measured().reading}, laid));
  store.setReference(1);
  ASSERT_NO_FATAL_FAILURE(openColumnsOf(1));
  ASSERT_TRUE(isRead()) << message().toStdString();
  EXPECT_NEAR(tallest(), 0.5 * 70, 1e-9);
  EXPECT_TRUE(list("measuredSignal")->currentText().startsWith("2: aba [m/s²]"));
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "3: right box [m/s²]"));
  ASSERT_TRUE(isRead()) << message().toStdString();
  EXPECT_NEAR(tallest(), 0.5 * 20, 1e-9);
  EXPECT_NEAR(peak(), 0.5 * 70, 1e-9);  // nothing is taken yet
  ASSERT_NO_FATAL_FAILURE(take());
  ASSERT_EQ(store.rowCount(), 2);
  EXPECT_NEAR(peak(), 0.5 * 20, 1e-9);
  EXPECT_EQ(measured().label, "north rail");
  EXPECT_EQ(measured().colour, QColor(200, 30, 60));
  EXPECT_TRUE(measured().overlaid);
  EXPECT_EQ(measured().reading.impact, 0.05);
  EXPECT_EQ(measured().reading.gain, 0.5);
  EXPECT_EQ(store.chosenReference(), 1);
  const auto chosen = measured().record;
  const QString project = folder_.filePath("day.squat-project");
  ASSERT_TRUE(window_.saveProjectTo(project)) << window_.messages()->text().toStdString();
  ASSERT_TRUE(window_.closeProject());
  MainWindow tomorrow(tests::services());
  ASSERT_TRUE(tomorrow.openProject(project)) << tomorrow.messages()->text().toStdString();
  ASSERT_TRUE(tomorrow.reader()->waitFor(30000));
  EXPECT_TRUE(tomorrow.messages()->isEmpty()) << tomorrow.messages()->text().toStdString();
  const StoredRun& again = tomorrow.store().at(tomorrow.store().rowCount() - 1);
  ASSERT_TRUE(again.isMeasured());
  EXPECT_EQ(again.label, "north rail");
  EXPECT_EQ(again.record->position, chosen->position);  // to the last bit
  EXPECT_EQ(*again.record->signal("aba"), *chosen->signal("aba"));
}

TEST_F(MeasuredColumns, areAskedForWhereNoneIsClearlyMeant) {
  ASSERT_NO_FATAL_FAILURE(
      overlay(write("boxes.csv", "time [s];left box [m/s2];right box [m/s2]", {timeAt, left, right})));
  EXPECT_TRUE(window_.messages()->text().isEmpty()) << window_.messages()->text().toStdString();
  ASSERT_NO_FATAL_FAILURE(findDialog());
  ASSERT_TRUE(isRead()) << message().toStdString();
  ASSERT_EQ(table()->columnCount(), 3);
  EXPECT_EQ(table()->rowCount(), 20);
  EXPECT_EQ(table()->item(3, 0)->text(), "0,0006");  // as the file writes it
  const auto heading = [&](int column) { return table()->horizontalHeaderItem(column)->text(); };
  EXPECT_EQ(heading(0), "1: time [s]\ntime");
  EXPECT_EQ(heading(1), "2: left box [m/s²]\nsignal");
  EXPECT_EQ(heading(2), "3: right box [m/s²]\nvalues");
  EXPECT_EQ(list("measuredTime")->currentText(), "by header: 1: time [s]");
  EXPECT_EQ(list("measuredPosition")->currentText(), "by header: none");
  EXPECT_FALSE(list("measuredUnit")->isEnabled());  // the file says it
  EXPECT_EQ(list("measuredUnit")->currentText(), "m/s²");
  EXPECT_NEAR(tallest(), 70, 1e-9);
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "3: right"));
  ASSERT_TRUE(isRead()) << message().toStdString();
  EXPECT_NEAR(tallest(), 20, 1e-9);
  EXPECT_EQ(heading(1), "2: left box [m/s²]\nvalues");
  EXPECT_EQ(heading(2), "3: right box [m/s²]\nsignal");
  ASSERT_EQ(window_.store().rowCount(), 1);
  ASSERT_NO_FATAL_FAILURE(take());
  ASSERT_EQ(window_.store().rowCount(), 2);
  EXPECT_NEAR(peak(), 20, 1e-9);
  EXPECT_EQ(measured().label, "boxes");
  EXPECT_TRUE(window_.messages()->text().contains("No speed in file")) << window_.messages()->text().toStdString();
}

TEST_F(MeasuredColumns, areNotAskedForWhereOneIsClear) {
  ASSERT_NO_FATAL_FAILURE(overlay(write("clear.csv", "time [s];aba [m/s2];right box [m/s2]", {timeAt, left, right})));
  EXPECT_FALSE(window_.findChild<MeasuredDialog*>());
  ASSERT_NO_FATAL_FAILURE(overlay(write("only.csv", "time [s];right box [m/s2]", {timeAt, right})));
  EXPECT_FALSE(window_.findChild<MeasuredDialog*>());
  ASSERT_EQ(window_.store().rowCount(), 3);
  EXPECT_NEAR(peak(1), 70, 1e-9);
  EXPECT_NEAR(peak(2), 20, 1e-9);
}

TEST_F(MeasuredColumns, allOfThemAreTakenAtOnce) {
  window_.askHowToRead(write("boxes.csv", "time [s];left box [m/s2];right box [m/s2]", {timeAt, left, right}));
  ASSERT_NO_FATAL_FAILURE(findDialog());
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "all columns"));
  ASSERT_NO_FATAL_FAILURE(take());
  ASSERT_EQ(window_.store().rowCount(), 3);
  EXPECT_NEAR(peak(1), 70, 1e-9);
  EXPECT_NEAR(peak(2), 20, 1e-9);
  EXPECT_EQ(measured(2).label, "boxes: right box");
}

// The gap lies far behind the lines that are shown.
TEST_F(MeasuredColumns, thatCannotBeReadSayWhyAndAreNotTaken) {
  const auto holed = [](int row) { return row == 1500 ? nothing : left(row); };
  const QString path = write("boxes.csv", "time [s];aba [m/s2];force [kN];holed [m/s2]", {timeAt, left, right, holed});
  ASSERT_TRUE(window_.openMeasured(path)) << window_.messages()->text().toStdString();
  const auto before = measured().record;
  ASSERT_NO_FATAL_FAILURE(openColumnsOf(1));
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "3: force [kN]"));
  EXPECT_TRUE(isRefused("not an acceleration")) << message().toStdString();
  EXPECT_LT(tallest(), 0);
  tests::press(*dialog_, Qt::Key_Return);
  ASSERT_TRUE(dialog_ && dialog_->isVisible());
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "4: holed"));
  EXPECT_TRUE(isRefused("line 1502")) << message().toStdString();  // a heading, and lines count from 1
  EXPECT_FALSE(message().contains(folder_.path())) << message().toStdString();
  tests::press(*dialog_, Qt::Key_Return);
  ASSERT_TRUE(dialog_ && dialog_->isVisible());
  EXPECT_EQ(measured().record, before);
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "2: aba"));
  EXPECT_TRUE(isRead()) << message().toStdString();
  tests::press(*dialog_, Qt::Key_Escape);
  ASSERT_TRUE(tests::passes([this] { return !dialog_; }));
  EXPECT_EQ(measured().record, before);
}

// Two boxes and no time: the column and the rate are asked for, and a wrong answer is told.
TEST_F(MeasuredColumns, ofAFileThatDoesNotTellByItself) {
  const QString path = write("boxes.csv", "left box [m/s2];right box [m/s2]", {left, right});
  ASSERT_FALSE(window_.openMeasured(path));
  window_.askHowToRead(path);
  ASSERT_NO_FATAL_FAILURE(findDialog());
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "2: right box"));
  EXPECT_TRUE(isRefused("sampling rate")) << message().toStdString();
  ASSERT_NO_FATAL_FAILURE(typeInto("measuredRate", "4000,5"));
  ASSERT_NO_FATAL_FAILURE(take());
  ASSERT_EQ(window_.store().rowCount(), 2);
  EXPECT_NEAR(measured().record->time[1] - measured().record->time[0], 1 / 4000.5, 1e-12);
  EXPECT_NEAR(peak(), 20, 1e-9);
}

// Headings that no reader knows: time and positions are chosen, and the speed is no longer asked for.
TEST_F(MeasuredColumns, axesAreChosen) {
  const auto place = [](int row) { return 8.0 * row; };          // 40 m/s
  const auto clock = [](int row) { return 1e3 * timeAt(row); };  // [ms]
  window_.askHowToRead(write("clock.csv", "clock [ms];aba [m/s2];place [mm]", {clock, right, place}));
  ASSERT_NO_FATAL_FAILURE(findDialog());
  EXPECT_TRUE(isRefused("no time column")) << message().toStdString();
  ASSERT_NO_FATAL_FAILURE(choose("measuredTime", "1: clock [ms]"));
  ASSERT_TRUE(isRead()) << message().toStdString();
  EXPECT_TRUE(message().contains("5000 Hz")) << message().toStdString();
  auto* speed = dialog_->findChild<QDoubleSpinBox*>("measuredSpeed");
  EXPECT_TRUE(speed->isEnabled());
  EXPECT_EQ(speed->text(), "30 m/s of the case");
  ASSERT_NO_FATAL_FAILURE(choose("measuredPosition", "3: place [mm]"));
  EXPECT_FALSE(speed->isEnabled());
  ASSERT_NO_FATAL_FAILURE(take());
  const auto& record = *measured().record;
  EXPECT_NEAR(record.time[1] - record.time[0], 1 / rate, 1e-12);
  EXPECT_NEAR(record.position[1] - record.position[0], 8e-3, 1e-9);
  EXPECT_TRUE(record.chainage);
}

// Without a unit in the file it is chosen, and is there again when the columns are looked at again.
TEST_F(MeasuredColumns, aUnitIsChosenWhereTheFileHasNone) {
  window_.askHowToRead(write("bare.csv", "time [s];left;right [m/s2]", {timeAt, left, right}));
  ASSERT_NO_FATAL_FAILURE(findDialog());
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "2: left"));
  ASSERT_NO_FATAL_FAILURE(choose("measuredUnit", "g"));
  ASSERT_TRUE(isRead()) << message().toStdString();
  EXPECT_NEAR(tallest(), 70 * 9.80665, 1e-6);
  ASSERT_NO_FATAL_FAILURE(take());
  EXPECT_NEAR(peak(), 70 * 9.80665, 1e-6);
  ASSERT_NO_FATAL_FAILURE(openColumnsOf(1));
  EXPECT_EQ(list("measuredUnit")->currentText(), "g");
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "3: right [m/s²]"));
  ASSERT_NO_FATAL_FAILURE(take());
  EXPECT_NEAR(peak(), 20, 1e-9);  // its own unit alone
}

TEST_F(MeasuredColumns, ofOneRunOfSeveralAreChanged) {
  const auto run = [](int row) { return row < 1000 ? 0.0 : 1.0; };
  const auto since = [](int row) { return timeAt(row % 1000); };
  const auto scaled = [&](double peak) {
    return [=](int row) { return (1 + run(row)) * strike(peak, since(row) - 0.1); };
  };
  const QString path = write("runs.csv", "run;time [s];aba [m/s2];right [m/s2]", {run, since, scaled(70), scaled(20)});
  ASSERT_TRUE(window_.openMeasured(path)) << window_.messages()->text().toStdString();
  ASSERT_EQ(window_.store().rowCount(), 3);
  ASSERT_NO_FATAL_FAILURE(openColumnsOf(2));
  ASSERT_NO_FATAL_FAILURE(choose("measuredSignal", "4: right"));
  ASSERT_NO_FATAL_FAILURE(take());
  EXPECT_EQ(measured(2).record->run, "right, run 1");
  EXPECT_NEAR(peak(2), 40, 1e-9);
  EXPECT_NEAR(peak(1), 70, 1e-9);
}

// The first of two groups was read in silence.
TEST_F(MeasuredColumns, ofSeveralGroupsOfArraysAreAskedFor) {
  const QString path = writeArrays();
  ASSERT_NO_FATAL_FAILURE(overlay(path));
  ASSERT_NO_FATAL_FAILURE(findDialog());
  ASSERT_TRUE(isRead()) << message().toStdString();
  EXPECT_EQ(list("measuredPart")->count(), 2);
  EXPECT_NEAR(tallest(), 70, 1e-9);
  ASSERT_EQ(table()->rowCount(), 20);
  const int time = table()->horizontalHeaderItem(0)->text().contains("time") ? 0 : 1;
  EXPECT_EQ(table()->item(3, time)->text(), "0.0006");
  ASSERT_NO_FATAL_FAILURE(choose("measuredPart", "/right, 2000 samples"));
  ASSERT_TRUE(isRead()) << message().toStdString();
  EXPECT_NEAR(tallest(), 20, 1e-9);
  ASSERT_NO_FATAL_FAILURE(take());
  ASSERT_EQ(window_.store().rowCount(), 2);
  EXPECT_NEAR(peak(), 20, 1e-9);
  ASSERT_NO_FATAL_FAILURE(openColumnsOf(1));
  EXPECT_TRUE(list("measuredPart")->currentText().startsWith("/right"));
  ASSERT_NO_FATAL_FAILURE(choose("measuredPart", "/left"));
  ASSERT_NO_FATAL_FAILURE(take());
  ASSERT_EQ(window_.store().rowCount(), 2);
  EXPECT_NEAR(peak(), 70, 1e-9);
}

TEST_F(MeasuredColumns, theDialogMayCloseWhileTheFileIsRead) {
  window_.askHowToRead(write("boxes.csv", "time [s];left box [m/s2];right box [m/s2]", {timeAt, left, right}));
  dialog_ = window_.findChild<MeasuredDialog*>();
  ASSERT_TRUE(dialog_);
  dialog_->reject();
  EXPECT_TRUE(tests::passes([this] { return !dialog_; }));
  EXPECT_EQ(window_.store().rowCount(), 1);
}

TEST_F(MeasuredColumns, aSignalThatIsRemovedEndsIt) {
  ASSERT_TRUE(window_.openMeasured(write("one.csv", "time [s];aba [m/s2]", {timeAt, left})));
  ASSERT_NO_FATAL_FAILURE(openColumnsOf(1));
  window_.store().remove(1);
  EXPECT_TRUE(tests::passes([this] { return !dialog_; }));
}

TEST_F(MeasuredColumns, everyControlHasANameAndKeysOfItsOwn) {
  window_.askHowToRead(writeArrays());
  ASSERT_NO_FATAL_FAILURE(findDialog());
  ASSERT_TRUE(isRead()) << message().toStdString();
  std::set<QString> taken;
  int seen = 0;
  for (QWidget* widget : dialog_->findChildren<QWidget*>()) {
    if (widget->objectName().startsWith("qt_")) continue;
    if (const auto* each = qobject_cast<QPushButton*>(widget)) {
      EXPECT_TRUE(taken.insert(each->shortcut().toString()).second) << each->text().toStdString();
      EXPECT_FALSE(each->shortcut().isEmpty()) << each->text().toStdString();
    }
    if (const auto* label = qobject_cast<QLabel*>(widget); label && label->buddy()) {
      const QString keys = QKeySequence::mnemonic(label->text()).toString();
      EXPECT_FALSE(keys.isEmpty()) << label->text().toStdString();
      EXPECT_TRUE(taken.insert(keys).second) << label->text().toStdString();
    }
    if (!(widget->focusPolicy() & Qt::TabFocus) || !widget->isVisible() || widget->inherits("QHeaderView")) continue;
    QAccessibleInterface* told = QAccessible::queryAccessibleInterface(widget);
    ASSERT_NE(told, nullptr);
    EXPECT_FALSE(told->text(QAccessible::Name).isEmpty())
        << widget->metaObject()->className() << ' ' << widget->objectName().toStdString();
    ++seen;
  }
  EXPECT_GE(seen, 10);  // five lists, two numbers, a table, two buttons
}

// No extreme is lost, and none is made up.
TEST(ThinnedCurve, keepsEveryExtreme) {
  std::vector<double> position, value;
  for (int i = 0; i < 100000; ++i) {
    position.push_back(1e-3 * i);
    value.push_back(i == 70001 ? -9 : i == 70002 ? 11 : std::sin(0.01 * i));
  }
  const PreviewCurve curve = thinned(position, value, 600);
  EXPECT_LE(curve.position.size(), 1200u);
  EXPECT_TRUE(std::is_sorted(curve.position.begin(), curve.position.end()));
  EXPECT_EQ(*std::min_element(curve.value.begin(), curve.value.end()), -9);
  EXPECT_EQ(*std::max_element(curve.value.begin(), curve.value.end()), 11);
  EXPECT_EQ(thinned({1, 2, 3}, {4, 6, 5}, 600).value, (std::vector<double>{4, 6, 5}));
}

}  // namespace
}  // namespace squat::studio
