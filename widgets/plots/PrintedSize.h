// widgets/plots/PrintedSize.h - size and resolution of figures in files. No Qt: a headless build knows the options too.
#pragma once

namespace squat::plots {

constexpr double printResolution = 300;  // [dpi] of PNG

struct PrintedSize {
  double width = 0, height = 0;         // [mm] of each figure; 0: its own, one or two columns of a journal
  double resolution = printResolution;  // [dpi] of PNG

  // What a user may choose. In smaller figures the labels of axes are cut.
  static constexpr double minimumWidth = 80, minimumHeight = 55, maximumSide = 400;  // [mm]
  static constexpr double minimumResolution = 50, maximumResolution = 1200;          // [dpi]
};

}  // namespace squat::plots
