// widgets/plots/Application.h - Qt needs an application object before any figure exists.
#pragma once

namespace squat::plots {

// Makes a QApplication that needs no display (platform "offscreen") unless the program has one already. Call once from
// main(), from the thread that draws. Numbers keep the decimal point of the C locale afterwards (Qt would switch the
// whole process to the user's locale, and strtod and printf with it).
void ensureApplication(int argc = 0, char** argv = nullptr);

}  // namespace squat::plots
