// solver/studies/Jobs.h - how many runs share this machine, and how many threads each of them gets.
#pragma once

#include <string>

namespace squat::studies {

struct Machine {
  int cores = 1;         // that this process may use
  double memory = 0;     // [bytes] free; 0: not known
  double bandwidth = 0;  // [bytes/s] between all cores together and the memory; 0: not known
  double cache = 0;      // [bytes] of the last level, all of it; 0: not known
};

// Cores: as many as Slurm has given to the task (SLURM_CPUS_PER_TASK), else those that the process may run on.
int coresHere();
// Measured by all cores at once, a tenth of a second. Four cores or fewer do not reach the limit of their memory with
// this solver (two threads compute 1.8 to 2.1 times as fast as one, resources/manual/speed.md): 0, nothing is measured.
double memoryBandwidth(int cores);
Machine thisMachine();

struct RunDemand {
  double memory = 0;   // [bytes]; 0: not known
  double traffic = 0;  // [bytes/s] that one thread moves to and from what is beyond its own caches; 0: not known
  double state = 0;    // [bytes] that a step goes through; 0: not known
};

struct Sharing {
  int jobs = 0;     // runs at once
  int threads = 0;  // of each
};

// 100 million element updates a second (resources/manual/speed.md), of 123 bytes each: what a simulated cache of 2 MiB
// (valgrind's cachegrind) reads and fills on `tiny` in a step, the mean of 480 steps, lines written back not counted.
// With 256 KiB it is 245 bytes. The smaller number stands here: too many runs wait for each other, too few leave cores
// idle.
inline constexpr double kTrafficOfAThread = 12.3e9;
// Of the state, an element: what the memory of a run grows by.
inline constexpr double kStateOfAnElement = 310;

// By the name of a preset, before the mesh is made: a quarter of a GiB on `draft` and 1.5 on `paper`, with room to
// spare.
RunDemand demandOnMesh(const std::string& preset);

// Fills in what is 0 of `wanted`. Runs at once: as many as cores (for `wanted.threads` each, else one) and nine tenths
// of the memory allow, and as the bandwidth feeds or four fifths of the last cache hold, whichever is more; at least
// one. Threads: what the cores leave to each run, and the bandwidth where the states do not stay in the cache. Several
// runs use the cores better than several threads of one; more of either would only wait for the memory.
Sharing shareMachine(const Machine& machine, const RunDemand& demand, Sharing wanted = {});

}  // namespace squat::studies
