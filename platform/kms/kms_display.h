#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "platform/display.h"
#include "platform/kms/outputs.h"
#include "runtime/model/pixels.h"
#include "runtime/model/result.h"

namespace docent::kms {

/// Screens driven straight through the kernel: GBM buffers, atomic mode setting, page flips; no
/// window system.
///
/// A screen may be pulled out, come back, come back with other modes, or be absent from the start;
/// another program or terminal may have the card for a while. None of that ends the display: it
/// says that it cannot show anything, and draws again as soon as it can.
class KmsDisplay : public Display {};

/// Finds a picture of exactly this size that can be shown before anything is drawn; empty: none.
using FindPoster = std::function<std::optional<Pixels>(PixelSize size)>;

/// Takes the wanted screens of the first graphics card that has one, or else of the first that
/// could have one later, and makes its OpenGL context current on this thread. Fails with a sentence
/// where there is no card, no permission, or another program holds it. Called before the first
/// thread is begun.
///
/// A poster is on the screens before the graphics driver is even loaded, and stays until the first
/// frame takes its place.
Result<std::unique_ptr<KmsDisplay>> open_kms(const WantedOutput& wanted = {},
                                             const FindPoster& find_poster = {});

/// Could open_kms show something now? True where a card with a connected screen can be had and
/// nobody else holds it. Changes nothing.
bool is_kms_free() noexcept;

}  // namespace docent::kms
