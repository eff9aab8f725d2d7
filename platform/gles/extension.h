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

/// Can a texture that encodes sRGB be read without being decoded (EXT_texture_sRGB_decode)? Whole
/// pictures are then taken over as they are: a processor spends longer on decoding and encoding a
/// pixel than on drawing it.
bool can_read_encoded() noexcept;
/// The texture's parameter and the value for that: TEXTURE_SRGB_DECODE_EXT, SKIP_DECODE_EXT.
inline constexpr unsigned texture_decodes = 0x8A48, reads_encoded = 0x8A4A;

}  // namespace docent::gles
