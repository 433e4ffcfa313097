#include "project/Project.h"

#include "case/ShortHash.h"

namespace squat::project {
namespace {

std::string hashOf(const std::vector<double>& values) {
  return cases::shortHash({reinterpret_cast<const char*>(values.data()), values.size() * sizeof(double)});
}

}  // namespace

std::string recordDigest(const signals::Record& record) {
  std::string parts = hashOf(record.time) + hashOf(record.position);
  for (const auto& channel : record.signals) parts += ' ' + channel.name + ' ' + hashOf(channel.values);
  return cases::shortHash(parts);
}

}  // namespace squat::project
