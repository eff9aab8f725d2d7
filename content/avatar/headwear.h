#pragma once

#include "content/avatar/body.h"

namespace docent::avatar {

/// Scarf, turban or cap as a solid in the model frame, metres; far away where none is worn.
float headwear(const BodyShape& body, Vec3 p);

}  // namespace docent::avatar
