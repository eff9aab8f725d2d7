#include "runtime/schema/label_blob.h"

#include <limits>
#include <utility>

namespace docent::schema {
namespace {

constexpr std::uint32_t low_bits = 0x7f, more_follow = 0x80;
constexpr unsigned group_bits = 7;
/// An entry's cost, and a byte for each of its counts.
constexpr std::size_t least_entry = sizeof(std::uint32_t) + 3;

class CountWriter {
 public:
  void put_byte(std::uint32_t byte) { bytes_.push_back(static_cast<std::byte>(byte)); }
  void put_count(std::uint32_t count) {
    for (; count > low_bits; count >>= group_bits) put_byte((count & low_bits) | more_follow);
    put_byte(count);
  }
  void put_u32(std::uint32_t value) {
    for (unsigned shift = 0; shift < 32; shift += 8) put_byte(value >> shift & 0xff);
  }
  std::vector<std::byte> take_bytes() && { return std::move(bytes_); }

 private:
  std::vector<std::byte> bytes_;
};

/// Past the end, and after a count that is none, it has failed and reads zeros.
class CountReader {
 public:
  explicit CountReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  std::uint32_t take_byte() noexcept {
    if (next_ < bytes_.size()) return std::to_integer<std::uint32_t>(bytes_[next_++]);
    has_failed_ = true;
    return 0;
  }
  std::uint32_t take_count() noexcept {
    std::uint64_t count = 0;
    for (unsigned shift = 0; shift < 35; shift += group_bits) {
      const std::uint32_t byte = take_byte();
      count |= std::uint64_t{byte & low_bits} << shift;
      if ((byte & more_follow) != 0) continue;
      if (count > std::numeric_limits<std::uint32_t>::max()) break;
      return static_cast<std::uint32_t>(count);
    }
    has_failed_ = true;
    return 0;
  }
  std::uint32_t take_u32() noexcept {
    std::uint32_t value = 0;
    for (unsigned shift = 0; shift < 32; shift += 8) value |= take_byte() << shift;
    return value;
  }
  std::size_t left() const noexcept { return bytes_.size() - next_; }
  bool has_failed() const noexcept { return has_failed_; }

 private:
  std::span<const std::byte> bytes_;
  std::size_t next_ = 0;
  bool has_failed_ = false;
};

/// Reads one station behind those that the table holds.
bool take_station(CountReader& reader, LabelTable& table) {
  const std::uint32_t first = table.first.back(), entries = reader.take_count();
  if (entries > reader.left() / least_entry) return false;
  std::uint32_t next_hub = 0;
  for (std::uint32_t i = 0; i < entries; ++i) {
    const std::uint32_t hub = next_hub + reader.take_count();
    if (hub < next_hub) return false;
    next_hub = hub + 1;
    table.hub.push_back({hub, reader.take_u32()});
    table.link.push_back(reader.take_count() - 1);
    const std::uint32_t parent = reader.take_count();
    if (parent > entries || (next_hub == 0 && i + 1 < entries)) return false;
    table.parent.push_back(parent == 0 ? LabelTable::no_parent : first + parent - 1);
  }
  table.first.push_back(first + entries);
  return !reader.has_failed();
}

}  // namespace

std::vector<std::byte> encode(const LabelTable& table) {
  CountWriter writer;
  writer.put_count(static_cast<std::uint32_t>(table.first.size() - 1));
  for (std::size_t station = 0; station + 1 < table.first.size(); ++station) {
    const std::uint32_t first = table.first[station], last = table.first[station + 1];
    writer.put_count(last - first);
    std::uint32_t next_hub = 0;
    for (std::uint32_t e = first; e < last; ++e) {
      writer.put_count(table.hub[e].hub - next_hub);
      next_hub = table.hub[e].hub + 1;
      writer.put_u32(table.hub[e].cost);
      writer.put_count(table.link[e] + 1);
      const std::uint32_t parent = table.parent[e];
      writer.put_count(parent == LabelTable::no_parent ? 0 : parent - first + 1);
    }
  }
  return std::move(writer).take_bytes();
}

bool decode(std::span<const std::byte> bytes, LabelTable& table) {
  CountReader reader(bytes);
  const std::uint32_t stations = reader.take_count();
  if (reader.has_failed() || stations > reader.left()) return false;
  LabelTable read;
  for (std::uint32_t station = 0; station < stations; ++station)
    if (!take_station(reader, read)) return false;
  if (reader.left() > 0) return false;
  table = std::move(read);
  return true;
}

}  // namespace docent::schema
