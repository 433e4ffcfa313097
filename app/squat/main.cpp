// squat - the command line of Squat Studio.
#include "commands/Program.h"
#include "core/SteadyMemory.h"

int main(int argc, char** argv) {
  squat::keepMemorySteady();
  return squat::commands::runProgram(argc, argv);
}
