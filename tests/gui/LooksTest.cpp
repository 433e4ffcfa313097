// How the window looks: nothing cut, nothing on top of something else, nothing empty, in every tab, light and dark, on
// plain and double resolution, and on the smallest screen that it is made for.
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QFile>
#include <QHeaderView>
#include <QImage>
#include <QLabel>
#include <QLayout>
#include <QPushButton>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTest>
#include <cmath>
#include <functional>
#include <map>

#include "case/ParameterTable.h"
#include "gui/MadeUpRun.h"
#include "plots/Figure.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "studio/common/FigureSizeDialog.h"
#include "studio/common/FixedLabel.h"
#include "studio/common/MessageBar.h"
#include "studio/common/Theme.h"
#include "studio/comparison/ComparisonWindow.h"
#include "studio/comparison/MapWindow.h"
#include "studio/document/ParameterForm.h"
#include "studio/document/ParameterRow.h"
#include "studio/model/SceneWidget.h"
#include "studio/profile/ImportDialog.h"
#include "studio/profile/SquatDialog.h"
#include "studio/runs/AlignDialog.h"
#include "studio/runs/MeasuredDialog.h"
#include "studio/tools/ToolTabs.h"
#include "studio/tools/ToolWindow.h"
#include "studio/window/HelpWindow.h"

namespace squat::studio {
namespace {

// A tablet or half a screen of 2048 pixels, and a laptop of 1366 x 768 less the frames of a desktop.
constexpr QSize smallest(1000, 700);

// A made-up run with a patch of 6 x 4 points.
results::RunResult runToLookAt() {
  results::RunResult result = tests::syntheticResult();
  results::PatchSnapshot patch;
  patch.name = "impact";
  for (int i = 0; i < 6; ++i)
    for (int j = 0; j < 4; ++j) {
      patch.x.push_back(0.002f * static_cast<float>(i) - 0.005f);
      patch.y.push_back(0.002f * static_cast<float>(j) - 0.003f);
      patch.pressure.push_back(1e8f * static_cast<float>(1 + i + j));
      patch.slipping.push_back(i < 2);
      patch.area.push_back(4e-6f);
    }
  result.patches = {patch};
  return result;
}

class Looks : public testing::Test {
 protected:
  void SetUp() override {
    window_ = std::make_unique<MainWindow>(tests::services());
    window_->openCase("light-defect");
    window_->store().add(
        {std::make_shared<const results::RunResult>(runToLookAt()), "light-defect #1", QString(), false});
    window_->resize(1280, 700);
    window_->show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(window_.get()));
  }
  void TearDown() override {
    if (window_) window_->setDark(false);
  }
  QImage picture(double ratio) const {
    QImage image((QSizeF(window_->size()) * ratio).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    window_->render(&image);
    return image;
  }
  std::unique_ptr<MainWindow> window_;
};

QString nameOf(const QWidget& widget) {
  QString text;
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) text = label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) text = button->text();
  return QStringLiteral("%1 '%2' '%3'").arg(widget.metaObject()->className(), widget.objectName(), text.left(40));
}

// Width that the text of a label or button takes, its frame left out; 0 for other widgets.
int widthOfText(const QWidget& widget) {
  QString text;
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    text = label->text();
    const bool isInTip = qobject_cast<const FixedLabel*>(label) && label->toolTip() == text;
    if (label->wordWrap() || isInTip) return 0;
    if (label->buddy()) text.remove('&');
  } else if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
    text = button->text().remove('&');
  } else if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    text = box->currentText();
  }
  return widget.fontMetrics().size(0, text).width();  // of the longest line
}

// Labels that wrap are as high as their lines ask for.
bool isCutInHeight(const QWidget& widget) {
  const auto* label = qobject_cast<const QLabel*>(&widget);
  return label && label->wordWrap() && !label->text().isEmpty() &&
         label->heightForWidth(label->width()) > label->height() + 2;
}

// Needs more than its text: the box of a check box, the arrow of a combo box, the buttons of a number.
bool isCutWithItsFrame(const QWidget& widget) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  const bool framed = (button && !button->text().isEmpty()) || qobject_cast<const QComboBox*>(&widget) ||
                      qobject_cast<const QAbstractSpinBox*>(&widget);
  const QSize least = widget.minimumSizeHint();
  return framed && (widget.width() < least.width() || widget.height() < least.height());
}

// A label that wraps breaks between words: the longest must fit.
QString cutWord(const QWidget& widget) {
  const auto* label = qobject_cast<const QLabel*>(&widget);
  if (!label || !label->wordWrap() || label->textFormat() == Qt::RichText) return {};
  for (const QString& word : label->text().split(' ', Qt::SkipEmptyParts))
    if (label->fontMetrics().horizontalAdvance(word) > label->width()) return word;
  return {};
}

// Tabs that a bar has no room for are cut or hidden behind arrows; so are headings of columns.
void judgeBars(const QWidget& widget) {
  if (const auto* bar = qobject_cast<const QTabBar*>(&widget)) {
    EXPECT_LE(bar->sizeHint().width(), bar->width()) << "tabs are cut, the first is " << bar->tabText(0).toStdString();
  }
  if (const auto* header = qobject_cast<const QHeaderView*>(&widget);
      header && header->orientation() == Qt::Horizontal && header->model()) {
    for (int section = 0; section < header->count(); ++section)
      for (const QString& line : header->model()->headerData(section, Qt::Horizontal).toString().split('\n'))
        EXPECT_GE(header->sectionSize(section), header->fontMetrics().horizontalAdvance(line))
            << line.toStdString() << " is cut";
  }
}

// The label of an axis stands at its middle and ends within the figure.
void judgeAxes(const QWidget& widget) {
  const auto* figure = qobject_cast<const plots::Figure*>(&widget);
  if (!figure) return;
  for (const QCPAxis* axis : {figure->xAxis, figure->yAxis}) {
    const QRectF room = axis->axisRect()->rect();
    const bool across = axis->orientation() == Qt::Horizontal;
    const double middle = across ? room.center().x() : room.center().y(),
                 end = across ? widget.width() : widget.height();
    const double half = 0.5 * QFontMetrics(axis->labelFont()).horizontalAdvance(axis->label());
    EXPECT_GE(middle - half, 0) << axis->label().toStdString() << " is cut";
    EXPECT_LE(middle + half, end) << axis->label().toStdString() << " is cut";
  }
}

void judgeLayout(const QWidget& window, int least = 100) {
  int seen = 0;
  for (const QWidget* widget : window.findChildren<QWidget*>()) {
    if (!widget->isVisible() || widget->isWindow()) continue;
    ++seen;
    EXPECT_LE(widthOfText(*widget), widget->width()) << nameOf(*widget).toStdString() << " is cut";
    EXPECT_FALSE(isCutInHeight(*widget)) << nameOf(*widget).toStdString() << " is cut";
    EXPECT_FALSE(isCutWithItsFrame(*widget)) << nameOf(*widget).toStdString() << " is cut";
    EXPECT_EQ(cutWord(*widget), "") << nameOf(*widget).toStdString() << " is cut";
    judgeBars(*widget);
    judgeAxes(*widget);
    const QWidget* parent = widget->parentWidget();
    if (!parent->layout() || parent->layout()->indexOf(widget) < 0) continue;
    EXPECT_TRUE(parent->rect().contains(widget->geometry()))
        << nameOf(*widget).toStdString() << " leaves " << nameOf(*parent).toStdString();
    for (const QObject* other : parent->children()) {
      const auto* sibling = qobject_cast<const QWidget*>(other);
      if (!sibling || sibling == widget || !sibling->isVisible() || parent->layout()->indexOf(sibling) < 0) continue;
      EXPECT_FALSE(sibling->geometry().intersects(widget->geometry()))
          << nameOf(*widget).toStdString() << " lies on " << nameOf(*sibling).toStdString();
    }
  }
  EXPECT_GT(seen, least);
}

TEST_F(Looks, fitsTheSmallestScreen) {
  EXPECT_LE(window_->minimumWidth(), smallest.width());
  EXPECT_LE(window_->minimumHeight(), smallest.height());
  window_->resize(smallest);
  for (const QString& tab : MainWindow::tabNames()) {
    SCOPED_TRACE(tab.toStdString());
    window_->showTab(tab);
    QTest::qWait(20);
    ASSERT_EQ(window_->size(), smallest);
    judgeLayout(*window_, 50);
  }
}

// The form stands in a tab there, and at the left again where the window has grown.
TEST_F(Looks, aNarrowWindowHasTheFormInATab) {
  auto* tabs = window_->findChild<QTabWidget*>();
  for (const bool narrow : {true, false, true, false}) {
    window_->resize(narrow ? smallest : MainWindow::usualSize);
    QTest::qWait(20);
    EXPECT_EQ(tabs->indexOf(window_->form()), narrow ? 0 : -1);
    EXPECT_EQ(tabs->tabText(0), narrow ? "Case" : "Profile");
    if (narrow) tabs->setCurrentIndex(0);
    EXPECT_TRUE(window_->form()->isVisible());
    if (narrow) judgeLayout(*window_);
  }
}

// Where each part of the window stands that is seen, but the parts of the line of messages.
std::map<const QWidget*, QRect> locationsOf(const MainWindow& window) {
  std::map<const QWidget*, QRect> locations;
  for (const QWidget* widget : window.findChildren<QWidget*>())
    if (widget->isVisible() && widget->window() == &window && !window.messages()->isAncestorOf(widget))
      locations[widget] = QRect(widget->mapTo(&window, QPoint(0, 0)), widget->size());
  return locations;
}

// What one aims at with the mouse must not move away.
TEST_F(Looks, nothingMovesWhenAMessageComesOrGoes) {
  const QString longer = QString(400, 'w').replace(20, 1, ' ');
  const auto set = [this](const char* key, const char* value) { window_->document().setParameter(key, value); };
  const std::vector<std::pair<const char*, std::function<void()>>> events{
      {"news", [&] { window_->messages()->say("The case was saved."); }},
      {"a long failure", [&] { window_->messages()->warn(longer, longer + '\n' + longer); }},
      {"none", [&] { window_->messages()->clear(); }},
      {"a result of another case", [&] { set("motion.speed", "25"); }},
      {"a case that cannot be run", [&] { set("motion.run_up", "9"); }},
      {"one that can", [&] { set("motion.run_up", "0.2"); }},
      {"a text that is no number", [&] { QTest::keyClicks(window_->form()->row("motion.speed")->editor(), "x"); }},
      {"a note on the profile", [&] { set("defect.height_scale", "0.5"); }},
      {"a run", [&] { window_->startRun(), window_->controller().waitFor(60000); }},
  };
  window_->showTab("profile");
  window_->showTab("aba_position");
  set("defect.depth", "0.2");  // the preview comes to the front with the first change
  QTest::qWait(50);
  const auto before = locationsOf(*window_);
  ASSERT_GT(before.size(), 100U);
  for (const auto& [name, happen] : events) {
    happen();
    QTest::qWait(30);
    const auto after = locationsOf(*window_);
    for (const auto& [widget, location] : before) {
      const auto found = after.find(widget);
      if (found == after.end()) continue;
      EXPECT_EQ(found->second, location) << nameOf(*widget).toStdString() << " moved with " << name;
    }
  }
}

TEST_F(Looks, everyTabInLightAndDarkAtPlainAndDoubleResolution) {
  for (const bool dark : {false, true}) {
    window_->setDark(dark);
    for (const QString& tab : MainWindow::tabNames()) {
      SCOPED_TRACE(tab.toStdString() + (dark ? ", dark" : ", light"));
      window_->showTab(tab);
      QTest::qWait(30);  // queued drawing
      judgeLayout(*window_);
      for (const double ratio : {1.0, 2.0}) {
        const QImage image = picture(ratio);
        ASSERT_EQ(image.size(), window_->size() * ratio);
        EXPECT_EQ(image.pixelColor(3, image.height() / 2).lightness() < 128, dark);
        for (const QWidget* figure : window_->findChildren<QWidget*>()) {
          const bool drawn = qobject_cast<const plots::Figure*>(figure) || qobject_cast<const SceneWidget*>(figure);
          if (!drawn || !figure->isVisible()) continue;
          const QPoint corner = figure->mapTo(window_.get(), QPoint(1, 1));
          const QRectF part(corner, figure->size() - QSize(2, 2));
          const QRect location(part.topLeft().toPoint() * ratio, (part.size() * ratio).toSize());
          // Lines and letters of a figure take 2 % and more of its area; an empty one has none.
          EXPECT_GT(tests::inkShare(image.copy(location)), 0.01) << figure->objectName().toStdString();
        }
      }
    }
  }
}

// At plain and double resolution; letters and lines take at least `share` of the picture.
void expectDrawn(QWidget& window, double share) {
  for (const double ratio : {1.0, 2.0}) {
    QImage image((QSizeF(window.size()) * ratio).toSize(), QImage::Format_RGB32);
    image.setDevicePixelRatio(ratio);
    window.render(&image);
    EXPECT_GT(tests::inkShare(image), share) << ratio;
  }
}

// As it opens, and as small as it can be made. Texts that wrap say how high they are, which a layout leaves to the
// window.
void judgeDialog(QDialog& dialog) {
  SCOPED_TRACE(dialog.metaObject()->className());
  dialog.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&dialog));
  const QSize usual = dialog.size(), least = dialog.minimumSizeHint();
  EXPECT_LE(least.width(), smallest.width());
  EXPECT_LE(least.height(), smallest.height());
  for (const QSize& room : {usual, least.expandedTo(QSize(0, dialog.heightForWidth(least.width())))}) {
    dialog.resize(room);
    QTest::qWait(20);
    judgeLayout(dialog, 5);
    expectDrawn(dialog, 0.005);
  }
}

TEST_F(Looks, dialogsAndMapsAreWhole) {
  window_->store().add({std::make_shared<const results::RunResult>(runToLookAt()), "another", QString(), false});
  for (const bool dark : {false, true}) {
    SCOPED_TRACE(dark ? "dark" : "light");
    window_->setDark(dark);
    SquatDialog squat(cases::defaultCase(), figureStyle(dark));
    FigureSizeDialog size({});
    for (QDialog* dialog : std::initializer_list<QDialog*>{&squat, &size}) judgeDialog(*dialog);
    window_->comparison()->showMaps();
    MapWindow& maps = *window_->comparison()->maps();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&maps));
    for (const QSize& room : {maps.size(), QSize(900, 320)}) {
      maps.resize(room);
      QTest::qWait(20);
      judgeLayout(maps, 8);
      expectDrawn(maps, 0.05);
    }
    maps.hide();
  }
}

TEST_F(Looks, dialogsOfFilesAndSignalsAreWhole) {
  const QTemporaryDir folder;
  const auto write = [&](const QString& name, const QByteArray& text) {
    QFile file(folder.filePath(name));
    EXPECT_TRUE(file.open(QIODevice::WriteOnly) && file.write(text) == text.size());
    return file.fileName();
  };
  QByteArray strike = "time [s],aba [m/s2]\n";
  for (int i = 0; i < 400; ++i)
    strike += QByteArray::number(i / 2000.0) + ',' + QByteArray::number(std::sin(0.5 * i) * std::exp(-0.02 * i)) + '\n';
  const QString profile = write("profile.csv", "position [mm];height [um]\n-10;0\n0;-50\n10;0\n");
  const std::string signal = write("measured.csv", strike).toStdString();
  RunStore store;
  const auto record = std::make_shared<const results::RunResult>(runToLookAt());
  store.add({nullptr, "measured", "/nowhere/measured.csv", true, record});
  for (const bool dark : {false, true}) {
    SCOPED_TRACE(dark ? "dark" : "light");
    window_->setDark(dark);
    ImportDialog ofProfile(profile, figureStyle(dark));
    judgeDialog(ofProfile);
    MeasuredDialog ofSignal({signal, {}, 30}, figureStyle(dark));
    const auto* take = ofSignal.findChild<QPushButton*>("takeMeasured");
    ASSERT_TRUE(take && tests::passes([&] { return take->isEnabled(); }, 60000));
    judgeDialog(ofSignal);
    AlignDialog align(store, 0);
    judgeDialog(align);
  }
}

TEST_F(Looks, helpIsWhole) {
  for (const bool dark : {false, true}) {
    SCOPED_TRACE(dark ? "dark" : "light");
    window_->setDark(dark);
    HelpWindow help(helpPages());
    help.setAttribute(Qt::WA_DeleteOnClose, false);
    help.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&help));
    for (const QSize& room : {help.size(), QSize(420, 320)}) {
      help.resize(room);
      QTest::qWait(20);
      judgeLayout(help, 4);
      expectDrawn(help, 0.005);
    }
  }
}

// As large as their window opens, and as small as it can be made.
TEST_F(Looks, toolsAreWhole) {
  for (const bool dark : {false, true}) {
    window_->setDark(dark);
    for (const char* name : {"study", "calibration", "growth", "receptance", "squats", "estimate"}) {
      SCOPED_TRACE(std::string(name) + (dark ? ", dark" : ", light"));
      ToolWindow* tool = window_->tool(name);
      window_->toolTabs()->open(*tool);
      QWidget& tools = *tool->window();
      ASSERT_TRUE(QTest::qWaitForWindowExposed(&tools));
      const QSize usual = tools.size(), least = tools.minimumSizeHint();
      EXPECT_LE(least.width(), smallest.width());
      EXPECT_LE(least.height(), smallest.height());
      for (const QSize& size : {usual, least}) {
        tools.resize(size);
        QTest::qWait(20);
        judgeLayout(tools, 12);
        expectDrawn(tools, 0.005);
      }
      tools.resize(usual);
      tool->close();
    }
  }
}

}  // namespace
}  // namespace squat::studio
