// squat - the command line of Squat Studio.
#include "commands/Program.h"
#include "core/platform/Memory.h"

int main(int argc, char** argv) {
  squat::platform::keepMemorySteady();
  return squat::commands::runProgram(argc, argv);
}
