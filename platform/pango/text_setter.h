#pragma once

#include "runtime/interface/text.h"
#include "runtime/model/museum.h"
#include "runtime/model/result.h"

namespace docent::pango {

/// A type setter on Pango and Cairo: shapes any script, breaks lines, right to left where the text
/// is, and gives back coverage. Families by language: Inter and Noto Serif, Noto CJK SC, Noto Sans
/// Arabic and Noto Naskh Arabic; what they lack comes from whatever font has it. Before them come
/// those that the museum brings along, in the languages in which they lead; the fonts of
/// the last two museums asked for are there; a museum need not outlive this call. Any thread may
/// call the function that comes back: all of a process set one after another. Fails where no font
/// at all can be found.
Result<interface::SetText> make_text_setter(const Museum* museum = nullptr);

/// Gives back what all setters have learnt of fonts, once some texts have been set since the last
/// time. The next texts take a few milliseconds longer, so call when nobody waits for one. Any
/// thread.
void forget_letters();

}  // namespace docent::pango
