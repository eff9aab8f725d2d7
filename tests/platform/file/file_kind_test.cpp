#include "platform/file/file_kind.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <string>

namespace docent::file::file_kind_test {
namespace {

using namespace std::string_view_literals;

TEST(FileKind, IsToldByTheFirstBytes) {
  struct Row {
    std::string_view bytes, name;
  };
  for (const Row& row :
       {Row{"\x89PNG\r\n\x1a\n", "a PNG picture"}, Row{"%PDF-1.7", "a PDF file"},
        Row{"{\\rtf1\\ansi", "a text of a word processor (RTF)"},
        Row{"BM\x36\0\0\0\0\0\0\0\x36\0"sv, "a BMP picture"},
        Row{"  0\nSECTION\n", "a DXF drawing"},
        Row{"<?xml version='1.0'?>\n<osm>", "an OpenStreetMap file"},
        Row{"\xEF\xBB\xBF<!DOCTYPE html>", "a web page"},
        Row{"# Blender\nv 1 2 3\n", "a 3D model (OBJ)"},
        Row{"POLYGON((0 0, 1 0, 1 1))", "a plan as well-known text (WKT)"},
        Row{"PK\3\4"
            "xxxx[Content_Types].xmlxxxxword/document.xml",
            "a Word document"},
        Row{"PK\3\4xxxx[Content_Types].xmlxxxxxl/workbook.xml", "an Excel workbook"},
        Row{"PK\3\4xxxxvenue.geojson", "an IMDF archive"}, Row{"PK\3\4xxxx", "a ZIP archive"},
        Row{"PK\3\4xxxxvisio/document.xml", "a Visio drawing"},
        Row{"\xd0\xcf\x11\xe0....R\0e\0v\0i\0t\0"sv, "a Revit model"},
        Row{"\xd0\xcf\x11\xe0....", "a file of Revit, or of an old Visio, Word or Excel"},
        Row{"Kaydara FBX Binary", "a 3D model (FBX)"},
        Row{"\0\0\0\0\0\0\0\0"sv, "nothing but zero bytes"},
        Row{"version https://git-lfs.github.com/spec/v1\n",
            "a pointer of Git LFS in place of the file"}})
    EXPECT_EQ(file_kind(row.bytes).name, row.name);
}

TEST(FileKind, OfOrdinaryTextHasNoName) {
  for (const std::string_view text :
       {""sv, "[museum]\ntitle.en = \"x\"\n"sv, "{\"type\": \"FeatureCollection\"}"sv, "BM = 3\n"sv,
        "# a remark\nv = 3\n"sv, "name;title\n1;x\n"sv, "<3 = true"sv})
    EXPECT_EQ(file_kind(text).name, "") << text;
}

RC_GTEST_PROP(FileKind, AnyBytesAreAnswered, (const std::string& bytes)) {
  const FileKind kind = file_kind(bytes);
  RC_ASSERT(!kind.name.empty() || kind.remedy.empty());
}

}  // namespace
}  // namespace docent::file::file_kind_test
