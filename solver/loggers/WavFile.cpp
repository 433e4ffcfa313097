#include "loggers/WavFile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <numeric>
#include <optional>

#include "core/DurableFile.h"
#include "core/Errors.h"
#include "loggers/WavCalibration.h"
#include "text/Numbers.h"
#include "text/Text.h"

namespace squat::loggers {
namespace {

std::uint64_t wavNumber(std::string_view bytes, std::size_t at, std::size_t size) {
  std::uint64_t value = 0;
  for (std::size_t i = 0; i < size; ++i)
    value |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes[at + i])) << (8 * i);
  return value;
}

struct WavChunks {
  std::string_view format, samples, info, description;
  bool hasSamples = false;
  std::vector<std::string> notes;
};

// What the comment of a LIST chunk of the form INFO says.
std::string_view wavComment(std::string_view list) {
  if (!list.starts_with("INFO")) return {};
  for (std::size_t at = 4; at + 8 <= list.size();) {
    const std::uint64_t size = wavNumber(list, at + 4, 4);
    const std::string_view body = list.substr(at + 8, size);
    if (list.substr(at, 4) == "ICMT") return body.substr(0, body.find('\0'));
    at += 8 + body.size() + body.size() % 2;
  }
  return {};
}

WavChunks wavChunks(std::string_view bytes) {
  constexpr std::uint64_t open = 0xFFFFFFFF;  // RF64: the size stands in ds64; RIFF: not known when it was written
  WavChunks chunks;
  std::optional<std::uint64_t> longSize;
  for (std::size_t at = 12; at + 8 <= bytes.size();) {
    const std::string_view name = bytes.substr(at, 4), rest = bytes.substr(at + 8);
    std::uint64_t size = wavNumber(bytes, at + 4, 4);
    if (name == "data" && !chunks.hasSamples) {
      // A recorder that lost its power has left the sizes at nothing: then all that follows is samples.
      const bool unwritten = size == 0 && wavNumber(bytes, 4, 4) <= at;
      if (size == open && longSize) size = *longSize;
      if (size > rest.size() || unwritten) {
        if (!rest.empty())
          chunks.notes.emplace_back(size == open || unwritten
                                        ? "the length of the samples was not written: read to the end of the file"
                                        : "the file ends before its samples do: read to its end");
        size = rest.size();
      }
      chunks.samples = rest.substr(0, size);
      chunks.hasSamples = true;
    }
    const std::string_view body = rest.substr(0, size);
    if (name == "fmt " && chunks.format.empty()) chunks.format = body;
    if (name == "ds64" && body.size() >= 16) longSize = wavNumber(body, 8, 8);
    if (name == "LIST" && chunks.info.empty()) chunks.info = wavComment(body);
    if (name == "bext" && chunks.description.empty()) {
      chunks.description = body.substr(0, 256);
      chunks.description = chunks.description.substr(0, chunks.description.find('\0'));
    }
    at += 8 + body.size() + body.size() % 2;
  }
  return chunks;
}

struct WavFormat {
  bool isFloat = false;
  std::size_t channels = 0, bytes = 0;  // of one sample
  double rate = 0;                      // [Hz]
};

std::string wavCodeName(std::uint64_t code) {
  struct Code {
    std::uint64_t code;
    const char* name;
  };
  static constexpr Code known[] = {{2, "ADPCM"},  {6, "A-law"},  {7, "mu-law"}, {0x11, "IMA ADPCM"}, {0x50, "MPEG"},
                                   {0x55, "MP3"}, {0x31, "GSM"}, {0xFF, "AAC"}, {0x161, "WMA"},      {0xF1AC, "FLAC"}};
  for (const auto& one : known)
    if (one.code == code) return one.name;
  return "format " + std::to_string(code);
}

WavFormat wavFormat(std::string_view chunk, const std::string& path) {
  const auto wrong = [&](const std::string& what) {
    return FileError(path, "chunk fmt", what, "Write the file again, as PCM or floating point");
  };
  if (chunk.size() < 16) throw wrong(chunk.empty() ? "is missing" : "is shorter than 16 bytes");
  std::uint64_t code = wavNumber(chunk, 0, 2);
  // Extensible: the true code begins the sub-format, and the bits are those of the container.
  if (code == 0xFFFE) {
    if (chunk.size() < 40) throw wrong("is shorter than the 40 bytes of an extensible format");
    code = wavNumber(chunk, 24, 2);
  }
  if (code != 1 && code != 3) throw wrong("names " + wavCodeName(code) + ", which is not read");
  WavFormat format;
  format.isFloat = code == 3;
  format.channels = wavNumber(chunk, 2, 2);
  format.rate = static_cast<double>(wavNumber(chunk, 4, 4));
  const std::size_t block = wavNumber(chunk, 12, 2), bits = wavNumber(chunk, 14, 2);
  format.bytes = (bits + 7) / 8;  // 12 bits stand in the upper part of 16
  if (format.channels == 0) throw wrong("states no channels");
  if (format.rate == 0) throw wrong("states a sampling rate of 0 Hz");
  if (format.isFloat ? format.bytes != 4 && format.bytes != 8 : format.bytes < 1 || format.bytes > 4)
    throw wrong("states " + std::to_string(bits) + " bits a sample, must be " +
                (format.isFloat ? "32 or 64" : "8, 16, 24 or 32"));
  // Some writers put samples of 24 bits into 32: the size of a frame then says so.
  if (block != format.channels * format.bytes) {
    const bool fits = !format.isFloat && block % format.channels == 0 && block / format.channels > format.bytes &&
                      block / format.channels <= 4;
    if (!fits)
      throw wrong("states frames of " + std::to_string(block) + " bytes, must be " +
                  std::to_string(format.channels * format.bytes));
    format.bytes = block / format.channels;
  }
  return format;
}

double wavSample(std::string_view samples, std::size_t at, const WavFormat& format) {
  const std::uint64_t raw = wavNumber(samples, at, format.bytes);
  if (format.isFloat && format.bytes == 8) return std::bit_cast<double>(raw);
  if (format.isFloat) return static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(raw)));
  if (format.bytes == 1) return (static_cast<double>(raw) - 128) / 128;  // the only size without a sign
  const std::uint64_t half = std::uint64_t{1} << (8 * format.bytes - 1);
  const double value = static_cast<double>(raw) - (raw >= half ? 2 * static_cast<double>(half) : 0.0);
  return value / static_cast<double>(half);
}

// The calibration that the file names, once or several times alike.
WavCalibration wavCalibration(const WavChunks& chunks, std::vector<std::string>& notes) {
  auto found = wavCalibrations(chunks.info);
  if (found.empty()) found = wavCalibrations(chunks.description);
  const bool one =
      !found.empty() && std::all_of(found.begin(), found.end(), [&](const auto& each) { return each == found[0]; });
  if (one) {
    notes.push_back("full scale is " + text::roundedText(found[0].fullScale) + " " + found[0].unit +
                    ", as the comment says");
    return found[0];
  }
  notes.push_back(std::string("full scale is 1: give the calibration, ") +
                  (found.empty() ? "which the file does not name" : "of which the comment names several"));
  return {};
}

}  // namespace

bool isWavFile(std::string_view head) {
  return head.size() >= 12 && (head.starts_with("RIFF") || head.starts_with("RF64") || head.starts_with("BW64")) &&
         head.substr(8, 4) == "WAVE";
}

LoggerTable parseWavFile(std::string_view bytes, const std::string& path) {
  if (!isWavFile(bytes)) throw FileError(path, "", "is not a wave file", "Name a file that begins with RIFF or RF64");
  const WavChunks chunks = wavChunks(bytes);
  const WavFormat format = wavFormat(chunks.format, path);
  if (!chunks.hasSamples) throw FileError(path, "chunk data", "is missing", "The file holds no samples");
  const std::size_t frame = format.channels * format.bytes, rows = chunks.samples.size() / frame;
  if (rows == 0) throw FileError(path, "chunk data", "holds no sample of every channel", "Name another file");

  LoggerTable result;
  result.notes = chunks.notes;
  if (chunks.samples.size() % frame != 0) result.notes.emplace_back("the last frame is not whole: left out");
  const WavCalibration calibration = wavCalibration(chunks, result.notes);
  result.rate = format.rate;
  result.table.columns.resize(format.channels);
  for (std::size_t c = 0; c < format.channels; ++c) {
    auto& column = result.table.columns[c];
    column.name = "channel " + std::to_string(c + 1);
    column.unit = calibration.unit;
    column.values.resize(rows);
    for (std::size_t i = 0; i < rows; ++i) {
      const double value = calibration.fullScale * wavSample(chunks.samples, i * frame + c * format.bytes, format);
      if (std::isinf(value)) {
        column.values[i] = std::nan("");
        if (column.badText.empty()) column.badRow = i, column.badText = "infinity";
      } else {
        column.values[i] = value;
      }
    }
  }
  result.table.path = path;
  result.table.rowWord = "sample";
  result.table.lines.resize(rows);
  std::iota(result.table.lines.begin(), result.table.lines.end(), 1U);
  return result;
}

LoggerTable readWavFile(const std::string& path) {
  return parseWavFile(readWholeFile(path, std::size_t{4} << 30), path);
}

}  // namespace squat::loggers
