#pragma once

#include <string>

/// The table of the journal's messages, as its readers want it.
namespace docent::test {

/// systemd's message catalog: what `journalctl -x` says beside a line.
std::string message_catalog();

/// A list for the manual page: what has happened, its identifier, what to do.
std::string mdoc_messages();

}  // namespace docent::test
