// solver/scenario/MeshSizes.h - element sizes and arithmetic.
#pragma once

namespace squat::scenario {

enum class MeshPreset { tiny, draft, standard, paper };
enum class ElementPrecision { single, full };  // "single", "double"

struct MeshSizes {
  MeshPreset preset = MeshPreset::tiny;
  double contactSize = 0;    // [m] element size in the contact band at the start and at the defect
  double rollingSize = 0;    // [m] largest length of elements rolled over in between
  double farSize = 0;        // [m] largest length of elements away from the wheel
  double sectionSize = 0;    // [m] largest element size in the sections of rail and rim
  double sectionGrowth = 0;  // [-] largest ratio of neighbouring sizes in the sections
  double bandHalfWidth = 0;  // [m] lateral half width of the contact band with contactSize
  double fineBefore = 0;     // [m] fine zone before the first and after the last point of the defect
  double fineStart = 0;      // [m] fine zone each side of the starting point
  // [m] The mesh serves every defect that reaches at most so far before and behind its deepest point; 0: its own.
  double zoneBefore = 0, zoneBehind = 0;
  int wheelSectors = 0;  // sectors of the coarse wheel body
  double rimDepth = 0;   // [m] depth of the finely meshed rim
  ElementPrecision precision = ElementPrecision::single;
  bool coarseWeb = false;             // three columns of the band become one below the upper head
  bool selectiveMassScaling = false;  // waves as short as the elements are slowed
};

}  // namespace squat::scenario
