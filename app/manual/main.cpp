// squat_manual INDEX.md GENERATED OUT.html - the manual as one file.
#include <cstdio>
#include <exception>

#include "core/DurableFile.h"
#include "core/ProgramVersion.h"
#include "manual/HtmlManual.h"

int main(int argc, char** argv) {
  if (argc != 4) {
    std::fprintf(stderr, "usage: squat_manual INDEX.md GENERATED OUT.html\n");
    return 2;
  }
  try {
    const auto html = squat::manual::htmlManual(argv[1], argv[2], squat::programVersionText());
    squat::writeDurably(argv[3], std::string_view(html));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "squat_manual: %s\n", error.what());
    return 1;
  }
  return 0;
}
