#include "loggers/TdmsObjects.h"

#include "core/CheckedCounts.h"

namespace squat::loggers {
namespace {

constexpr std::uint32_t tdmsFormatChanging = 0x1269, tdmsDigitalLine = 0x1369;  // first words of DAQmx indices
constexpr std::uint32_t tdmsRawType = 0xFFFFFFFF;
constexpr std::uint32_t tdmsMostCards = 256;  // and scalers of one channel

// Cards number their types in another way than the file does. As the type of a scaler, all ones are a time stamp.
const TdmsType* tdmsCardType(std::uint32_t code) {
  constexpr std::uint32_t types[] = {5, 1, 6, 2, 7, 3, 8, 4, 9, 10};
  if (code == tdmsRawType) return findTdmsType(0x44);
  return code < std::size(types) ? findTdmsType(types[code]) : nullptr;
}

std::uint32_t tdmsCardLength(TdmsCursor& cursor) {
  const std::uint32_t length = cursor.word();
  if (length > tdmsMostCards) cursor.refuse("a DAQmx channel has " + std::to_string(length) + " scalers or cards");
  return length;
}

TdmsIndex tdmsCardIndex(TdmsCursor& cursor, bool digital) {
  TdmsIndex index;
  cursor.word();  // data type: raw, or that of the scaler
  if (cursor.word() != 1) cursor.refuse("the file has arrays of more than one dimension, which are not read");
  index.count = cursor.doubleWord();
  for (std::uint32_t left = tdmsCardLength(cursor); left > 0; --left) {
    TdmsScaler scaler;
    const std::uint32_t code = cursor.word();
    scaler.type = digital ? nullptr : tdmsCardType(code);
    scaler.buffer = cursor.word();
    scaler.offset = cursor.word();
    digital ? static_cast<void>(cursor.byte()) : static_cast<void>(cursor.word());  // format of the sample
    scaler.id = cursor.word();
    index.scalers.push_back(scaler);
  }
  for (std::uint32_t left = tdmsCardLength(cursor); left > 0; --left) index.widths.push_back(cursor.word());
  return index;
}

bool tdmsIsOfUse(std::string_view property) {
  return property.substr(0, 3) == "wf_" || property.substr(0, 3) == "NI_" || property == "unit_string";
}

// The name in quotation marks that `path` begins with behind a slash, which is taken off. A mark within is doubled.
std::optional<std::string> tdmsTakeName(std::string_view& path) {
  if (path.substr(0, 2) != "/'") return {};
  std::string name;
  for (std::size_t i = 2; i < path.size(); ++i) {
    const bool mark = path[i] == '\'', doubled = mark && i + 1 < path.size() && path[i + 1] == '\'';
    if (mark && !doubled) {
      path.remove_prefix(i + 1);
      return name;
    }
    if (doubled) ++i;
    name += path[i];
  }
  return {};
}

}  // namespace

std::optional<double> tdmsNumber(const TdmsProperties& properties, std::string_view name) {
  const auto found = properties.find(name);
  return found == properties.end() ? std::nullopt : found->second.number;
}

std::string_view tdmsText(const TdmsProperties& properties, std::string_view name) {
  const auto found = properties.find(name);
  return found == properties.end() ? std::string_view{} : found->second.text;
}

std::optional<TdmsObject> tdmsObjectOf(std::string_view path) {
  TdmsObject object;
  if (path == "/") return object;
  const auto group = tdmsTakeName(path);
  if (!group) return {};
  object.level = TdmsObject::Level::group;
  object.group = *group;
  if (path.empty()) return object;
  const auto channel = tdmsTakeName(path);
  if (!channel || !path.empty()) return {};
  object.level = TdmsObject::Level::channel;
  object.channel = *channel;
  return object;
}

TdmsIndex readTdmsIndex(TdmsCursor& cursor, std::uint32_t firstWord) {
  if (firstWord == tdmsFormatChanging || firstWord == tdmsDigitalLine)
    return tdmsCardIndex(cursor, firstWord == tdmsDigitalLine);
  TdmsIndex index;
  const std::uint32_t code = cursor.word();
  index.type = findTdmsType(code);
  if (!index.type) cursor.refuse("a channel has values of the type " + std::to_string(code) + ", which is not read");
  if (cursor.word() != 1) cursor.refuse("the file has arrays of more than one dimension, which are not read");
  index.count = cursor.doubleWord();
  if (index.type->kind == TdmsKind::text) {
    index.bytes = cursor.doubleWord();
  } else {
    const auto bytes = checkedProduct(index.count, std::uint64_t{index.type->size});
    if (!bytes) cursor.fail("the file is damaged here: a channel of " + std::to_string(index.count) + " values");
    index.bytes = *bytes;
  }
  return index;
}

void readTdmsProperties(TdmsCursor& cursor, TdmsProperties& properties) {
  for (std::uint32_t left = cursor.word(); left > 0; --left) {
    const std::string_view name = cursor.text();
    const std::uint32_t code = cursor.word();
    const auto* type = findTdmsType(code);
    if (!type) cursor.refuse("a property has the type " + std::to_string(code) + ", which is not read");
    TdmsProperty property;
    if (type->kind == TdmsKind::text) {
      property.text = cursor.text();
    } else {
      const char* bytes = cursor.take(type->size);
      if (type->kind == TdmsKind::number) property.number = tdmsNumberAt(bytes, *type, cursor.bigEndian());
      if (type->kind == TdmsKind::moment) property.moment = tdmsMomentAt(bytes, cursor.bigEndian());
    }
    if (tdmsIsOfUse(name)) properties[name] = property;
  }
}

}  // namespace squat::loggers
