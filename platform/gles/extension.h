#pragma once

#include <string_view>

namespace docent::gles {

/// Has the current context this extension of OpenGL ES?
bool has_extension(std::string_view name) noexcept;

/// Can a framebuffer that encodes sRGB be told to take what shaders have encoded themselves
/// (EXT_sRGB_write_control)? Where pixels have several samples, a processor then encodes each pixel
/// once and not each of its samples.
bool can_shaders_encode() noexcept;
/// What is enabled or disabled for that: FRAMEBUFFER_SRGB_EXT.
inline constexpr unsigned framebuffer_encodes = 0x8DB9;

}  // namespace docent::gles
