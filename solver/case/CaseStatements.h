// solver/case/CaseStatements.h - what a case file states, key by key, before any of it is understood; internal to
// solver/case.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "case/TomlLibrary.h"
#include "core/Errors.h"

namespace squat::cases {

// A key as the file states it.
struct Stated {
  std::string key;
  std::string text;  // as for trySetValue
  std::size_t line = 0;
  std::optional<CaseProblem> typeProblem;
};

// The text as TOML. Throws FileError with the line, and with what to write instead where that is known.
toml::table parsedToml(std::string_view text, const std::string& origin);

// "a string", for messages.
const char* typeName(const toml::node& node);

// Every key of the table but `schema`, in the order of the file. Numbers keep the digits that stand in `text`
// (DecimalNumber.h).
std::vector<Stated> statementsOf(const toml::table& table, std::string_view text);

}  // namespace squat::cases
