#include "analysis/Analysis.h"

#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "analysis/AnalysisFiles.h"
#include "analysis/Folder.h"
#include "core/Errors.h"

namespace squat::analysis {
namespace {

using ::testing::HasSubstr;
using tests::Folder;
using tests::runTable;

TEST(Analysis, oneFileFromEndToEnd) {
  const Folder folder;
  const auto file = folder.write("run.csv", runTable(0.08, 60, 30));
  Monitor monitor;
  AnalysisOptions options;
  options.spectrum.window = signals::Window::boxcar;  // for which the integral is the mean square exactly
  const auto analysis = analyse({file}, options, monitor);
  ASSERT_EQ(analysis.signals.size(), 1u);
  const auto& signal = analysis.signals[0];
  EXPECT_NEAR(signal.features.speed, 30, 1e-6);
  EXPECT_NEAR(signal.features.wavelengthByRidge, 30.0 / 1034, 0.002);
  EXPECT_NEAR(signal.features.impactTime, 0.08, 0.002);
  ASSERT_TRUE(signal.stft);
  EXPECT_LE(signal.scalogram.time.size(), 2000u);
  EXPECT_EQ(signal.scalogramPosition.size(), signal.scalogram.time.size());
  EXPECT_NEAR(signal.spectrum.integral, signal.spectrum.meanSquare, 1e-12 * signal.spectrum.meanSquare);
  EXPECT_FALSE(analysis.inTime);

  const auto paths = writeAnalysis(analysis, folder.path("out"));
  ASSERT_EQ(paths.size(), 3u);
  const auto json = nlohmann::json::parse(folder.read("out/features.json"));
  EXPECT_NEAR(json["signals"][0]["features"]["peak [m/s2]"], signal.features.peak, 1e-12);
  EXPECT_EQ(json["signals"][0]["bands"].size(), 3u);
  const std::string csv = folder.read("out/features.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 2);
  EXPECT_THAT(csv, HasSubstr("wavelength by ridge [m]"));
  EXPECT_THAT(folder.read("out/aba_spectrum.csv"), HasSubstr("frequency [Hz],whole record [(m/s2)2/Hz]"));
}

// A tone that does not decay, and one that is gone after a tenth of the record.
TEST(Analysis, vibrationBeyondTheRecordIsNoted) {
  const Folder folder;
  const auto noted = [&](double decay) {
    std::string text = "time [s],aba [m/s2]\n";
    for (int i = 0; i < 5000; ++i) {
      const double t = i / 25e3;
      text +=
          std::to_string(t) + "," + std::to_string(100 * std::exp(-decay * t) * std::sin(2 * M_PI * 300 * t)) + "\n";
    }
    AnalysisOptions options;
    options.file.speed = 30;
    Monitor monitor;
    const auto analysis = analyse({folder.write("tone.csv", text)}, options, monitor);
    for (const auto& note : analysis.signals.at(0).notes)
      if (note.find("free vibration not over") != std::string::npos) return note;
    return std::string();
  };
  EXPECT_THAT(noted(0), HasSubstr("200-400 Hz"));
  EXPECT_EQ(noted(200), "");
}

TEST(Analysis, repeatedRunsAreAligned) {
  const Folder folder;
  std::vector<std::string> files;
  const double impacts[3] = {0.08, 0.091, 0.0703}, heights[3] = {60, 66, 54}, speeds[3] = {30, 28, 29};
  for (int r = 0; r < 3; ++r)
    files.push_back(folder.write("run" + std::to_string(r) + ".csv", runTable(impacts[r], heights[r], speeds[r])));
  Monitor monitor;
  const auto analysis = analyse(files, {}, monitor);
  ASSERT_TRUE(analysis.inTime && analysis.inPosition && analysis.dispersion);
  for (std::size_t r = 0; r < 3; ++r)
    EXPECT_NEAR(analysis.inTime->impact[r] - analysis.inTime->impact[0], impacts[r] - impacts[0], 1 / 25000.0);
  EXPECT_NEAR(analysis.dispersion->largestPeak.range, 0.2, 0.005);  // (66 - 54)/60
  EXPECT_EQ(analysis.signals[1].run, "run1: aba");
  writeAnalysis(analysis, folder.path("out"));
  EXPECT_THAT(folder.read("out/aligned_time.csv"), HasSubstr("time [s],mean,lowest,highest,run0: aba,run1: aba"));
  EXPECT_THAT(folder.read("out/features.json"), HasSubstr("range_by_mean"));
  EXPECT_EQ(Folder().files(), 0u);
}

TEST(Analysis, slowRatesAreNotedAndAskedBandsRefused) {
  const Folder folder;
  std::ostringstream text;
  text << "t,aba\n";
  for (int i = 0; i < 3000; ++i)
    text << i / 1000.0 << ',' << std::exp(-std::abs(i - 1000) / 50.0) * (i % 9 - 4) << '\n';
  const auto file = folder.write("slow.csv", text.str());
  AnalysisOptions options;
  options.file.speed = 30;
  Monitor monitor;
  // What nobody asked for is left out and told.
  const auto usual = analyse({file}, options, monitor);
  EXPECT_THAT(
      usual.signals[0].notes,
      ::testing::Contains(HasSubstr("sampling rate of 1000 Hz: 1000-1200 Hz, the wavelength (600 Hz to 2000 Hz)")));
  const auto csv = featureCsv(usual);
  EXPECT_THAT(csv, HasSubstr(",,"));
  EXPECT_EQ(csv.find("nan"), std::string::npos);
  options.features.bands.push_back({"own", 700, 900});
  try {
    analyse({file}, options, monitor);
    FAIL() << "a band above half the rate was accepted";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the band 700 to 900 Hz needs a sampling rate above 1800 Hz"));
  }
  options.features.bands = {{"low", 20, 200}};
  options.features.waveBand = {"wave", 100, 400};
  options.wavelet.lowest = 10;
  const auto analysis = analyse({file}, options, monitor);
  // no low-pass, no waves in the band, the uneven window, and the scalogram to 500 Hz
  EXPECT_THAT(analysis.signals[0].notes,
              ::testing::ElementsAre(HasSubstr("not low-pass filtered"), HasSubstr("no wavelength by crossings"),
                                     HasSubstr("window weights"), HasSubstr("ends at 500 Hz")));
  EXPECT_LE(analysis.signals[0].scalogram.frequency.back(), 500);
}

// 0.24 s hold one wave of 4.17 Hz; the wavelet of 0.001 Hz lasts hours, and took gigabytes over it.
TEST(Analysis, theScalogramKeepsToWhatTheRecordCanShow) {
  const Folder folder;
  const auto file = folder.write("run.csv", runTable(0.08, 60, 30));
  AnalysisOptions options;
  options.wavelet.lowest = 1e-3;
  options.wavelet.voicesPerOctave = 200;
  Monitor monitor;
  const auto signal = analyse({file}, options, monitor).signals.at(0);
  EXPECT_NEAR(signal.scalogram.frequency.front(), 1 / 0.24, 1e-9);
  EXPECT_LE(signal.scalogram.frequency.size(), 1001u);
  EXPECT_THAT(signal.notes, ::testing::Contains(HasSubstr("one period in the record")));
  EXPECT_THAT(signal.notes, ::testing::Contains(HasSubstr("limited to 1000 rows")));
  EXPECT_THAT(analyse({file}, {}, monitor).signals.at(0).notes,
              ::testing::Not(::testing::Contains(HasSubstr("begins"))));

  // Of a long record the sampling rate limits what a wavelet may cost.
  std::string text = "t,aba\n";
  for (int i = 0; i < 300000; ++i) text += std::to_string(i / 1e3) + "," + std::to_string(i % 7) + "\n";
  options.file.speed = 30;
  options.wavelet.lowest = 1e-4, options.wavelet.highest = 0.1, options.wavelet.voicesPerOctave = 2;
  const auto slow = analyse({folder.write("slow.csv", text)}, options, monitor).signals.at(0);
  EXPECT_NEAR(slow.scalogram.frequency.front(), 0.01, 1e-6);
}

TEST(Analysis, badInputIsOneMessageAndNoFile) {
  const Folder folder;
  Monitor monitor;
  const auto noSpeed = folder.write("a.csv", "t,aba\n0,1\n0.1,2\n0.2,1\n");
  EXPECT_THROW(analyse({noSpeed}, {}, monitor), CaseError);
  AnalysisOptions options;
  options.file.speed = 30;
  EXPECT_THROW(analyse({noSpeed}, options, monitor), FileError);  // too short
  std::string constant = "t,aba\n";
  for (int i = 0; i < 500; ++i) constant += std::to_string(i) + ",3\n";
  const auto flat = folder.write("b.csv", constant);
  try {
    analyse({flat}, options, monitor);
    FAIL() << "a constant signal was accepted";
  } catch (const FileError& error) {
    EXPECT_THAT(error.what(), testing::AllOf(HasSubstr("b.csv"), HasSubstr("constant")));
  }
  EXPECT_THROW(analyse({}, {}, monitor), CaseError);
  EXPECT_EQ(folder.files(), 2u);
}

TEST(Analysis, cancelledKeepsWhatIsThere) {
  struct Impatient : Monitor {
    bool cancelled() override { return ++asked > 1; }
    int asked = 0;
  };
  const Folder folder;
  const auto file = folder.write("run.csv", runTable(0.08, 60, 30));
  Impatient monitor;
  const auto analysis = analyse({file, file, file}, {}, monitor);
  EXPECT_EQ(analysis.signals.size(), 1u);
  EXPECT_EQ(analysis.notes.size(), 1u);
}

// The tables of a file that has the name of one of them, in its own folder: the measurement must stay.
TEST(AnalysisFiles, neverReplaceWhatWasAnalysed) {
  const Folder folder;
  std::filesystem::create_symlink(folder.path(), folder.path("link"));
  for (const std::string name : {"features.csv", "aba_spectrum.csv", "aligned_time.csv"}) {
    const auto text = runTable(0.08, 60, 30);
    const auto file = folder.write(name, text), other = folder.write("other.csv", runTable(0.09, 50, 30));
    const auto files = name == "aligned_time.csv" ? std::vector{file, other} : std::vector{file};
    Monitor monitor;
    const auto analysis = analyse(files, {}, monitor);
    for (const auto& out : {folder.path(), folder.path("link")})
      EXPECT_THROW(writeAnalysis(analysis, out), CaseError) << name;
    EXPECT_EQ(folder.read(name), text);
    std::filesystem::remove(file);
    EXPECT_EQ(folder.files(), 2u) << "nothing is written where one table must not be";  // the link and the other file
  }
}

TEST(AnalysisFiles, namesAreSafe) {
  EXPECT_EQ(safeFileName("../a b: \"c\""), "a_b_c");
  EXPECT_EQ(safeFileName(""), "signal");
  EXPECT_EQ(safeFileName("run-7"), "run-7");
}

}  // namespace
}  // namespace squat::analysis
