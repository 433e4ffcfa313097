// python/Case.h - a case as Python holds it: a text, and the keys that were set since.
#pragma once

#include <pybind11/pybind11.h>

#include <filesystem>
#include <string>

#include "case/CaseDescription.h"
#include "case/CaseFile.h"
#include "case/ParameterTable.h"
#include "results/RunResult.h"

namespace squat::python {

// Setting a key reads the text again with all keys that were set, so that a key does here what it does on the command
// line: a preset, say, counts less than keys that are stated.
struct Case {
  std::string text;    // TOML
  std::string origin;  // names it in messages
  std::filesystem::path folder;
  std::string stem;  // name of its results
  cases::CaseOverrides overrides;
  cases::CaseDescription description;  // `text` with `overrides`
};

// Throw CaseError and FileError.
Case caseFromText(std::string text, std::string origin, std::filesystem::path folder, std::string stem,
                  cases::CaseOverrides overrides);
Case caseOf(const cases::CaseDescription& description, const std::string& stem);
// `toml`: as cases::writeCase() writes it.
Case caseOfWritten(std::string toml, const std::string& stem);

// Keys and values; all of them are set, or none. Throws CaseError.
void setKeys(Case& which, const pybind11::dict& values);
cases::CaseOverrides overridesFrom(const pybind11::dict& values);

// A value of Python as the case file's text: True is "true", [[0, -0.1]] "[[0, -0.1]]". Throws TypeError of Python.
std::string textOf(const pybind11::handle& value);
// The value of a key: a number in the unit of the case file, text, bool or list.
pybind11::object valueOf(const cases::CaseDescription& description, const cases::Parameter& parameter);
// The same for text that stands for a value of this key.
pybind11::object valueFrom(const std::string& text, const cases::Parameter& parameter);

}  // namespace squat::python
