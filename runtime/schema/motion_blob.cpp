#include "runtime/schema/motion_blob.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cassert>
#include <cmath>
#include <optional>
#include <utility>

#include "runtime/model/motion/motion_grid.h"
#include "runtime/schema/bit_stream.h"
#include "runtime/schema/elements.h"

namespace docent::schema {
namespace {

using namespace motion_grid;

constexpr std::size_t block_frames = 16;
constexpr int length_bits = 4;  // of a stretch within a block
constexpr int most_ones = 24;   // of Rice's code

struct Header {
  std::uint8_t bits = 0;  ///< 0 for plain floats.
  std::uint32_t frames = 0, joints = 0;
};
void fields(auto& io, MaybeConst<Header> auto& h) {
  io(h.bits, h.frames, h.joints);
}

constexpr std::size_t header_size = 9;

/// What a joint's rotation is before the first frame.
constexpr Quat no_turn(1, 0, 0, 0);

bool same_bits(float a, float b) noexcept {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

/// What one number of a motion was in the last two frames, and how well that foretold it.
struct Predictor {
  std::int64_t last = 0, before = 0;
  std::uint64_t level = 256;

  std::int64_t foretold() const noexcept { return 2 * last - before; }
  int parameter() const noexcept { return static_cast<int>(std::bit_width(level >> 4)); }
  void learn(std::uint64_t code) noexcept {
    level += std::min<std::uint64_t>(code, 1U << 20) - (level >> 3);
  }
  void go_to(std::int64_t value) noexcept { before = std::exchange(last, value); }
};

/// The courses of a rotation's parts, and which of them is derived.
struct Turning {
  std::array<Predictor, 4> part;
  std::size_t derived = 3;
  bool negative = false;  ///< The derived part.

  explicit Turning(int bits) { part[3].last = part[3].before = steps_of(bits); }

  RotationSteps last() const noexcept {
    return {part[0].last, part[1].last, part[2].last, part[3].last};
  }
  /// Goes to the derived part of this size in steps, after the other parts.
  void derive(double size) noexcept {
    const std::int64_t steps = std::llround(size);
    part[derived].go_to(negative ? -steps : steps);
  }
  void keep_still() noexcept {
    for (Predictor& predictor : part) predictor.before = predictor.last;
  }
};

constexpr std::uint64_t code_of(std::int64_t residual) noexcept {
  const auto bits = static_cast<std::uint64_t>(residual);
  return residual < 0 ? ~(bits << 1) : bits << 1;
}
constexpr std::int64_t residual_of(std::uint64_t code) noexcept {
  return static_cast<std::int64_t>((code >> 1) ^ (~(code & 1) + 1));
}

// Encoding.

/// A root coordinate in steps; none where it lies between them or too far away.
std::optional<std::int64_t> root_steps_of(float metres) noexcept {
  const double steps = static_cast<double>(metres) * root_steps;
  if (!(std::abs(steps) <= static_cast<double>(most_root_steps))) return {};
  const auto whole = static_cast<std::int64_t>(std::llround(steps));
  if (!same_bits(root_at(whole), metres)) return {};
  return whole;
}

/// A rotation on the finest grid: which parts could be the derived one, and how it lies on a grid.
struct GridRotation {
  RotationSteps steps{};
  std::array<bool, 4> may_derive{};

  bool is_negative(std::size_t part) const noexcept { return steps[part] < 0; }
};

GridRotation on_finest_grid(const Quat& q) noexcept {
  GridRotation rotation;
  std::array<bool, 4> is_whole{};
  for (std::size_t i = 0; i < 4; ++i) {
    const float part = part_of(q, i);
    if (!(std::abs(part) <= 1)) return rotation;
    rotation.steps[i] = std::lround(part * static_cast<float>(steps_of(most_bits)));
    is_whole[i] = same_bits(part_at(rotation.steps[i], most_bits), part);
  }
  for (std::size_t i = 0; i < 4; ++i) {
    const double size = derived_steps(rotation.steps, i, most_bits);
    const float derived = derived_at(rotation.is_negative(i) ? -size : size, most_bits);
    rotation.may_derive[i] = size >= 0 && same_bits(derived, part_of(q, i));
    for (std::size_t other = 0; other < 4; ++other)
      if (other != i && !is_whole[other]) rotation.may_derive[i] = false;
  }
  return rotation;
}

/// Bits of the coarsest grid on which all parts but the derived one lie.
int bits_of(const GridRotation& rotation, std::size_t derived) noexcept {
  auto any = static_cast<std::uint64_t>(steps_of(most_bits));
  for (std::size_t i = 0; i < 4; ++i)
    if (i != derived) any |= static_cast<std::uint64_t>(rotation.steps[i]);
  return std::max(most_bits - std::countr_zero(any), least_bits);
}

/// A clip in steps of its grid (rotations: of the finest).
struct GridMotion {
  int bits = least_bits;
  std::vector<std::array<std::int64_t, 3>> root;
  std::vector<GridRotation> rotation;
};

/// The clip on the coarsest grid that has all of it; none where no grid has.
std::optional<GridMotion> on_grid(const MotionClip& clip) {
  GridMotion motion;
  motion.root.reserve(clip.root.size());
  for (const Vec3& place : clip.root) {
    const auto x = root_steps_of(place.x), y = root_steps_of(place.y), z = root_steps_of(place.z);
    if (!x || !y || !z) return {};
    motion.root.push_back({*x, *y, *z});
  }
  motion.rotation.reserve(clip.rotation.size());
  for (const Quat& q : clip.rotation) {
    const GridRotation& rotation = motion.rotation.emplace_back(on_finest_grid(q));
    int fewest = most_bits + 1;
    for (std::size_t i = 0; i < 4; ++i)
      if (rotation.may_derive[i]) fewest = std::min(fewest, bits_of(rotation, i));
    if (fewest > most_bits) return {};
    motion.bits = std::max(motion.bits, fewest);
  }
  for (GridRotation& rotation : motion.rotation)
    for (std::size_t i = 0; i < 4; ++i)
      if (bits_of(rotation, i) > motion.bits) rotation.may_derive[i] = false;
  return motion;
}

class Encoder {
 public:
  Encoder(const MotionClip& clip, const GridMotion& motion, std::vector<std::byte> header)
      : clip_(clip), motion_(motion), out_(std::move(header)) {}

  std::vector<std::byte> encode() && {
    const std::size_t frames = clip_.root.size();
    std::vector<Turning> joint(frames > 0 ? clip_.joint_count : 0, Turning(motion_.bits));
    std::array<Predictor, 3> root{};
    for (std::size_t first = 0; first < frames; first += block_frames) {
      const std::size_t end = std::min(first + block_frames, frames);
      for (std::size_t f = first; f < end; ++f) {
        out_.put_flag(clip_.plants[f].left);
        out_.put_flag(clip_.plants[f].right);
      }
      for (std::size_t f = first; f < end; ++f)
        for (std::size_t i = 0; i < root.size(); ++i) put(root[i], motion_.root[f][i]);
      for (std::size_t j = 0; j < joint.size(); ++j) put_block(joint[j], j, first, end);
    }
    return std::move(out_).take_bytes();
  }

 private:
  std::size_t place_of(std::size_t frame, std::size_t joint) const {
    return frame * clip_.joint_count + joint;
  }

  void put(Predictor& predictor, std::int64_t value) {
    const std::uint64_t code = code_of(value - predictor.foretold());
    const int low = predictor.parameter();
    const std::uint64_t ones = code >> low;
    if (ones < most_ones) {
      out_.put((std::uint64_t{2} << ones) - 2, static_cast<int>(ones) + 1);
      out_.put(code, low);
    } else {
      out_.put((std::uint64_t{1} << most_ones) - 1, most_ones);
      out_.put(code, 64);
    }
    predictor.learn(code);
    predictor.go_to(value);
  }

  void put_block(Turning& turning, std::size_t joint, std::size_t first, std::size_t end) {
    const bool turns = !keeps_still(joint, first, end);
    out_.put_flag(turns);
    if (!turns) turning.keep_still();
    while (turns && first < end) first = put_stretch(turning, joint, first, end);
  }

  bool keeps_still(std::size_t joint, std::size_t first, std::size_t end) const {
    const Quat before = first == 0 ? no_turn : clip_.rotation[place_of(first - 1, joint)];
    for (std::size_t f = first; f < end; ++f)
      for (std::size_t i = 0; i < 4; ++i)
        if (!same_bits(part_of(clip_.rotation[place_of(f, joint)], i), part_of(before, i)))
          return false;
    return true;
  }

  /// Where the frames from `first` on that can derive this part with one sign end.
  std::size_t reach(std::size_t joint, std::size_t derived, std::size_t first,
                    std::size_t end) const {
    const bool negative = motion_.rotation[place_of(first, joint)].is_negative(derived);
    std::size_t f = first;
    for (; f < end; ++f) {
      const GridRotation& rotation = motion_.rotation[place_of(f, joint)];
      if (!rotation.may_derive[derived] || rotation.is_negative(derived) != negative) break;
    }
    return f;
  }

  /// Writes frames that derive the same part; returns where they end.
  std::size_t put_stretch(Turning& turning, std::size_t joint, std::size_t first, std::size_t end) {
    std::size_t derived = turning.derived;
    for (std::size_t i = 0; i < 4; ++i)
      if (reach(joint, i, first, end) > reach(joint, derived, first, end)) derived = i;
    const bool negative = motion_.rotation[place_of(first, joint)].is_negative(derived);
    const std::size_t stop = reach(joint, derived, first, end);

    const bool changes = derived != turning.derived || negative != turning.negative;
    out_.put_flag(changes);
    if (changes) {
      out_.put(derived, 2);
      out_.put_flag(negative);
      turning.derived = derived;
      turning.negative = negative;
    }
    out_.put_flag(stop < end);
    if (stop < end) out_.put(stop - first - 1, length_bits);
    for (std::size_t f = first; f < stop; ++f) put(turning, motion_.rotation[place_of(f, joint)]);
    return stop;
  }

  void put(Turning& turning, const GridRotation& rotation) {
    const std::int64_t finer = steps_of(most_bits) / steps_of(motion_.bits);
    for (std::size_t i = 0; i < 4; ++i)
      if (i != turning.derived) put(turning.part[i], rotation.steps[i] / finer);
    turning.derive(derived_steps(turning.last(), turning.derived, motion_.bits));
  }

  const MotionClip& clip_;
  const GridMotion& motion_;
  BitWriter out_;
};

class Decoder {
 public:
  /// `clip` has room for all frames.
  Decoder(std::span<const std::byte> bytes, int bits, MotionClip& clip)
      : in_(bytes), bits_(bits), clip_(clip) {}

  [[nodiscard]] bool decode() {
    const std::size_t frames = clip_.root.size();
    std::vector<Turning> joint(frames > 0 ? clip_.joint_count : 0, Turning(bits_));
    std::array<Predictor, 3> root{};
    for (std::size_t first = 0; first < frames && is_sound(); first += block_frames) {
      const std::size_t end = std::min(first + block_frames, frames);
      for (std::size_t f = first; f < end; ++f) {
        clip_.plants[f].left = in_.take_flag();
        clip_.plants[f].right = in_.take_flag();
      }
      for (std::size_t f = first; f < end; ++f) {
        for (Predictor& predictor : root) take(predictor, most_root_steps);
        clip_.root[f] = {root_at(root[0].last), root_at(root[1].last), root_at(root[2].last)};
      }
      for (std::size_t j = 0; j < joint.size(); ++j) take_block(joint[j], j, first, end);
    }
    return is_sound() && in_.is_at_end();
  }

 private:
  bool is_sound() const { return sound_ && !in_.has_overrun(); }

  Quat& rotation(std::size_t frame, std::size_t joint) {
    return clip_.rotation[frame * clip_.joint_count + joint];
  }

  void take(Predictor& predictor, std::int64_t most) {
    const int low = predictor.parameter();
    const auto ones = static_cast<std::uint64_t>(in_.take_ones(most_ones));
    std::uint64_t code = 0;
    if (ones < most_ones) {
      code = ones << low | in_.take(low);
    } else {
      code = in_.take(32) << 32;
      code |= in_.take(32);
    }
    // Damaged bytes may say anything: wraps round instead of overflowing.
    const auto value = static_cast<std::int64_t>(static_cast<std::uint64_t>(predictor.foretold()) +
                                                 static_cast<std::uint64_t>(residual_of(code)));
    sound_ = sound_ && value >= -most && value <= most;
    predictor.learn(code);
    predictor.go_to(sound_ ? value : 0);
  }

  void take_block(Turning& turning, std::size_t joint, std::size_t first, std::size_t end) {
    if (in_.take_flag()) {
      while (first < end) first = take_stretch(turning, joint, first, end);
      return;
    }
    turning.keep_still();
    const Quat still = first == 0 ? no_turn : rotation(first - 1, joint);
    for (std::size_t f = first; f < end; ++f) rotation(f, joint) = still;
  }

  std::size_t take_stretch(Turning& turning, std::size_t joint, std::size_t first,
                           std::size_t end) {
    if (in_.take_flag()) {
      turning.derived = in_.take(2);
      turning.negative = in_.take_flag();
    }
    if (in_.take_flag()) end = std::min(end, first + in_.take(length_bits) + 1);
    for (std::size_t f = first; f < end; ++f) rotation(f, joint) = take(turning);
    return end;
  }

  Quat take(Turning& turning) {
    std::array<float, 4> part{};
    for (std::size_t i = 0; i < 4; ++i)
      if (i != turning.derived) {
        take(turning.part[i], steps_of(bits_));
        part[i] = part_at(turning.part[i].last, bits_);
      }
    const double size = derived_steps(turning.last(), turning.derived, bits_);
    sound_ = sound_ && size >= 0;
    if (sound_) turning.derive(size);
    part[turning.derived] = derived_at(turning.negative ? -size : size, bits_);
    return from_parts(part);
  }

  BitReader in_;
  int bits_;
  MotionClip& clip_;
  bool sound_ = true;
};

/// Could `size` bytes hold that much? Says how much memory they may take.
bool may_hold(const Header& header, std::size_t size) noexcept {
  const std::uint64_t frames = header.frames, joints = header.joints;
  if (header.bits == 0)
    return (frames == 0 || joints <= size / frames) && size == frames * (14 + 16 * joints);
  const std::uint64_t blocks = frames / block_frames + (frames % block_frames != 0 ? 1 : 0);
  return header.bits >= least_bits && header.bits <= most_bits && frames <= 8 * size &&
         joints * blocks <= 8 * size;
}

void append(std::vector<std::byte>& bytes, const std::vector<std::byte>& more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

}  // namespace

std::vector<std::byte> encode(const MotionClip& clip) {
  assert(clip.plants.size() == clip.root.size());
  assert(clip.rotation.size() == clip.root.size() * clip.joint_count);
  const std::optional<GridMotion> motion = on_grid(clip);
  const Header header{.bits = static_cast<std::uint8_t>(motion ? motion->bits : 0),
                      .frames = frame_count(clip),
                      .joints = clip.joint_count};
  std::vector<std::byte> bytes = encode(std::span(&header, 1));
  if (motion) return Encoder(clip, *motion, std::move(bytes)).encode();
  append(bytes, encode(clip.root));
  append(bytes, encode(clip.rotation));
  append(bytes, encode(clip.plants));
  return bytes;
}

bool decode(std::span<const std::byte> bytes, MotionClip& clip) {
  if (bytes.size() < header_size) return false;
  Header header;
  schema::Decode{bytes.data()}.add(header);
  bytes = bytes.subspan(header_size);
  if (!may_hold(header, bytes.size())) return false;

  MotionClip read;
  read.joint_count = header.joints;
  if (header.bits == 0) {
    const std::size_t roots = header.frames * encoded_size<Vec3>();
    const std::size_t plants = header.frames * encoded_size<FootPlants>();
    const bool whole = decode(bytes.first(roots), read.root) &&
                       decode(bytes.subspan(roots, bytes.size() - roots - plants), read.rotation) &&
                       decode(bytes.last(plants), read.plants);
    if (!whole) return false;
  } else {
    read.root.resize(header.frames);
    read.plants.resize(header.frames);
    read.rotation.resize(std::size_t{header.frames} * header.joints);
    if (!Decoder(bytes, header.bits, read).decode()) return false;
  }
  clip.joint_count = read.joint_count;
  clip.root = std::move(read.root);
  clip.rotation = std::move(read.rotation);
  clip.plants = std::move(read.plants);
  return true;
}

}  // namespace docent::schema
