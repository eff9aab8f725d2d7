#pragma once

#include <cstdint>
#include <span>
#include <string_view>

/// What a kiosk tells the journal: a table, so that an operator and a fleet's monitoring can ask
/// for a message by its identifier, whatever its words are today.
namespace docent::journal {

enum class Message : std::uint8_t {
  Started,
  Shows,
  TakenUp,
  Refused,
  FewerVisitors,
  HangsHigh,
  CannotStart,
  ScreenLost,
  FrameUnfinished,
  Ended,
  DeviceTaken,
  DeviceGone,
  DeviceUnusable,
  NoStatus,
  ScreenTaken,
  NoScreen,
  CardTaken,
  CardBack,
  FrameLost,
  FramesBack,
  TooHot,
  CooledDown,
  ReportUnwritten,
  TodayTakenUp,
  TodayRefused,
  SoundLost,
  SoundBack,
};

/// As syslog(3) counts them.
enum class Priority : std::uint8_t { Error = 3, Warning = 4, Notice = 5, Info = 6 };

struct MessageKind {
  Message message{};
  Priority priority = Priority::Info;
  std::string_view id;       ///< MESSAGE_ID: 32 hexadecimal digits, for ever.
  std::string_view subject;  ///< What has happened, without particulars.
  std::string_view remedy;   ///< What it means and what to do, a line or more.
};

/// All of them, in the order of the enumeration.
std::span<const MessageKind> message_kinds() noexcept;
const MessageKind& kind_of(Message message) noexcept;

}  // namespace docent::journal
