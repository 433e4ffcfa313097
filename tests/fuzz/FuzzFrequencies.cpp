// Tables by frequency: measured decay rates, stiffness of pads and receptances. Any bytes give finite numbers over
// frequencies that rise, or an error of ours.
#include <cmath>

#include "MemoryFile.h"
#include "calibration/ReceptanceResiduals.h"
#include "case/DynamicPads.h"
#include "core/Errors.h"
#include "receptance/DecayFiles.h"

namespace {

template <typename Read>
void play(const Read& read) {
  try {
    read();
  } catch (const squat::FileError&) {
  } catch (const squat::CaseError&) {
  }
}

void require(bool holds) {
  if (!holds) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace squat;
  const std::string path = tests::memoryFile(data, size);
  play([&] {
    const auto read = receptance::readMeasuredDecayRates(path);
    require(read.band.size() == read.vertical.size() && read.band.size() == read.lateral.size());
    for (const auto* direction : {&read.vertical, &read.lateral})
      for (const auto& rate : *direction)
        require(rate.count == 0 || (std::isfinite(rate.mean) && rate.lowest <= rate.highest));
  });
  play([&] {
    const auto pads = cases::readDynamicStiffness(path);
    require(!pads.empty() && cases::dynamicStiffnessMistake(pads).empty());
  });
  play([&] {
    calibration::ReceptanceTarget target;
    target.file = path, target.point = "over a sleeper";
    const auto read = calibration::readMeasuredReceptance(target);
    require(read.frequency.size() == read.receptance.size());
    for (std::size_t i = 0; i < read.frequency.size(); ++i) {
      require(i == 0 || read.frequency[i] > read.frequency[i - 1]);
      require(std::isfinite(read.receptance[i].real()) && std::isfinite(read.receptance[i].imag()));
    }
  });
  return 0;
}
