// app/studio/Arguments.h - what stands on the command line of squat-studio.
#pragma once

#include <QSize>
#include <QString>

namespace squat::studio {

struct Arguments {
  QString file;        // case, result, project or name of a shipped case
  QString screenshot;  // PNG to write; empty: open the window
  QString tab;
  bool dark = false;
  bool run = false;  // the case, before the picture is taken
  QSize size;        // of the window; empty: as it opens
};

// Ends the program for --help and --version (0) and for a call that is wrong (2), with one line on what is wrong.
Arguments readArguments();

// True where the arguments ask for a picture only: then no display is needed.
bool wantsScreenshot(int argc, char** argv);

// The same for what is only printed: help and version.
bool wantsWords(int argc, char** argv);

}  // namespace squat::studio
