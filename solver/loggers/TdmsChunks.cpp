#include "loggers/TdmsChunks.h"

#include <algorithm>
#include <optional>

#include "core/CheckedCounts.h"
#include "core/Errors.h"

namespace squat::loggers {
namespace {

// The work on one stretch; a chunk is what the indices of its objects describe, and follows itself until the end.
class TdmsChunks {
 public:
  TdmsChunks(const TdmsStretch& stretch, std::string_view bytes, const std::string& path,
             const std::vector<std::size_t>& layout, std::vector<TdmsObject>& objects,
             const std::function<void(std::size_t, const TdmsRun&)>& sink)
      : stretch_(stretch), bytes_(bytes), path_(path), layout_(layout), objects_(objects), sink_(sink) {}

  std::uint64_t handOut() {
    const std::uint64_t size = stretch_.end - stretch_.begin;
    if (size == 0) return 0;
    const auto cards = std::count_if(layout_.begin(), layout_.end(), [&](std::size_t i) { return !indexOf(i).type; });
    if (cards > 0 && cards < static_cast<std::ptrdiff_t>(layout_.size()))
      refuse("a segment has DAQmx channels beside others, which is not read");
    if (cards > 0) return handOutCards(size);
    return stretch_.interleaved ? handOutRows(size) : handOutChunks(size);
  }

 private:
  const TdmsIndex& indexOf(std::size_t object) const { return *objects_[object].index; }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(path_, "byte " + std::to_string(stretch_.begin), what, tdmsDamagedAdvice);
  }
  [[noreturn]] void refuse(const std::string& what) const {
    throw FileError(path_, "byte " + std::to_string(stretch_.begin), what, tdmsRefusedAdvice);
  }

  void add(std::uint64_t& sum, std::uint64_t factor, std::uint64_t other = 1) const {
    const auto product = checkedProduct(factor, other);
    const auto total = product ? checkedSum(sum, *product) : std::nullopt;
    if (!total) fail("the file is damaged: its channels have more values than a file can hold");
    sum = *total;
  }

  void run(std::size_t object, std::uint64_t offset, std::uint64_t count, std::size_t stride) const {
    const auto* type = indexOf(object).type;
    const char* first = type->kind == TdmsKind::text ? nullptr : bytes_.data() + stretch_.begin + offset;
    if (count > 0) sink_(object, {first, count, stride, type, stretch_.bigEndian});
  }

  // All values of a channel, then all of the next.
  std::uint64_t handOutChunks(std::uint64_t size) {
    std::uint64_t chunk = 0;
    std::vector<std::size_t> filled;
    for (const std::size_t i : layout_) {
      add(chunk, indexOf(i).bytes);
      if (indexOf(i).bytes > 0) filled.push_back(i);
    }
    if (chunk == 0) fail("the file is damaged: values that belong to no channel");
    std::uint64_t offset = 0;
    for (; size - offset >= chunk;)
      for (const std::size_t i : filled) {
        run(i, offset, indexOf(i).count, indexOf(i).type->size);
        offset += indexOf(i).bytes;
      }
    return size - offset - handOutPart(filled, offset, size - offset, chunk);
  }

  // What is whole of a last chunk of `rest` bytes; returns its bytes. One channel is cut anywhere. Of several, a closed
  // segment has the same share of each; in one that was not closed they are of different lengths.
  std::uint64_t handOutPart(const std::vector<std::size_t>& filled, std::uint64_t offset, std::uint64_t rest,
                            std::uint64_t chunk) {
    const auto share = [&](std::size_t i) { return shareOf(indexOf(i).count, rest, chunk); };
    const auto isText = [&](std::size_t i) { return indexOf(i).type->kind == TdmsKind::text; };
    if (rest == 0 || std::any_of(filled.begin(), filled.end(), isText)) return 0;
    if (filled.size() > 1 && (!stretch_.closed || std::any_of(filled.begin(), filled.end(),
                                                              [&](std::size_t i) { return share(i).left != 0; })))
      return 0;
    std::uint64_t used = 0;
    for (const std::size_t i : filled) {
      const std::uint64_t count = share(i).whole;
      run(i, offset + used, count, indexOf(i).type->size);
      used += count * indexOf(i).type->size;
    }
    return used;
  }

  // One value of each channel, then the next of each.
  std::uint64_t handOutRows(std::uint64_t size) {
    std::uint64_t width = 0;
    for (const std::size_t i : layout_) {
      const auto& index = indexOf(i);
      if (index.type->kind == TdmsKind::text) refuse("a segment has text among interleaved values, which is not read");
      if (index.count != indexOf(layout_.front()).count)
        refuse("a segment has interleaved channels of different lengths");
      width += index.type->size;
    }
    if (width == 0) fail("the file is damaged: values that belong to no channel");
    std::uint64_t offset = 0;
    for (const std::size_t i : layout_) {
      run(i, offset, size / width, width);
      offset += indexOf(i).type->size;
    }
    return size % width;
  }

  // Data acquisition cards: the rows of the first, then those of the next. A channel stands somewhere in the rows.
  std::uint64_t handOutCards(std::uint64_t size) {
    const auto& widths = indexOf(layout_.front()).widths;
    std::vector<std::uint64_t> rows(widths.size(), 0);
    for (const std::size_t i : layout_) {
      const auto& index = indexOf(i);
      if (index.widths != widths) refuse("a segment has DAQmx channels that do not agree on their rows");
      for (const auto& scaler : index.scalers) {
        const bool lies = scaler.buffer < widths.size() && scaler.offset <= widths[scaler.buffer] &&
                          (!scaler.type || scaler.type->size <= widths[scaler.buffer] - scaler.offset);
        // The bits of a digital line are counted in another way, and nothing of it is read.
        if (scaler.type && !lies) fail("the file is damaged: a DAQmx channel lies outside its rows");
        if (scaler.buffer < rows.size()) {
          auto& known = rows[scaler.buffer];
          if (known != 0 && known != index.count)
            refuse("a segment has DAQmx channels of different lengths on one card");
          known = index.count;
        }
      }
      if (index.scalers.size() == 1 && index.scalers[0].type)
        cards_.push_back(i);
      else
        objects_[i].refusal = index.scalers.size() == 1
                                  ? "it is a DAQmx digital line or of a DAQmx type that is not read"
                                  : "it has several DAQmx scalers";
    }
    std::uint64_t chunk = 0;
    for (std::size_t b = 0; b < widths.size(); ++b) add(chunk, rows[b], widths[b]);
    if (chunk == 0) fail("the file is damaged: values that belong to no channel");
    for (std::uint64_t offset = 0;; offset += chunk) {
      const bool whole = size - offset >= chunk;
      if (!whole && widths.size() > 1) return size - offset;
      const std::uint64_t last = whole ? 0 : (size - offset) / widths[0];
      cardsOfChunk(offset, widths, whole ? rows : std::vector<std::uint64_t>{last});
      if (!whole) return size - offset - last * widths[0];
    }
  }

  void cardsOfChunk(std::uint64_t offset, const std::vector<std::uint32_t>& widths,
                    const std::vector<std::uint64_t>& rows) const {
    std::vector<std::uint64_t> begins(1, offset);
    for (std::size_t b = 0; b + 1 < rows.size(); ++b) begins.push_back(begins[b] + rows[b] * widths[b]);
    for (const std::size_t i : cards_) {
      const auto& scaler = indexOf(i).scalers[0];
      const char* first = bytes_.data() + stretch_.begin + begins[scaler.buffer] + scaler.offset;
      if (rows[scaler.buffer] > 0)
        sink_(i, {first, rows[scaler.buffer], widths[scaler.buffer], scaler.type, stretch_.bigEndian});
    }
  }

  const TdmsStretch& stretch_;
  std::string_view bytes_;
  const std::string& path_;
  const std::vector<std::size_t>& layout_;
  std::vector<TdmsObject>& objects_;
  const std::function<void(std::size_t, const TdmsRun&)>& sink_;
  std::vector<std::size_t> cards_;  // DAQmx channels that are read
};

}  // namespace

std::uint64_t tdmsValuesIn(const TdmsStretch& stretch, std::string_view bytes, const std::string& path,
                           const std::vector<std::size_t>& layout, std::vector<TdmsObject>& objects,
                           const std::function<void(std::size_t, const TdmsRun&)>& sink) {
  return TdmsChunks(stretch, bytes, path, layout, objects, sink).handOut();
}

}  // namespace squat::loggers
