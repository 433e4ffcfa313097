// app/pages/ParameterPage.h - the manual's page of all parameters of a case.
#pragma once

#include <string>

namespace squat::pages {

// Markdown: a table for each table of the case file, from the one table of parameters; the values of the mesh presets.
std::string parameterPage();

}  // namespace squat::pages
