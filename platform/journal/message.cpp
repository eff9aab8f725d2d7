#include "platform/journal/message.h"

#include <array>

namespace docent::journal {
namespace {

constexpr std::array kinds{
    MessageKind{Message::Started, Priority::Info, "7a98d53cdee14b03afc804e7d6e0f3de",
                "The kiosk has begun",
                "The line says the program's version and on what it draws. Nothing is to be done."},
    MessageKind{Message::Shows, Priority::Info, "1f67ddceca984559b931dec9c982f135",
                "The kiosk shows a museum",
                "The line says which museum, and from which database. Nothing is to be done."},
    MessageKind{Message::TakenUp, Priority::Notice, "1c73e7816a86427ea13f56605731a9ac",
                "The kiosk has taken up a new database",
                "From now on visitors see the new content. The database before it is no longer "
                "used."},
    MessageKind{Message::Refused, Priority::Error, "6f5f0d645024461dba43c3a469f4da05",
                "A database was refused",
                "The kiosk goes on with the museum that it shows; visitors notice nothing.\n"
                "The line says what is wrong with the new database. Compile or copy it again,\n"
                "ask `docent check FILE` on the device whether it can be shown, and reload."},
    MessageKind{Message::FewerVisitors, Priority::Warning, "b126b35d07b047ca8e0b7568b2b04d4e",
                "The glass has room for fewer visitors than kiosk.toml asks for",
                "A screen that is too small for so many cards, large letters, or a floor about "
                "the kiosk\non which so many guides find no place. Set `visitors` in "
                "/etc/docent/kiosk.toml to the number\nin the line, or look at `screen_inches` "
                "there."},
    MessageKind{
        Message::HangsHigh, Priority::Warning, "e66f6f22d5354d8ca217ef8e8ccd0bd7",
        "The glass hangs too high for all controls to come within reach of a wheelchair",
        "Visitors who ask for it lower find controls above 1,220 mm. Hang the screen as low "
        "as the line\nsays, or take a smaller one, or one that stands upright; or look at "
        "`mount_height` and\n`screen_inches` in /etc/docent/kiosk.toml. A keypad reaches "
        "everything."},
    MessageKind{Message::CannotStart, Priority::Error, "0319b8e8da7b407cbbf1b0fb585e8ffb",
                "The kiosk cannot start",
                "The line says which file or device, and what to do. It is tried again every few "
                "seconds\nuntil it works; nothing has to be started by hand."},
    MessageKind{Message::ScreenLost, Priority::Error, "4d7afe9a1704430bb917cf1e8d2d21b5",
                "The screen has gone",
                "The graphics card or the window system went away while the kiosk ran. It is "
                "started again.\nIf it happens more than once: the cable, the power supply, the "
                "driver (`journalctl -k`)."},
    MessageKind{Message::FrameUnfinished, Priority::Warning, "348fd8e49c9d4143be3ef822d1952140",
                "The kiosk ended in the middle of a frame",
                "It was asked to end while the graphics driver did not come back from a frame. "
                "Once is no harm;\noften means a driver or a graphics card that hangs (`journalctl "
                "-k`)."},
    MessageKind{Message::Ended, Priority::Info, "ef565df662df4541a0c86f9f2bfae362",
                "The kiosk has ended as it was asked to",
                "Somebody stopped or restarted the service. `systemctl start docent` brings the "
                "guide back."},
    MessageKind{Message::DeviceTaken, Priority::Info, "33f43e9612a847aa837781dffcd3dca1",
                "An input device is used",
                "The line says which, and whether it is taken for a touch screen or a keypad."},
    MessageKind{Message::DeviceGone, Priority::Notice, "a6976ae455f5480d8aa85fa24c48e646",
                "An input device has gone",
                "It was unplugged or has failed. It is used again as soon as it is back; fingers "
                "that it held are lifted.\nIf nobody unplugged it: the cable, the USB port, its "
                "power."},
    MessageKind{Message::DeviceUnusable, Priority::Warning, "f583e11cf65c44108fafa034667737d4",
                "An input device cannot be used",
                "The line says why. Where it cannot be opened: `ls -l /dev/hidraw*` must say "
                "root input and crw-rw----,\nwhich the udev rule of the package docent does; "
                "`docent hid list` says how each device is taken.\nIt is tried again by itself."},
    MessageKind{Message::NoStatus, Priority::Warning, "6bd87454d7da4d7bbbc37d085a3ad088",
                "The kiosk cannot be asked for its status",
                "Everything else works. The line says why the socket in /run/docent could not be "
                "made."},
    MessageKind{Message::ScreenTaken, Priority::Info, "9a646aa1efee41039caedc3c2d078c61",
                "The kiosk draws on a screen",
                "The line says which screen and in which mode. Nothing is to be done."},
    MessageKind{Message::NoScreen, Priority::Warning, "640dd353a10f46cdb66feae77d71c683",
                "No screen is connected",
                "The kiosk goes on without one, and is there as soon as one is. Look at the cable, "
                "the screen's\npower and its chosen input, and at `output` in "
                "/etc/docent/kiosk.toml."},
    MessageKind{Message::CardTaken, Priority::Warning, "2daaf9dcf964458997cabb1ee8693e60",
                "The graphics card draws for somebody else",
                "Another terminal was chosen, or another program has taken the graphics card. "
                "`chvt 1` brings the\nguide back from a terminal; `fuser -v /dev/dri/card*` names "
                "a program."},
    MessageKind{Message::CardBack, Priority::Info, "bc4866fb50fd4b4083274d31bd25d0eb",
                "The graphics card draws for the kiosk again", "Nothing is to be done."},
    MessageKind{Message::FrameLost, Priority::Warning, "595d39725e954c969a572738f533091d",
                "A frame did not reach the screen",
                "For a second the graphics card was busy, or did not say that it shows a frame. "
                "The kiosk sets\nthe screen's mode anew and goes on. Once is no harm; often means "
                "a driver, a cable or a screen\nthat fails (`journalctl -k`)."},
    MessageKind{Message::FramesBack, Priority::Info, "bf461b18d2fa4374908e901505d51bc0",
                "Frames reach the screen again", "Nothing is to be done."},
    MessageKind{Message::TooHot, Priority::Warning, "1cf35e5923204d94b0a43983ffe22dd5",
                "The machine is too hot",
                "The kiosk draws 30 frames a second instead of 60 until it has cooled down. Let "
                "air to the machine:\ndust, a closed cabinet, the sun."},
    MessageKind{Message::CooledDown, Priority::Notice, "442e9c7f041c4cd093a7ff2ae41c24e5",
                "The machine has cooled down", "The kiosk draws 60 frames a second again."},
    MessageKind{
        Message::ReportUnwritten, Priority::Warning, "5ed81884f99c40b4893842805a473511",
        "Health or counts cannot be written",
        "Visitors notice nothing. The line says which file, and why: mostly a full disk, or "
        "a folder that\ndoes not belong to the user docent."},
    MessageKind{Message::TodayTakenUp, Priority::Info, "b7d063b22bee51ededfd79f3d5356e6f",
                "What is closed today has been taken up",
                "From now on ways go round what the file names. Nothing is to be done."},
    MessageKind{Message::TodayRefused, Priority::Warning, "c41eaaaa98aa7e3cd7c1d123d6523cac",
                "A today.toml was refused",
                "What was closed before stays closed, and nothing more is. The line says what is\n"
                "wrong and where; mend the file, and it is taken up within a second."},
    MessageKind{Message::SoundLost, Priority::Warning, "d0b6f3c3a1f44f2f9d3e0b8e53a7c1aa",
                "The kiosk cannot be heard",
                "Visitors who do not see the screen need it. The line says which sound device, and "
                "why:\nnot plugged in, used by another program, or not `device` of [sound] in "
                "/etc/docent/kiosk.toml\n(`aplay -L` lists the names). It is tried again every two "
                "seconds."},
    MessageKind{Message::SoundBack, Priority::Info, "5be5dfd26f0c4a3c8c7f4b1e0b6f94d2",
                "The kiosk can be heard again", "Nothing is to be done."},
};

constexpr bool are_in_order() {
  for (std::size_t i = 0; i < kinds.size(); ++i)
    if (static_cast<std::size_t>(kinds[i].message) != i) return false;
  return kinds.size() == static_cast<std::size_t>(Message::SoundBack) + 1;
}
static_assert(are_in_order());

}  // namespace

std::span<const MessageKind> message_kinds() noexcept {
  return kinds;
}

const MessageKind& kind_of(Message message) noexcept {
  return kinds[static_cast<std::size_t>(message)];
}

}  // namespace docent::journal
