#pragma once

#include "platform/sqlite/content_reader.h"
#include "runtime/model/museum.h"
#include "tests/support/sample_database.h"

namespace docent::test {

/// The sample museum as a kiosk reads it. Read when it is first asked for, so not while a test
/// program is being started.
inline const Museum& sample_museum() {
  static const Museum it = sqlite::load_museum(sample_database()).value();
  return it;
}

}  // namespace docent::test
