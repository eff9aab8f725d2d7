#include <zlib.h>

#include <stdexcept>

namespace docent::import {
/// A field is of another type than the format says.
struct DamagedField : std::runtime_error {
  using std::runtime_error::runtime_error;
};
}  // namespace docent::import
// What protozero asserts of its callers is what a damaged file breaks.
#define protozero_assert(promise) \
  ((promise) ? void() : throw docent::import::DamagedField("a field is of another type"))
#include <protozero/pbf_reader.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string_view>

#include "content/content_error.h"
#include "content/import/osm/osm_data.h"

// The wiki's "PBF Format": blocks of a length, a BlobHeader and a Blob; each OSMData blob is a
// PrimitiveBlock with a table of strings and groups of nodes, ways and relations.
namespace docent::import {
namespace {

using protozero::pbf_reader;

[[noreturn]] void fail(const std::string& file, const std::string& message) {
  throw content::ContentError(file, 0, 0, "invalid-pbf", message,
                              "download or export the extract again");
}

constexpr std::size_t largest_header = 64 << 10;  ///< The format's own limits.
constexpr std::size_t largest_blob = 32 << 20;

std::string inflate(const std::string& file, std::string_view packed, std::size_t size) {
  if (size > largest_blob) fail(file, "a block says that it is larger than the format allows");
  std::string raw(size, '\0');
  uLongf length = size;
  const int fault = uncompress(reinterpret_cast<Bytef*>(raw.data()), &length,
                               reinterpret_cast<const Bytef*>(packed.data()), packed.size());
  if (fault != Z_OK || length != size) fail(file, "a block is damaged: it cannot be unpacked");
  return raw;
}

/// A blob's bytes, unpacked.
std::string content_of(const std::string& file, std::string_view blob) {
  pbf_reader reader(blob.data(), blob.size());
  std::string raw;
  std::string_view packed;
  std::size_t size = 0;
  bool other = false;
  while (reader.next()) {
    if (reader.tag() == 1) {
      const auto view = reader.get_view();
      raw.assign(view.data(), view.size());
    } else if (reader.tag() == 2) {
      size = static_cast<std::size_t>(std::max(reader.get_int32(), 0));
    } else if (reader.tag() == 3) {
      const auto view = reader.get_view();
      packed = {view.data(), view.size()};
    } else {
      other = other || reader.tag() >= 4;
      reader.skip();
    }
  }
  if (!raw.empty()) return raw;
  if (!packed.empty()) return inflate(file, packed, size);
  if (other) fail(file, "its blocks are packed by something other than zlib");
  return {};
}

class PrimitiveBlock {
 public:
  PrimitiveBlock(std::string_view bytes, const std::string& file, OsmData& data)
      : bytes_(bytes), file_(file), data_(data) {}

  void read() {
    pbf_reader reader(bytes_.data(), bytes_.size());
    while (reader.next()) {
      if (reader.tag() == 1)
        read_strings(reader.get_message());
      else if (reader.tag() == 17)
        granularity_ = reader.get_int32();
      else if (reader.tag() == 19)
        latitude_offset_ = reader.get_int64();
      else if (reader.tag() == 20)
        longitude_offset_ = reader.get_int64();
      else
        reader.skip();
    }
    pbf_reader groups(bytes_.data(), bytes_.size());
    while (groups.next(2)) read_group(groups.get_message());
  }

 private:
  void read_strings(pbf_reader reader) {
    while (reader.next(1)) strings_.push_back(std::string(reader.get_view()));
  }

  const std::string& text(std::uint64_t index) const {
    if (index >= strings_.size()) fail(file_, "a tag points outside the table of strings");
    return strings_[index];
  }

  void read_group(pbf_reader group) {
    while (group.next()) {
      if (group.tag() == 1)
        read_node(group.get_message());
      else if (group.tag() == 2)
        read_dense(group.get_message());
      else if (group.tag() == 3)
        read_way(group.get_message());
      else if (group.tag() == 4)
        read_relation(group.get_message());
      else
        group.skip();
    }
  }

  void add_node(std::int64_t id, std::int64_t longitude, std::int64_t latitude, OsmTags tags) {
    const auto degrees = [&](std::int64_t offset, std::int64_t value) {
      return 1e-9 * (static_cast<double>(offset) +
                     static_cast<double>(granularity_) * static_cast<double>(value));
    };
    const Vec2 at{degrees(longitude_offset_, longitude), degrees(latitude_offset_, latitude)};
    if (std::abs(at.x) > 180 || std::abs(at.y) > 90)
      fail(file_, "a node lies on no globe: its latitude or longitude is out of range");
    data_.nodes[id] = {at, std::move(tags), {file_}};
  }

  void read_node(pbf_reader node) {
    std::int64_t id = 0, longitude = 0, latitude = 0;
    protozero::iterator_range<pbf_reader::const_uint32_iterator> keys, values;
    while (node.next()) {
      if (node.tag() == 1)
        id = node.get_sint64();
      else if (node.tag() == 2)
        keys = node.get_packed_uint32();
      else if (node.tag() == 3)
        values = node.get_packed_uint32();
      else if (node.tag() == 8)
        latitude = node.get_sint64();
      else if (node.tag() == 9)
        longitude = node.get_sint64();
      else
        node.skip();
    }
    add_node(id, longitude, latitude, tags_of(keys, values));
  }

  template <typename Range>
  OsmTags tags_of(Range keys, Range values) const {
    OsmTags tags;
    auto value = values.begin();
    for (auto key = keys.begin(); key != keys.end() && value != values.end(); ++key, ++value)
      tags[text(*key)] = text(*value);
    return tags;
  }

  void read_dense(pbf_reader dense) {
    protozero::iterator_range<pbf_reader::const_sint64_iterator> ids, latitudes, longitudes;
    protozero::iterator_range<pbf_reader::const_int32_iterator> keys_values;
    while (dense.next()) {
      if (dense.tag() == 1)
        ids = dense.get_packed_sint64();
      else if (dense.tag() == 8)
        latitudes = dense.get_packed_sint64();
      else if (dense.tag() == 9)
        longitudes = dense.get_packed_sint64();
      else if (dense.tag() == 10)
        keys_values = dense.get_packed_int32();
      else
        dense.skip();
    }
    // Sums of differences: unsigned, so that those of a damaged file wrap.
    std::uint64_t id = 0, latitude = 0, longitude = 0;
    auto at_latitude = latitudes.begin();
    auto at_longitude = longitudes.begin();
    auto tag = keys_values.begin();
    for (const std::int64_t difference : ids) {
      if (at_latitude == latitudes.end() || at_longitude == longitudes.end())
        fail(file_, "it has fewer coordinates than nodes");
      id += static_cast<std::uint64_t>(difference);
      latitude += static_cast<std::uint64_t>(*at_latitude++);
      longitude += static_cast<std::uint64_t>(*at_longitude++);
      OsmTags tags;
      while (tag != keys_values.end() && *tag != 0) {
        const auto key = static_cast<std::uint32_t>(*tag++);
        if (tag == keys_values.end()) break;
        tags[text(key)] = text(static_cast<std::uint32_t>(*tag++));
      }
      if (tag != keys_values.end()) ++tag;
      add_node(static_cast<std::int64_t>(id), static_cast<std::int64_t>(longitude),
               static_cast<std::int64_t>(latitude), std::move(tags));
    }
  }

  void read_way(pbf_reader way) {
    OsmWay made{.placed = {file_}};
    protozero::iterator_range<pbf_reader::const_uint32_iterator> keys, values;
    while (way.next()) {
      if (way.tag() == 1)
        made.id = way.get_int64();
      else if (way.tag() == 2)
        keys = way.get_packed_uint32();
      else if (way.tag() == 3)
        values = way.get_packed_uint32();
      else if (way.tag() == 8)
        made.nodes = sums(way.get_packed_sint64());
      else
        way.skip();
    }
    made.tags = tags_of(keys, values);
    data_.ways.push_back(std::move(made));
  }

  template <typename Range>
  static std::vector<std::int64_t> sums(Range differences) {
    std::vector<std::int64_t> ids;
    std::uint64_t id = 0;
    for (const std::int64_t difference : differences) {
      id += static_cast<std::uint64_t>(difference);
      ids.push_back(static_cast<std::int64_t>(id));
    }
    return ids;
  }

  void read_relation(pbf_reader relation) {
    OsmRelation made{.placed = {file_}};
    protozero::iterator_range<pbf_reader::const_uint32_iterator> keys, values;
    std::vector<std::int64_t> members;
    std::vector<std::int32_t> roles, kinds;
    while (relation.next()) {
      if (relation.tag() == 1)
        made.id = relation.get_int64();
      else if (relation.tag() == 2)
        keys = relation.get_packed_uint32();
      else if (relation.tag() == 3)
        values = relation.get_packed_uint32();
      else if (relation.tag() == 8) {
        for (const std::int32_t role : relation.get_packed_int32()) roles.push_back(role);
      } else if (relation.tag() == 9) {
        members = sums(relation.get_packed_sint64());
      } else if (relation.tag() == 10) {
        for (const std::int32_t kind : relation.get_packed_enum()) kinds.push_back(kind);
      } else {
        relation.skip();
      }
    }
    made.tags = tags_of(keys, values);
    constexpr std::int32_t way = 1;
    for (std::size_t i = 0; i < std::min({members.size(), roles.size(), kinds.size()}); ++i)
      if (kinds[i] == way)
        made.members.push_back({members[i], text(static_cast<std::uint32_t>(roles[i])) == "inner"});
    data_.relations.push_back(std::move(made));
  }

  std::string_view bytes_;
  const std::string& file_;
  OsmData& data_;
  std::vector<std::string> strings_;
  std::int64_t granularity_ = 100, latitude_offset_ = 0, longitude_offset_ = 0;
};

std::string_view take(const std::string& file, std::string_view& bytes, std::size_t count) {
  if (count > bytes.size()) fail(file, "the file is cut short");
  const std::string_view taken = bytes.substr(0, count);
  bytes.remove_prefix(count);
  return taken;
}

void read_block(const std::string& file, std::string_view& bytes, OsmData& data) {
  std::size_t header_size = 0;
  for (const char byte : take(file, bytes, 4))
    header_size = header_size << 8 | static_cast<unsigned char>(byte);
  if (header_size > largest_header) fail(file, "this is no PBF of OpenStreetMap's");
  const std::string_view header = take(file, bytes, header_size);
  pbf_reader reader(header.data(), header.size());
  std::string kind;
  std::size_t blob_size = 0;
  while (reader.next()) {
    if (reader.tag() == 1)
      kind = reader.get_string();
    else if (reader.tag() == 3)
      blob_size = static_cast<std::size_t>(std::max(reader.get_int32(), 0));
    else
      reader.skip();
  }
  const std::string_view blob = take(file, bytes, blob_size);
  if (kind != "OSMData") return;
  const std::string content = content_of(file, blob);
  PrimitiveBlock(content, file, data).read();
}

}  // namespace

OsmData read_osm_pbf(const std::string& file, std::string_view bytes) {
  OsmData data;
  try {
    while (!bytes.empty()) read_block(file, bytes, data);
  } catch (const protozero::exception&) {
    fail(file, "a block is damaged: it is no message of the format");
  } catch (const DamagedField&) {
    fail(file, "a block is damaged: its fields are of other types than the format's");
  }
  return data;
}

}  // namespace docent::import
