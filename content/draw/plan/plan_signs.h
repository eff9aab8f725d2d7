#pragma once

#include <cstdint>
#include <string>

#include "content/draw/svg.h"
#include "runtime/model/museum.h"

namespace docent::draw {

/// Draws the sign of a kind of connection, `size` pixels high: steps, a slope with steps, a lift's
/// box with arrows, a slope. Red and struck through where it is closed.
void draw_sign(Svg& svg, const Connection& connection, Vec2 at, double size);

/// What stands beside a stop: the connection, and the floors that it leads to from here. Floors
/// that it only comes from are named so.
std::string words_at_stop(const Museum& museum, const Connection& connection, std::size_t stop);

}  // namespace docent::draw
