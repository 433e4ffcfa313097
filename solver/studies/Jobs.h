// solver/studies/Jobs.h - how many runs fit on this machine at once.
#pragma once

#include <cstddef>

namespace squat::studies {

// Runs at once such that `threadsPerRun` fit on the processors and `bytesPerRun` into the memory that is free now, a
// tenth kept back; at least 1. Zero for either leaves it out.
int jobsThatFit(int threadsPerRun, double bytesPerRun);

// Cores that this process may use: as many as Slurm has given to the task (SLURM_CPUS_PER_TASK), else those that it may
// run on; at least 1.
int coresHere();

double freeMemory();  // [bytes]; 0: not known

}  // namespace squat::studies
