#pragma once

#include <memory>
#include <string>

#include "platform/display.h"
#include "runtime/model/result.h"

namespace docent::kms {

/// A screen driven straight through the kernel: GBM buffers, atomic mode setting, page flips; no
/// window system.
class KmsDisplay : public Display {};

/// Takes the first connected screen of the first graphics card that drives one, in its preferred
/// mode (or the mode nearest to `wanted`, where that is not 0 by 0), and makes its OpenGL context
/// current on this thread. Fails with a sentence where there is no card, no screen, no permission,
/// or another program holds it.
Result<std::unique_ptr<KmsDisplay>> open_kms(PixelSize wanted = {});

/// Could open_kms work here? True where a card with a connected screen can be had and nobody else
/// holds it. Changes nothing.
bool is_kms_free() noexcept;

}  // namespace docent::kms
