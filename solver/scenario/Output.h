// solver/scenario/Output.h - what is recorded.
#pragma once

namespace squat::scenario {

struct Output {
  double rate = 0;               // [Hz]
  double filterCutoff = 0;       // [Hz] low-pass of aba_filtered
  double timeStep = 0;           // [s] requested step; 0: the stable one
  double cwtVoices = 0;          // voices per octave of the scalogram
  double railAccelerometer = 0;  // [m] of a sensor on the rail foot, relative to the deepest point of the defect
};

}  // namespace squat::scenario
