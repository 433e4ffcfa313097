#include "commands/SlurmScripts.h"

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/platform/CommandOutput.h"

namespace squat::commands {

namespace {

std::string lineOf(const std::vector<std::string>& words) {
  std::string line;
  for (const auto& word : words) line += (line.empty() ? "" : " ") + quoted(word);
  return line;
}

std::string option(const std::string& text) { return "#SBATCH --" + text + "\n"; }

// What a command prints, both streams. RunError with it where the command fails.
std::string outputOf(const std::string& command) {
  auto output = platform::outputOfCommand(command + " 2>&1");
  if (!output.isStarted) throw RunError("cannot call " + command, 0, 0, "");
  output.text.erase(output.text.find_last_not_of('\n') + 1);
  if (!output.isDone)
    throw RunError(command + ": " + output.text + "; the scripts are written, submit them yourself", 0, 0, "");
  return output.text;
}

}  // namespace

std::string quoted(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=:,./%@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char letter : word) text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

std::string arrayText(const std::vector<std::size_t>& parts) {
  std::string text;
  for (std::size_t i = 0; i < parts.size();) {
    std::size_t last = i;
    while (last + 1 < parts.size() && parts[last + 1] == parts[last] + 1) ++last;
    text += (text.empty() ? "" : ",") + std::to_string(parts[i]);
    if (last > i) text += "-" + std::to_string(parts[last]);
    i = last + 1;
  }
  return text;
}

std::string arrayScript(const SlurmJob& job) {
  auto partition = job.partition;
  partition.replace(partition.find('%'), 1, "$SLURM_ARRAY_TASK_ID");
  // Preempted or near its time limit, a task gets SIGTERM a minute ahead; started again, it resumes.
  return "#!/bin/sh\n# The parts of a study, one a task. A part that is started again resumes.\n" +
         option("job-name=squat-study") + option("array=" + arrayText(job.parts)) +
         option("cpus-per-task=" + std::to_string(job.cores)) + (job.time.empty() ? "" : option("time=" + job.time)) +
         option("requeue") + option("open-mode=append") + option("signal=B:TERM@60") +
         option("output=" + quoted(job.folder + "/part-%a.log")) + "exec " + lineOf(job.call) +
         (job.repeatsFailed ? " --retry-failed" : "") + " --partition " + partition + "\n";
}

std::string collectScript(const SlurmJob& job) {
  return "#!/bin/sh\n# Puts the parts of a study together, and names what is missing.\n" +
         option("job-name=squat-collect") + option("output=" + quoted(job.folder + "/collect.log")) + "exec " +
         lineOf(job.call) + " --collect\n";
}

std::vector<std::string> writeScripts(const SlurmJob& job) {
  makeFolder(job.folder);
  std::vector<std::string> paths{job.folder + "/study.slurm", job.folder + "/study-collect.slurm"};
  writeDurably(paths[0], std::string_view(arrayScript(job)));
  writeDurably(paths[1], std::string_view(collectScript(job)));
  return paths;
}

std::string submitScripts(const std::vector<std::string>& scripts) {
  // "4711" or "4711;cluster"
  const auto array = outputOf("sbatch --parsable " + quoted(scripts[0]));
  const auto collect = outputOf("sbatch --parsable --dependency=afterany:" + array.substr(0, array.find(';')) + " " +
                                quoted(scripts[1]));
  return "submitted: job array " + array + ", then job " + collect;
}

}  // namespace squat::commands
