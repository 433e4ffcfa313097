// The live preview in the window: what starts it, what it gives way to, what is said where there is none.
#include <gmock/gmock.h>

#include <QAction>
#include <QCheckBox>
#include <QDir>
#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>
#include <QTimer>
#include <QUndoStack>
#include <initializer_list>
#include <iostream>
#include <random>

#include "case/CaseFile.h"
#include "case/Resolve.h"
#include "case/Validation.h"
#include "gui/EventWaits.h"
#include "gui/Hands.h"
#include "gui/MadeUpRun.h"
#include "gui/PreviewSolvers.h"
#include "studio/preview/CurvePlot.h"
#include "studio/preview/PreviewCase.h"
#include "studio/preview/PreviewPanel.h"

namespace squat::studio {
namespace {

using ::testing::HasSubstr;

class PreviewWindow : public testing::Test {
 protected:
  void open(const PreviewSolver& solver, int runMilliseconds = 50) {
    QSettings().remove("preview");
    StudioServices services = tests::services(runMilliseconds);
    services.preview = solver;
    services.threads = 2;
    window_ = std::make_unique<MainWindow>(services);
    ASSERT_TRUE(window_->openCase("light-defect"));
    window_->show();
  }
  void openMadeUp(int startMilliseconds = 3, int runMilliseconds = 3) {
    open(tests::madeUpPreviewSolver(calls_, startMilliseconds, runMilliseconds));
  }
  void TearDown() override { QSettings().remove("preview"); }
  bool settles() { return window_->preview().waitFor(tests::patience); }
  const Preview& latest() { return window_->preview().latest(); }
  PreviewPanel& panel() { return *window_->previewPanel(); }
  QString text(const char* name) { return panel().findChild<QLabel*>(name)->text(); }
  void set(const char* key, const std::string& value) {
    EXPECT_FALSE(window_->document().setParameter(key, value).has_value()) << key;
  }

  std::shared_ptr<tests::PreviewCalls> calls_ = std::make_shared<tests::PreviewCalls>();
  std::unique_ptr<MainWindow> window_;
};

TEST_F(PreviewWindow, everyChangeOfTheDefectRollsAnewFromTheSameStart) {
  openMadeUp();
  ASSERT_TRUE(settles());
  EXPECT_EQ(latest().phase, PreviewPhase::done);
  EXPECT_EQ(text("previewTitle"), "Preview, mesh tiny");
  const int made = calls_->made;
  int complete = calls_->complete;
  const auto isRolledAnew = [&] {
    const bool over = settles() && calls_->complete == complete + 1 && latest().phase == PreviewPhase::done;
    complete = calls_->complete;
    return over;
  };
  set("defect.depth", "0.2");
  EXPECT_TRUE(isRolledAnew());
  set("defect.length", "30");
  EXPECT_TRUE(isRolledAnew());
  set("defect.shape", "cosine");
  EXPECT_TRUE(isRolledAnew());
  set("defect.points", "[[-15, 0], [0, -0.1], [15, 0]]");
  set("defect.shape", "profile");
  EXPECT_TRUE(settles());
  complete = calls_->complete;
  window_->document().undoStack().undo();
  EXPECT_TRUE(isRolledAnew());
  window_->document().undoStack().redo();
  EXPECT_TRUE(isRolledAnew());
  EXPECT_EQ(calls_->made, made);
  EXPECT_EQ(window_->store().rowCount(), 0) << "a preview is no run";
}

TEST_F(PreviewWindow, anotherCaseMakesANewStartAndMarksTheCurveUntilThen) {
  openMadeUp(60, 3);
  ASSERT_TRUE(settles());
  const int made = calls_->made;
  set("pad.stiffness", "900");
  ASSERT_TRUE(tests::passes([&] { return latest().phase == PreviewPhase::preparing; }));
  EXPECT_EQ(text("previewState"), "out of date");
  auto* progress = panel().findChild<QProgressBar*>("previewProgress");
  EXPECT_TRUE(progress->isVisibleTo(&panel()));
  EXPECT_EQ(progress->format(), "equilibrium");
  EXPECT_GT(panel().acceleration()->pointCount(), 0U);
  ASSERT_TRUE(settles());
  EXPECT_EQ(calls_->made, made + 1);
  EXPECT_FALSE(progress->isVisibleTo(&panel()));
  EXPECT_FALSE(text("previewState").contains("out of date"));
}

// The mesh is fine over 40 mm on both sides: a cut of 24 mm may grow to 80 mm on it.
TEST_F(PreviewWindow, aProfileThatOutgrowsTheMeshMakesALongerOne) {
  openMadeUp();
  ASSERT_TRUE(settles());
  const int made = calls_->made;
  set("defect.length", "80");
  ASSERT_TRUE(settles());
  EXPECT_EQ(calls_->made, made);
  set("defect.length", "82");
  ASSERT_TRUE(settles());
  EXPECT_EQ(calls_->made, made + 1);
  set("defect.length", "30");
  ASSERT_TRUE(settles());
  EXPECT_EQ(calls_->made, made + 1) << "the mesh from before is still there";
}

TEST_F(PreviewWindow, aWholeRunComesFirst) {
  openMadeUp(3, 400);
  ASSERT_TRUE(tests::passes([&] { return latest().phase == PreviewPhase::rolling; }));
  window_->startRun();
  ASSERT_TRUE(window_->controller().isRunning());
  EXPECT_TRUE(window_->preview().isHeld());
  ASSERT_TRUE(tests::passes([&] { return calls_->cancelled > 0; }));
  const int begun = calls_->begun;
  int begunDuringRun = 0;
  QObject::connect(&window_->controller(), &RunController::finished, [&] { begunDuringRun = calls_->begun - begun; });
  set("defect.depth", "0.12");
  EXPECT_EQ(text("previewState"), "waits for the run");
  ASSERT_TRUE(window_->controller().waitFor(tests::patience));
  EXPECT_EQ(begunDuringRun, 0);
  ASSERT_TRUE(settles());
  EXPECT_EQ(latest().phase, PreviewPhase::done);
  // The run is there in grey.
  const auto run = window_->store().currentResult();
  ASSERT_TRUE(run);
  EXPECT_EQ(panel().acceleration()->referenceCount(), run->position.size());
  EXPECT_GT(panel().spectrum()->referenceCount(), 10U);
}

TEST_F(PreviewWindow, theSwitchIsAnActionThatIsRemembered) {
  openMadeUp();
  ASSERT_TRUE(settles());
  auto* action = window_->findChild<QAction*>("livePreview");
  ASSERT_TRUE(action && action->isChecked());
  tests::press(*window_, Qt::Key_F7);
  EXPECT_FALSE(window_->preview().isOn());
  EXPECT_FALSE(panel().onOff()->isChecked());
  EXPECT_EQ(text("previewState"), "off");
  const int begun = calls_->begun;
  set("defect.depth", "0.2");
  QTest::qWait(30);
  EXPECT_EQ(calls_->begun, begun);
  StudioServices services = tests::services();
  services.preview = tests::madeUpPreviewSolver(calls_, 1, 1);
  EXPECT_FALSE(MainWindow(services).preview().isOn());
  panel().onOff()->click();
  EXPECT_TRUE(action->isChecked());
  ASSERT_TRUE(settles());
  EXPECT_EQ(latest().phase, PreviewPhase::done);
  EXPECT_GT(calls_->begun, begun);
}

TEST_F(PreviewWindow, whatHasNoPreviewSaysWhyInOneSentence) {
  openMadeUp();
  const struct {
    const char *key, *value, *reason;
  } calls[] = {
      {"defect.move_nodes", "true", "No preview with defect.move_nodes"},
      {"defect.shape", "none", "No preview of a smooth rail"},
      {"title", "fails", "No preview: made to fail"},
  };
  for (const auto& [key, value, reason] : calls) {
    ASSERT_TRUE(settles());
    EXPECT_FALSE(panel().findChild<QLabel*>("previewReason")->isVisibleTo(&panel()));
    set(key, value);
    ASSERT_TRUE(settles());
    EXPECT_EQ(latest().phase, PreviewPhase::unavailable);
    EXPECT_TRUE(panel().findChild<QLabel*>("previewReason")->isVisibleTo(&panel()));
    EXPECT_THAT(text("previewReason").toStdString(), HasSubstr(reason));
    EXPECT_TRUE(text("previewReason").endsWith('.'));
    window_->document().undoStack().undo();
  }
  ASSERT_TRUE(settles());
  EXPECT_EQ(latest().phase, PreviewPhase::done);
}

// Left to right: each picture has the points of the one before and more, and the wheel's way is known from the start.
TEST_F(PreviewWindow, theCurveGrowsFromLeftToRight) {
  openMadeUp(1, 300);
  ASSERT_TRUE(settles());
  std::vector<std::size_t> lengths;
  QElapsedTimer clock;
  QObject::connect(&window_->preview(), &PreviewController::changed, [&](const Preview& preview) {
    lengths.push_back(preview.position.size());
    EXPECT_EQ(preview.position.size(), preview.acceleration.size());
    EXPECT_DOUBLE_EQ(preview.to, 0.1);
  });
  clock.start();
  set("defect.depth", "0.2");
  ASSERT_TRUE(settles());
  EXPECT_GT(lengths.size(), 5U);
  EXPECT_LE(lengths.size(), 2U + static_cast<std::size_t>(clock.elapsed()) / 15) << "more than a screen shows";
  EXPECT_TRUE(std::is_sorted(lengths.begin(), lengths.end()));
}

TEST_F(PreviewWindow, comesToTheFrontWithAChangeAndLeavesARunInFront) {
  openMadeUp();
  ASSERT_TRUE(settles());
  window_->startRun();
  ASSERT_TRUE(window_->controller().waitFor(tests::patience));
  EXPECT_TRUE(tests::passes([&] { return panel().visibleRegion().isEmpty(); }));
  set("defect.depth", "0.2");
  EXPECT_TRUE(tests::passes([&] { return !panel().visibleRegion().isEmpty(); }));
  window_->showTab("psd");
  set("defect.depth", "0.21");
  ASSERT_TRUE(settles());
  EXPECT_TRUE(panel().visibleRegion().isEmpty()) << "the user had turned to the run";
}

TEST(PreviewCase, isAValidOneForEveryShippedCaseAndReaches100MillimetresBehindTheDefect) {
  for (const char* name : {"light-defect", "class-c-squat", "class-c-squat-modified", "light-defect-partial-slip"}) {
    SCOPED_TRACE(name);
    const auto open = cases::loadCase(name, {"paper", {}});
    const auto description = previewCase(open);
    EXPECT_THAT(cases::validate(description).problems, ::testing::IsEmpty());
    EXPECT_EQ(description.mesh.preset, cases::MeshPreset::tiny);
    const cases::DefectSurface surface(open.defect);
    EXPECT_GE(description.motion.beyond, 0.1);
    EXPECT_GE(description.motion.beyond, surface.last() + 0.04);
    EXPECT_GE(description.mesh.zoneBefore, -surface.first());
    EXPECT_GE(description.mesh.zoneBehind, surface.last());
  }
}

// An instrument measures 1.2 m at once.
TEST(PreviewCase, aLongMeasuredProfileGetsALongerTrack) {
  auto open = cases::loadCase("light-defect", {"paper", {}});
  open.defect.shape = cases::DefectShape::profile;
  open.defect.points = {{-0.6, 0}, {-0.2, -1e-5}, {0, -2e-4}, {0.3, -1e-5}, {0.6, 0}};
  const auto description = previewCase(open);
  EXPECT_GT(description.track.length, 3);
  for (const auto& problem : cases::validate(description).problems) ADD_FAILURE() << toText(problem);
}

// The real solver: the signals are those of the whole run of the same case, which starts nowhere but at its beginning.
TEST_F(PreviewWindow, itsSignalsAreThoseOfAWholeRunToTheBit) {
  open(tests::realPreviewSolver());
  ASSERT_TRUE(window_->preview().waitFor(4 * tests::patience));
  const QTemporaryDir folder;
  const auto before = QDir::current().entryList(QDir::Files);
  set("defect.length", "30");
  set("defect.depth", "0.12");
  std::vector<double> grown;
  QObject::connect(&window_->preview(), &PreviewController::changed, [&](const Preview& preview) {
    if (preview.phase == PreviewPhase::rolling) grown = preview.position;
  });
  ASSERT_TRUE(window_->preview().waitFor(4 * tests::patience));
  ASSERT_EQ(latest().phase, PreviewPhase::done) << latest().text;
  const auto result = latest().result;
  simulation::RunOptions options;
  options.threads = 1;
  options.wheelsetModes = options.snapshots = false;
  Monitor silent;
  const auto whole = simulation::runCase(result->resolvedCase->description, options, silent);
  ASSERT_TRUE(whole.complete);
  EXPECT_EQ(whole.position, result->position);
  ASSERT_EQ(whole.signals.size(), result->signals.size());
  for (std::size_t i = 0; i < whole.signals.size(); ++i)
    EXPECT_EQ(whole.signals[i].values, result->signals[i].values) << whole.signals[i].name;
  EXPECT_EQ(whole.psd, result->psd);
  EXPECT_EQ(latest().acceleration, *whole.signal("aba_filtered"));
  // What was shown on the way is the beginning of it.
  ASSERT_GT(grown.size(), 30U);
  EXPECT_TRUE(std::equal(grown.begin(), grown.end(), whole.position.begin()));
  EXPECT_EQ(QDir::current().entryList(QDir::Files), before);
  EXPECT_EQ(window_->store().rowCount(), 0);
}

// Twenty histories of drags, at random and most of them cut short: meshes that come, go and come back, longer and
// shorter defects, another speed. The preview of the case that they end with has the bits of a whole run; on the mesh
// `tiny`, those of the run that F5 would start.
TEST_F(PreviewWindow, dependsOnTheCaseAloneWhateverWasDraggedBefore) {
  open(tests::realPreviewSolver());
  std::mt19937 random(58);
  const auto oneOf = [&](std::initializer_list<const char*> values) {
    return std::string(values.begin()[random() % values.size()]);
  };
  const auto dragAbout = [&] {
    set("defect.length", oneOf({"14", "22", "60", "82", "130", "170"}));
    QTest::qWait(static_cast<int>(random() % 60));
    set("defect.depth", oneOf({"0.05", "0.1", "0.25"}));
    if (random() % 3 == 0) set("motion.speed", oneOf({"25", "35"}));
    QTest::qWait(static_cast<int>(random() % 200));
  };
  for (const char* preset : {"standard", "tiny"}) {
    SCOPED_TRACE(preset);
    set("mesh.preset", preset);
    const auto length = preset == std::string("tiny") ? "100" : "36", depth = "0.17", speed = "31";
    const auto goBack = [&] {
      set("defect.depth", depth), set("motion.speed", speed), set("defect.length", length);
      return window_->preview().waitFor(4 * tests::patience) && latest().phase == PreviewPhase::done;
    };
    set("defect.length", length), set("defect.depth", depth), set("motion.speed", speed);
    const auto& open = window_->document().description();
    simulation::RunOptions options;
    options.threads = 1;
    options.wheelsetModes = options.snapshots = false;
    Monitor silent;
    const bool isTiny = open.mesh.preset == cases::MeshPreset::tiny;
    const auto whole = simulation::runCase(isTiny ? open : previewCase(open), options, silent);
    for (int history = 0; history < 10; ++history) {
      dragAbout();
      ASSERT_TRUE(goBack()) << latest().text;
      ASSERT_EQ(latest().position, whole.position) << history;
      ASSERT_EQ(latest().acceleration, *whole.signal("aba_filtered")) << history;
      ASSERT_EQ(latest().result->psd, whole.psd) << history;
    }
  }
}

// Three seconds of what PreviewSpeed does for a minute.
TEST_F(PreviewWindow, theWindowAnswersWhilePreviewsRestart) {
  open(tests::realPreviewSolver());
  window_->showTab("preview");
  ASSERT_TRUE(window_->preview().waitFor(4 * tests::patience));
  tests::EventWaits waits;
  const int shown = tests::dragAtTwentyChangesASecond(*window_, 3000);
  waits.stop();
  waits.print("previews that restart 20 times a second");
  EXPECT_GT(shown, 0);  // some: how many, the machine and its load decide
  EXPECT_LT(waits.processorTime(1), 50) << "a turn of the event loop";
}

// A hump of 0.3 mm ahead of the dip is touched earlier than where the profile begins.
TEST_F(PreviewWindow, aProfileThatRisesIsServedFromAnEarlierStateOrSaysSo) {
  open(tests::realPreviewSolver());
  set("defect.points", "[[-20, 0], [-15, 0.3], [0, -0.2], [20, 0]]");
  set("defect.level", "false");
  set("defect.shape", "profile");
  ASSERT_TRUE(window_->preview().waitFor(4 * tests::patience));
  EXPECT_EQ(latest().phase, PreviewPhase::done) << latest().text;
  set("defect.points", "[[-40, 0], [-30, 1.2], [-20, 0], [0, -0.2], [20, 0]]");
  ASSERT_TRUE(window_->preview().waitFor(4 * tests::patience));
  EXPECT_EQ(latest().phase, PreviewPhase::unavailable);
  EXPECT_THAT(latest().text, HasSubstr("touches it"));
}

}  // namespace
}  // namespace squat::studio
