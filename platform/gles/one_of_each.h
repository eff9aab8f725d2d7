#pragma once

#include "platform/gles/holdings.h"
#include "runtime/scene/draw_list.h"

namespace docent::gles {

/// One of everything that a draw list may name, each a few pixels large.
struct OneOfEach {
  Holdings holdings;
  scene::DrawList list;
};
OneOfEach one_of_each();

}  // namespace docent::gles
