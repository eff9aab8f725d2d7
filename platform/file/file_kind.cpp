#include "platform/file/file_kind.h"

#include <algorithm>
#include <array>

namespace docent::file {

namespace {

using namespace std::string_view_literals;
using For = FileKind::For;

/// A mark at a fixed place of the file.
struct Mark {
  std::size_t at;
  std::string_view bytes;
  FileKind kind;
};

constexpr std::string_view as_picture = "save it as PNG, JPEG, WebP or SVG";
constexpr std::string_view as_dxf =
    "save it as DXF in the program that made it; docent-content import reads that";
constexpr std::string_view as_geojson = "save the plan as GeoJSON in the program that made it";
constexpr std::string_view as_text =
    "save it as plain text: in TextEdit, Format, Make Plain Text; in Word, Save as, Plain text, "
    "UTF-8";
constexpr std::string_view as_csv = "save the sheet as CSV UTF-8";
constexpr std::string_view copy_again =
    "it was not copied whole: copy it again, or take it from a backup";
constexpr std::string_view unpack = "unpack it first";
constexpr std::string_view is_it_right = "is this the right file?";
constexpr std::string_view as_drawing =
    "save the drawing as DXF or SVG in the program that made it";
constexpr std::string_view as_model =
    "a plan has rooms and doors: ask the architect for DXF or IFC; figures are for docent-content "
    "figure";
constexpr std::string_view as_ifc =
    "in Revit, export it as IFC (File, Export, IFC), with rooms; save words as plain text";

constexpr std::array<Mark, 42> marks{{
    {0, "\x89PNG\r\n\x1a\n"sv, {"a PNG picture", For::Picture}},
    {0, "\xff\xd8\xff"sv, {"a JPEG picture", For::Picture}},
    {0, "GIF87a"sv, {"a GIF picture", For::Picture}},
    {0, "GIF89a"sv, {"a GIF picture", For::Picture}},
    {8, "WEBPVP8"sv, {"a WebP picture", For::Picture}},
    {4, "ftypheic"sv, {"a HEIC picture", For::Picture}},
    {4, "ftypheix"sv, {"a HEIC picture", For::Picture}},
    {4, "ftypmif1"sv, {"a HEIF picture", For::Picture}},
    {4, "ftypmsf1"sv, {"a HEIF picture", For::Picture}},
    {4, "ftypavif"sv, {"an AVIF picture", For::Picture}},
    {0, "II*\0"sv, {"a TIFF picture", For::Nothing, as_picture}},
    {0, "MM\0*"sv, {"a TIFF picture", For::Nothing, as_picture}},
    {0, "8BPS"sv, {"a Photoshop picture", For::Nothing, as_picture}},
    {0, "\0\0\1\0"sv, {"an icon", For::Nothing, as_picture}},
    {0,
     "%PDF"sv,
     {"a PDF file", For::Nothing,
      "save the page as SVG or PNG; of a plan ask for the DXF, or make an SVG of it: pdftocairo "
      "-svg"}},
    {0, "%!PS"sv, {"a PostScript file", For::Nothing, as_picture}},
    {4,
     "ftyp"sv,
     {"a film", For::Nothing, "save it as WebM (VP9), or one picture of it as PNG or JPEG"}},
    {0, "\x1a\x45\xdf\xa3"sv, {"a video (WebM, MKV)", For::Nothing, is_it_right}},
    {0, "AC10"sv, {"a DWG drawing", For::Nothing, as_dxf}},
    {0, "AutoCAD Binary DXF"sv, {"a DXF drawing", For::Plan}},
    {0, "ISO-10303-21"sv, {"an IFC building model", For::Plan}},
    {4, "\x0a\x09OSMHeader"sv, {"an OpenStreetMap extract (PBF)", For::Plan}},
    {0, "\xff\xfe\xff\x0eS\0k\0e\0t\0c\0h\0U\0p\0"sv, {"a SketchUp model", For::Nothing, as_dxf}},
    {0, "(DWF V"sv, {"a DWF drawing", For::Nothing, as_dxf}},
    {0, "\x08\x09\xfe\x02"sv, {"a MicroStation drawing (DGN)", For::Nothing, as_dxf}},
    {0, "3D Geometry File Format"sv, {"a Rhino model (3DM)", For::Nothing, as_dxf}},
    {0, "Kaydara FBX"sv, {"a 3D model (FBX)", For::Nothing, as_model}},
    {0, "glTF"sv, {"a 3D model (glTF)", For::Nothing, as_model}},
    {40, " EMF"sv, {"a Windows metafile (EMF)", For::Nothing, "save it as SVG"}},
    {0, "\0\0\x27\x0a"sv, {"a shapefile", For::Nothing, as_geojson}},
    {0, "SQLite format 3"sv, {"a database (SQLite, GeoPackage)", For::Nothing, as_geojson}},
    {0, "PK\5\6"sv, {"an empty ZIP archive", For::Nothing, is_it_right}},
    {0, "\x1f\x8b"sv, {"a packed file (gzip)", For::Nothing, unpack}},
    {0, "7z\xbc\xaf"sv, {"a packed file (7z)", For::Nothing, unpack}},
    {0, "Rar!"sv, {"a packed file (RAR)", For::Nothing, unpack}},
    {0, "{\\rtf"sv, {"a text of a word processor (RTF)", For::Nothing, as_text}},
    {0,
     "\x7f"
     "ELF"sv,
     {"a program", For::Nothing, is_it_right}},
    {0, "MZ\x90\0"sv, {"a program", For::Nothing, is_it_right}},
    {0, "RIFF"sv, {"a sound or a film", For::Nothing, is_it_right}},
    {0,
     "book\0\0\0\0mark"sv,
     {"an alias, as a Mac makes them", For::Nothing, "copy the file itself here"}},
    {0,
     "version https://git-lfs"sv,
     {"a pointer of Git LFS in place of the file", For::Nothing, "fetch the file: git lfs pull"}},
    {0,
     "[InternetShortcut]"sv,
     {"a shortcut to a web page", For::Nothing, "download the file itself, not the page about it"}},
}};

/// A word near the beginning of a file that is text.
struct Word {
  std::string_view word;
  FileKind kind;
};
constexpr std::string_view download = "download the file itself, not the page about it";
constexpr std::array<Word, 13> words{{
    {"<svg", {"an SVG drawing", For::Picture}},
    {"<osm", {"an OpenStreetMap file", For::Plan}},
    {"IndoorFeatures", {"an IndoorGML plan", For::Plan}},
    {"CityModel", {"a CityGML model", For::Nothing, as_geojson}},
    {"<gbxml", {"a gbXML model", For::Nothing, "export it as IFC, with rooms"}},
    {"<ifcxml", {"an IFC model as XML", For::Nothing, "export it as IFC in its text form (.ifc)"}},
    {"<COLLADA", {"a 3D model (COLLADA)", For::Nothing, as_model}},
    {"<kml", {"a KML file", For::Nothing, as_geojson}},
    {"<gpx", {"a GPX track", For::Nothing, "draw the floor as areas and save it as GeoJSON"}},
    {"<building", {"a building's XML plan", For::Plan}},
    {"<!doctype html", {"a web page", For::Nothing, download}},
    {"<html", {"a web page", For::Nothing, download}},
    {"<xliff", {"an XLIFF translation", For::Nothing, "docent-content translate --in reads it"}},
}};

/// What programs pack into a ZIP archive, by names of files in it.
constexpr std::array<Word, 14> packed{{
    {"visio/", {"a Visio drawing", For::Nothing, as_drawing}},
    {"word/", {"a Word document", For::Nothing, as_text}},
    {"xl/", {"an Excel workbook", For::Nothing, as_csv}},
    {"ppt/", {"a PowerPoint presentation", For::Nothing, as_picture}},
    {"dwf/", {"a DWFx drawing", For::Nothing, as_dxf}},
    {"[Content_Types]",
     {"a document of Word, Excel or PowerPoint", For::Nothing,
      "save a sheet as CSV UTF-8, and words as plain text"}},
    {"Home.xml", {"a Sweet Home 3D plan", For::Nothing, "export its plan as SVG"}},
    {"opendocument.text", {"a LibreOffice text", For::Nothing, as_text}},
    {"opendocument.spreadsheet", {"a LibreOffice spreadsheet", For::Nothing, as_csv}},
    {"vnd.oasis.opendocument", {"a LibreOffice document", For::Nothing, "save a drawing as SVG"}},
    {".kml", {"a KMZ file", For::Nothing, as_geojson}},
    {"GuiDocument.xml", {"a FreeCAD model", For::Nothing, "export it as IFC or DXF"}},
    {"Index/Document.iwa",
     {"a document of Pages, Numbers or Keynote", For::Nothing,
      "export a sheet as CSV, and words as plain text"}},
    {"venue.geojson", {"an IMDF archive", For::Plan}},
}};

/// What Microsoft's compound files hold, by names of streams in UTF-16.
constexpr std::array<Word, 4> streams{{
    {"R\0e\0v\0i\0t\0"sv, {"a Revit model", For::Nothing, as_ifc}},
    {"B\0a\0s\0i\0c\0F\0i\0l\0e\0I\0n\0f\0o\0"sv, {"a Revit model", For::Nothing, as_ifc}},
    {"V\0i\0s\0i\0o\0"sv, {"a Visio drawing", For::Nothing, as_drawing}},
    {"W\0o\0r\0d\0D\0o\0c\0"sv, {"an old Word document", For::Nothing, as_text}},
}};

bool is_letter(char c) noexcept {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

char small(char c) noexcept {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool holds(std::string_view text, std::string_view word) noexcept {
  return !std::ranges::search(text, word, [](char a, char b) {
            return small(a) == small(b);
          }).empty();
}

/// A DXF of text begins with the group code 0 and SECTION, or with remarks of code 999.
bool is_text_dxf(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  if (first == std::string_view::npos) return false;
  text.remove_prefix(first);
  const bool begins = text.starts_with("0\n") || text.starts_with("0\r") || text.starts_with("999");
  return begins && holds(text.substr(0, 4096), "SECTION");
}

/// A BMP says how large it is, and then four bytes that are zero.
bool is_bmp(std::string_view bytes) noexcept {
  return bytes.starts_with("BM") &&
         bytes.substr(std::min<std::size_t>(6, bytes.size()), 4) == "\0\0\0\0"sv;
}

/// A 3D model of lines such as "v 1.0 2.0 3.0", usually after a remark.
bool is_obj(std::string_view beginning) noexcept {
  return (beginning.starts_with("# ") || beginning.starts_with("mtllib ") ||
          beginning.starts_with("v ")) &&
         (beginning.starts_with("v ") || beginning.find("\nv ") != std::string_view::npos) &&
         beginning.find('=') == std::string_view::npos;
}

/// Well-known text: POLYGON((0 0, 1 0, 1 1, 0 0)).
bool is_wkt(std::string_view beginning) noexcept {
  for (const std::string_view word :
       {"POLYGON", "MULTIPOLYGON", "LINESTRING", "GEOMETRYCOLLECTION"})
    if (beginning.starts_with(word) && beginning.substr(0, 64).find('(') != std::string_view::npos)
      return true;
  return false;
}

/// An archive's names stand before each file and, once more, at its end.
FileKind kind_of_archive(std::string_view bytes) noexcept {
  constexpr std::size_t enough = 65536;
  const std::string_view first = bytes.substr(0, enough);
  const std::string_view last = bytes.substr(bytes.size() - std::min(bytes.size(), enough));
  for (const Word& word : packed)
    if (first.find(word.word) != std::string_view::npos ||
        last.find(word.word) != std::string_view::npos)
      return word.kind;
  return {"a ZIP archive", For::Nothing,
          "unpack it, and name the files in it; docent-content import reads archives of IMDF and "
          "IFC"};
}

FileKind kind_of_compound(std::string_view bytes) noexcept {
  for (const Word& stream : streams)
    if (bytes.find(stream.word) != std::string_view::npos) return stream.kind;
  return {"a file of Revit, or of an old Visio, Word or Excel", For::Nothing,
          "save a model as IFC, a drawing as DXF or SVG, a table as CSV, words as plain text"};
}

}  // namespace

FileKind file_kind(std::string_view bytes) noexcept {
  const std::string_view beginning = bytes.substr(0, 4096);
  if (!beginning.empty() && beginning.find_first_not_of('\0') == std::string_view::npos)
    return {"nothing but zero bytes", For::Nothing, copy_again};
  for (const Mark& mark : marks)
    if (bytes.size() > mark.at && bytes.substr(mark.at).starts_with(mark.bytes)) return mark.kind;
  if (bytes.starts_with("PK\3\4")) return kind_of_archive(bytes);
  if (bytes.starts_with("\xd0\xcf\x11\xe0")) return kind_of_compound(bytes);
  if (is_bmp(bytes)) return {"a BMP picture", For::Nothing, as_picture};
  if (is_text_dxf(bytes)) return {"a DXF drawing", For::Plan};
  if (is_wkt(beginning)) return {"a plan as well-known text (WKT)", For::Nothing, as_geojson};
  if (is_obj(beginning)) return {"a 3D model (OBJ)", For::Nothing, as_dxf};
  const std::size_t first = beginning.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (first == std::string_view::npos || beginning[first] != '<') return {};
  for (const Word& word : words)
    if (holds(beginning, word.word)) return word.kind;
  const bool is_xml =
      first + 1 < beginning.size() && (beginning[first + 1] == '?' || beginning[first + 1] == '!' ||
                                       is_letter(beginning[first + 1]));
  return is_xml ? FileKind{"an XML file", For::Nothing, is_it_right} : FileKind{};
}

}  // namespace docent::file
