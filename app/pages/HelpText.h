// app/pages/HelpText.h - what a program prints for --help, taken apart.
#pragma once

#include <string>
#include <vector>

namespace squat::pages {

// One option, argument, command or figure.
struct HelpEntry {
  std::vector<std::string> names;    // "-o", "--output"; "case"; "run"
  std::string value;                 // "DIR"; empty: a switch
  std::string range;                 // "1 to 1024"; empty: none is said
  std::vector<std::string> choices;  // the only values that are allowed; empty: any
  bool isList = false;               // several values with commas between them
  std::string excludes, needs;       // other options, as they are printed
  std::string text;                  // a sentence
};

struct HelpSection {
  std::string title;  // "Options", "Positionals", "Subcommands", "Figures"
  std::vector<HelpEntry> entries;
};

struct HelpText {
  std::string summary, usage;
  std::vector<HelpSection> sections;
  std::vector<std::string> footer;  // lines below the sections

  // The entries of a section; none where there is no such section.
  const std::vector<HelpEntry>& of(const std::string& title) const;
};

// All that an entry says, in sentences: its text, choices that the text does not list, range, other options.
std::string sentenceOf(const HelpEntry& entry);

// What stands behind the name of the program in the line of usage: "[OPTIONS] case".
std::string argumentsOf(const HelpText& help);

std::string joined(const std::vector<std::string>& parts, const std::string& between = " ");

// Reads what the command line (CLI11) and the studio (Qt) print. Entries are indented by two columns; what is indented
// further goes on with the entry above. Throws std::runtime_error for a text without "Usage:".
HelpText helpFrom(const std::string& text);

}  // namespace squat::pages
