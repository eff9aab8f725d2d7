#include "content/import/drawing/code_page.h"

#include <iconv.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "platform/file/text_encoding.h"

namespace docent::import {
namespace {

/// What iconv calls a code page of AutoCAD: the digits behind `ANSI_` or `dos`.
std::string iconv_name(std::string_view code_page) {
  std::string digits;
  for (const char c : code_page)
    if (std::isdigit(static_cast<unsigned char>(c))) digits += c;
  if (digits == "1361") return "JOHAB";
  return digits.empty() ? std::string() : "CP" + digits;
}

std::optional<std::string> converted(std::string_view bytes, const std::string& from) {
  const iconv_t handle = iconv_open("UTF-8", from.c_str());
  // NOLINTNEXTLINE(performance-no-int-to-ptr): as POSIX has it
  if (handle == reinterpret_cast<iconv_t>(-1)) return std::nullopt;
  std::string in(bytes), out(bytes.size() * 4 + 4, '\0');
  char* in_at = in.data();
  char* out_at = out.data();
  std::size_t in_left = in.size(), out_left = out.size();
  const std::size_t result = iconv(handle, &in_at, &in_left, &out_at, &out_left);
  iconv_close(handle);
  if (result == static_cast<std::size_t>(-1)) return std::nullopt;
  out.resize(out.size() - out_left);
  return out;
}

bool is_ascii(std::string_view bytes) {
  return std::ranges::all_of(bytes, [](char c) { return static_cast<unsigned char>(c) < 0x80; });
}

}  // namespace

std::string to_utf8(std::string_view bytes, std::string_view code_page) {
  if (is_ascii(bytes)) return std::string(bytes);
  const std::string stated = iconv_name(code_page);
  // Two bytes of a Chinese letter may be UTF-8, too; a text of single bytes hardly ever is.
  const bool of_two_bytes = stated == "CP932" || stated == "CP936" || stated == "CP949" ||
                            stated == "CP950" || stated == "JOHAB";
  if (!of_two_bytes && !file::encoding_fault(bytes)) return std::string(bytes);
  if (!stated.empty())
    if (auto text = converted(bytes, stated)) return *text;
  // Nothing stated: Shift-JIS refuses most texts that are not Japanese, Windows-1252 takes nearly
  // all.
  if (stated.empty())
    for (const char* guess : {"CP932", "CP1252"})
      if (auto text = converted(bytes, guess)) return *text;
  return file::shown_as_utf8(bytes);
}

}  // namespace docent::import
