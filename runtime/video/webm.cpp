#include "runtime/video/webm.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "runtime/video/ebml.h"

namespace docent::video {
namespace {

/// Element identifiers: RFC 8794, section 11.2; RFC 9559, section 5.1.
enum Id : std::uint32_t {
  EbmlHead = 0x1A45DFA3,
  EbmlReadVersion = 0x42F7,
  EbmlMaxIdLength = 0x42F2,
  EbmlMaxSizeLength = 0x42F3,
  DocType = 0x4282,
  Segment = 0x18538067,
  Info = 0x1549A966,
  TimestampScale = 0x2AD7B1,
  Tracks = 0x1654AE6B,
  TrackEntry = 0xAE,
  TrackNumber = 0xD7,
  TrackType = 0x83,
  CodecId = 0x86,
  ContentEncodings = 0x6D80,
  Pictures = 0xE0,
  PixelWidth = 0xB0,
  PixelHeight = 0xBA,
  PixelCropBottom = 0x54AA,
  PixelCropTop = 0x54BB,
  PixelCropLeft = 0x54CC,
  PixelCropRight = 0x54DD,
  DisplayWidth = 0x54B0,
  DisplayHeight = 0x54BA,
  DisplayUnit = 0x54B2,
  Cluster = 0x1F43B675,
  Timestamp = 0xE7,
  SimpleBlock = 0xA3,
  BlockGroup = 0xA0,
  Block = 0xA1,
};

/// What a track says of itself.
struct Track {
  std::uint64_t number = 0, type = 0, width = 0, height = 0;
  std::uint64_t shown_width = 0, shown_height = 0, shown_unit = 0;  ///< 0: as the pixels are.
  bool is_cropped = false;                                          ///< Edges are not to be seen.
  std::string_view codec;
  bool is_packed = false;  ///< Compressed once more, or encrypted.
};

std::unexpected<Error> refusal(std::string why) {
  return std::unexpected(Error{Errc::InvalidInput, std::move(why)});
}

/// Does a coded frame need no other? RFC 6386, section 9.1; VP9 bitstream, section 6.2.
bool is_key_frame(Codec codec, std::span<const std::byte> frame) noexcept {
  if (frame.empty()) return false;
  const auto first = std::to_integer<unsigned>(frame[0]);
  if (codec == Codec::Vp8) return (first & 1U) == 0;
  if ((first & 0b1100'0000U) != 0b1000'0000U) return false;  // the marker of a frame
  const bool is_of_profile_3 = (first & 0b0011'0000U) == 0b0011'0000U;
  const unsigned rest =
      is_of_profile_3 ? first << 1U : first;  // a reserved bit follows its profile
  return (rest & 0b1100U) == 0;  // neither an old frame shown again, nor one made from others
}

bool is_shown(Codec codec, std::span<const std::byte> frame) noexcept {
  return codec == Codec::Vp9 || frame.empty() ||
         (std::to_integer<unsigned>(frame[0]) & 0b1'0000U) != 0;
}

/// How wide a pixel is to be shown for its height. Whatever the unit is, both are in it; where it
/// is unknown, so is the shape. A side that is not said is that of the pixels
/// (section 5.1.4.1.28.11).
double shape_of_pixels(const Track& track) noexcept {
  constexpr std::uint64_t pixels = 0, unknown = 4;
  const bool is_whole = track.shown_width != 0 && track.shown_height != 0;
  if (track.shown_unit >= unknown || (track.shown_unit != pixels && !is_whole)) return 1;
  const auto width = static_cast<double>(track.width), height = static_cast<double>(track.height);
  const double shown_width =
      track.shown_width == 0 ? width : static_cast<double>(track.shown_width);
  const double shown_height =
      track.shown_height == 0 ? height : static_cast<double>(track.shown_height);
  return shown_width * height / (shown_height * width);
}

class WebmReader {
 public:
  WebmReader(std::span<const std::byte> file, const Limits& limits)
      : file_(file), limits_(limits) {}

  Result<Video> read() {
    if (file_.empty()) return refusal("this file is empty");
    if (file_.size() > limits_.bytes)
      return refusal(fmt::format("this video has {:.1f} MB; at most {} MB are played",
                                 static_cast<double>(file_.size()) / (1U << 20U),
                                 limits_.bytes >> 20U));
    for (const auto step : {&WebmReader::read_head, &WebmReader::read_segment})
      if (!(this->*step)()) return refusal(fault_);
    if (!track_) return refusal("this video has no track of pictures");
    if (video_.frames.empty()) return refusal("this video holds no frame");
    if (!video_.frames.front().is_key)
      return refusal("this video does not begin with a whole frame: it was cut out of another one");
    return std::move(video_);
  }

 private:
  bool fail(std::string why) {
    if (fault_.empty()) fault_ = std::move(why);
    return false;
  }
  bool cut_short(std::size_t at) {
    return fail(
        fmt::format("this video is damaged or cut short, at byte {} of {}", at, file_.size()));
  }
  std::span<const std::byte> content(const Element& element) const noexcept {
    return file_.subspan(element.begin, element.end - element.begin);
  }
  std::string_view text(const Element& element) const noexcept {
    const auto bytes = content(element);
    std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.substr(0,
                       text.find('\0'));  // RFC 8794, section 7.4: it may be filled up with zeros
  }
  bool number(const Element& element, std::uint64_t& value) {
    const auto read = read_unsigned(content(element));
    if (!read) return cut_short(element.begin);
    value = *read;
    return true;
  }

  /// Calls `take` with all that an element holds, until that says no.
  bool each(const Element& of_it, const auto& take) {
    std::size_t at = of_it.begin;
    while (at < of_it.end) {
      const auto element = read_element(file_, at, of_it.end);
      if (!element || element->is_endless) return cut_short(at);
      if (!take(*element)) return false;
      at = element->end;
    }
    return true;
  }

  bool read_head() {
    const auto head = read_element(file_, 0, file_.size());
    if (!head || head->is_endless || head->id != EbmlHead)
      return fail("this is no WebM video, or it is damaged in its first bytes");
    std::uint64_t version = 1, id_length = 4, size_length = 8;
    std::string_view type;
    const bool is_read = each(*head, [&](const Element& element) {
      if (element.id == EbmlReadVersion) return number(element, version);
      if (element.id == EbmlMaxIdLength) return number(element, id_length);
      if (element.id == EbmlMaxSizeLength) return number(element, size_length);
      if (element.id == DocType) type = text(element);
      return true;
    });
    if (!is_read) return false;
    if (type == "matroska") return fail("this is a Matroska video (MKV), and no WebM");
    if (type != "webm" || version != 1 || id_length > 4 || size_length > 8)
      return fail("this is no WebM video");
    at_ = head->end;
    return true;
  }

  /// Segment and Cluster may be without an end (RFC 9559, sections 5.1, 5.1.3), so what they hold
  /// is read in one row: no element has the same identifier on two levels.
  bool read_segment() {
    auto segment = read_element(file_, at_, file_.size());
    while (segment && segment->id != Segment && !segment->is_endless)
      segment = read_element(file_, at_ = segment->end, file_.size());
    if (!segment || segment->id != Segment) return cut_short(at_);
    at_ = segment->begin;
    std::size_t end_of_cluster = segment->end;
    while (at_ < segment->end) {
      if (at_ == end_of_cluster) end_of_cluster = segment->end;
      const auto element = read_element(file_, at_, end_of_cluster);
      if (!element) return cut_short(at_);
      if (element->id == Cluster) {
        time_ = 0;
        end_of_cluster = element->end;
        at_ = element->begin;
        continue;
      }
      if (element->is_endless) return cut_short(at_);
      if (!take(*element)) return false;
      at_ = element->end;
    }
    return true;
  }

  bool take(const Element& element) {
    switch (element.id) {
      case Info:
        return each(element, [&](const Element& one) {
          return one.id != TimestampScale || number(one, scale_);
        });
      case Tracks:
        return each(element,
                    [&](const Element& one) { return one.id != TrackEntry || read_track(one); });
      case Timestamp:
        return number(element, time_);
      case SimpleBlock:
        return read_block(element);
      case BlockGroup:
        return each(element,
                    [&](const Element& one) { return one.id != Block || read_block(one); });
      default:
        return true;
    }
  }

  bool read_track(const Element& entry) {
    Track track;
    const bool is_read = each(entry, [&](const Element& one) {
      if (one.id == TrackNumber) return number(one, track.number);
      if (one.id == TrackType) return number(one, track.type);
      if (one.id == CodecId) track.codec = text(one);
      if (one.id == ContentEncodings) track.is_packed = true;
      if (one.id != Pictures) return true;
      return each(one, [&](const Element& side) { return read_side(side, track); });
    });
    return is_read && keep(track);
  }

  /// Of the picture: section 5.1.4.1.28.
  bool read_side(const Element& side, Track& track) {
    std::uint64_t cropped = 0;
    switch (side.id) {
      case PixelWidth:
        return number(side, track.width);
      case PixelHeight:
        return number(side, track.height);
      case DisplayWidth:
        return number(side, track.shown_width);
      case DisplayHeight:
        return number(side, track.shown_height);
      case DisplayUnit:
        return number(side, track.shown_unit);
      case PixelCropBottom:
      case PixelCropTop:
      case PixelCropLeft:
      case PixelCropRight:
        if (!number(side, cropped)) return false;
        track.is_cropped = track.is_cropped || cropped != 0;
        return true;
      default:
        return true;
    }
  }

  bool keep(const Track& track) {
    constexpr std::uint64_t of_pictures = 1, of_sound = 2;  // RFC 9559, section 5.1.4.1.3
    if (track.type == of_sound) video_.has_sound = true;
    if (track.type != of_pictures || track_) return true;
    if (track.is_packed) return fail("the frames of this video are packed once more or encrypted");
    if (track.codec != "V_VP8" && track.codec != "V_VP9")
      return fail(fmt::format("this video is coded as {}; VP8 and VP9 are played",
                              track.codec.starts_with("V_AV1") ? "AV1" : "something unknown"));
    constexpr std::uint64_t widest = 16383;  // VP8 cannot say more
    if (track.width == 0 || track.height == 0 || track.width > widest || track.height > widest)
      return fail(
          fmt::format("this video says that it is {} x {} pixels", track.width, track.height));
    video_.codec = track.codec == "V_VP8" ? Codec::Vp8 : Codec::Vp9;
    video_.width = static_cast<std::uint32_t>(track.width);
    video_.height = static_cast<std::uint32_t>(track.height);
    video_.pixel_shape = shape_of_pixels(track);
    video_.is_cropped = track.is_cropped;
    track_ = track.number;
    return true;
  }

  /// RFC 9559, section 10: a track's number, a time of 16 bits, flags, and the frame.
  bool read_block(const Element& block) {
    const auto bytes = content(block);
    const auto track = read_variable_number(bytes);
    if (!track || bytes.size() < track->width + 3) return cut_short(block.begin);
    if (!track_) return fail("this video has frames before it says how they are coded");
    if (track->value != *track_) return true;
    const auto byte = [&](std::size_t i) {
      return std::to_integer<unsigned>(bytes[track->width + i]);
    };
    constexpr unsigned lacing = 0b110;
    if ((byte(2) & lacing) != 0) return fail("this video has several frames in one block");
    const auto after = static_cast<std::int16_t>(byte(0) << 8U | byte(1));
    return add_frame(block.begin + track->width + 3, block.end, after);
  }

  bool add_frame(std::size_t begin, std::size_t end, std::int64_t after_cluster) {
    constexpr std::uint64_t most_ticks = std::uint64_t{1} << 40U, longest_tick = 1'000'000'000;
    if (time_ > most_ticks || scale_ == 0 || scale_ > longest_tick)
      return fail("this video says impossible times");
    const std::int64_t ticks = static_cast<std::int64_t>(time_) + after_cluster;
    if (video_.frames.empty()) first_ticks_ = ticks;
    const double milliseconds =
        static_cast<double>(ticks - first_ticks_) * static_cast<double>(scale_) / 1e6;
    constexpr double a_day = 86'400'000;
    const double before =
        video_.frames.empty() ? 0.0 : static_cast<double>(video_.frames.back().milliseconds);
    if (milliseconds > a_day || milliseconds < before - 1)
      return fail(fmt::format("frame {} of this video is before the one before it, or a day later",
                              video_.frames.size() + 1));
    const auto coded = file_.subspan(begin, end - begin);
    if (coded.empty()) return true;  // nothing new to see
    video_.frames.push_back(
        {.at = static_cast<std::uint32_t>(begin),
         .size = static_cast<std::uint32_t>(coded.size()),
         .milliseconds = static_cast<std::uint32_t>(std::max(milliseconds, before)),
         .is_key = is_key_frame(video_.codec, coded),
         .is_shown = is_shown(video_.codec, coded)});
    return true;
  }

  std::span<const std::byte> file_;
  const Limits& limits_;
  std::size_t at_ = 0;
  std::string fault_;
  std::uint64_t scale_ = 1'000'000;  ///< Nanoseconds a tick: RFC 9559, section 5.1.2.9.
  std::uint64_t time_ = 0;           ///< Of the cluster, in ticks.
  std::int64_t first_ticks_ = 0;
  std::optional<std::uint64_t> track_;
  Video video_;
};

}  // namespace

std::chrono::milliseconds Video::duration() const noexcept {
  if (frames.size() < 2) return {};
  const std::uint32_t last = frames.back().milliseconds;
  return std::chrono::milliseconds(last + last / (frames.size() - 1));
}

std::size_t Video::shown() const noexcept {
  return static_cast<std::size_t>(std::ranges::count(frames, true, &Frame::is_shown));
}

Result<Video> read_webm(std::span<const std::byte> file, const Limits& limits) {
  return WebmReader(file, limits).read();
}

std::optional<std::string> beyond(const Video& video, const Limits& limits) {
  const auto [least, most] = std::minmax(video.width, video.height);
  if (most > limits.longest_side || least > limits.shortest_side)
    return fmt::format("this video is {} x {} pixels; at most {} x {} are played", video.width,
                       video.height, limits.longest_side, limits.shortest_side);
  if (least < limits.least_side)
    return fmt::format("this video is {} x {} pixels, too small to be seen", video.width,
                       video.height);
  if (video.is_cropped) return "this video says that parts of it at its edges are not to be seen";
  if (std::abs(video.pixel_shape - 1) > limits.squeeze)
    return fmt::format(
        "the pixels of this video are {:.2f} times as wide as they are high; those "
        "of a screen are square",
        video.pixel_shape);
  if (video.shown() < 2) return "this video has a single frame: name a picture instead";
  const double seconds = static_cast<double>(video.duration().count()) / 1000;
  if (seconds > static_cast<double>(limits.duration.count()))
    return fmt::format("this video lasts {:.0f} seconds; at most {} are played", seconds,
                       limits.duration.count());
  // Half a frame more, because times are told in whole milliseconds.
  const double a_second = static_cast<double>(video.shown()) / std::max(seconds, 0.001);
  if (a_second > limits.frames_a_second + 0.5)
    return fmt::format("this video has {:.0f} frames a second; at most {:.0f} are played", a_second,
                       limits.frames_a_second);
  return std::nullopt;
}

}  // namespace docent::video
