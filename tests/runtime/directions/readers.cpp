#include "tests/runtime/directions/readers.h"

#include <algorithm>
#include <stdexcept>

namespace docent::test {
namespace {

using Text = const std::string&;

bool is_from_to(long number, long least, long most) {
  return number >= least && number <= most;
}

// Russian: one as in 1, 21, 101; few as in 2 to 4 and 22 to 24; many are all others.
enum class Slavic { One, Few, Many };
Slavic slavic(long number) {
  const long last = number % 10, teens = number % 100;
  if (is_from_to(teens, 11, 14)) return Slavic::Many;
  return last == 1 ? Slavic::One : is_from_to(last, 2, 4) ? Slavic::Few : Slavic::Many;
}

std::string russian_minutes(Text digits, long number) {
  if (number == 1) return "около минуты";
  if (number == 2) return "около двух минут";
  return "около " + digits + (slavic(number) == Slavic::One ? " минуты" : " минут");
}

std::string russian_metres(Text digits, long number) {
  constexpr std::array<const char*, 3> forms{" метр", " метра", " метров"};
  return digits + forms[static_cast<std::size_t>(slavic(number))];
}

// Arabic: a dual for 2; the plural after 3 to 10; the singular after 11 to 99, and after hundreds.
std::string arabic_minutes(Text digits, long number) {
  if (number <= 2) return number == 1 ? "نحو دقيقة" : "نحو دقيقتين";
  return "نحو " + digits + (is_from_to(number % 100, 3, 10) ? " دقائق" : " دقيقة");
}

std::string arabic_metres(Text digits, long number) {
  if (number <= 2) return number == 1 ? "متر واحد" : "متران";
  const long rest = number % 100;
  return digits + (is_from_to(rest, 3, 10)    ? " أمتار"
                   : is_from_to(rest, 11, 99) ? " مترًا"
                                              : " متر");
}

// Hebrew: a dual for 2; the plural after all others but 1.
std::string hebrew_minutes(Text digits, long number) {
  return number == 1 ? "כדקה" : number == 2 ? "כשתי דקות" : "כ־" + digits + " דקות";
}

std::string hebrew_metres(Text digits, long number) {
  return number == 1 ? "מטר אחד" : number == 2 ? "שני מטרים" : digits + " מטרים";
}

const std::array<Reader, 12>& readers() {
  static const std::array<Reader, 12> all{{
      {.tag = "en",
       .side = {"straight ahead", "on the left", "on the right", "behind you",
                "behind you on the left", "behind you on the right"},
       .nth = {"first", "second", "third", "fourth", "fifth", "sixth"},
       .where = {"straight ahead", "on your left", "on your right", "behind you",
                 "in the middle of the room"},
       .on_wall = "on the wall",
       .in_case = "in a glass case",
       .ride = {"the stairs", "the escalator", "the lift", "the ramp"},
       .up = " up to ",
       .down = " down to ",
       .then = ", then ",
       .free_of_steps = "step-free",
       .open_quote = "“",
       .close_quote = "”",
       .stop = ".",
       .digits = "0123456789",
       .never = {},
       .minutes =
           [](Text digits, long number) {
             return number == 1   ? "about a minute"
                    : number == 2 ? "about two minutes"
                                  : "about " + digits + " minutes";
           },
       .metres = [](Text digits,
                    long number) { return digits + (number == 1 ? " metre" : " metres"); }},
      {.tag = "zh",
       .side = {"正前方", "左手边", "右手边", "您身后", "左后方", "右后方"},
       .nth = {"第一道门", "第二道门", "第三道门", "第四道门", "第五道门", "第六道门"},
       .where = {"正前方", "左手边", "右手边", "身后", "展厅中央"},
       .on_wall = "墙上",
       .in_case = "展柜里",
       .ride = {"走楼梯", "乘自动扶梯", "乘电梯", "走坡道"},
       .up = "上到",
       .down = "下到",
       .then = "，然后",
       .free_of_steps = "无台阶",
       .open_quote = "“",
       .close_quote = "”",
       .stop = "。",
       .digits = "0123456789",
       .never = {" {room}", "{room} "},
       .minutes =
           [](Text digits, long number) {
             return number == 1   ? "大约一分钟"
                    : number == 2 ? "大约两分钟"
                                  : "大约 " + digits + " 分钟";
           },
       .metres = [](Text digits, long) { return digits + "米"; }},
      {.tag = "ja",
       .side = {"正面", "左の|左側", "右の|右側", "後ろ", "左後ろ", "右後ろ"},
       .nth = {"一番目の扉", "二番目の扉", "三番目の扉", "四番目の扉", "五番目の扉", "六番目の扉"},
       .where = {"正面", "左手", "右手", "後ろ", "部屋の中央"},
       .on_wall = "壁にあります",
       .in_case = "展示ケース",
       .ride = {"階段で", "エスカレーターで", "エレベーターで", "スロープで"},
       .up = "へ上がって",
       .down = "へ下りて",
       .then = "、次に",
       .free_of_steps = "段差なし",
       .open_quote = "「",
       .close_quote = "」",
       .stop = "。",
       .digits = "0123456789",
       .never = {" {room}", "{room} "},
       .minutes = [](Text digits, long) { return "約" + digits + "分"; },
       .metres = [](Text digits, long) { return digits + "メートル"; }},
      {.tag = "ko",
       .side = {"정면", "왼쪽", "오른쪽", "뒤쪽", "왼쪽 뒤", "오른쪽 뒤"},
       .nth = {"첫 번째 문", "두 번째 문", "세 번째 문", "네 번째 문", "다섯 번째 문",
               "여섯 번째 문"},
       .where = {"정면", "왼쪽", "오른쪽", "뒤쪽", "방 한가운데"},
       .on_wall = "벽에 있습니다",
       .in_case = "진열장 안에",
       .ride = {"계단으로", "에스컬레이터로", "엘리베이터로", "경사로로"},
       .up = "로 올라가 ",
       .down = "로 내려가 ",
       .then = ", 그다음 ",
       .free_of_steps = "계단 없음",
       .open_quote = "‘",
       .close_quote = "’",
       .stop = ".",
       .digits = "0123456789",
       // These hang on whether the name ends in a vowel.
       .never = {"{room}을", "{room}를", "{room}이", "{room}가", "{room}은", "{room}는", "{room}과",
                 "{room}와", "{room}로", "{room}으로", "{room}(", "{room}나", "{room}이나"},
       .minutes = [](Text digits, long) { return "약 " + digits + "분"; },
       .metres = [](Text digits, long) { return digits + "미터"; }},
      {.tag = "ar",
       .side = {"أمامك", "على اليسار", "على اليمين", "خلفك", "خلفك على اليسار", "خلفك على اليمين"},
       .nth = {"الباب الأول", "الباب الثاني", "الباب الثالث", "الباب الرابع", "الباب الخامس",
               "الباب السادس"},
       .where = {"أمامك مباشرة", "عن يسارك", "عن يمينك", "خلفك", "في وسط القاعة"},
       .on_wall = "على الجدار",
       .in_case = "في خزانة زجاجية",
       .ride = {"الدرج", "السلم الكهربائي", "المصعد", "المنحدر"},
       .up = "صعودًا",
       .down = "نزولًا",
       .then = "، ثم ",
       .free_of_steps = "بلا درج",
       .open_quote = "«",
       .close_quote = "»",
       .stop = ".",
       .digits = "٠١٢٣٤٥٦٧٨٩",
       .never = {" و {room}", "ال{room}"},
       .minutes = arabic_minutes,
       .metres = arabic_metres},
      {.tag = "he",
       .side = {"שמולכם|ישר", "משמאל|בצד שמאל", "מימין|בצד ימין", "מאחוריכם", "מאחוריכם משמאל",
                "מאחוריכם מימין"},
       .nth = {"הדלת הראשונה", "הדלת השנייה", "הדלת השלישית", "הדלת הרביעית", "הדלת החמישית",
               "הדלת השישית"},
       .where = {"ישר מולכם", "משמאלכם", "מימינכם", "מאחוריכם", "באמצע האולם"},
       .on_wall = "על הקיר",
       .in_case = "בארון תצוגה",
       .ride = {"במדרגות ל", "במדרגות הנעות", "במעלית", "ברמפה"},
       .up = "למעלה",
       .down = "למטה",
       .then = ", ואז ",
       .free_of_steps = "בלי מדרגות",
       .open_quote = "„",
       .close_quote = "”",
       .stop = ".",
       .digits = "0123456789",
       // What is one letter stands without a blank; the article hangs on the name.
       .never = {" ב {room}", " ו {room}", " ל {room}", "ה{room}"},
       .minutes = hebrew_minutes,
       .metres = hebrew_metres},
      {.tag = "hi",
       .side = {"सामने", "बाईं ओर", "दाईं ओर", "आपके पीछे", "आपके पीछे बाईं ओर", "आपके पीछे दाईं ओर"},
       .nth = {"पहला दरवाज़ा", "दूसरा दरवाज़ा", "तीसरा दरवाज़ा", "चौथा दरवाज़ा", "पाँचवाँ दरवाज़ा",
               "छठा दरवाज़ा"},
       .where = {"ठीक सामने", "आपके बाईं ओर", "आपके दाईं ओर", "आपके पीछे", "कक्ष के बीचोंबीच"},
       .on_wall = "दीवार पर",
       .in_case = "काँच की पेटी में",
       .ride = {"सीढ़ियों से", "एस्केलेटर से", "लिफ़्ट से", "ढलान से"},
       .up = "से ऊपर",
       .down = "से नीचे",
       .then = ", फिर ",
       .free_of_steps = "बिना सीढ़ियों के",
       .open_quote = "“",
       .close_quote = "”",
       .stop = "।",
       .digits = "0123456789",
       .never = {},
       .minutes =
           [](Text digits, long number) {
             return "लगभग " + (number == 1 ? "एक" : number == 2 ? "दो" : digits) + " मिनट";
           },
       .metres = [](Text digits, long) { return digits + " मीटर"; }},
      {.tag = "th",
       .side = {"ตรงหน้า|ตรงไป", "ด้านซ้าย", "ด้านขวา", "ด้านหลังคุณ", "ด้านหลังซ้าย", "ด้านหลังขวา"},
       .nth = {"ประตูบานที่หนึ่ง", "ประตูบานที่สอง", "ประตูบานที่สาม", "ประตูบานที่สี่", "ประตูบานที่ห้า",
               "ประตูบานที่หก"},
       .where = {"ตรงหน้า", "ทางซ้ายของคุณ", "ทางขวาของคุณ", "ด้านหลังคุณ", "กลางห้อง"},
       .on_wall = "บนผนัง",
       .in_case = "ในตู้กระจก",
       .ride = {"บันไดไป", "บันไดเลื่อนไป", "ลิฟต์ไป", "ทางลาดไป"},
       .up = "ขึ้น",
       .down = "ลง",
       .then = " จากนั้น",
       .free_of_steps = "ไม่มีขั้นบันได",
       .open_quote = "“",
       .close_quote = "”",
       .stop = "",
       .digits = "0123456789",
       // A blank stands on both sides of quotation marks.
       .never = {"ผ่าน{room}", "ใน{room}", "และ{room}", "ไป{room}", "ยัง{room}", "{room}จาก"},
       .minutes =
           [](Text digits, long number) {
             return number == 1   ? "ประมาณหนึ่งนาที"
                    : number == 2 ? "ประมาณสองนาที"
                                  : "ประมาณ " + digits + " นาที";
           },
       .metres = [](Text digits, long) { return digits + " เมตร"; }},
      {.tag = "de",
       .side = {"geradeaus", "links", "rechts", "hinter Ihnen", "hinter Ihnen links",
                "hinter Ihnen rechts"},
       .nth = {"die erste Tür", "die zweite Tür", "die dritte Tür", "die vierte Tür",
               "die fünfte Tür", "die sechste Tür"},
       .where = {"geradeaus vor Ihnen", "links von Ihnen", "rechts von Ihnen", "hinter Ihnen",
                 "mitten im Raum"},
       .on_wall = "an der Wand",
       .in_case = "in einer Vitrine",
       .ride = {"die Treppe", "mit der Rolltreppe", "mit dem Aufzug", "die Rampe"},
       .up = "hinauf zu",
       .down = "hinunter zu",
       .then = ", dann ",
       .free_of_steps = "ohne Stufen",
       .open_quote = "„",
       .close_quote = "“",
       .stop = ".",
       .digits = "0123456789",
       .never = {"zum {room}", "zur {room}", "im {room}", "den {room}", "dem {room}", "der {room}",
                 "die {room}", "das {room}"},
       .minutes =
           [](Text digits, long number) {
             return number == 1   ? "etwa eine Minute"
                    : number == 2 ? "etwa zwei Minuten"
                                  : "etwa " + digits + " Minuten";
           },
       .metres = [](Text digits,
                    long number) { return number == 1 ? "ein Meter" : digits + " Meter"; }},
      {.tag = "fr",
       .side = {"en face", "à gauche", "à droite", "derrière vous", "derrière vous à gauche",
                "derrière vous à droite"},
       .nth = {"la première porte", "la deuxième porte", "la troisième porte", "la quatrième porte",
               "la cinquième porte", "la sixième porte"},
       .where = {"en face de vous", "à votre gauche", "à votre droite", "derrière vous",
                 "au milieu de la salle"},
       .on_wall = "au mur",
       .in_case = "dans une vitrine",
       .ride = {"l’escalier qui", "l’escalier mécanique", "l’ascenseur", "la rampe"},
       .up = "qui monte vers ",
       .down = "qui descend vers ",
       .then = ", puis ",
       .free_of_steps = "sans marches",
       .open_quote = "«\u00a0",
       .close_quote = "\u00a0»",
       .stop = ".",
       .digits = "0123456789",
       // "de" and "à" melt with an article that the name begins with, "de" and "le" with a vowel.
       .never = {"de {room}", "d’{room}", "à {room}", "au {room}", "le {room}", "la {room}",
                 "que {room}"},
       .minutes =
           [](Text digits, long number) {
             return number == 1   ? "environ une minute"
                    : number == 2 ? "environ deux minutes"
                                  : "environ " + digits + " minutes";
           },
       .metres = [](Text digits,
                    long number) { return number == 1 ? "un mètre" : digits + " mètres"; }},
      {.tag = "es",
       .side = {"de enfrente|enfrente", "a la izquierda|de la izquierda",
                "a la derecha|de la derecha", "detrás de usted", "detrás de usted a la izquierda",
                "detrás de usted a la derecha"},
       .nth = {"la primera puerta", "la segunda puerta", "la tercera puerta", "la cuarta puerta",
               "la quinta puerta", "la sexta puerta"},
       .where = {"frente a usted", "a su izquierda", "a su derecha", "detrás de usted",
                 "en el centro de la sala"},
       .on_wall = "en la pared",
       .in_case = "en una vitrina",
       .ride = {"la escalera que", "la escalera mecánica", "el ascensor", "la rampa"},
       .up = "que sube a ",
       .down = "que baja a ",
       .then = ", luego ",
       .free_of_steps = "sin escalones",
       .open_quote = "«",
       .close_quote = "»",
       .stop = ".",
       .digits = "0123456789",
       // "y" is "e" before a name that begins with an i, "o" is "u" before an o.
       .never = {"y {room}", " e {room}", " o {room}", "al {room}", "del {room}", "el {room}",
                 "la {room}"},
       .minutes =
           [](Text digits, long number) {
             return number == 1   ? "cerca de un minuto"
                    : number == 2 ? "cerca de dos minutos"
                                  : "cerca de " + digits + " minutos";
           },
       .metres = [](Text digits,
                    long number) { return number == 1 ? "un metro" : digits + " metros"; }},
      {.tag = "ru",
       .side = {"прямо", "слева|по левой стороне", "справа|по правой стороне", "позади вас",
                "позади вас слева", "позади вас справа"},
       .nth = {"первая дверь", "вторая дверь", "третья дверь", "четвёртая дверь", "пятая дверь",
               "шестая дверь"},
       .where = {"прямо перед вами", "слева от вас", "справа от вас", "позади вас", "посередине"},
       .on_wall = "на стене",
       .in_case = "в витрине",
       .ride = {"по лестнице", "на эскалаторе", "на лифте", "по пандусу"},
       .up = "вверх на ",
       .down = "вниз на ",
       .then = ", затем ",
       .free_of_steps = "без ступеней",
       .open_quote = "«",
       .close_quote = "»",
       .stop = ".",
       .digits = "0123456789",
       // A name in quotes keeps its ending: a hall, or a floor, stands before it.
       .never = {"через {room}", "войдите в {room}", "дверь в {room}"},
       .minutes = russian_minutes,
       .metres = russian_metres},
  }};
  return all;
}

/// The bytes of the character that begins here.
std::size_t size_of_character(std::string_view text, std::size_t at) {
  std::size_t end = at + 1;
  while (end < text.size() && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) ++end;
  return end - at;
}

std::array<std::string_view, 10> digits_of(const Reader& reader) {
  std::array<std::string_view, 10> digits;
  std::size_t at = 0;
  for (std::string_view& digit : digits) {
    digit = reader.digits.substr(at, size_of_character(reader.digits, at));
    at += digit.size();
  }
  return digits;
}

}  // namespace

const Reader& reader_of(std::string_view language) {
  const auto& all = readers();
  const auto found = std::ranges::find(all, language, &Reader::tag);
  if (found == all.end()) throw std::runtime_error("nobody reads " + std::string(language));
  return *found;
}

std::string written(const Reader& reader, long number) {
  std::string text;
  for (const char digit : std::to_string(number))
    text += digits_of(reader)[static_cast<std::size_t>(digit - '0')];
  return text;
}

long number_in(const Reader& reader, std::string_view text) {
  const auto digits = digits_of(reader);
  long number = 0;
  while (!text.empty()) {
    const auto digit =
        std::ranges::find_if(digits, [&](std::string_view d) { return text.starts_with(d); });
    if (digit == digits.end()) return number;
    number = number * 10 + (digit - digits.begin());
    text.remove_prefix(digit->size());
  }
  return number;
}

std::vector<std::string> names_in(const Reader& reader, std::string_view text) {
  std::vector<std::string> names;
  for (std::size_t at = text.find(reader.open_quote); at != std::string_view::npos;
       at = text.find(reader.open_quote, at + 1)) {
    const std::size_t begin = at + reader.open_quote.size();
    names.emplace_back(text.substr(begin, text.find(reader.close_quote, begin) - begin));
  }
  return names;
}

std::string without_names(const Reader& reader, std::string_view text) {
  std::string rest(text);
  for (std::size_t at = rest.find(reader.open_quote); at != std::string::npos;
       at = rest.find(reader.open_quote, at)) {
    const std::size_t end = rest.find(reader.close_quote, at + reader.open_quote.size());
    rest.erase(at, end == std::string::npos ? end : end + reader.close_quote.size() - at);
  }
  return rest;
}

std::string within_a_sentence(std::string text) {
  if (text.size() < 2) return text;
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  if (byte(0) >= 'A' && byte(0) <= 'Z') {
    text[0] = static_cast<char>(byte(0) + 0x20);
  } else if (byte(0) == 0xC3 && byte(1) <= 0x9E) {  // À to Þ
    text[1] = static_cast<char>(byte(1) + 0x20);
  } else if (byte(0) == 0xD0 && byte(1) >= 0x90 && byte(1) <= 0x9F) {  // А to П
    text[1] = static_cast<char>(byte(1) + 0x20);
  } else if (byte(0) == 0xD0 && byte(1) >= 0xA0 && byte(1) <= 0xAF) {  // Р to Я
    text[0] = static_cast<char>(0xD1);
    text[1] = static_cast<char>(byte(1) - 0x20);
  }
  return text;
}

bool begins_small(std::string_view text) {
  if (text.size() < 2) return false;
  const auto first = static_cast<unsigned char>(text[0]),
             second = static_cast<unsigned char>(text[1]);
  if (first == 0xC3) return second >= 0xA0;                // à to þ
  if (first == 0xD0) return second >= 0xB0;                // а to п
  return first == 0xD1 || (first >= 'a' && first <= 'z');  // р to я
}

Found find_said(std::string_view ways_to_say, std::string_view text) {
  Found best;
  while (!ways_to_say.empty()) {
    const std::size_t end = std::min(ways_to_say.find('|'), ways_to_say.size());
    if (const std::size_t at = text.find(ways_to_say.substr(0, end)); at < best.at)
      best = {at, end};
    ways_to_say.remove_prefix(std::min(end + 1, ways_to_say.size()));
  }
  return best;
}

}  // namespace docent::test
