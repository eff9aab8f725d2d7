#pragma once

#include <chrono>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace docent::speech {

/// What came of a program.
struct Outcome {
  enum class Kind { Ended, Missing, TooSlow, TooMuch } kind = Kind::Ended;
  int status = 0;      ///< Its exit status; of one that a signal ended, 128 and the signal.
  std::string output;  ///< What it wrote to its standard output.
  std::string errors;  ///< The first part of what it wrote to its standard error.
};

/// Bytes; more sound than any text has.
inline constexpr std::size_t most_output = std::size_t{1} << 28U;

/// Runs a program of PATH without a shell: `words` are its name and arguments, `input` what it
/// reads from its standard input. It is ended where it takes longer than `patience` or writes more
/// than `most` bytes. Where the system allows it, it lies at the same addresses each time, so that
/// it says the same even of memory that it never wrote. `libraries`: a folder in which it looks for
/// its libraries first; empty for none. Any thread.
Outcome run_program(const std::vector<std::string>& words, std::string_view input,
                    std::chrono::milliseconds patience, std::size_t most = most_output,
                    const std::string& libraries = {});

}  // namespace docent::speech
