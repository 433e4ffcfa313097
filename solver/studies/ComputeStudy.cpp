#include "studies/ComputeStudy.h"

#include <cstdio>
#include <utility>

#include "case/ShortHash.h"
#include "core/DurableFile.h"
#include "results/ResultFile.h"
#include "studies/CaseStudy.h"
#include "studies/Jobs.h"
#include "studies/SharedStart.h"

namespace squat::studies {

namespace {

constexpr double kBytesOfARun = 1ULL << 30;  // of a part; the paper's mesh takes a quarter of it

std::size_t runsAhead(const StudyJob& job) {
  const auto table = tableSoFar(job);
  return table.count(RowState::open) + (job.study.retryFailed ? table.count(RowState::failed) : 0);
}

// Of a point's files. Points that are added to a study change the numbers of others; parts by hash may grow.
std::string nameOf(const StudyJob& job, const StudyPoint& point) {
  if (job.study.part && job.study.part->kind == Partition::Kind::hash)
    return job.stem + "-" + cases::shortHash(toText(job.definition, point));
  char number[32];
  std::snprintf(number, sizeof number, "-%04zu", point.index + 1);
  return job.stem + number;
}

}  // namespace

std::string toText(const StudyCost& cost) {
  char text[160];
  std::snprintf(text, sizeof text, "%zu runs of %zu elements and %.0f steps, %.2g core hours; %.0f MiB a run",
                cost.runs, cost.run.elements, cost.run.steps, cost.coreHours(), cost.run.bytes / (1 << 20));
  return text;
}

StudyTable tableSoFar(const StudyJob& job) {
  auto table = readTable(job.definition, job.study.folder, job.study.part);
  return table ? std::move(*table) : emptyTable(job.definition, job.study.part);
}

StudyCost costAhead(const StudyJob& job) {
  StudyCost cost;
  cost.run.bytes = kBytesOfARun;
  cost.runs = job.study.part ? 0 : runsAhead(job);
  if (cost.runs > 0) cost.run = costOfARun(job.definition, job.overrides);
  return cost;
}

void shareCores(StudyJob& job, int jobs, int threads, const StudyCost& cost) {
  const RunDemand demand{cost.run.bytes, kTrafficOfAThread, kStateOfAnElement * static_cast<double>(cost.run.elements)};
  const auto sharing = shareMachine(thisMachine(), demand, {jobs, threads});
  job.study.jobs = sharing.jobs, job.run.threads = sharing.threads;
}

std::string resultFile(const StudyJob& job, const StudyPoint& point) {
  return job.study.folder + "/" + nameOf(job, point) + ".h5";
}

StudyTable computeStudy(StudyJob job, Monitor& monitor) {
  job.run.wheelsetModes = false;
  job.run.snapshots = false;
  const auto& folder = job.study.folder;
  makeFolder(folder);
  SharedStart start(job.definition, job.overrides, job.run, job.run.threads * job.study.jobs);
  job.definition.start = start.text();
  const auto run = [&](const cases::CaseDescription& description, const StudyPoint& point, Monitor& own) {
    auto result = start.run(description, own);
    result.stem = nameOf(job, point);
    if (job.keepResults && result.complete) results::writeResult(resultFile(job, point), result);
    return result;
  };
  return runCaseStudy(job.definition, job.overrides, run, job.study, monitor);
}

}  // namespace squat::studies
