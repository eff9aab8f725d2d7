#include "tests/deploy/catalog.h"

#include <fmt/format.h>

#include <algorithm>

#include "platform/journal/message.h"
#include "tests/deploy/manual.h"

namespace docent::test {

std::string message_catalog() {
  std::string text =
      "# Made of the table in platform/journal/message.cpp by tests/deploy; change that.\n";
  for (const journal::MessageKind& kind : journal::message_kinds())
    text += fmt::format(
        "\n-- {}\nSubject: {}\nDefined-By: docent\nDocumentation: man:docent(1)\n\n{}\n", kind.id,
        kind.subject, kind.remedy);
  return text;
}

std::string mdoc_messages() {
  std::string text = ".Bl -tag -width Ds\n";
  for (const journal::MessageKind& kind : journal::message_kinds()) {
    std::string remedy(kind.remedy);
    std::ranges::replace(remedy, '\n', ' ');
    for (std::size_t at = 0; (at = remedy.find(". ", at)) != std::string::npos;)
      remedy[at + 1] = '\n';  // mdoc wants each sentence on a line
    text += fmt::format(".It {}\n.Va {}\n.Pp\n{}\n", mdoc_text(kind.subject), kind.id,
                        mdoc_text(remedy));
  }
  return text + ".El\n";
}

}  // namespace docent::test
