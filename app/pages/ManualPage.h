// app/pages/ManualPage.h - a help as a page for man(1).
#pragma once

#include <string>
#include <vector>

#include "pages/HelpText.h"

namespace squat::pages {

struct PageOf {
  std::string call;                  // "squat figures paper"
  HelpText help;                     // what that call prints with --help
  std::vector<std::string> seeAlso;  // other calls
};

// "squat-figures-paper", the name of the page of a call.
std::string pageName(const std::string& call);

// The page in the language of man(7), section 1. `version`: "Squat Studio 0.2.0".
std::string manualPage(const PageOf& page, const std::string& version);

}  // namespace squat::pages
