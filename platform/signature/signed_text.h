#pragma once

#include <span>
#include <string>
#include <string_view>

#include "platform/signature/signature.h"
#include "runtime/model/result.h"

/// A text with its signatures behind it, as DSSE keeps both in one envelope: what is signed is the
/// text's bytes, and nothing of it is understood before they are verified.
///
///   ...the text, which ends with a line feed...
///   signature 0123456789abcdef 128 hexadecimal digits
///   ...
namespace docent::signature {

std::string to_signed_text(std::string_view text, Purpose purpose, std::span<const SecretKey> keys);

/// The text, where it is signed with one of the keys; else a sentence about `where`. Safe on any
/// bytes.
Result<std::string> read_signed_text(std::string_view bytes, Purpose purpose,
                                     std::span<const PublicKey> keys, const std::string& where);

}  // namespace docent::signature
