#include "content/import/building/write_museum.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "content/content_error.h"
#include "content/import/building/keep_edits.h"
#include "content/read_source.h"
#include "platform/file/write_file.h"

namespace docent::import {
namespace {

namespace fs = std::filesystem;

constexpr const char* last_import = "imported";

std::optional<std::string> text_of(const fs::path& file) {
  std::error_code fault;
  if (!fs::is_regular_file(file, fault)) return {};
  return content::read_source(file);
}

void make_folder(const fs::path& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault)
    throw content::ContentError(
        Errc::Environment, folder.string(), "cannot-write",
        fmt::format("the folder cannot be made: {}", fault.message()),
        "is there a file of that name, or no permission? Name another folder with -o");
}

void write(const fs::path& file, const std::string& text) {
  make_folder(file.parent_path());
  if (const auto written = file::replace_file(file, std::as_bytes(std::span(text))); !written)
    throw content::to_content_error(written.error(), file.string(), "cannot-write");
}

class FolderUpdate {
 public:
  explicit FolderUpdate(const fs::path& museum) : museum_(museum) {}

  void update(const MuseumText& next) {
    const fs::path file = museum_ / next.name, base_file = museum_ / last_import / next.name;
    const auto mine = text_of(file), base = text_of(base_file);
    std::string text = next.text;
    if (mine && next.name == "museum.toml") {
      MergedToml merged = keep_edits(base.value_or(""), *mine, next.text);
      for (const Edit& edit : merged.edits) tell(file, edit);
      text = std::move(merged.text);
    } else if (mine && *mine != next.text && (!base || *mine != *base)) {
      text = keep_plan(next, *mine, base);
    }
    pending_.emplace_back(file, std::move(text));
    pending_.emplace_back(base_file, next.text);
  }

  std::vector<Diagnostic> finish() && {
    for (const auto& [file, text] : pending_) write(file, text);
    return std::move(told_);
  }

 private:
  /// A plan that staff have drawn in is not merged: theirs stays, the new one lies beside it.
  std::string keep_plan(const MuseumText& next, const std::string& mine,
                        const std::optional<std::string>& base) {
    if (base && *base == next.text) {
      tell(museum_ / next.name, 0, "kept-by-hand", "this plan was changed by hand and is kept",
           "nothing has changed in the source");
      return mine;
    }
    fs::path beside = museum_ / next.name;
    beside.replace_extension(".new.geojson");
    pending_.emplace_back(beside, next.text);
    tell(museum_ / next.name, 0, "kept-by-hand",
         "this plan was changed by hand and is kept, although its source has changed",
         fmt::format("the new plan is {}: take it over, or delete it", beside.string()));
    return mine;
  }

  void tell(const fs::path& file, const Edit& edit) {
    switch (edit.kind) {
      case Edit::Kind::Kept:
        return tell(file, edit.line, "kept-by-hand",
                    fmt::format("kept as it was written by hand: {}", edit.what),
                    "to have the plan's, delete the line and import again");
      case Edit::Kind::Changed:
        return tell(file, edit.line, "plan-changed",
                    fmt::format("changed with the plan: {}", edit.what), {});
      case Edit::Kind::Added:
        return tell(file, edit.line, "plan-added", fmt::format("new in the plan: {}", edit.what),
                    {});
      case Edit::Kind::Removed:
        return tell(file, edit.line, "plan-removed",
                    fmt::format("no longer in the plan, and taken out: {}", edit.what), {});
      case Edit::Kind::Orphan:
        return tell(
            file, edit.line, "kept-by-hand",
            fmt::format("no longer in the plan, and kept because it was changed by hand: {}",
                        edit.what),
            "delete it if it is gone");
    }
  }

  void tell(const fs::path& file, std::size_t line, std::string code, std::string message,
            std::string hint) {
    told_.push_back({.file = file.string(),
                     .line = static_cast<std::uint32_t>(line),
                     .severity = Severity::Warning,
                     .code = std::move(code),
                     .message = std::move(message),
                     .hint = std::move(hint)});
  }

  fs::path museum_;
  std::vector<std::pair<fs::path, std::string>> pending_;
  std::vector<Diagnostic> told_;
};

}  // namespace

std::vector<Diagnostic> write_museum_folder(const fs::path& museum,
                                            std::span<const MuseumText> texts) {
  if (texts.empty()) return {};
  make_folder(museum);
  FolderUpdate update(museum);
  for (const MuseumText& text : texts) update.update(text);
  return std::move(update).finish();
}

}  // namespace docent::import
