// The size in which figures are copied and exported.
#include <gtest/gtest.h>

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QEvent>
#include <QImage>
#include <QScopeGuard>
#include <QTemporaryDir>
#include <QTest>

#include "plots/FigureSheet.h"
#include "render/SyntheticResult.h"
#include "studio/common/FigureSizeDialog.h"
#include "studio/common/Theme.h"
#include "studio/document/CaseDocument.h"
#include "studio/runs/RunStore.h"
#include "studio/signals/FigureView.h"
#include "studio/signals/SignalsPanel.h"
#include "studio/tools/ToolWindow.h"

namespace squat::studio {
namespace {

// Whatever the size of the window, which keeps its own layout.
TEST(FigureSize, figuresAreExportedInTheChosenSize) {
  const QTemporaryDir folder;
  RunStore store;
  SignalsPanel panel(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  panel.showTab("psd");
  FigureView* view = panel.view("psd");
  const auto exported = [&](const char* name) {
    view->writeFile(folder.filePath(name));
    return QImage(folder.filePath(name));
  };
  const QImage own = exported("own.png");  // one column, at 300 dpi
  EXPECT_NEAR(own.width(), 85 / 25.4 * 300, 2);
  for (const QSize& window : {QSize(500, 400), QSize(1100, 700)}) {
    panel.resize(window);
    panel.show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&panel));
    panel.setFigureSize({100, 70, 150});
    const QImage before = view->figure()->grab().toImage();
    const QImage chosen = exported("chosen.png");
    EXPECT_NEAR(chosen.width(), 100 / 25.4 * 150, 1);
    EXPECT_NEAR(chosen.height(), 70 / 25.4 * 150, 1);
    view->copy();
    EXPECT_EQ(QApplication::clipboard()->image().size(), chosen.size());
    view->figure()->replot();
    EXPECT_EQ(view->figure()->grab().toImage(), before);
  }
}

TEST(FigureSize, theChosenSizeIsKept) {
  RunStore store;
  const QTemporaryDir folder;
  {
    SignalsPanel panel(store, figureStyle(false));
    panel.show();
    panel.askForSize();
    auto* dialog = panel.findChild<FigureSizeDialog*>();
    ASSERT_NE(dialog, nullptr);
    auto* preset = dialog->findChild<QComboBox*>("figurePreset");
    auto* width = dialog->findChild<QDoubleSpinBox*>("figureWidth");
    EXPECT_FALSE(width->isEnabled());  // each figure's own
    preset->setCurrentText("Two columns");
    EXPECT_EQ(width->value(), 170);
    preset->setCurrentText("Other");
    width->setValue(120);
    dialog->findChild<QDoubleSpinBox*>("figureResolution")->setValue(100);
    dialog->accept();
  }
  SignalsPanel next(store, figureStyle(false));
  store.add({tests::sharedSyntheticResult(), "run", {}, false});
  next.showTab("psd");
  next.view("psd")->writeFile(folder.filePath("next.png"));
  const QImage image(folder.filePath("next.png"));
  EXPECT_NEAR(image.width(), 120 / 25.4 * 100, 1);
  EXPECT_NEAR(image.height(), 90 / 25.4 * 100, 1);
  storeFigureSize({});
}

// A tool whose work is one figure.
class OneFigure : public ToolForm {
 public:
  QString name() const override { return "one"; }
  QString title() const override { return "One figure"; }
  QString explanation() const override { return "Draws one figure."; }
  QString subject() const override { return "The figure"; }
  ToolWork work() override {
    return [](const ToolInput&, Monitor&) {
      ToolResult result;
      result.complete = true;
      result.figures = [](const plots::Style& style) {
        std::vector<plots::FigureSheet> sheets;
        sheets.push_back(plots::sheetOf("one", std::make_unique<plots::Figure>("one", style)));
        return sheets;
      };
      return result;
    };
  }
};

// Also one that is chosen while the figure stands there.
TEST(FigureSize, figuresOfToolsAreWrittenInTheChosenSize) {
  const QTemporaryDir folder;
  const auto restored = qScopeGuard([] { storeFigureSize({}); });
  storeFigureSize({100, 70, 150});
  CaseDocument document;
  ToolWindow tool(
      document, new OneFigure, [] { return QString(); }, figureStyle(false));
  tool.setFolder(folder.path());
  tool.show();
  ASSERT_TRUE(QTest::qWaitForWindowExposed(&tool));
  tool.start();
  ASSERT_TRUE(tool.waitFor(30000));
  auto* view = tool.findChild<FigureView*>();
  ASSERT_NE(view, nullptr);
  const auto expectSize = [](const QImage& image, double width, double height) {
    EXPECT_NEAR(image.width(), width, 1);
    EXPECT_NEAR(image.height(), height, 1);
  };
  expectSize(QImage(folder.filePath("one.png")), 100 / 25.4 * 150, 70 / 25.4 * 150);  // written by the tool
  view->writeFile(folder.filePath("exported.png"));
  expectSize(QImage(folder.filePath("exported.png")), 100 / 25.4 * 150, 70 / 25.4 * 150);
  storeFigureSize({120, 80, 100});
  QEvent activation(QEvent::ActivationChange);  // the user comes back from the main window
  QApplication::sendEvent(&tool, &activation);
  view->writeFile(folder.filePath("again.png"));
  expectSize(QImage(folder.filePath("again.png")), 120 / 25.4 * 100, 80 / 25.4 * 100);
  view->copy();
  expectSize(QApplication::clipboard()->image(), 120 / 25.4 * 100, 80 / 25.4 * 100);
}

}  // namespace
}  // namespace squat::studio
