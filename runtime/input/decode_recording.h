#pragma once

#include <string>

#include "runtime/input/hid_recording.h"

namespace docent::input {

/// Plays a recording through the kiosk's own decoders and returns the CSV of `docent hid decode`:
/// `report,kind,id,x,y,state`, rows after each report that completes a frame or makes a key edge.
/// Fails where the descriptor is broken or the device is neither touch screen nor keypad.
Result<std::string> decode_recording(const HidRecording& recording);

}  // namespace docent::input
