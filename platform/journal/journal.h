#pragma once

#include <string>
#include <string_view>

#include "platform/journal/message.h"

namespace docent::journal {

/// Says a sentence on standard error, as "docent: SENTENCE". Where that is the journal
/// (JOURNAL_STREAM names it), the journal gets it in its own form instead, with MESSAGE_ID and
/// PRIORITY. Any thread; neither waits nor allocates.
void tell(Message message, std::string_view sentence) noexcept;

/// The last sentence that was a warning or an error; empty where there was none. Any thread.
std::string last_problem();

// What tell() is made of, for tests.

/// Is this file descriptor what JOURNAL_STREAM ("DEVICE:INODE") names?
bool is_journal(int descriptor, const char* journal_stream) noexcept;

/// Sends a sentence to the journal that listens at `socket`; false where nobody takes it at once.
bool send(const char* socket, Message message, std::string_view sentence) noexcept;

}  // namespace docent::journal
