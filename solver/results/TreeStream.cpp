#include "results/TreeStream.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <memory>
#include <set>
#include <type_traits>

#include "core/Errors.h"

namespace squat::results {

static_assert(std::endian::native == std::endian::little, "the stream is little-endian");

namespace {

constexpr std::string_view kMagic = "SQTREE01";
constexpr std::size_t kMaximumSections = 100000;
constexpr std::size_t kMaximumAttributes = 1000;  // of one owner
constexpr std::size_t kMaximumRank = 8;
constexpr std::size_t kStep = std::size_t{1} << 20;  // memory grows by this much while bytes come
enum Kind : std::uint8_t { kEnd = 0, kRoot = 1, kGroup = 2, kArray = 3 };

class Writer {
 public:
  template <typename T>
  void number(T value) {
    static_assert(std::is_arithmetic_v<T>);
    append(&value, sizeof value);
  }
  void text(const std::string& value) {
    number<std::uint64_t>(value.size());
    append(value.data(), value.size());
  }
  void attributes(const std::vector<Attribute>& list) {
    number<std::uint32_t>(static_cast<std::uint32_t>(list.size()));
    for (const auto& attribute : list) {
      text(attribute.name);
      number<std::uint8_t>(static_cast<std::uint8_t>(attribute.value.index()));
      std::visit(
          [&](const auto& value) {
            if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::string>)
              text(value);
            else
              number(value);
          },
          attribute.value);
    }
  }
  void values(const Values& list) {
    number<std::uint8_t>(static_cast<std::uint8_t>(list.index()));
    number<std::uint64_t>(valueCount(list));
    std::visit(
        [&](const auto& items) {
          using T = typename std::decay_t<decltype(items)>::value_type;
          if constexpr (std::is_same_v<T, std::string>)
            for (const auto& item : items) text(item);
          else
            append(items.data(), items.size() * sizeof(T));
        },
        list);
  }
  std::vector<std::byte>& bytes() { return bytes_; }

 private:
  void append(const void* data, std::size_t size) {
    const auto* first = static_cast<const std::byte*>(data);
    if (size > 0) bytes_.insert(bytes_.end(), first, first + size);
  }
  std::vector<std::byte> bytes_;
};

class Reader {
 public:
  Reader(std::span<const std::byte> bytes, std::function<void(const char*)> refuse)
      : bytes_(bytes), refuse_(std::move(refuse)) {}

  template <typename T>
  T number() {
    T value{};
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }
  std::string text() {
    const auto size = number<std::uint64_t>();
    const auto* data = take(size);
    return {reinterpret_cast<const char*>(data), static_cast<std::size_t>(size)};
  }
  std::vector<Attribute> attributes() {
    const auto count = number<std::uint32_t>();
    if (count > kMaximumAttributes) refuse_("too many attributes");
    std::vector<Attribute> list;
    for (std::uint32_t i = 0; i < count; ++i) {
      Attribute attribute;
      attribute.name = text();
      for (const auto& earlier : list)
        if (earlier.name == attribute.name) refuse_("an attribute comes twice");
      switch (number<std::uint8_t>()) {
        case 0:
          attribute.value = text();
          break;
        case 1:
          attribute.value = number<double>();
          break;
        case 2:
          attribute.value = number<std::int64_t>();
          break;
        case 3:
          attribute.value = number<std::uint8_t>();
          break;
        default:
          refuse_("unknown kind of attribute");
      }
      list.push_back(std::move(attribute));
    }
    return list;
  }
  Values values() {
    const auto kind = number<std::uint8_t>();
    const auto count = number<std::uint64_t>();
    switch (kind) {
      case 0:
        return numbers<double>(count);
      case 1:
        return numbers<float>(count);
      case 2:
        return numbers<std::int64_t>(count);
      case 3:
        return numbers<std::int32_t>(count);
      case 4:
        return numbers<std::uint8_t>(count);
      case 5:
        break;
      default:
        refuse_("unknown kind of values");
    }
    std::vector<std::string> texts;
    for (std::uint64_t i = 0; i < count; ++i) texts.push_back(text());  // each takes bytes, so the count is bounded
    return texts;
  }
  void mustBeAtEnd() {
    if (!bytes_.empty()) refuse_("bytes left over");
  }

 private:
  const std::byte* take(std::uint64_t size) {
    if (size > bytes_.size()) refuse_("ends too early");
    const auto* data = bytes_.data();
    bytes_ = bytes_.subspan(static_cast<std::size_t>(size));
    return data;
  }
  template <typename T>
  std::vector<T> numbers(std::uint64_t count) {
    if (count > bytes_.size() / sizeof(T)) refuse_("ends too early");
    std::vector<T> list(static_cast<std::size_t>(count));
    const auto* data = take(count * sizeof(T));
    if (count > 0) std::memcpy(list.data(), data, list.size() * sizeof(T));
    return list;
  }
  std::span<const std::byte> bytes_;
  std::function<void(const char*)> refuse_;  // throws
};

void emit(const ByteSink& sink, Kind kind, std::span<const std::byte> payload) {
  std::array<std::byte, 9> head{};
  const std::uint64_t length = payload.size();
  head[0] = static_cast<std::byte>(kind);
  std::memcpy(head.data() + 1, &length, sizeof length);
  sink(head);
  sink(payload);
  const std::uint32_t sum = crc32(payload);
  std::array<std::byte, 4> tail{};
  std::memcpy(tail.data(), &sum, sizeof sum);
  sink(tail);
}

bool shapeFits(const std::vector<std::size_t>& shape, std::size_t count) {
  std::size_t product = 1;
  for (const auto extent : shape)
    if (extent != 0 && product > std::size_t(-1) / extent)
      return false;
    else
      product *= extent;
  return product == count;
}

Array readArray(Reader& reader, const std::function<void(const char*)>& refuse, bool listed) {
  Array array;
  array.path = reader.text();
  const auto rank = reader.number<std::uint8_t>();
  if (rank > kMaximumRank) refuse("too many dimensions");
  for (int i = 0; i < rank; ++i) array.shape.push_back(reader.number<std::uint64_t>());
  array.attributes = reader.attributes();
  array.values = reader.values();
  const bool withoutValues = listed && valueCount(array.values) == 0;
  if (!withoutValues && !shapeFits(array.shape, valueCount(array.values)))
    refuse("its shape and its values do not fit");
  return array;
}

}  // namespace

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t previous) {
  return static_cast<std::uint32_t>(::crc32_z(previous, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

void encodeTree(const ArrayTree& tree, const ByteSink& sink) {
  sink(std::as_bytes(std::span(kMagic)));
  Writer root;
  root.attributes(tree.attributes);
  emit(sink, kRoot, root.bytes());
  for (const auto& group : tree.groups) {
    Writer writer;
    writer.text(group.path);
    writer.attributes(group.attributes);
    emit(sink, kGroup, writer.bytes());
  }
  for (const auto& array : tree.arrays) {
    Writer writer;
    writer.text(array.path);
    writer.number<std::uint8_t>(static_cast<std::uint8_t>(array.shape.size()));
    for (const auto extent : array.shape) writer.number<std::uint64_t>(extent);
    writer.attributes(array.attributes);
    writer.values(array.values);
    emit(sink, kArray, writer.bytes());
  }
  Writer end;
  end.number<std::uint64_t>(1 + tree.groups.size() + tree.arrays.size());
  emit(sink, kEnd, end.bytes());
}

std::vector<std::byte> encodeTree(const ArrayTree& tree) {
  std::vector<std::byte> bytes;
  encodeTree(tree, [&](std::span<const std::byte> part) { bytes.insert(bytes.end(), part.begin(), part.end()); });
  return bytes;
}

ByteSource sourceOf(std::span<const std::byte> bytes) {
  auto rest = std::make_shared<std::span<const std::byte>>(bytes);
  return [rest](std::span<std::byte> wanted) {
    const auto count = std::min(wanted.size(), rest->size());
    if (count > 0) std::memcpy(wanted.data(), rest->data(), count);
    *rest = rest->subspan(count);
    return count;
  };
}

ArrayTree decodeTree(const ByteSource& source, const std::string& path, std::size_t largestBytes, bool listed) {
  std::string section = "beginning";
  const std::function<void(const char*)> refuse = [&](const char* what) {
    throw FileError(path, section, std::string("damaged: ") + what, "Use an earlier file or run the case again");
  };
  const auto fill = [&](std::span<std::byte> wanted) {
    if (source(wanted) != wanted.size()) refuse("ends too early");
  };
  std::array<std::byte, kMagic.size()> magic{};
  fill(magic);
  if (std::memcmp(magic.data(), kMagic.data(), kMagic.size()) != 0) refuse("not a file of this program");

  ArrayTree tree;
  std::set<std::string> paths;
  std::size_t used = 0;
  for (std::uint64_t index = 0;; ++index) {
    section = "section " + std::to_string(index);
    if (index > kMaximumSections) refuse("too many sections");
    std::array<std::byte, 9> head{};
    fill(head);
    std::uint64_t length = 0;
    std::memcpy(&length, head.data() + 1, sizeof length);
    if (length > largestBytes - used) refuse("larger than allowed");
    used += static_cast<std::size_t>(length);
    std::vector<std::byte> payload;
    while (payload.size() < length) {
      const auto have = payload.size();
      payload.resize(std::min<std::size_t>(static_cast<std::size_t>(length), have + std::max(kStep, have)));
      fill(std::span(payload).subspan(have));
    }
    std::array<std::byte, 4> tail{};
    fill(tail);
    std::uint32_t sum = 0;
    std::memcpy(&sum, tail.data(), sizeof sum);
    if (sum != crc32(payload)) refuse("checksum is wrong");
    Reader reader(payload, refuse);
    switch (static_cast<std::uint8_t>(head[0])) {
      case kEnd: {
        if (reader.number<std::uint64_t>() != index) refuse("sections are missing");
        std::byte extra{};
        if (source(std::span(&extra, 1)) != 0) refuse("bytes left over");
        return tree;
      }
      case kRoot:
        tree.attributes = reader.attributes();
        break;
      case kGroup: {
        Group group;
        group.path = reader.text();
        group.attributes = reader.attributes();
        if (!paths.insert(group.path + "/").second) refuse("a group comes twice");
        tree.groups.push_back(std::move(group));
        break;
      }
      case kArray:
        tree.arrays.push_back(readArray(reader, refuse, listed));
        if (!paths.insert(tree.arrays.back().path).second) refuse("an array comes twice");
        break;
      default:
        refuse("unknown kind of section");
    }
    reader.mustBeAtEnd();
  }
}

}  // namespace squat::results
