#include "results/StateFile.h"

#include <algorithm>
#include <cctype>
#include <span>
#include <utility>

#include "core/Errors.h"
#include "results/TreeStream.h"

namespace squat::results {

namespace {

constexpr std::size_t kLargestState = std::size_t{2} << 30;  // [bytes]; the paper's mesh needs about 0.1e9
}  // namespace

std::string asSentence(std::string text) {
  if (!text.empty()) text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
  return text;
}

void writeState(const std::string& path, ArrayTree state, const StateKind& kind, Previous previous) {
  if (const auto array = firstNotFinite(state); !array.empty())
    throw FileError(path, array, "not written: the state holds a value that is not a number");
  setAttribute(state.attributes, "schema", std::string(kind.schema));
  setAttribute(state.attributes, "schema_version", std::int64_t{kind.version});
  const auto bytes = encodeTree(state);
  const auto verify = [&](const std::string& part) {
    const auto back = readWholeFile(part, kLargestState);
    if (!std::ranges::equal(std::as_bytes(std::span(back)), bytes))
      throw FileError(path, "", "did not read back as it was written", "Check the disk");
  };
  writeDurably(path, bytes, verify, previous);
}

ArrayTree readState(const std::string& path, const StateKind& kind) {
  const auto text = readWholeFile(path, kLargestState);
  auto state = decodeTree(sourceOf(std::as_bytes(std::span(text))), path, kLargestState);
  const std::string name = kind.name, instead = kind.insteadOf;
  if (textAttribute(state.attributes, "schema") != kind.schema)
    throw FileError(path, "attribute schema", "is not " + name, "Name " + name + " of this program");
  const double version = numberAttribute(state.attributes, "schema_version", -1);
  if (!(version >= 1)) throw FileError(path, "attribute schema_version", "is missing or wrong");
  if (version > kind.version)
    throw FileError(path, "attribute schema_version", "was written by a newer version of the program",
                    "Use that version, or " + instead);
  if (const auto array = firstNotFinite(state); !array.empty())
    throw FileError(path, array, "holds a value that is not a number", asSentence(instead));
  return state;
}

}  // namespace squat::results
