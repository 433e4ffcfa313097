#include "loggers/TdmsSegments.h"

#include <algorithm>
#include <unordered_map>

#include "core/Errors.h"
#include "loggers/TdmsChunks.h"
#include "text/Text.h"

namespace squat::loggers {
namespace {

constexpr std::uint32_t tdmsMetaData = 1U << 1, tdmsNewList = 1U << 2, tdmsRawData = 1U << 3, tdmsInterleaved = 1U << 5,
                        tdmsBigEndian = 1U << 6;
constexpr std::size_t tdmsLeadIn = 28;                      // [bytes]
constexpr std::uint64_t tdmsNotClosed = ~std::uint64_t{0};  // length of a segment that was never finished
constexpr std::uint32_t tdmsNoData = 0xFFFFFFFF, tdmsAsBefore = 0;
constexpr std::size_t tdmsMostObjects = 20000;
// Bounds the time that a damaged file can take. A sound one visits an object once or twice for each byte at most.
constexpr std::uint64_t tdmsVisitsPerByte = 4, tdmsFreeVisits = 100000000;

class TdmsWalker {
 public:
  TdmsWalker(std::string_view bytes, const std::string& path, const TdmsSink& sink)
      : bytes_(bytes), path_(path), sink_(sink) {}

  TdmsContents walk() {
    for (std::size_t at = 0; at < bytes_.size();) at = segment(at);
    if (leftOver_ > 0)
      contents_.notes.push_back(std::to_string(leftOver_) + " bytes that do not fill a whole block are left out");
    return std::move(contents_);
  }

 private:
  struct Listed {
    std::size_t place = 0;  // in list_
    bool inList = false, hasData = false;
  };

  // Returns where the next one begins.
  std::size_t segment(std::size_t start) {
    TdmsCursor cursor(bytes_, path_, start, bytes_.size());
    const std::string_view rest = bytes_.substr(start);
    if (rest.substr(0, 4) != "TDSm")
      cursor.fail(start == 0 ? "is not a TDMS file" : "the file is damaged here: no segment begins where one should");
    if (rest.size() < tdmsLeadIn) cursor.fail("the file is cut off here");
    cursor.take(4);
    const std::uint32_t contents = cursor.word();  // little-endian, whatever the rest is
    cursor.setBigEndian((contents & tdmsBigEndian) != 0);
    if (const std::uint32_t version = cursor.word(); version != 4712 && version != 4713)
      cursor.refuse("a segment has the version " + std::to_string(version) + "; 4712 and 4713 are read");
    const std::uint64_t length = cursor.doubleWord(), rawOffset = cursor.doubleWord();
    const std::size_t behind = bytes_.size() - cursor.at();
    const bool closed = length != tdmsNotClosed;
    if (closed && length > behind)
      cursor.fail("the file is cut off: " + std::to_string(length - behind) + " bytes of this segment are missing");
    const std::size_t size = closed ? static_cast<std::size_t>(length) : behind;
    if (!closed) contents_.notes.push_back("the recording was not closed; it is read as far as it is whole");
    if (rawOffset > size) {
      if (!closed) return bytes_.size();  // not even its meta data were written
      cursor.fail("the file is damaged here: the values of a segment lie beyond it");
    }
    const std::size_t values = cursor.at() + static_cast<std::size_t>(rawOffset), end = cursor.at() + size;
    if (contents & tdmsMetaData) {
      TdmsCursor meta(bytes_, path_, cursor.at(), end);
      meta.setBigEndian(cursor.bigEndian());
      readMetaData(meta, (contents & tdmsNewList) != 0);
    }
    if (contents & tdmsRawData) {
      spend(layout_.size());
      const TdmsStretch stretch{values, end, cursor.bigEndian(), (contents & tdmsInterleaved) != 0, closed};
      leftOver_ +=
          tdmsValuesIn(stretch, bytes_, path_, layout_, contents_.objects, [&](std::size_t i, const TdmsRun& run) {
            spend(1);
            sink_(i, run);
          });
    }
    return end;
  }

  void readMetaData(TdmsCursor& cursor, bool newList) {
    if (newList) {
      for (const std::size_t i : list_) listed_[i] = {};
      list_.clear();
    }
    for (std::uint32_t left = cursor.word(); left > 0; --left) readObject(cursor);
    spend(list_.size());
    layout_.clear();
    for (const std::size_t i : list_)
      if (listed_[i].hasData) layout_.push_back(i);
  }

  void readObject(TdmsCursor& cursor) {
    const std::size_t i = objectAt(cursor, cursor.text());
    auto& object = contents_.objects[i];
    auto& listed = listed_[i];
    if (!listed.inList) {
      listed = {list_.size(), true, false};
      list_.push_back(i);
    }
    const std::uint32_t firstWord = cursor.word();
    listed.hasData = firstWord != tdmsNoData;
    if (firstWord == tdmsAsBefore && !object.index)
      cursor.fail("the file is damaged here: " + text::shown(object.channel) +
                  " is to be read as before, but never was");
    if (firstWord != tdmsNoData && firstWord != tdmsAsBefore) object.index = readTdmsIndex(cursor, firstWord);
    readTdmsProperties(cursor, object.properties);
  }

  std::size_t objectAt(const TdmsCursor& cursor, std::string_view objectPath) {
    const auto [found, isNew] = numbers_.try_emplace(objectPath, contents_.objects.size());
    if (!isNew) return found->second;
    auto object = tdmsObjectOf(objectPath);
    if (!object) cursor.fail("the file is damaged here: " + text::shown(objectPath) + " is not the path of an object");
    if (contents_.objects.size() >= tdmsMostObjects)
      cursor.refuse("the file has more than " + std::to_string(tdmsMostObjects) + " groups and channels");
    contents_.objects.push_back(std::move(*object));
    listed_.emplace_back();
    return found->second;
  }

  void spend(std::size_t visits) {
    visits_ += visits;
    if (visits_ > tdmsFreeVisits + tdmsVisitsPerByte * bytes_.size())
      throw FileError(path_, "", "is cut into too many small blocks to be read", "Defragment it with TDMS Defragment");
  }

  std::string_view bytes_;
  const std::string& path_;
  const TdmsSink& sink_;
  TdmsContents contents_;
  std::unordered_map<std::string_view, std::size_t> numbers_;  // of objects, by their path
  std::vector<Listed> listed_;                                 // of each object
  std::vector<std::size_t> list_;                              // objects of the segment, as their values follow
  std::vector<std::size_t> layout_;                            // those of them that have values in it
  std::uint64_t visits_ = 0, leftOver_ = 0;
};

}  // namespace

TdmsContents walkTdms(std::string_view bytes, const std::string& path, const TdmsSink& sink) {
  return TdmsWalker(bytes, path, sink).walk();
}

}  // namespace squat::loggers
