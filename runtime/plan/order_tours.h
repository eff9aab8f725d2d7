#pragma once

#include "runtime/model/museum.h"

namespace docent::plan {

/// Orders the museum's tours by the walk from its kiosk, where that is another than the one they
/// were compiled for; those that staff have fixed keep their order, and those
/// for who has so much time are chosen anew. A tour to which there is no way stays as it is.
void order_tours(Museum& museum);

}  // namespace docent::plan
