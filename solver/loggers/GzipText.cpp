#include "loggers/GzipText.h"

#include <zlib.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <new>
#include <vector>

#include "core/Errors.h"

namespace squat::loggers {
namespace {

constexpr std::size_t gzipBlock = std::size_t{1} << 18;  // [bytes] unpacked at a time

// One stream for all members.
class GzipMembers {
 public:
  GzipMembers(std::string_view bytes, const std::string& path, std::size_t maximum)
      : rest_(bytes), size_(bytes.size()), path_(path), maximum_(maximum), block_(gzipBlock) {
    if (inflateInit2(&stream_, 16 + MAX_WBITS) != Z_OK) throw std::bad_alloc();
  }
  ~GzipMembers() { inflateEnd(&stream_); }
  GzipMembers(const GzipMembers&) = delete;
  GzipMembers& operator=(const GzipMembers&) = delete;

  std::string unpack() {
    std::string text;
    do {
      member(text);
    } while (isGzip(rest_));
    if (rest_.find_first_not_of('\0') != std::string_view::npos) fail("the packed file is followed by something else");
    return text;
  }

 private:
  void member(std::string& text) {
    if (inflateReset(&stream_) != Z_OK) throw std::bad_alloc();
    for (int state = Z_OK; state != Z_STREAM_END;) {
      // zlib counts in 32 bits and takes its input for its own.
      const auto given = static_cast<uInt>(std::min<std::size_t>(rest_.size(), std::numeric_limits<uInt>::max()));
      stream_.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(rest_.data()));
      stream_.avail_in = given;
      stream_.next_out = block_.data();
      stream_.avail_out = static_cast<uInt>(block_.size());
      state = inflate(&stream_, Z_NO_FLUSH);
      const std::size_t taken = given - stream_.avail_in, made = block_.size() - stream_.avail_out;
      rest_.remove_prefix(taken);
      if (state == Z_MEM_ERROR) throw std::bad_alloc();
      if (state != Z_OK && state != Z_STREAM_END && state != Z_BUF_ERROR)
        fail(std::string("the packed file is damaged") + (stream_.msg ? std::string(": ") + stream_.msg : ""));
      if (made > maximum_ - text.size())
        throw FileError(path_, "", "unpacks to more than the " + std::to_string(maximum_) + " bytes that are read",
                        "Unpack it and cut it down");
      text.append(reinterpret_cast<const char*>(block_.data()), made);
      if (state != Z_STREAM_END && taken == 0 && made == 0) fail("the packed file is cut off here");
    }
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileError(path_, "byte " + std::to_string(size_ - rest_.size()), what,
                    "Copy the file again from where it was recorded");
  }

  std::string_view rest_;
  std::size_t size_;
  const std::string& path_;
  std::size_t maximum_;
  std::vector<Bytef> block_;
  z_stream stream_{};
};

}  // namespace

bool isGzip(std::string_view head) { return head.substr(0, 2) == "\x1F\x8B"; }

std::string unpacked(std::string_view bytes, const std::string& path, std::size_t maximum) {
  if (!isGzip(bytes)) throw FileError(path, "", "is not packed with gzip", "Name a file that is");
  return GzipMembers(bytes, path, maximum).unpack();
}

}  // namespace squat::loggers
