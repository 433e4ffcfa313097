// solver/case/TomlLibrary.h - the one place that includes toml++; internal to solver/case.
// Some malformed texts fail assertions inside toml++ 3.3, which would end the program in a debug build and leave the
// parser in an undefined state in any other. Here a failed assertion is an exception, in every build.
#pragma once

#include <stdexcept>

namespace squat::cases {

struct TomlAssertion : std::runtime_error {
  using std::runtime_error::runtime_error;
};

[[noreturn]] inline void failTomlAssertion() { throw TomlAssertion("the text is malformed"); }

}  // namespace squat::cases

#pragma push_macro("NDEBUG")
#undef NDEBUG
#define TOML_EXCEPTIONS 0
#define TOML_ASSERT(expression) ((expression) ? static_cast<void>(0) : ::squat::cases::failTomlAssertion())
#include <toml++/toml.h>
#pragma pop_macro("NDEBUG")
