#pragma once

#include "content/avatar/body.h"

namespace docent::avatar {

// Solids in the model frame, metres. What a figure does not have is far away from everywhere.

/// Hair on the head, carved into locks that lie in its direction. The brows are apart.
float hair(const BodyShape& body, Vec3 p);
bool has_hair(const Figure& figure);
float beard(const BodyShape& body, Vec3 p);

}  // namespace docent::avatar
