#include "commands/EstimateEach.h"

#include <cstdio>
#include <map>

#include "commands/ExitCodes.h"
#include "commands/FilesInParts.h"
#include "core/DurableFile.h"
#include "core/Errors.h"
#include "estimation/EstimateFiles.h"
#include "text/Numbers.h"
#include "text/TextTable.h"

namespace squat::commands {

namespace {

using text::kTerminalWidth;
using text::TextTable;

using estimation::EstimateRow;

void requireOwnFolders(const EachEstimate& each) {
  std::map<std::string, std::string> fileOf;
  for (const auto& file : each.definition.files)
    if (const auto [known, isNew] = fileOf.emplace(estimation::estimateFolder(each.folder, file), file); !isNew)
      throw CaseError({{"MEASURED", file, "files with names of their own",
                        "The results of " + known->second + " would go into " + known->first + " as well"}});
}

estimation::EstimateDefinition definitionFor(const EachEstimate& each, const std::string& file) {
  auto definition = each.definition;
  definition.files = {file};
  return definition;
}

// Of one passage; the row in a folder's `estimate.json` comes last, so that what has one is whole.
FileOutcome estimateFile(const EachEstimate& each, const std::string& file, const std::function<void()>& requireOwn,
                         Monitor& monitor) {
  std::string key;
  const auto fail = [&](const std::string& why) {
    monitor.message("error: " + why);
    if (!key.empty()) estimation::writeRow(each.folder, {file, true, why, {}, {}, 0, 0, 0}, key, nullptr);
    return FileOutcome::failed;
  };
  try {
    const auto definition = definitionFor(each, file);
    key = estimation::estimateKey(definition, each.options);
    if (const auto known = estimation::readRow(each.folder, file, key); known && !known->hasFailed)
      return FileOutcome::known;
    const auto found = estimation::estimateProfile(definition, each.options, monitor);
    if (!found.complete) return FileOutcome::cancelled;
    requireOwn();
    const auto folder = estimation::estimateFolder(each.folder, file);
    makeFolder(folder);
    estimation::writeEstimate(found, folder);
    // Three files a passage are many: drawn where asked for. A figure that cannot be written costs no estimate.
    if (each.partition.empty() && !each.figures.formats.empty()) try {
        writeEstimateFigure(found, folder, each.figures);
      } catch (const FileError& error) {
        monitor.message(std::string("no figure: ") + error.what());
      }
    estimation::writeRow(each.folder, estimation::rowOf(file, found), key, &found);
    return FileOutcome::done;
  } catch (const FileError& error) {
    return fail(error.what());
  } catch (const RunError& error) {
    return fail(error.what());
  }
}

int collectEstimates(const EachEstimate& each) {
  std::vector<EstimateRow> rows;
  std::vector<std::string> missing;
  std::size_t failed = 0;
  for (const auto& file : each.definition.files) {
    const auto key = estimation::estimateKey(definitionFor(each, file), each.options);
    if (auto row = estimation::readRow(each.folder, file, key))
      rows.push_back(*std::move(row)), failed += rows.back().hasFailed;
    else
      missing.push_back(file);
  }
  if (!missing.empty())
    throw FileError(each.folder, "", "holds no estimates of " + listed(missing) + " with the options of this call",
                    "Repeat the parts that have these passages");
  TextTable table({"passage", "depth [um]", "length [mm]", "misfit", "peak [m/s²]"});
  const auto range = [](const estimation::Interval& interval, double unit) {
    return text::roundedText(unit * interval.value) + " (" + text::roundedText(unit * interval.low) + " to " +
           text::roundedText(unit * interval.high) + ")";
  };
  for (const auto& row : rows)
    table.add(row.hasFailed ? std::vector<std::string>{row.file, "failed", "", "", ""}
                            : std::vector<std::string>{row.file, range(row.depth, 1e6), range(row.length, 1e3),
                                                       text::roundedText(row.misfit), text::roundedText(row.peak)});
  std::printf("%s", table.text(kTerminalWidth).c_str());
  for (const auto& row : rows)
    if (row.hasFailed) std::fprintf(stderr, "failed: %s\n", row.message.c_str());
  const auto path = estimation::estimatesFile(each.folder);
  writeDurably(path, std::string_view(estimation::estimatesText(rows)));
  std::printf("%s: %zu of %zu passages explained\n", path.c_str(), rows.size() - failed, rows.size());
  return failed > 0 ? kFileWrong : kDone;
}

}  // namespace

int estimateEach(const EachEstimate& each, Monitor& monitor) {
  requireOwnFolders(each);
  if (each.collect) return collectEstimates(each);
  if (!each.partition.empty())
    return workOnPart(
        "estimate", each.definition.files, each.folder, studies::partitionFromText(each.partition),
        [&](const std::string& file, const studies::PartLock& lock) {
          return estimateFile(
              each, file, [&] { lock.requireOwn(); }, monitor);
        },
        monitor);
  const auto& files = each.definition.files;
  for (std::size_t i = 0; i < files.size(); ++i) {
    monitor.message("passage " + std::to_string(i + 1) + " of " + std::to_string(files.size()) + ": " + files[i]);
    if (estimateFile(
            each, files[i], [] {}, monitor) != FileOutcome::cancelled)
      continue;
    std::fprintf(stderr, "cancelled: repeat the command to resume\n");
    return kCancelled;
  }
  return collectEstimates(each);
}

}  // namespace squat::commands
