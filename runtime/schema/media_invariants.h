#pragma once

#include <string>

#include "runtime/model/museum.h"

namespace docent::schema {

/// The part of what visitors look at, listen to and are told that does not keep what the model
/// promises; empty where all of it does. Of broken_invariant().
std::string broken_media(const Museum& museum);

}  // namespace docent::schema
