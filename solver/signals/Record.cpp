#include "signals/Record.h"

#include "signals/SignalError.h"

namespace squat::signals {

const Channel* Record::channel(std::string_view name) const {
  for (const auto& each : signals)
    if (each.name == name) return &each;
  return nullptr;
}

Channel* Record::channel(std::string_view name) {
  return const_cast<Channel*>(static_cast<const Record*>(this)->channel(name));
}

const std::vector<double>* Record::signal(std::string_view name) const {
  const Channel* found = channel(name);
  return found ? &found->values : nullptr;
}

TimeSeries seriesOf(const Record& record, std::string_view name) {
  const Channel* channel = !name.empty()            ? record.channel(name)
                           : record.signals.empty() ? nullptr
                                                    : &record.signals.front();
  if (!channel) throw SignalError("the record has no signal '" + std::string(name) + "'");
  const std::size_t n = channel->values.size();
  if (n != record.time.size() || n < 2)
    throw SignalError("signal '" + channel->name + "' has " + std::to_string(n) + " samples at " +
                      std::to_string(record.time.size()) + " times; at least 2 at as many times are needed");
  const double step = (record.time.back() - record.time.front()) / static_cast<double>(n - 1);
  return {record.time.front(), step, channel->values, channel->name, channel->unit};
}

Passage passageOf(const Record& record, std::string_view name) {
  Passage passage{seriesOf(record, name), record.position};
  if (!record.position.empty() && record.position.size() != record.time.size())
    throw SignalError("the record has " + std::to_string(record.position.size()) + " positions at " +
                      std::to_string(record.time.size()) + " times");
  return passage;
}

}  // namespace squat::signals
