#include "project/ProjectCopy.h"

#include <algorithm>
#include <filesystem>
#include <span>
#include <system_error>
#include <vector>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "core/PartFile.h"
#include "core/platform/File.h"
#include "core/platform/FileLock.h"
#include "core/platform/Process.h"
#include "core/platform/Signals.h"
#include "project/CopyPlan.h"
#include "project/ProjectFile.h"

namespace squat::project {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannotRead(const std::string& path, std::error_code error) {
  throw FileError(path, "", "cannot be read: " + error.message(),
                  "Nothing was copied; remove it from the project, or try again");
}

[[noreturn]] void cannotWrite(const std::string& path, std::error_code error) {
  throw FileError(path, "", "cannot be written: " + error.message(),
                  "Nothing is left of the copy; free some space or choose another folder");
}

// FOLDER.part-PID, which takes the name FOLDER when all is in it; else it goes.
class PartFolder {
 public:
  explicit PartFolder(const fs::path& folder) : folder_(folder), part_(partName(folder.string())) {
    removeLeftOvers(folder.string());
    fs::remove_all(part_);
  }
  ~PartFolder() {
    std::error_code none;
    if (!kept_) fs::remove_all(renamed_ ? folder_ : part_, none);
  }
  PartFolder(const PartFolder&) = delete;
  PartFolder& operator=(const PartFolder&) = delete;

  // Of a file in it, whose folder is made.
  std::string pathOf(const std::string& name) const {
    std::error_code error;
    fs::path path = part_ / name;
    fs::create_directories(path.parent_path(), error);
    if (error) cannotWrite((folder_ / name).string(), error);
    return path.string();
  }
  void takeName() {
    std::error_code error;
    if (!fs::exists(part_, error)) return;  // no file goes with the project
    for (const auto& each : fs::recursive_directory_iterator(part_))
      if (each.is_directory()) platform::flushFolder(each.path().string());
    platform::flushFolder(part_.string());
    error = platform::rename(part_.string(), folder_.string());
    if (error) cannotWrite(folder_.string(), error);
    renamed_ = true;
    platform::flushFolder(folder_.parent_path().string());
  }
  void keep() { kept_ = true; }

 private:
  fs::path folder_, part_;
  bool renamed_ = false, kept_ = false;
};

// Reports how much is copied, and asks whether to continue.
class Watch {
 public:
  Watch(Monitor& monitor, const std::vector<PlannedFile>& files) : monitor_(monitor) {
    for (const auto& file : files) {
      std::error_code error;
      const auto size = fs::file_size(file.from, error);
      if (!error) all_ += static_cast<double>(size);
    }
  }
  double all() const { return all_; }  // [bytes]
  bool goesOn(const std::string& name, std::size_t bytes) {
    copied_ += static_cast<double>(bytes);
    Progress progress;
    progress.phase = name;
    progress.fraction = all_ > 0 ? std::min(copied_ / all_, 1.0) : 1;
    monitor_.report(progress);
    return !monitor_.cancelled();
  }

 private:
  Monitor& monitor_;
  double all_ = 0, copied_ = 0;
};

// False: cancelled. `shown`: the name that the copy will have, for messages.
bool copyFile(const PlannedFile& file, const std::string& to, const std::string& shown, Watch& watch) {
  platform::File source(file.from, platform::File::Access::read);
  if (source.openingError()) cannotRead(file.from, source.openingError());
  platform::File target(to, platform::File::Access::replace);
  if (target.openingError()) cannotWrite(shown, target.openingError());
  std::vector<std::byte> buffer(std::size_t{4} << 20U);
  for (;;) {
    std::error_code reading;
    const auto count = source.read(buffer, reading);
    if (reading) cannotRead(file.from, reading);
    if (count == 0) break;
    if (const auto writing = target.write(std::span(buffer).first(count))) cannotWrite(shown, writing);
    if (!watch.goesOn(file.to, count)) return false;
  }
  const auto flushing = target.flush(), closing = target.close();
  if (flushing || closing) cannotWrite(shown, flushing ? flushing : closing);
  return true;
}

void requireRoom(const std::string& folder, double bytes) {
  std::error_code error;
  if (!fs::is_directory(folder, error))
    throw FileError(folder, "", "is not a folder", "Choose another folder for the copy");
  const auto room = fs::space(folder, error);
  if (error || static_cast<double>(room.available) >= bytes) return;
  const auto megabytes = [](double count) { return std::to_string(static_cast<long>(count / 1e6)) + " MB"; };
  throw FileError(folder, "",
                  "has " + megabytes(static_cast<double>(room.available)) + " free; the copy needs " + megabytes(bytes),
                  "Free some space or choose another folder");
}

bool copyAll(const CopyPlan& plan, const PartFolder& part, const std::string& folder, Watch& watch) {
  for (const auto& file : plan.files) {
    const std::string to = part.pathOf(file.to);
    if (!watch.goesOn(file.to, 0)) return false;
    if (!file.text.empty())
      writeDurably(to, file.text);
    else if (!copyFile(file, to, folder + "/" + file.to, watch))
      return false;
  }
  return true;
}

}  // namespace

std::string dataFolder(const std::string& path) {
  const fs::path file(path);
  return (file.parent_path() / file.stem()).string() + ".data";
}

ProjectCopy copyWithData(const Project& project, const std::string& path, Monitor& monitor) {
  const std::string folder = dataFolder(path), beside = fs::path(path).parent_path().string();
  platform::FileLock owner(beside + "/." + fs::path(path).filename().string() + ".lock");  // as the studio has it
  if (owner.isTaken())
    throw FileError(path, "", "is open in a window: " + owner.other(), "Choose another name for the copy");
  owner.write(platform::processName("a copy of a project"));
  std::error_code none;
  if (fs::exists(fs::symlink_status(folder, none)))
    throw FileError(folder, "", "exists", "Choose another name for the copy, or move this folder away");
  const CopyPlan plan = planCopy(project, folder);
  ProjectCopy copy{false, 0, plan.problems};
  Watch watch(monitor, plan.files);
  requireRoom(beside, watch.all());
  const platform::FileSizeSignalBlocked blocked;
  PartFolder part(folder);
  if (!copyAll(plan, part, folder, watch)) return copy;
  part.takeName();
  writeProject(path, plan.project);
  part.keep();
  copy.complete = true, copy.files = plan.files.size();
  return copy;
}

}  // namespace squat::project
