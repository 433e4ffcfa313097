// widgets/plots/PrintedSize.h - size and resolution of figures in files.
#pragma once

namespace squat::plots {

constexpr double printResolution = 300;  // [dpi] of PNG

// The 3-D picture keeps its own size.
struct PrintedSize {
  double width = 0, height = 0;         // [mm] of each plot; 0: its own, one or two columns of a journal
  double resolution = printResolution;  // [dpi] of PNG
};

}  // namespace squat::plots
