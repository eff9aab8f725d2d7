#pragma once

#include "runtime/interface/text.h"
#include "runtime/model/result.h"

namespace docent::pango {

/// A type setter on Pango and Cairo: shapes any script, breaks lines, right to left where the text
/// is, and gives back coverage. Families by language: Inter and Noto Serif, Noto CJK SC, Noto Sans
/// Arabic and Noto Naskh Arabic; what they lack comes from whatever font has it. The function that
/// comes back may be called by one thread at a time. Fails where no font at all can be found.
Result<interface::SetText> make_text_setter();

}  // namespace docent::pango
