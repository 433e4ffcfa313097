// solver/analysis/ComparisonTable.h - runs and measured signals side by side, a row each.
#pragma once

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "case/CaseNames.h"
#include "signals/Comparison.h"
#include "signals/Features.h"
#include "signals/Record.h"

namespace squat::analysis {

// Names with unit and values; not-a-number where a signal has none.
using NamedNumbers = std::vector<std::pair<std::string, double>>;

// The features of a signal that the table is made of, of its acceleration up to 2 kHz. Throws FileError, CaseError and
// SignalError.
signals::Features comparedFeatures(const signals::Record& signal);

// What the table shows of a signal: peak, three lines, wavelength and band powers, those of squat analyse. Throws
// as comparedFeatures.
NamedNumbers signalNumbers(const signals::Features& features);
NamedNumbers signalNumbers(const signals::Record& signal);

// The comparison of squat compare SIGNAL REFERENCE, without names. Throws the same.
signals::Comparison recordComparison(const signals::Record& signal, const signals::Record& reference);

// What it shows of a signal beside a reference: correlation and peak ratio (signal / reference), those of squat compare
// SIGNAL REFERENCE. Throws the same.
NamedNumbers likenessNumbers(const signals::Record& signal, const signals::Record& reference);

struct ComparedSignal {
  std::string name;
  const cases::ComparedCase* values = nullptr;  // null: no case is known
  NamedNumbers numbers, likeness;               // empty: not known
};

struct ComparisonCell {
  std::string text;  // as the commands print it: four significant digits; "-" where there is none
  double number = NAN;
};

struct ComparisonTable {
  std::vector<std::string> columns;  // with unit: "signal", what differs between the cases, the numbers
  std::vector<std::vector<ComparisonCell>> rows;
};

ComparisonTable comparisonTable(const std::vector<ComparedSignal>& signals);

std::string tableCsv(const ComparisonTable& table);    // every digit
std::string tabbedText(const ComparisonTable& table);  // as shown, for a spreadsheet or a text

}  // namespace squat::analysis
