#pragma once

#include <string>

#include "runtime/model/museum.h"

namespace docent::schema {

/// The first invariant of the model that the museum breaks, in a few words; empty where it keeps
/// all. Covers what the kiosk relies on without checking: every index is in range, arrays that go
/// together have one length, numbers are finite, enumerators exist, parents come before children.
std::string broken_invariant(const Museum& museum);

}  // namespace docent::schema
