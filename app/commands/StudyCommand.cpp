#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <filesystem>
#include <mutex>
#include <optional>
#include <thread>

#include "case/CaseFile.h"
#include "commands/CaseOptions.h"
#include "commands/Command.h"
#include "commands/ExitCodes.h"
#include "commands/Interrupt.h"
#include "commands/RunFiles.h"
#include "commands/Study.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "results/ResultFile.h"
#include "simulation/RunCase.h"

namespace squat::commands {

namespace {

struct StudyOptions {
  CaseOptions caseOptions;
  std::vector<std::string> variations;
  std::string folder = ".", isa;
  int threads = 0, jobs = 0;
  bool fresh = false, resume = false;
};

class StudyMonitor : public Monitor {
 public:
  bool cancelled() override { return InterruptGuard::asked(); }
};

unsigned cores() { return std::max(1U, std::thread::hardware_concurrency()); }

// As many runs at once as cores, but 2 GiB of free memory for each (the paper's mesh takes 1.5).
unsigned jobsThatFit() {
  constexpr double kBytesOfARun = 2.0 * (1ULL << 30);
  const double available =
      static_cast<double>(::sysconf(_SC_AVPHYS_PAGES)) * static_cast<double>(::sysconf(_SC_PAGESIZE));
  return std::clamp(static_cast<unsigned>(available / kBytesOfARun), 1U, cores());
}

// A result of this very case by this very program is not computed again.
std::optional<results::RunResult> finished(const RunFiles& files, const std::string& hash) {
  std::error_code ignored;
  if (!std::filesystem::exists(files.result(), ignored)) return std::nullopt;
  try {
    auto result = results::readResult(files.result());
    if (result.complete && result.caseHash == hash && result.codeVersion == SQUAT_VERSION) return result;
  } catch (const FileError&) {  // damaged: computed again
  }
  return std::nullopt;
}

// Fills outcome; false where the user cancelled.
bool runOne(const StudyOptions& options, const StudyRun& run, int threads, StudyOutcome& outcome) {
  outcome.run = run;
  try {
    auto caseOptions = options.caseOptions;
    for (const auto& [key, value] : run.sets) caseOptions.sets.push_back(key + "=" + value);
    const auto description = readCase(caseOptions);
    const RunFiles files{options.folder, cases::caseStem(options.caseOptions.name) + "-" + run.name};
    auto result = options.fresh ? std::nullopt : finished(files, cases::caseHash(description));
    if (!result) {
      simulation::RunOptions runOptions;
      runOptions.threads = threads;
      runOptions.isa = options.isa;
      runOptions.wheelsetModes = false;
      runOptions.snapshots = false;
      StudyMonitor monitor;
      result = simulation::runCase(description, runOptions, monitor);
      if (!result->complete) return false;
      result->stem = files.stem;
      writeRunFiles(files, *result);
    }
    outcome.features = studyFeatures(*result);
    outcome.status = "done";
  } catch (const std::exception& error) {
    outcome.status = std::string("failed: ") + error.what();
    std::replace(outcome.status.begin(), outcome.status.end(), '\n', ';');
  }
  return true;
}

int study(const StudyOptions& options) {
  std::vector<Variation> variations;
  for (const auto& text : options.variations) variations.push_back(variationFromText(text));
  const auto runs = studyRuns(variations);
  readCase(options.caseOptions);  // what is wrong with the case itself is told before any run
  const RunFiles table{options.folder, cases::caseStem(options.caseOptions.name) + "-study"};
  prepareFolder(table);

  const unsigned jobs = std::min<unsigned>(options.jobs > 0 ? static_cast<unsigned>(options.jobs) : jobsThatFit(),
                                           static_cast<unsigned>(runs.size()));
  const int threads = options.threads > 0 ? options.threads : static_cast<int>(std::max(1U, cores() / jobs));
  const InterruptGuard interrupt;
  std::vector<StudyOutcome> outcomes(runs.size());
  std::atomic<std::size_t> next{0}, done{0};
  std::mutex printing;
  const auto work = [&] {
    for (std::size_t i = next++; i < runs.size() && !InterruptGuard::asked(); i = next++) {
      if (!runOne(options, runs[i], threads, outcomes[i])) return;
      const std::lock_guard lock(printing);
      std::string sets;
      for (const auto& [key, value] : runs[i].sets) sets += "  " + key + " = " + value;
      std::fprintf(stderr, "%zu of %zu: run %s%s: %s\n", ++done, runs.size(), runs[i].name.c_str(), sets.c_str(),
                   outcomes[i].status.c_str());
    }
  };
  std::vector<std::thread> workers;
  for (unsigned i = 1; i < jobs; ++i) workers.emplace_back(work);
  work();
  for (auto& worker : workers) worker.join();

  if (InterruptGuard::asked()) {
    std::fprintf(stderr, "cancelled after %zu of %zu runs; the same call goes on from here\n", done.load(),
                 runs.size());
    return kCancelled;
  }
  writeDurably(table.signals(), studyCsv(outcomes));
  std::printf("%s\n", table.signals().c_str());
  bool failed = false;
  for (const auto& outcome : outcomes)
    if (outcome.status != "done") {
      std::fprintf(stderr, "run %s %s\n", outcome.run.name.c_str(), outcome.status.c_str());
      failed = true;
    }
  return failed ? kRunFailed : kDone;
}

}  // namespace

void addStudyCommand(CLI::App& program, Action& action) {
  auto* command = program.add_subcommand("study", "Many runs of a case with keys varied, and one table of features");
  auto options = std::make_shared<StudyOptions>();
  addCaseOptions(*command, options->caseOptions);
  command
      ->add_option("--vary", options->variations,
                   "Values of one key: KEY=FROM:TO:COUNT or KEY=V,W,...; may be repeated")
      ->required()
      ->allow_extra_args(false)
      ->type_name("KEY=...");
  command->add_option("-o,--output", options->folder, "Folder for results and table (default: here)")->type_name("DIR");
  command->add_option("--jobs", options->jobs, "Runs at once (default: as cores and memory allow)")
      ->check(CLI::Range(1, 256))
      ->type_name("N");
  command->add_option("--threads", options->threads, "Threads of each run (default: cores / jobs)")
      ->check(CLI::Range(1, 1024))
      ->type_name("N");
  command->add_option("--isa", options->isa, "Instruction set: sse2, avx2 or avx512")
      ->check(CLI::IsMember({"sse2", "avx2", "avx512"}))
      ->type_name("NAME");
  command->add_flag("--resume", options->resume, "Keeps finished runs of the same cases: what is done anyway");
  command->add_flag("--fresh", options->fresh, "Computes finished runs again");
  command->callback([options, &action] { action = [options] { return study(*options); }; });
}

}  // namespace squat::commands
