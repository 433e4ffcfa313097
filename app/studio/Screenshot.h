// app/studio/Screenshot.h - the real window as a picture.
#pragma once

#include <QString>

namespace squat::studio {

class MainWindow;

// Runs the case to its end in the window that is shown. False where that fails.
bool runFirst(MainWindow& window);

// Lets the window end its preview, lay out and paint, then writes it as PNG. False where the file cannot be written.
bool takeScreenshot(MainWindow& window, const QString& path);

}  // namespace squat::studio
