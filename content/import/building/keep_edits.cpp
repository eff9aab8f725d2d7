#include "content/import/building/keep_edits.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <optional>

namespace docent::import {
namespace {

using std::string_view;

string_view trimmed(string_view text) {
  const std::size_t begin = text.find_first_not_of(" \t\r\n");
  if (begin == string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t\r\n") - begin + 1);
}

/// How much deeper in brackets a line ends than it begins; strings and comments do not count.
int depth_of(string_view line) {
  int depth = 0;
  char quote = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const char c = line[i];
    if (quote != 0) {
      if (c == '\\' && quote == '"')
        ++i;
      else if (c == quote)
        quote = 0;
    } else if (c == '"' || c == '\'') {
      quote = c;
    } else if (c == '#') {
      break;
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if (c == ']' || c == '}') {
      --depth;
    }
  }
  return depth;
}

/// One or several lines: a field with its value, a header, or a comment.
struct Piece {
  std::string key;   ///< Of a field: `title.en`; else empty.
  std::string text;  ///< With its line breaks.
};

/// From a header to the next. The first has none: the file's head.
struct Section {
  std::string header{};  ///< `[[room]]`; empty for the head.
  std::string name{};    ///< What tells it from others of the header.
  std::vector<Piece> pieces{};

  [[nodiscard]] const Piece* field(string_view key) const {
    const auto piece = std::ranges::find(pieces, key, &Piece::key);
    return piece == pieces.end() ? nullptr : &*piece;
  }
};

std::string key_of(string_view line) {
  line = trimmed(line);
  if (line.empty() || line.front() == '#' || line.front() == '[') return {};
  const std::size_t equals = line.find('=');
  return equals == string_view::npos ? std::string() : std::string(trimmed(line.substr(0, equals)));
}

/// Takes a line, with its break, from the front.
string_view take_line(string_view& text) {
  const std::size_t end = text.find('\n');
  const string_view line = text.substr(0, end == string_view::npos ? text.size() : end + 1);
  text.remove_prefix(line.size());
  return line;
}

void set_name(Section& section) {
  for (const char* key : {"id", "name"})
    if (const Piece* field = section.field(key)) {
      const string_view value = string_view(field->text).substr(field->text.find('=') + 1);
      section.name = trimmed(value.substr(0, value.find('#')));
      // A door is known by its name on its floor.
      if (const Piece* floor = section.field("floor");
          floor != nullptr && section.header == "[[door]]")
        section.name +=
            " on " +
            std::string(trimmed(string_view(floor->text).substr(floor->text.find('=') + 1)));
      return;
    }
}

std::vector<Section> sections_of(string_view text) {
  std::vector<Section> sections(1);
  while (!text.empty()) {
    string_view rest = text;
    const string_view line = take_line(rest);
    const string_view content = trimmed(line);
    std::string whole(line);
    if (content.starts_with('[')) {
      set_name(sections.back());
      sections.push_back({.header = std::string(content.substr(
                              0, content.find(content.starts_with("[[") ? "]]" : "]") +
                                     (content.starts_with("[[") ? 2 : 1)))});
      sections.back().pieces.push_back({"", whole});
    } else {
      const std::string key = key_of(line);
      const auto triple = [&](const char* quote) {
        const std::size_t first = whole.find(quote);
        return first != std::string::npos && whole.find(quote, first + 3) == std::string::npos;
      };
      if (!key.empty()) {
        int depth = depth_of(line);
        while (!rest.empty() && (depth > 0 || triple("\"\"\"") || triple("'''"))) {
          const string_view more = take_line(rest);
          depth += depth_of(more);
          whole += more;
        }
      }
      sections.back().pieces.push_back({key, whole});
    }
    text = rest;
  }
  set_name(sections.back());
  return sections;
}

/// A field's value as it is written, without a comment behind it.
std::string value_of(const Piece* piece) {
  if (piece == nullptr) return {};
  string_view text = trimmed(piece->text);
  text.remove_prefix(std::min(text.size(), text.find('=') + 1));
  if (text.find('\n') == string_view::npos && depth_of(text) == 0 &&
      text.find('"') == string_view::npos)
    text = text.substr(0, text.find('#'));
  std::string value;
  for (const char c : text)
    if (c != ' ' && c != '\t' && c != '\r' && c != '\n') value += c;
  return value;
}

using Name = std::pair<std::string, std::string>;

class Merge {
 public:
  Merge(string_view base, string_view mine, string_view theirs)
      : base_(sections_of(base)), mine_(sections_of(mine)), theirs_(sections_of(theirs)) {}

  MergedToml merged() && {
    for (Section& section : mine_) {
      const Section* was = find(base_, section);
      const Section* is = find(theirs_, section);
      if (is != nullptr)
        merge(section, was, *is);
      else if (was != nullptr && !section.header.empty())
        drop(section, *was);
      else
        write(section);
    }
    for (const Section& section : theirs_)
      if (find(mine_, section) == nullptr) add(section);
    return std::move(merged_);
  }

 private:
  static const Section* find(const std::vector<Section>& sections, const Section& like) {
    const auto same = std::ranges::find_if(sections, [&](const Section& section) {
      return section.header == like.header && section.name == like.name;
    });
    return same == sections.end() ? nullptr : &*same;
  }

  static std::string called(const Section& section) {
    return section.name.empty() ? section.header : section.header + " " + section.name;
  }

  void note(Edit::Kind kind, std::string what, bool here = true) {
    const auto line = static_cast<std::size_t>(std::ranges::count(merged_.text, '\n')) + 1;
    merged_.edits.push_back({kind, here ? line : 0, std::move(what)});
  }

  void write(const Section& section) {
    for (const Piece& piece : section.pieces) merged_.text += piece.text;
  }

  /// Both have it: field by field.
  void merge(const Section& mine, const Section* was, const Section& is) {
    const auto last_field = std::ranges::find_if(mine.pieces.rbegin(), mine.pieces.rend(),
                                                 [](const Piece& p) { return !p.key.empty(); });
    const std::size_t end = static_cast<std::size_t>(mine.pieces.rend() - last_field);
    for (std::size_t i = 0; i < mine.pieces.size(); ++i) {
      merge_piece(mine, mine.pieces[i], was, is);
      if (i + 1 == std::max<std::size_t>(end, 1)) add_fields(mine, was, is);
    }
  }

  void merge_piece(const Section& mine, const Piece& piece, const Section* was, const Section& is) {
    if (piece.key.empty()) return void(merged_.text += piece.text);
    const Piece* old = was == nullptr ? nullptr : was->field(piece.key);
    const Piece* now = is.field(piece.key);
    const std::string value = value_of(&piece);
    const std::string what = piece.key + " of " + called(mine);
    if (now != nullptr && value_of(now) == value) {
      merged_.text += piece.text;
    } else if (old != nullptr && value_of(old) == value) {
      // Untouched by staff: as the plan has it now.
      note(now == nullptr ? Edit::Kind::Removed : Edit::Kind::Changed, what, now != nullptr);
      if (now != nullptr) merged_.text += now->text;
    } else {
      if (now != nullptr || old != nullptr) note(Edit::Kind::Kept, what);
      merged_.text += piece.text;
    }
  }

  /// What the plan says anew; what staff have taken out stays out.
  void add_fields(const Section& mine, const Section* was, const Section& is) {
    for (const Piece& piece : is.pieces) {
      if (piece.key.empty() || mine.field(piece.key) != nullptr) continue;
      if (was != nullptr && was->field(piece.key) != nullptr) {
        note(Edit::Kind::Kept, fmt::format("that {} of {} is not there", piece.key, called(mine)));
        continue;
      }
      note(Edit::Kind::Added, piece.key + " of " + called(mine));
      if (!merged_.text.empty() && merged_.text.back() != '\n') merged_.text += '\n';
      merged_.text += piece.text;
    }
  }

  /// The plan has it no longer.
  void drop(const Section& mine, const Section& was) {
    bool touched = false;
    for (const Piece& piece : mine.pieces)
      touched =
          touched || (!piece.key.empty() && value_of(&piece) != value_of(was.field(piece.key)));
    if (touched) {
      note(Edit::Kind::Orphan, called(mine));
      write(mine);
      return;
    }
    note(Edit::Kind::Removed, called(mine), false);
    // Comments in it may be staff's, and may speak of what follows.
    for (const Piece& piece : mine.pieces)
      if (piece.key.empty() && trimmed(piece.text).starts_with('#')) merged_.text += piece.text;
  }

  void add(const Section& section) {
    if (find(base_, section) != nullptr) {
      if (!section.header.empty())
        note(Edit::Kind::Kept, fmt::format("that {} is not there", called(section)), false);
      return;
    }
    if (!merged_.text.empty() && merged_.text.back() != '\n') merged_.text += '\n';
    if (!merged_.text.ends_with("\n\n")) merged_.text += '\n';
    note(Edit::Kind::Added, called(section));
    write(section);
  }

  std::vector<Section> base_, mine_, theirs_;
  MergedToml merged_;
};

}  // namespace

MergedToml keep_edits(string_view base, string_view mine, string_view theirs) {
  return Merge(base, mine, theirs).merged();
}

}  // namespace docent::import
