#include "loggers/TdmsChannels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

#include "core/Errors.h"
#include "text/Numbers.h"
#include "text/Text.h"
#include "text/Units.h"

namespace squat::loggers {
namespace {

constexpr std::size_t tdmsNamesShown = 5;

std::string tdmsNames(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < std::min(names.size(), tdmsNamesShown); ++i)
    list += (i > 0 ? ", " : "") + text::shown(names[i]);
  return names.size() > tdmsNamesShown ? list + " and " + std::to_string(names.size() - tdmsNamesShown) + " more"
                                       : list;
}

// [s] from sample to sample; 0: not stated, or not along the time.
double tdmsIncrement(const TdmsObject& channel) {
  const auto increment = tdmsNumber(channel.properties, "wf_increment");
  if (!increment || !(*increment > 0) || !std::isfinite(1 / *increment)) return 0;
  const auto unit = tdmsText(channel.properties, "wf_xunit_string");
  if (text::trimmed(unit).empty()) return *increment;
  const auto* known = text::findUnit(text::bareUnit(unit));
  return known && known->si == "s" ? *increment * known->factor : 0;
}

// Increments that were computed from the same rate may differ in their last digits.
bool tdmsSameIncrement(double a, double b) { return std::abs(a - b) <= 1e-9 * std::max(a, b); }

// The increment that most of the channels state, the smallest of several; 0: none does.
double tdmsCommonIncrement(const TdmsContents& contents, const std::vector<TdmsChannel>& channels) {
  std::vector<double> stated;
  for (const auto& channel : channels)
    if (const double increment = tdmsIncrement(contents.objects[channel.object]); increment > 0)
      stated.push_back(increment);
  std::sort(stated.begin(), stated.end());
  double common = 0;
  std::size_t most = 0;
  for (std::size_t begin = 0, end = 0; begin < stated.size(); begin = end) {
    while (end < stated.size() && tdmsSameIncrement(stated[begin], stated[end])) ++end;
    if (end - begin > most) common = stated[begin], most = end - begin;
  }
  return common;
}

std::string tdmsKindRefusal(const TdmsObject& channel, const TdmsCount& count) {
  if (!channel.refusal.empty() || !count.type) return channel.refusal;
  if (count.type->kind == TdmsKind::text) return "it holds text";
  if (count.type->kind == TdmsKind::other) return "it holds complex numbers";
  return {};
}

// One note for all channels with the same reason.
void tdmsNoteRefusals(const std::map<std::string, std::vector<std::string>>& namesByReason,
                      std::vector<std::string>& notes) {
  for (const auto& [reason, names] : namesByReason) notes.push_back("left out (" + reason + "): " + tdmsNames(names));
}

// The date of the first sample, and the channels that do not begin with it.
void tdmsNoteStart(const TdmsContents& contents, TdmsChoice& choice) {
  const TdmsMoment* first = nullptr;
  double firstOffset = 0;
  std::vector<std::string> others;
  for (const auto& channel : choice.channels) {
    const auto& object = contents.objects[channel.object];
    const auto start = object.properties.find("wf_start_time");
    if (start == object.properties.end() || !start->second.moment || tdmsIncrement(object) == 0) continue;
    const double offset = tdmsNumber(object.properties, "wf_start_offset").value_or(0);
    const auto& moment = *start->second.moment;
    if (first) {
      const double late = tdmsSecondsBetween(*first, moment) + offset - firstOffset;
      if (!(std::abs(late) * choice.rate <= 0.5)) others.push_back(object.channel);
      continue;
    }
    first = &moment;
    firstOffset = offset;
    std::string note = tdmsMomentText(moment);
    if (note.empty()) continue;
    note = "recorded from " + note + " on";
    if (offset != 0) note += ", the first sample " + text::numberText(offset) + " s after that";
    choice.notes.push_back(note);
  }
  if (others.empty()) return;
  choice.notes.push_back(tdmsNames(others) +
                         " began at another time than the first channel; samples of the same "
                         "number are taken together all the same");
}

// The channels of one group, or of all where none is named.
class TdmsSelection {
 public:
  TdmsSelection(const TdmsContents& contents, const std::vector<TdmsCount>& counts, const std::string& path,
                std::string group)
      : contents_(contents), counts_(counts), path_(path), group_(std::move(group)) {
    for (const auto& object : contents.objects) {
      if (object.level == TdmsObject::Level::group) groups_[object.group] = &object.properties;
      if (object.level == TdmsObject::Level::channel) groups_.try_emplace(object.group, nullptr);
      if (object.level == TdmsObject::Level::file) file_ = &object.properties;
    }
  }

  TdmsChoice choose() {
    if (!group_.empty() && groups_.count(group_) == 0)
      throw FileError(path_, text::shown(group_), "is no group of the file", groupAdvice());
    TdmsChoice choice;
    choice.notes = contents_.notes;
    if (group_.empty()) chooseGroup(choice.notes);
    std::map<std::string, std::vector<std::string>> refusals;
    auto usable = usableChannels(refusals);
    tdmsNoteRefusals(refusals, choice.notes);
    if (usable.empty()) failEmpty(choice.notes);
    keepAlike(usable, choice);
    tdmsNoteStart(contents_, choice);
    return choice;
  }

 private:
  std::uint64_t lengthOf(const TdmsChannel& channel) const { return counts_[channel.object].values; }

  std::uint64_t longest(const std::vector<TdmsChannel>& channels) const {
    std::uint64_t length = 0;
    for (const auto& channel : channels) length = std::max(length, lengthOf(channel));
    return length;
  }

  // Those of the group that have numbers; why others are not among them.
  std::vector<TdmsChannel> usableChannels(std::map<std::string, std::vector<std::string>>& refusals) const {
    static const TdmsProperties none;
    std::vector<TdmsChannel> usable;
    for (std::size_t i = 0; i < contents_.objects.size(); ++i) {
      const auto& object = contents_.objects[i];
      if (object.level != TdmsObject::Level::channel || (!group_.empty() && object.group != group_)) continue;
      TdmsChannel channel{i, {}};
      std::string refusal = tdmsKindRefusal(object, counts_[i]);
      if (refusal.empty() && counts_[i].values == 0) refusal = "it has no values";
      if (refusal.empty() && counts_[i].type->kind == TdmsKind::number) {
        const auto* group = groups_.at(object.group);
        channel.scaling = tdmsScaling(object, group ? *group : none, file_ ? *file_ : none);
        refusal = channel.scaling.refusal;
      }
      if (refusal.empty())
        usable.push_back(std::move(channel));
      else
        refusals[refusal].push_back(object.channel);
    }
    return usable;
  }

  void chooseGroup(std::vector<std::string>& notes) {
    std::map<std::string, std::vector<std::string>> ignored;
    const auto usable = usableChannels(ignored);
    if (usable.empty()) return;
    const auto isLongest = [&, length = longest(usable)](const auto& channel) { return lengthOf(channel) == length; };
    group_ = contents_.objects[std::find_if(usable.begin(), usable.end(), isLongest)->object].group;
    std::vector<std::string> others;
    for (const auto& channel : usable)
      if (const auto& other = contents_.objects[channel.object].group; other != group_) others.push_back(other);
    std::sort(others.begin(), others.end());
    others.erase(std::unique(others.begin(), others.end()), others.end());
    if (!others.empty())
      notes.push_back("the group " + text::shown(group_) + " is read, which is the longest; others are " +
                      tdmsNames(others));
  }

  // Of the longest ones, those of the rate that most of them have, or that state none.
  void keepAlike(std::vector<TdmsChannel>& usable, TdmsChoice& choice) const {
    const auto isShorter = [&, length = longest(usable)](const auto& channel) { return lengthOf(channel) != length; };
    const auto shorter = std::stable_partition(usable.begin(), usable.end(), std::not_fn(isShorter));
    leaveOut(shorter, usable, "of another length", choice.notes);
    const double increment = tdmsCommonIncrement(contents_, usable);
    const auto isAlike = [&](const TdmsChannel& channel) {
      const double own = tdmsIncrement(contents_.objects[channel.object]);
      return own == 0 || tdmsSameIncrement(own, increment);
    };
    leaveOut(std::stable_partition(usable.begin(), usable.end(), isAlike), usable, "of another rate", choice.notes);
    choice.rate = increment > 0 ? 1 / increment : 0;
    choice.channels = std::move(usable);
  }

  void leaveOut(std::vector<TdmsChannel>::iterator from, std::vector<TdmsChannel>& channels, const std::string& why,
                std::vector<std::string>& notes) const {
    std::vector<std::string> names;
    for (auto channel = from; channel != channels.end(); ++channel)
      names.push_back(contents_.objects[channel->object].channel);
    channels.erase(from, channels.end());
    if (!names.empty()) notes.push_back("left out (" + why + "): " + tdmsNames(names));
  }

  std::string groupAdvice() const {
    std::vector<std::string> names;
    for (const auto& [name, properties] : groups_) names.push_back(name);
    return names.empty() ? tdmsRefusedAdvice : "Groups of the file: " + tdmsNames(names);
  }

  [[noreturn]] void failEmpty(const std::vector<std::string>& notes) const {
    std::string why;
    for (const auto& note : notes) why += (why.empty() ? ": " : "; ") + note;
    throw FileError(path_, group_.empty() ? "" : text::shown(group_),
                    "has no channel of numbers that can be read" + why, groupAdvice());
  }

  const TdmsContents& contents_;
  const std::vector<TdmsCount>& counts_;
  const std::string& path_;
  std::string group_;                                    // empty: not chosen
  std::map<std::string, const TdmsProperties*> groups_;  // null: the file has channels of it alone
  const TdmsProperties* file_ = nullptr;
};

}  // namespace

TdmsChoice chooseTdmsChannels(const TdmsContents& contents, const std::vector<TdmsCount>& counts,
                              const std::string& path, const std::string& group) {
  return TdmsSelection(contents, counts, path, group).choose();
}

}  // namespace squat::loggers
