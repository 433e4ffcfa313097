// solver/core/DurableFile.h - files that are whole or not there: written beside, flushed, verified, renamed.
#pragma once

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace squat {

enum class Previous { replaced, kept };  // kept: the file that stood there goes on as PATH.previous

// Puts `bytes` under `path` so that at every instant, also after a kill or a power cut, `path` is either the earlier
// file or the new one, whole. `verify` is given the path of the finished file beside (PATH.part-PID) and throws if it
// does not read back; then nothing is replaced. Throws FileError with the path, the reason, the bytes needed and the
// bytes free. Removes what dead processes left beside `path`.
void writeDurably(const std::string& path, std::span<const std::byte> bytes,
                  const std::function<void(const std::string&)>& verify = {}, Previous previous = Previous::replaced);
void writeDurably(const std::string& path, std::string_view text);

// Throws CaseError where one of `outputs` is one of `inputs`, under whatever name: what was read is not to be replaced.
void keepInputs(const std::vector<std::string>& inputs, const std::vector<std::string>& outputs);

// Makes the folder and its parents; FileError where that cannot be done.
void makeFolder(const std::string& folder);

// The whole of a regular file (no pipe, no device), at most `largest` bytes; FileError otherwise.
std::string readWholeFile(const std::string& path, std::size_t largest);

}  // namespace squat
