#include "config/museum_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <system_error>
#include <utility>

#include "config/letters.h"
#include "platform/file/read_file.h"
#include "platform/terminal/suggest.h"

namespace docent::config {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view where_files_belong =
    "copy the file into the museum's folder and name it from there: images/jar.png";
constexpr std::string_view in_place_of_link = "copy what it leads to here, in place of the link";

/// Whoever has lost more files has lost a folder, and wants no suggestion for each.
constexpr std::size_t most_suggestions = 200, most_files = 100'000;

/// A name in which a backslash stood for a slash: "images\tripod.svg" holds a tab in TOML.
std::string with_slashes(std::string_view name) {
  constexpr std::string_view made = "\b\t\n\f\r\\", letters = "btnfr";
  std::string slashes;
  for (const char c : name) {
    const std::size_t which = made.find(c);
    if (which == std::string_view::npos) {
      slashes += c;
      continue;
    }
    slashes += '/';
    if (which < letters.size()) slashes += letters[which];
  }
  return slashes;
}

/// Signs above letters that are characters of their own, as Macs write names.
bool has_separate_accents(std::string_view name) {
  for (std::size_t i = 0; i + 1 < name.size(); ++i) {
    const auto first = static_cast<unsigned char>(name[i]),
               second = static_cast<unsigned char>(name[i + 1]);
    if (first == 0xCC || (first == 0xCD && second < 0xB0)) return true;
  }
  return false;
}

bool leads_out(const fs::path& name) {
  int depth = 0;
  for (const fs::path& part : name) {
    depth += part == ".." ? -1 : part == "." ? 0 : 1;
    if (depth < 0) return true;
  }
  return false;
}

PathFault of_link(const std::string& name, std::error_code why) {
  const bool loops = why == std::errc::too_many_symbolic_link_levels;
  return {"missing-file",
          fmt::format("'{}' is a link {}", name,
                      loops ? "that leads back to itself" : "to a file that is not there"),
          {},
          std::string(in_place_of_link)};
}

}  // namespace

bool is_within(const fs::path& folder, const fs::path& file) {
  std::error_code failed;
  const fs::path home = fs::canonical(folder, failed);
  const fs::path there = failed ? fs::path() : fs::weakly_canonical(file, failed);
  if (failed) return false;
  return std::ranges::mismatch(home, there).in1 == home.end();
}

const std::vector<std::string>& MuseumPaths::names_in(const fs::path& folder) {
  const auto [at, is_new] = listed_.try_emplace(folder.string());
  if (!is_new) return at->second;
  std::error_code ignored;  // a folder that cannot be listed offers no names
  for (fs::directory_iterator entry(museum_ / folder, ignored);
       !ignored && entry != fs::directory_iterator(); entry.increment(ignored))
    at->second.push_back(entry->path().filename().string());
  std::ranges::sort(at->second);
  return at->second;
}

/// The name as it is on the disk, where it differs in capital letters only; empty where none does.
std::string MuseumPaths::in_right_case(const fs::path& name) {
  fs::path right;
  for (const fs::path& part : name) {
    if (file::is_there(museum_ / right / part)) {
      right /= part;
      continue;
    }
    const std::vector<std::string>& names = names_in(right);
    const auto found = std::ranges::find(names, in_small_letters(part.string()), in_small_letters);
    if (found == names.end()) return {};
    right /= *found;
  }
  return right.string();
}

/// A name in the same folder that staff may have meant; empty where none is near.
std::string MuseumPaths::nearly(const fs::path& name) {
  const std::vector<std::string>& names = names_in(name.parent_path());
  const std::vector<std::string_view> views(names.begin(), names.end());
  const std::string stem = in_small_letters(name.stem().string());
  const std::string whole = in_small_letters(name.filename().string());
  for (const std::string& other : names)
    if (in_small_letters(fs::path(other).stem().string()) == stem ||
        in_small_letters(other) == stem || in_small_letters(other).starts_with(whole + '.'))
      return (name.parent_path() / other).string();
  const std::string_view near = terminal::closest(name.filename().string(), views);
  return near.empty() ? "" : (name.parent_path() / near).string();
}

std::string MuseumPaths::elsewhere(const std::string& file_name) {
  if (!all_) {
    all_.emplace();
    std::error_code ignored;
    std::size_t count = 0;
    for (fs::recursive_directory_iterator entry(
             museum_, fs::directory_options::skip_permission_denied, ignored);
         !ignored && entry != fs::recursive_directory_iterator() && ++count < most_files;
         entry.increment(ignored))
      if (entry->is_regular_file(ignored)) {
        const std::string path = entry->path().lexically_relative(museum_).string();
        std::string& known = (*all_)[in_small_letters(entry->path().filename().string())];
        if (known.empty() || path < known) known = path;
      }
  }
  const auto found = all_->find(in_small_letters(file_name));
  return found == all_->end() ? "" : found->second;
}

/// What to write in place of a name that leads out of the museum.
std::string MuseumPaths::where_it_is(const std::string& name) {
  if (++told_ > most_suggestions) return std::string(where_files_belong);
  const std::string slashes = with_slashes(name);
  const std::string there = elsewhere(fs::path(slashes).filename().string());
  return there.empty() ? std::string(where_files_belong)
                       : fmt::format("write \"{}\", which is in the museum's folder", there);
}

PathFault MuseumPaths::missing(const std::string& name, Wanted wanted) {
  PathFault fault{
      "missing-file",
      fmt::format("there is no {} '{}'", wanted == Wanted::Folder ? "folder" : "file", name),
      "not found", fmt::format("it is looked for in {}", museum_.string())};
  const fs::path path(name);
  if (const fs::path parent = path.parent_path();
      !parent.empty() && !file::is_there(museum_ / parent))
    fault.label = fmt::format("the folder '{}' is not there", parent.string());
  if (++told_ > most_suggestions) return fault;
  if (std::string right = in_right_case(path); !right.empty()) {
    fault.label = "capital letters matter";
    fault.hint = fmt::format("it is called '{}'", right);
  } else if (std::string there = elsewhere(path.filename().string()); !there.empty()) {
    fault.hint = fmt::format("write \"{}\", where there is one, or move that file", there);
  } else if (std::string meant = nearly(path); !meant.empty()) {
    fault.hint = fmt::format("did you mean '{}'?", meant);
    if (has_separate_accents(meant) != has_separate_accents(name)) {
      fault.label = "its accents are made in another way, as Macs do";
      fault.hint = "give the file a name without accents, and write that";
    }
  }
  return fault;
}

/// What can be said of the words alone.
std::optional<PathFault> MuseumPaths::fault_of_words(const std::string& name) {
  const auto outside = [&](const char* sentence) {
    return PathFault{
        "outside-museum", fmt::format("'{}' {}", name, sentence), {}, where_it_is(name)};
  };
  if (fs::path(name).is_absolute() || (name.size() > 1 && name[1] == ':' && is_letter(name[0])) ||
      name.starts_with("file:"))
    return outside("is an absolute path");
  const bool odd =
      std::ranges::any_of(name, [](char c) { return static_cast<unsigned char>(c) < 0x20; });
  if (odd || name.find('\\') != std::string::npos) {
    const std::string meant = with_slashes(name);
    const bool is_known = file::is_there(museum_ / meant);
    return PathFault{"bad-path",
                     "a file's name holds a backslash, or what a backslash made of it",
                     {},
                     is_known ? fmt::format("write \"{}\"", meant)
                              : fmt::format("write folders with a slash: \"{}\"", meant)};
  }
  if (name.find("://") != std::string::npos)
    return PathFault{"outside-museum",
                     fmt::format("'{}' is in the web, and nothing is fetched from there", name),
                     {},
                     "save it in the museum's folder, such as images/, and name that file"};
  if (name.starts_with("~/")) return outside("is in somebody's home folder");
  if (leads_out(name)) return outside("leads out of the museum's folder");
  return {};
}

std::optional<PathFault> MuseumPaths::fault(const std::string& name, Wanted wanted) {
  if (auto fault = fault_of_words(name)) return fault;
  const fs::path file = museum_ / name;
  std::error_code failed, ignored;
  const fs::file_status status = fs::status(file, failed);
  const bool is_link = fs::is_symlink(fs::symlink_status(file, ignored));
  const std::string in_quotes = fmt::format("'{}'", name);
  if (is_link && !fs::exists(status) && failed != std::errc::permission_denied)
    return of_link(name, failed);
  if (failed == std::errc::filename_too_long)
    return PathFault{
        "bad-path", "a file's name cannot be as long as this", {}, std::string(where_files_belong)};
  if (status.type() == fs::file_type::none)
    return PathFault{"unreadable-file",
                     in_quotes + " may not be looked at by this user",
                     {},
                     "give the folders about it permission: chmod a+rx"};
  if (!fs::exists(status)) return missing(name, wanted);
  if (!is_within(museum_, file))
    return PathFault{"outside-museum",
                     in_quotes + " is a link that leads out of the museum's folder",
                     {},
                     std::string(in_place_of_link)};
  const bool is_folder = fs::is_directory(status);
  if (is_folder && wanted != Wanted::Folder && wanted != Wanted::FileOrFolder)
    return PathFault{"bad-path", in_quotes + " is a folder", {}, "name a file in it"};
  if (!is_folder && wanted == Wanted::Folder)
    return PathFault{"bad-path",
                     in_quotes + " is a file, and should be a folder",
                     {},
                     "make a folder of that name"};
  if (!is_folder && !fs::is_regular_file(status))
    return PathFault{"bad-path",
                     in_quotes + " is no file, but a device or a pipe",
                     {},
                     std::string(where_files_belong)};
  if (!file::may_be_read(file))
    return PathFault{"unreadable-file",
                     in_quotes + " may not be read by this user",
                     {},
                     fmt::format("give it permission: chmod a+r{} {}", is_folder ? "x" : "", name)};
  if (!is_folder && wanted != Wanted::Text && fs::file_size(file, failed) == 0 && !failed)
    return PathFault{"empty-file",
                     fmt::format("the file {} is empty", in_quotes),
                     {},
                     "save or copy it again: it holds not a single byte"};
  return {};
}

}  // namespace docent::config
