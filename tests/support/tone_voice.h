#pragma once

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include "tests/support/temporary_folder.h"

namespace docent::test {

/// A program that takes the place of espeak-ng: it says a tone of 440 Hz and so many seconds for
/// every text, remembers what it was asked for, and reads Japanese as Debian's voice does, except
/// kana.
class ToneVoice {
 public:
  explicit ToneVoice(double seconds = 1) {
    std::ofstream(folder_.path() / "tone.wav", std::ios::binary) << tone(seconds);
    std::ofstream(program())
        << "#!/bin/sh\n"
           "[ \"$1\" = --version ] && echo 'eSpeak NG text-to-speech: 9.9  Data at: /x' && exit 0\n"
           "[ \"$1\" = --voices ] && exit 0\n"
           "text=$(cat)\n"
           "if [ \"$1\" = -q ]; then\n"
           "  case \"$text\" in *館*) echo '(en)letˈə(ja)';; *) echo aha;; esac\n"
           "else\n"
           "  echo \"$text\" >>"
        << folder_.path() / "said" << "\n  cat " << folder_.path() / "tone.wav" << "\nfi\n";
    std::filesystem::permissions(program(), std::filesystem::perms::owner_all);
  }
  std::string program() const { return (folder_.path() / "espeak-ng").string(); }

  /// Lines that it was asked to say since the last call.
  std::size_t said() {
    std::ifstream file(folder_.path() / "said");
    std::size_t lines = 0;
    for (std::string line; std::getline(file, line);) ++lines;
    file.close();
    std::filesystem::remove(folder_.path() / "said");
    return lines;
  }

 private:
  /// WAV, 22,050 samples a second of 16 bits.
  static std::string tone(double seconds) {
    constexpr std::uint32_t rate = 22'050;
    const auto samples = static_cast<std::uint32_t>(seconds * rate);
    std::string wav = "RIFF";
    const auto put = [&](std::uint32_t value, int count) {
      for (int i = 0; i < count; ++i)
        wav += static_cast<char>(value >> (8U * static_cast<unsigned>(i)));
    };
    put(36 + 2 * samples, 4);
    wav += "WAVEfmt ";
    put(16, 4);
    put(0x00010001, 4);
    put(rate, 4);
    put(2 * rate, 4);
    put(0x00100002, 4);
    wav += "data";
    put(2 * samples, 4);
    for (std::uint32_t i = 0; i < samples; ++i)
      put(static_cast<std::uint32_t>(
              std::lround(12'000 * std::sin(2 * std::numbers::pi * 440 * i / rate))),
          2);
    return wav;
  }

  TemporaryFolder folder_;
};

/// What programs find first while this is there.
class InPath {
 public:
  explicit InPath(const std::filesystem::path& folder) : before_(std::getenv("PATH")) {
    ::setenv("PATH", (folder.string() + ":" + before_).c_str(), 1);
  }
  InPath(const InPath&) = delete;
  InPath& operator=(const InPath&) = delete;
  ~InPath() { ::setenv("PATH", before_.c_str(), 1); }

 private:
  std::string before_;
};

}  // namespace docent::test
