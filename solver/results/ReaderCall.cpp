#include "results/ReaderCall.h"

#include <cstring>
#include <stdexcept>

#include "results/ArrayStream.h"

namespace squat::results {

ReaderCall& ReaderCall::number(std::uint64_t value) {
  const auto bytes = std::as_bytes(std::span(&value, 1));
  arguments.insert(arguments.end(), bytes.begin(), bytes.end());
  return *this;
}

ReaderCall& ReaderCall::text(std::string_view value) {
  number(value.size());
  const auto bytes = std::as_bytes(std::span(value));
  arguments.insert(arguments.end(), bytes.begin(), bytes.end());
  return *this;
}

std::span<const std::byte> ReaderArguments::take(std::size_t count) {
  if (count > bytes_.size()) throw std::out_of_range("a call of the reading program is cut off");
  const auto taken = bytes_.first(count);
  bytes_ = bytes_.subspan(count);
  return taken;
}

std::size_t ReaderArguments::number() {
  std::uint64_t value = 0;
  std::memcpy(&value, take(sizeof value).data(), sizeof value);
  return static_cast<std::size_t>(value);
}

std::string ReaderArguments::text() {
  const auto bytes = take(number());
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

void putColumns(ReaderCall& call, const std::vector<ArrayColumn>& columns) {
  call.number(columns.size());
  for (const auto& column : columns)
    call.text(column.path).number(column.run).number(column.runs).number(column.samplesFirst ? 1 : 0);
}

std::vector<ArrayColumn> takeColumns(ReaderArguments& arguments) {
  std::vector<ArrayColumn> columns(arguments.number());
  for (auto& column : columns) {
    column.path = arguments.text();
    column.run = arguments.number();
    column.runs = arguments.number();
    column.samplesFirst = arguments.number() != 0;
  }
  return columns;
}

}  // namespace squat::results
