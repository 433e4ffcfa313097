// Commands as a user types them, on the mesh `tiny`: they end with 0, and what they have written is read back and held
// against what is known without them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QImage>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "FixtureCase.h"
#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "case/Resolve.h"
#include "core/DurableFile.h"
#include "model/Model.h"
#include "model/WheelsetModes.h"
#include "project/ProjectFile.h"
#include "results/Hdf5.h"
#include "results/SampleResult.h"
#include "signals/Features.h"
#include "trust/Program.h"
#include "verification/TrackBeam.h"

namespace squat {
namespace {

using ::testing::HasSubstr;
using tests::TemporaryFolder;

// A table with a head: values by name of column, as text.
using Table = std::vector<std::map<std::string, std::string>>;

std::vector<std::string> fieldsOf(const std::string& line) {
  std::vector<std::string> fields(1);
  bool isQuoted = false;
  for (const char c : line) {
    if (c == '"')
      isQuoted = !isQuoted;
    else if (c == ',' && !isQuoted)
      fields.emplace_back();
    else
      fields.back() += c;
  }
  return fields;
}

Table readCsv(const std::string& path) {
  std::istringstream text(readWholeFile(path, 100000000));
  std::string line;
  std::getline(text, line);
  const auto names = fieldsOf(line);
  Table table;
  while (std::getline(text, line)) {
    const auto fields = fieldsOf(line);
    EXPECT_EQ(fields.size(), names.size()) << path << ": " << line;
    auto& row = table.emplace_back();
    for (std::size_t i = 0; i < std::min(names.size(), fields.size()); ++i) row[names[i]] = fields[i];
  }
  return table;
}

std::string call(std::vector<std::string> words) {
  std::string output;
  EXPECT_EQ(tests::call(words, &output), 0) << words.front() << "\n" << output;
  return output;
}

// Three runs and the figures of the paper, made by ctest's Call.FiguresPaper, which these tests ask for.
class EndToEnd : public ::testing::Test {
 protected:
  static std::string file(const std::string& name) { return std::string(FIGURES_PAPER_FOLDER "/") + name; }
};

// A picture with at least this share of its pixels other than its background.
void expectPicture(const std::string& path, double ink) {
  const QImage picture = QImage(QString::fromStdString(path)).convertToFormat(QImage::Format_RGB32);
  ASSERT_FALSE(picture.isNull()) << path;
  EXPECT_GT(picture.width(), 900) << path;  // a column of 85 mm at 300 dpi: 1004
  long long other = 0;
  for (int y = 0; y < picture.height(); ++y)
    for (int x = 0; x < picture.width(); ++x) other += picture.pixel(x, y) != picture.pixel(0, 0);
  EXPECT_GT(static_cast<double>(other), ink * picture.width() * picture.height()) << path;
}

// What is on its pages, plots::ReportPages tests.
TEST_F(EndToEnd, ReportOfResultsAndOfAProject) {
  const TemporaryFolder folder;
  const std::string pdf = folder / "report.pdf";
  const auto pages = [&] { return readWholeFile(pdf, 100000000); };
  writeDurably(folder / "notes.txt", "Second bogie\n");
  const std::vector<std::string> report{"report", file("light-defect.h5"), file("class-c-squat.h5"), "-o", pdf};
  auto words = report;
  words.insert(words.end(),
               {"--notes", folder / "notes.txt", "--figures", "psd", "--measured", file("light-defect.csv")});
  EXPECT_THAT(call(words), HasSubstr(pdf));
  EXPECT_TRUE(pages().starts_with("%PDF-"));

  project::Project work;
  work.open = {"dip", "", false, cases::writeCase(cases::defaultCase())};
  work.entries.resize(2);
  work.entries[0].path = file("class-c-squat.h5"), work.entries[0].name = "deep";
  work.entries[1].path = folder / "gone.h5", work.entries[1].name = "gone";
  work.current = 0;
  project::writeProject(folder / "day.squat-project", work);
  std::filesystem::remove(pdf);
  EXPECT_THAT(call({"report", folder / "day.squat-project", "-o", pdf}), HasSubstr("gone.h5"));  // said, and left out
  EXPECT_TRUE(pages().starts_with("%PDF-"));

  std::string said;
  EXPECT_EQ(tests::call({"report", file("light-defect.h5"), folder / "gone.h5", "-o", pdf}, &said), 4);
  EXPECT_THAT(said, HasSubstr("invalid file: " + (folder / "gone.h5")));
  std::filesystem::copy_file(file("light-defect.h5"), folder / "mine.h5");
  EXPECT_EQ(tests::call({"report", folder / "mine.h5", "-o", folder / "mine.h5"}), 2);  // it would be lost
  EXPECT_TRUE(results::isCompleteResult(folder / "mine.h5"));
  EXPECT_EQ(tests::call({"report", file("light-defect.h5"), "--figures", "nonsense", "-o", pdf}), 2);
  EXPECT_EQ(tests::call({"report", folder / "day.squat-project", file("light-defect.h5"), "-o", pdf}), 2);
  EXPECT_EQ(tests::call({"report", file("light-defect.h5"), "-o", folder / "no/such/folder"}), 0);  // it is made
  EXPECT_EQ(tests::call({"report", file("light-defect.h5"), "-o", "/proc/report.pdf"}), 4);
}

TEST_F(EndToEnd, FiguresPaperRunsTheCasesAndDrawsThem) {
  for (const char* name : {"light-defect", "class-c-squat", "class-c-squat-modified"}) {
    const auto result = results::readResult(file(std::string(name) + ".h5"));
    EXPECT_TRUE(result.complete) << name;
    EXPECT_EQ(result.caseHash, cases::caseHash(cases::loadCase(name, {"tiny", {}}))) << name;
    // The wheel carries what stands on it, 9.81 m/s2 times 896 kg and the 8000 kg above; the residual of the
    // equilibrium is 1e-7 of it.
    const auto force = std::find_if(result.equilibrium.begin(), result.equilibrium.end(),
                                    [](const auto& item) { return item.name == "contact_force"; });
    ASSERT_NE(force, result.equilibrium.end());
    EXPECT_NEAR(force->value, 9.81 * 8896, 0.1) << name;
  }
  for (const char* number : {"04", "05", "06", "08", "09", "10", "11"}) {
    const auto path = file(std::string("paper_figure_") + number);
    expectPicture(path + ".png", 0.03);
    EXPECT_THAT(readWholeFile(path + ".svg", 100000000), HasSubstr("<text"));
  }
}

// A second call takes what stands there: no run, the same pictures to the bit.
TEST_F(EndToEnd, FiguresPaperTakesExistingResults) {
  const auto before = readWholeFile(file("paper_figure_06.png"), 100000000);
  const auto said =
      call({"figures", "paper", "--mesh", "tiny", "--threads", "1", "--format", "png", "-o", FIGURES_PAPER_FOLDER});
  EXPECT_THAT(said, HasSubstr("using existing " + file("light-defect.h5")));
  EXPECT_THAT(said, ::testing::Not(HasSubstr("running ")));
  EXPECT_EQ(readWholeFile(file("paper_figure_06.png"), 100000000), before);
}

// A measured passage, here the run's own signals as a table, stands in the panels that the paper leaves to
// measurements.
TEST_F(EndToEnd, FiguresPaperTakesMeasuredPassages) {
  const auto folder = file("measured");
  std::filesystem::create_directories(folder);
  for (const char* name : {"light-defect.h5", "class-c-squat.h5", "class-c-squat-modified.h5"})
    std::filesystem::copy_file(file(name), folder + "/" + name, std::filesystem::copy_options::overwrite_existing);
  const auto said = call({"figures", "paper", "--measured", file("light-defect.csv"), "--measured-squat",
                          file("class-c-squat.csv"), "--column", "aba", "--format", "svg", "-o", folder});
  EXPECT_THAT(said, HasSubstr("placed by its defect at position 0"));
  for (const char* number : {"04", "05", "06", "08", "10", "11"}) {
    const auto picture = readWholeFile(folder + "/paper_figure_" + number + ".svg", 100000000);
    EXPECT_THAT(picture, HasSubstr(number < std::string("08") ? "light-defect: aba" : "class-c-squat: aba")) << number;
    EXPECT_THAT(picture, ::testing::Not(HasSubstr("picture only"))) << number;
  }
}

// The spectrum's picture is named by the lines of the result's own spectrum, the curve's largest value is its top.
TEST_F(EndToEnd, RenderDrawsTheResult) {
  const auto folder = file("drawn");
  call({"render", file("light-defect.h5"), "-o", folder, "--format", "png,svg"});
  const auto result = results::readResult(file("light-defect.h5"));
  for (const char* name : {"defect_profile", "aba_position", "aba_time", "psd", "scalogram", "contact_force", "model"})
    expectPicture(folder + "/" + name + ".png", 0.03);
  signals::PowerSpectrum spectrum;
  spectrum.frequency = result.frequency, spectrum.density = result.psd;
  const auto lines = signals::namedLines(spectrum);
  const auto drawn = readWholeFile(folder + "/psd.svg", 100000000);
  ASSERT_FALSE(lines.empty());
  for (const auto& line : lines)
    EXPECT_THAT(drawn, HasSubstr(">" + std::to_string(std::lround(line.frequency)) + "</text>"));
  EXPECT_THAT(drawn, HasSubstr(result.caseHash));
}

// A signal is like itself; twice the signal in a file of one's own is alike and twice as large.
TEST_F(EndToEnd, CompareKnowsASignalAndItsDouble) {
  const auto result = results::readResult(file("light-defect.h5"));
  const auto& aba = *result.signal("aba");
  std::string text = "time [s],position [m],acceleration [m/s2]\n";
  char line[120];
  for (std::size_t i = 0; i < aba.size(); ++i) {
    std::snprintf(line, sizeof line, "%.17g,%.17g,%.17g\n", result.time[i], result.position[i], 2 * aba[i]);
    text += line;
  }
  writeDurably(file("double.csv"), std::string_view(text));
  const auto folder = file("compared");
  call({"compare", file("light-defect.h5"), file("light-defect.h5"), file("double.csv"), "-o", folder, "--format",
        "png"});
  const auto table = readCsv(folder + "/comparison.csv");
  const auto json = nlohmann::json::parse(readWholeFile(folder + "/comparison.json", 1000000)).at("pairs");
  ASSERT_EQ(table.size(), 2u);
  ASSERT_EQ(json.size(), 2u);
  for (int i = 0; i < 2; ++i) {
    const double ratio = i == 0 ? 1 : 0.5;
    // Numbers are written with 9 digits and more; the second goes through a text file and is put on the same samples.
    const auto number = [&](const char* name) { return std::stod(table[i].at(name)); };
    EXPECT_NEAR(number("correlation [-]"), 1, 1e-8);
    EXPECT_NEAR(number("peak ratio [-]"), ratio, 1e-6);
    EXPECT_NEAR(number("rms ratio [-]"), ratio, 1e-6);
    EXPECT_NEAR(json[i]["comparison"]["correlation [-]"].get<double>(), 1, 1e-8);
  }
}

// Every statement of the paper is in the table; those of runs that are not there are not judged, of the others the
// verdict follows from the value and the range that stand beside it; the peak is the record's largest value.
TEST_F(EndToEnd, ValidateJudgesWhatStandsThere) {
  const auto folder = file("judged");
  const auto said = call({"validate", "--from", FIGURES_PAPER_FOLDER, "-o", folder, "--format", "png"});
  EXPECT_THAT(said, HasSubstr("smooth-rail.h5 not found"));
  const auto reference =
      nlohmann::json::parse(readWholeFile(SQUAT_SOURCE_DIR "/resources/reference/paper.json", 1000000));
  const auto table = readCsv(folder + "/validation.csv");
  ASSERT_EQ(table.size(), reference["statements"].size());
  const auto aba = *results::readResult(file("light-defect.h5")).signal("aba_filtered");
  const double peak = *std::max_element(aba.begin(), aba.end());
  int judged = 0, peaks = 0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const auto& row = table[i];
    const auto& statement = reference["statements"][i];
    EXPECT_EQ(row.at("run"), statement["run"].get<std::string>());
    const bool isThere = std::filesystem::exists(file(row.at("run") + ".h5"));
    EXPECT_TRUE(isThere || row.at("verdict") == "not judged") << row.at("statement");
    if (statement["measure"] == "maximum" && row.at("against").empty()) {
      EXPECT_NEAR(std::stod(row.at("value")), peak, 1e-5 * peak);
      ++peaks;
    }
    if (row.at("verdict") == "not judged" || row.at("value").empty()) continue;
    const double value = std::stod(row.at("value"));
    const auto &low = row.at("low"), &high = row.at("high");
    const bool isMet = (low.empty() || value >= std::stod(low)) && (high.empty() || value <= std::stod(high));
    EXPECT_EQ(row.at("verdict"), isMet ? "met" : "not met") << row.at("statement");
    ++judged;
  }
  EXPECT_GT(judged, 8);
  EXPECT_EQ(peaks, 2);
  EXPECT_GT(readCsv(folder + "/validation_parameters.csv").size(), 10u);
}

// A peak that a shallower defect gives: the depth that is found meets it when the calibrated case is run by itself, and
// table, case, text and picture are there.
TEST_F(EndToEnd, CalibrateWritesACaseThatMeetsItsTarget) {
  const auto folder = file("calibrated");
  std::filesystem::create_directories(folder);
  writeDurably(folder + "/peak.json",
               std::string_view(R"({"schema": "squat-targets", "schema_version": 1, "statements": [{"statement": "peak",
                 "measure": "maximum", "expected": 60, "tolerance": 0.1, "unit": "m/s2"}]})"));
  const auto said =
      call({"calibrate", "light-defect", "--targets", folder + "/peak.json", "--free", "defect.depth=0.05:0.2",
            "--confirm", "tiny", "--evaluations", "10", "-o", folder, "--format", "png"});
  EXPECT_THAT(said, HasSubstr("defect.depth"));
  for (const auto& row : readCsv(folder + "/calibration.csv")) {
    const bool isMet = std::abs(std::stod(row.at("peak")) - 60) <= 6;
    EXPECT_EQ(row.at("met"), isMet ? "yes" : "no");
  }
  EXPECT_FALSE(QImage(QString::fromStdString(folder + "/calibration.png")).isNull());
  call({"run", folder + "/light-defect-calibrated.toml", "--mesh", "tiny", "--no-figures", "-o", folder});
  const auto aba = *results::readResult(folder + "/light-defect-calibrated.h5").signal("aba_filtered");
  EXPECT_NEAR(*std::max_element(aba.begin(), aba.end()), 60, 6);
}

// The table against the Timoshenko beam on the same seats (tests/verification): 1.5 dB from 50 to 250 Hz, below the
// resonances, where a coarse mesh of the rail is a beam. Magnitude and phase are those of real and imaginary part; the
// HDF5 file has the same numbers; the modes are those of the half wheelset.
TEST(EndToEndReceptance, IsThatOfABeam) {
  const TemporaryFolder folder;
  const auto path = tests::fixtureCase("smooth-rail");
  call({"receptance", path, "--mesh", "tiny", "--threads", "1", "--format", "png", "--figure-size", "100x70", "--dpi",
        "150", "-o", folder.path()});
  const auto table = readCsv(folder / "smooth-rail-receptance.csv");
  ASSERT_EQ(table.size(), 1951u);  // 50 to 2000 Hz
  const auto scenario = cases::loadScenario(path, {"tiny", {}});
  const auto model = model::buildModel(scenario);
  const auto& rail = model.blocks[model.rail];
  const verification::TrackBeam beam(scenario, verification::beamSection(rail.section), rail.positions.front(),
                                     model.sleeperPositions);
  const double middle = model.sleeperPositions[model.sleeperPositions.size() / 2];
  for (const std::size_t i : {0u, 30u, 70u, 120u, 200u}) {
    const auto& row = table[i];
    const auto number = [&](const char* name) { return std::stod(row.at(name)); };
    const double frequency = number("frequency [Hz]");
    EXPECT_EQ(frequency, 50 + static_cast<double>(i));
    const std::complex<double> found(number("over a sleeper real [m/N]"), number("over a sleeper imaginary [m/N]"));
    const auto expected = beam.receptance({middle}, frequency)[0];
    EXPECT_NEAR(20 * std::log10(std::abs(found) / std::abs(expected)), 0, 1.5) << frequency << " Hz";
    EXPECT_NEAR(number("over a sleeper magnitude [m/N]"), std::abs(found), 1e-6 * std::abs(found));
    EXPECT_NEAR(number("over a sleeper phase [deg]"), std::arg(found) * 180 / M_PI, 1e-4);
  }
  const auto modes = readCsv(folder / "smooth-rail-wheelset-modes.csv");
  const auto expected = model::allWheelsetModes(scenario, 2000, 3);
  ASSERT_EQ(modes.size(), expected.size());
  for (std::size_t k = 0; k < modes.size(); ++k)
    EXPECT_NEAR(std::stod(modes[k].at("frequency [Hz]")), expected[k].frequency, 1e-5 * expected[k].frequency);
  // Plots below each other, 100 mm wide at 150 dpi.
  EXPECT_NEAR(QImage(QString::fromStdString(folder / "smooth-rail-receptance.png")).width(), 100 / 25.4 * 150, 1);
}

}  // namespace
}  // namespace squat
