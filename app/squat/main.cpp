// squat - the command line of Squat Studio.
#include "commands/Program.h"

int main(int argc, char** argv) { return squat::commands::runProgram(argc, argv); }
