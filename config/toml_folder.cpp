#include "config/toml_folder.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <span>
#include <string_view>
#include <system_error>

#include "config/letters.h"
#include "platform/file/file_kind.h"
#include "platform/file/read_file.h"
#include "platform/terminal/suggest.h"

namespace docent::config {

namespace {

namespace fs = std::filesystem;

Diagnostic about(const fs::path& file, Severity severity, std::string code, std::string message,
                 std::string hint) {
  return {.file = file.string(),
          .severity = severity,
          .code = std::move(code),
          .message = std::move(message),
          .hint = std::move(hint)};
}

/// Left by editors, file managers, word processors and version control.
bool is_passed_over(const std::string& name) {
  return name.starts_with('.') || name.starts_with("~$") || name.ends_with('~') ||
         name.ends_with(".bak") || name.ends_with(".swp") || name == "Thumbs.db" ||
         name == "desktop.ini" || name.ends_with(".md");
}

/// The name that would be read; empty where another name is not what is wrong with the file.
std::string right_name(const fs::path& file) {
  const std::string name = file.filename().string(), small = in_small_letters(name);
  if (const std::size_t at = small.find(".toml"); at != std::string::npos)
    return name.substr(0, at) + ".toml";
  const std::string ending = in_small_letters(file.extension().string());
  if (ending == ".txt" || ending == ".text" || ending == ".tml" || ending == ".toml" ||
      ending.empty())
    return file.stem().string() + ".toml";
  return {};
}

/// What belongs elsewhere, by the ending of its name.
std::string where_it_belongs(const fs::path& file) {
  const std::string ending = in_small_letters(file.extension().string());
  const auto is_one_of = [&](std::span<const std::string_view> endings) {
    return std::ranges::find(endings, ending) != endings.end();
  };
  constexpr std::array<std::string_view, 11> pictures{
      ".svg", ".png", ".jpg", ".jpeg", ".webp", ".gif", ".heic", ".avif", ".tif", ".tiff", ".bmp"};
  constexpr std::array<std::string_view, 5> sheets{".csv", ".xlsx", ".xls", ".ods", ".tsv"};
  constexpr std::array<std::string_view, 6> documents{".doc", ".docx",  ".odt",
                                                      ".rtf", ".pages", ".pdf"};
  if (is_one_of(pictures)) return "pictures belong in images/";
  if (is_one_of(sheets))
    return fmt::format(
        "a spreadsheet is saved as CSV UTF-8 and named in museum.toml: [source] file = \"{}\"",
        (file.parent_path().filename() / file.stem()).string() + ".csv");
  if (is_one_of(documents))
    return fmt::format(
        "write what is in it into a file of plain text, {}.toml, or move it elsewhere",
        file.stem().string());
  return "move it elsewhere";
}

/// A file of a word processor, whatever it is called, becomes no other by another name.
std::string_view remedy_of(const fs::path& file) {
  constexpr std::size_t beginning = 65536;
  const Result<std::string> bytes = file::read_file(file, std::size_t{64} << 20U);
  const file::FileKind kind =
      bytes ? file::file_kind(std::string_view(*bytes).substr(0, beginning)) : file::FileKind{};
  return kind.use == file::FileKind::For::Nothing ? kind.remedy : std::string_view{};
}

Diagnostic not_read(const fs::path& file) {
  const std::string name = right_name(file);
  std::string hint =
      name.empty() ? where_it_belongs(file) : fmt::format("call it {}, or move it elsewhere", name);
  if (!name.empty() && file::may_be_read(file))
    if (const std::string_view remedy = remedy_of(file); !remedy.empty())
      hint = fmt::format("{}, and call it {}", remedy, name);
  return about(file, Severity::Warning, "not-read", "is not read: its name does not end in .toml",
               std::move(hint));
}

/// A sentence about 'name' as one about a file that is named already.
std::string without_name(const std::string& message, const std::string& name) {
  const std::string in_quotes = fmt::format("'{}' ", name);
  const std::size_t at = message.find(in_quotes);
  return at == std::string::npos ? message
                                 : message.substr(0, at) + message.substr(at + in_quotes.size());
}

void take(const fs::path& museum, const fs::path& file, MuseumPaths& paths, TomlFolder& folder) {
  if (is_passed_over(file.filename().string())) return;
  if (file::is_folder(file)) {
    folder.diagnostics.push_back(
        about(file, Severity::Warning, "not-read", "is a folder, and what is in it is not read",
              fmt::format("move its files to {}", file.parent_path().string())));
    return;
  }
  if (file.extension() != ".toml") {
    folder.diagnostics.push_back(not_read(file));
    return;
  }
  const std::string name = file.lexically_relative(museum).string();
  auto fault = paths.fault(name, Wanted::Text);
  if (!fault) return folder.files.push_back(file);
  folder.diagnostics.push_back(about(file, Severity::Error, std::move(fault->code),
                                     without_name(fault->message, name), std::move(fault->hint)));
}

/// A folder of nearly that name, which staff may take for it.
void look_for_another(const fs::path& museum, const std::string& name, TomlFolder& folder) {
  std::error_code failed;
  for (fs::directory_iterator entry(museum, failed); !failed && entry != fs::directory_iterator();
       entry.increment(failed)) {
    const std::string other = entry->path().filename().string();
    if (!file::is_folder(entry->path()) ||
        terminal::edit_distance(in_small_letters(other), name) > 1)
      continue;
    folder.diagnostics.push_back(about(entry->path(), Severity::Warning, "not-read",
                                       "is not read: the folder is called otherwise",
                                       fmt::format("call it {}", name)));
  }
}

}  // namespace

TomlFolder list_toml_files(const fs::path& museum, const std::string& name, MuseumPaths& paths) {
  TomlFolder folder;
  const fs::path path = museum / name;
  std::error_code failed;
  const fs::file_status status = fs::symlink_status(path, failed);
  if (status.type() == fs::file_type::not_found) {
    look_for_another(museum, name, folder);
    return folder;
  }
  if (auto fault = paths.fault(name, Wanted::Folder)) {
    const bool is_file = fs::is_regular_file(path, failed);
    folder.diagnostics.push_back(
        is_file
            ? about(path, Severity::Error, "bad-path",
                    "is a file, and should be a folder of .toml files",
                    fmt::format("make a folder {} and put this file into it, as {}-1.toml", name,
                                name))
            : about(path, Severity::Error,
                    fault->code == "unreadable-file" ? "unreadable-folder" : std::move(fault->code),
                    without_name(fault->message, name), std::move(fault->hint)));
    return folder;
  }
  std::vector<fs::path> entries;
  fs::directory_iterator entry(path, failed);
  for (; !failed && entry != fs::directory_iterator(); entry.increment(failed))
    entries.push_back(entry->path());
  std::ranges::sort(entries);
  for (const fs::path& file : entries) take(museum, file, paths, folder);
  return folder;
}

std::vector<Diagnostic> stray_toml_files(const fs::path& museum) {
  std::vector<Diagnostic> strays;
  std::error_code failed;
  for (fs::directory_iterator entry(museum, failed); !failed && entry != fs::directory_iterator();
       entry.increment(failed)) {
    const fs::path& file = entry->path();
    const std::string name = file.filename().string();
    if (file.extension() != ".toml" || is_passed_over(name) || name == "museum.toml" ||
        name == "kiosk.toml" || name == "today.toml" || file::is_folder(file))
      continue;
    strays.push_back(about(file, Severity::Warning, "not-read",
                           "is not read: it lies beside museum.toml",
                           "files of exhibits belong in exhibits/, and words in words/"));
  }
  std::ranges::sort(strays, {}, &Diagnostic::file);
  return strays;
}

}  // namespace docent::config
