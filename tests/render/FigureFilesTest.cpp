// Figures as files, with no display at all.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <filesystem>

#include "core/Errors.h"
#include "core/ProgramVersion.h"
#include "plots/FigureRegistry.h"
#include "plots/Figures.h"
#include "render/PictureComparison.h"
#include "render/SyntheticResult.h"
#include "render/WithoutDisplay.h"

namespace squat {
namespace {

using testing::Contains;
using testing::HasSubstr;

using FigureFiles = tests::WithoutDisplay;

TEST_F(FigureFiles, everyFigureComesInEveryFormat) {
  const std::string folder = tests::freshFolder("every-figure");
  std::vector<std::string> messages;
  const auto written = plots::renderFigures(tests::syntheticResult(), folder, {}, &messages);
  EXPECT_TRUE(messages.empty()) << messages.front();
  EXPECT_EQ(written.size(), 3 * (plots::figureRegistry().size() - 1) + 1);  // the 3-D picture is a PNG alone
  for (const auto& path : written) EXPECT_GT(std::filesystem::file_size(path), 5000u) << path;
  // Nothing half-written is left beside.
  std::size_t files = 0;
  for ([[maybe_unused]] const auto& entry : std::filesystem::directory_iterator(folder)) ++files;
  EXPECT_EQ(files, written.size());
}

// A figure that was named is not drawn empty; the message lists what there is.
TEST_F(FigureFiles, aNamedFigureThatTheResultLacksIsRefused) {
  const std::string folder = tests::freshFolder("lacking");
  auto result = tests::syntheticResult();
  result.permanent = {};
  result.scalogramPower.clear();
  for (const char* name : {"residual_stress", "permanent_change", "scalogram", "no_such"}) try {
      plots::renderFigures(result, folder, {{"psd", name}, {"svg"}});
      FAIL() << name;
    } catch (const CaseError& error) {
      EXPECT_THAT(error.what(), testing::AllOf(HasSubstr(name), HasSubstr("--figures"), HasSubstr("contact_force")));
    }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(FigureFiles, picturesHaveTheWidthOfAColumnAt300Dpi) {
  const std::string folder = tests::freshFolder("sizes");
  for (const auto& path : plots::renderFigures(tests::syntheticResult(), folder, {{"psd", "scalogram"}, {"png"}})) {
    const QImage image(QString::fromStdString(path));
    EXPECT_NEAR(image.width(), 85 / 25.4 * 300, 2) << path;  // drawn on whole 1/96 inches
    EXPECT_NEAR(image.dotsPerMeterX(), 300 / 0.0254, 1) << path;
    EXPECT_GT(tests::inkShare(image), 0.03) << path << " is nearly empty";
  }
}

// 25.4 mm an inch; figures are laid out in whole 1/96 inches, 0.26 mm.
TEST_F(FigureFiles, aChosenSizeAndResolutionAreThoseOfTheFiles) {
  plots::FigureRequest request{{"psd", "scalogram"}, {"png", "svg"}};
  request.size = {140, 70, 150};
  for (const auto& path : plots::renderFigures(tests::syntheticResult(), tests::freshFolder("chosen-size"), request)) {
    if (path.ends_with(".svg")) {
      EXPECT_THAT(contents(path).toStdString(), HasSubstr("viewBox=\"0 0 529 265\"")) << path;
      continue;
    }
    const QImage image(QString::fromStdString(path));
    EXPECT_NEAR(image.width(), 140 / 25.4 * 150, 1) << path;
    EXPECT_NEAR(image.height(), 70 / 25.4 * 150, 1) << path;
    EXPECT_NEAR(image.dotsPerMeterX(), 150 / 0.0254, 1) << path;
    EXPECT_GT(tests::inkShare(image), 0.03) << path << " is nearly empty";
  }
}

// In files as asked for, and no word of it is lost where the figure is not drawn.
TEST_F(FigureFiles, theSpectrumHasTheScaleThatIsAskedFor) {
  plots::FigureRequest request{{"psd"}, {"svg"}};
  const auto textOf = [&](analysis::SpectrumScale scale) {
    request.settings.spectrum = scale;
    std::vector<std::string> messages;
    const auto paths = plots::renderFigures(tests::syntheticResult(), tests::freshFolder("scale"), request, &messages);
    EXPECT_THAT(messages, testing::IsEmpty());
    return contents(paths.at(0)).toStdString();
  };
  EXPECT_THAT(textOf(analysis::SpectrumScale::linear), HasSubstr("PSD [(m/s²)²/Hz]"));
  EXPECT_THAT(textOf(analysis::SpectrumScale::decibel), HasSubstr("PSD [dB re (1 µm/s²)²/Hz]"));
  const auto octaves = textOf(analysis::SpectrumScale::thirdOctaves);
  EXPECT_THAT(octaves, HasSubstr("Level [dB re 1 µm/s²]"));
  EXPECT_THAT(octaves, HasSubstr(">1600<"));  // a nominal frequency at the axis
  request.figures = {"aba_time"};
  std::vector<std::string> messages;
  plots::renderFigures(tests::syntheticResult(), tests::freshFolder("scale"), request, &messages);
  EXPECT_THAT(messages, testing::ElementsAre(HasSubstr("--spectrum has no effect")));
}

// A label that is cut leaves ink at the edge.
TEST_F(FigureFiles, nothingIsCutAtTheSmallestSize) {
  plots::FigureRequest request{{}, {"png"}};
  request.size = {plots::PrintedSize::minimumWidth, plots::PrintedSize::minimumHeight, 150};
  auto paths = plots::renderFigures(tests::syntheticResult(), tests::freshFolder("smallest"), request);
  plots::FigureRequest spectrum{{"psd"}, {"png"}};
  spectrum.size = request.size;
  for (const auto scale : {analysis::SpectrumScale::logarithmic, analysis::SpectrumScale::decibel,
                           analysis::SpectrumScale::thirdOctaves}) {
    spectrum.settings.spectrum = scale;
    const auto folder = tests::freshFolder("smallest-" + std::to_string(static_cast<int>(scale)));
    for (auto& path : plots::renderFigures(tests::syntheticResult(), folder, spectrum)) paths.push_back(path);
  }
  for (const auto& path : paths) {
    if (path.ends_with("model.png")) continue;
    const QImage image(QString::fromStdString(path));
    const QRgb background = image.pixel(0, 0);
    int ink = 0;
    for (int x = 0; x < image.width(); ++x)
      ink += (image.pixel(x, 0) != background) + (image.pixel(x, image.height() - 1) != background);
    for (int y = 0; y < image.height(); ++y)
      ink += (image.pixel(0, y) != background) + (image.pixel(image.width() - 1, y) != background);
    EXPECT_EQ(ink, 0) << path;
  }
}

TEST_F(FigureFiles, aPictureLargerThanTheMemoryIsRefused) {
  plots::FigureRequest request{{"psd"}, {"png"}};
  request.size = {400, 400, 1200};
  try {
    plots::renderFigures(tests::syntheticResult(), tests::freshFolder("too-large"), request);
    FAIL();
  } catch (const CaseError& error) {
    EXPECT_THAT(error.what(), HasSubstr("1200 dpi"));
  }
}

TEST_F(FigureFiles, textInSvgIsTextWithUnitsAndCase) {
  const std::string folder = tests::freshFolder("svg");
  for (const auto& path : plots::renderFigures(
           tests::syntheticResult(), folder,
           {{"defect_profile", "aba_position", "aba_time", "psd", "scalogram", "contact_force"}, {"svg"}})) {
    const auto texts = textsOf(contents(path));
    EXPECT_GT(texts.size(), 10u) << path;
    int axesWithUnit = 0;
    for (const auto& text : texts) axesWithUnit += text.back() == ']';
    EXPECT_GE(axesWithUnit, 2) << path;
    EXPECT_THAT(texts, Contains(HasSubstr("1a2b3c4d"))) << path;
    EXPECT_THAT(texts, Contains(HasSubstr("Light defect"))) << path;
  }
}

TEST_F(FigureFiles, pdfIsAPdfWithItsFontInside) {
  const std::string folder = tests::freshFolder("pdf");
  const auto written = plots::renderFigures(tests::syntheticResult(), folder, {{"aba_time"}, {"pdf"}});
  const QByteArray bytes = contents(written.at(0));
  EXPECT_TRUE(bytes.startsWith("%PDF-"));
  EXPECT_TRUE(bytes.contains("/FontFile2"));
}

// A picture tells which program drew it, wherever it has gone: in the fields that the formats have for that.
TEST_F(FigureFiles, everyFormatNamesProgramVersionAndCommit) {
  const std::string folder = tests::freshFolder("version");
  const std::string program = "Squat Studio " + programVersionText();
  for (const auto& path : plots::renderFigures(tests::syntheticResult(), folder, {{"psd", "model"}, {}})) {
    const QByteArray bytes = contents(path);
    if (path.ends_with(".svg")) {
      EXPECT_TRUE(bytes.contains(("<desc>" + program + "</desc>").c_str())) << path;
    } else if (path.ends_with(".png")) {
      EXPECT_EQ(QImage(QString::fromStdString(path)).text("Software").toStdString(), program) << path;
    } else {  // UTF-16, as Qt writes it; brackets are escaped: the version alone, then
      QByteArray wide;
      for (const char c : std::string("Squat Studio ") + programVersion()) wide += '\0', wide += c;
      EXPECT_TRUE(bytes.contains(wide)) << path;
    }
  }
}

TEST_F(FigureFiles, nothingIsCutAtTheBorder) {
  const std::string folder = tests::freshFolder("border");
  for (const auto& path : plots::renderFigures(tests::syntheticResult(), folder, {{}, {"png"}})) {
    if (path.find("model") != std::string::npos) continue;
    const QImage image(QString::fromStdString(path));
    const QRgb background = image.pixel(0, 0);
    for (int x = 0; x < image.width(); ++x) {
      ASSERT_EQ(image.pixel(x, 0), background) << path << " top, column " << x;
      ASSERT_EQ(image.pixel(x, image.height() - 1), background) << path << " bottom, column " << x;
    }
    for (int y = 0; y < image.height(); ++y) {
      ASSERT_EQ(image.pixel(0, y), background) << path << " left, line " << y;
      ASSERT_EQ(image.pixel(image.width() - 1, y), background) << path << " right, line " << y;
    }
  }
}

TEST_F(FigureFiles, anEmptyResultYieldsNoFigureAndSaysSo) {
  results::RunResult empty;
  empty.stem = "empty";
  const std::string folder = tests::freshFolder("empty");
  std::vector<std::string> messages;
  EXPECT_TRUE(plots::renderFigures(empty, folder, {}, &messages).empty());
  ASSERT_EQ(messages.size(), 1u);
  EXPECT_THAT(messages[0], HasSubstr("no figure drawn"));
}

TEST_F(FigureFiles, wrongNamesAreAllReportedBeforeAnythingIsWritten) {
  const std::string folder = tests::freshFolder("wrong");
  plots::FigureRequest request{{"psd", "spectrum"}, {"gif"}};
  request.settings.colours = "rainbow";
  try {
    plots::renderFigures(tests::syntheticResult(), folder, request);
    FAIL() << "no error";
  } catch (const CaseError& error) {
    ASSERT_EQ(error.problems().size(), 3u);
    EXPECT_EQ(error.problems()[0].value, "spectrum");
    EXPECT_THAT(error.problems()[0].allowed, HasSubstr("scalogram"));
    EXPECT_EQ(error.problems()[1].value, "gif");
    EXPECT_EQ(error.problems()[2].value, "rainbow");
  }
  EXPECT_TRUE(std::filesystem::is_empty(folder));
}

TEST_F(FigureFiles, aFolderThatCannotBeMadeIsAFileError) {
  const std::string folder = tests::freshFolder("not-a-folder");
  const std::string file = folder + "/file";
  { QFile(QString::fromStdString(file)).open(QIODevice::WriteOnly); }
  EXPECT_THROW(plots::renderFigures(tests::syntheticResult(), file + "/below", {{"psd"}}), FileError);
}

}  // namespace
}  // namespace squat
