#include "content/compile/compile_readings.h"

#include "content/reading/pinyin.h"

namespace docent::compile {
namespace {

bool is_chinese(std::string_view tag) noexcept {
  return tag == "zh" || tag.starts_with("zh-");
}

class Reader {
 public:
  explicit Reader(Museum& museum) : museum_(museum) {}

  void read(const LocalText& text) {
    for (const auto& [tag, words] : text)
      if (is_chinese(tag)) read(words);
  }
  void read(const std::string& text) {
    if (museum_.readings.contains(text)) return;  // staff know better
    if (std::string syllables = reading::pinyin_of(text); !syllables.empty())
      museum_.readings.emplace(text, std::move(syllables));
  }

 private:
  Museum& museum_;
};

}  // namespace

void compile_readings(const config::MuseumConfig& config, Museum& museum) {
  for (const config::SpeechSection& section : config.speech)
    if (section.text.given && section.reading.given)
      museum.readings.emplace(section.text.value, section.reading.value);
  Reader reader(museum);
  for (const Room& room : museum.rooms) reader.read(room.title);
  for (const Place& place : museum.places) reader.read(place.title);
  for (const Exhibit& exhibit : museum.exhibits)
    for (const LocalText* text :
         {&exhibit.title, &exhibit.artist, &exhibit.subject, &exhibit.period})
      reader.read(*text);
  for (const Language& language : museum.languages)
    if (is_chinese(language.tag))
      for (const auto& [key, word] : language.words)
        if (key.starts_with("place_")) reader.read(word);
}

}  // namespace docent::compile
