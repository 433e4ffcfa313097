#include "scene/Picture.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>

#include "core/Errors.h"
#include "core/ProgramVersion.h"

namespace squat::scene {
namespace {

std::uint32_t crc32(const std::uint8_t* bytes, std::size_t count) {
  std::uint32_t crc = 0xffffffffu;
  for (std::size_t i = 0; i < count; ++i) {
    crc ^= bytes[i];
    for (int bit = 0; bit < 8; ++bit) crc = (crc >> 1) ^ (0xedb88320u & (0u - (crc & 1u)));
  }
  return ~crc;
}

void putBigEndian(std::uint8_t* to, std::uint32_t value) {
  for (int i = 0; i < 4; ++i) to[i] = static_cast<std::uint8_t>(value >> (24 - 8 * i));
}

// The chunk pHYs (pixels per metre), which the writer does not offer. PNG specification, section 11.3.5.3.
std::array<std::uint8_t, 21> resolutionChunk(double resolution) {
  std::array<std::uint8_t, 21> chunk{0, 0, 0, 9, 'p', 'H', 'Y', 's'};
  const auto perMetre = static_cast<std::uint32_t>(std::lround(resolution / 0.0254));
  putBigEndian(&chunk[8], perMetre);
  putBigEndian(&chunk[12], perMetre);
  chunk[16] = 1;
  putBigEndian(&chunk[17], crc32(&chunk[4], 13));
  return chunk;
}

}  // namespace

void writePng(const Picture& picture, const std::string& path, double resolution) {
  vtkNew<vtkImageData> image;
  image->SetDimensions(picture.width, picture.height, 1);
  image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
  const std::size_t row = 3 * static_cast<std::size_t>(picture.width);
  for (int line = 0; line < picture.height; ++line)
    std::memcpy(image->GetScalarPointer(0, picture.height - 1 - line, 0),
                &picture.rgb[row * static_cast<std::size_t>(line)], row);
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputData(image);
  writer->AddText("Software", ("Squat Studio " + programVersionText()).c_str());
  writer->WriteToMemoryOn();
  writer->Write();
  const vtkUnsignedCharArray* result = writer->GetResult();
  const std::uint8_t* bytes = const_cast<vtkUnsignedCharArray*>(result)->GetPointer(0);
  const auto count = static_cast<std::streamsize>(const_cast<vtkUnsignedCharArray*>(result)->GetNumberOfValues());
  constexpr std::streamsize headerLength = 33;  // signature and IHDR, after which pHYs may stand
  const auto chunk = resolutionChunk(resolution);
  const std::string beside = path + ".part";
  {
    std::ofstream file(beside, std::ios::binary);
    file.write(reinterpret_cast<const char*>(bytes), std::min(headerLength, count));
    file.write(reinterpret_cast<const char*>(chunk.data()), chunk.size());
    file.write(reinterpret_cast<const char*>(bytes) + headerLength, count - headerLength);
    file.close();
    if (!file) throw FileError(path, "", "cannot be written", "check that the folder may be written and has room");
  }
  std::error_code failure;
  std::filesystem::rename(beside, path, failure);
  if (failure) throw FileError(path, "", "cannot be written: " + failure.message());
}

}  // namespace squat::scene
