#pragma once

#include <memory>

#include "runtime/interface/layout.h"
#include "runtime/interface/sheet.h"

namespace docent::interface {

/// What is being said (`request.said`), as text above whatever lies on the model's lower edge: a
/// view of its own, over the one that the rest of the request asks for. A long text is shown a page
/// of a few lines at a time: View::remaining has the pages, each for as long as at most that share
/// of it is still to be said. Empty where nothing is said. Runs on the worker.
std::unique_ptr<View> make_caption(const Museum& museum, const ViewRequest& request,
                                   PieceCache& pieces, const Closures& closed = {},
                                   const ShownWay* way = nullptr);

/// Where what is heard is read: in the middle of `free`, a part of the screen, below its middle and
/// above all that can be touched there.
PixelBox box_above(const View& view, const scene::Rect& free, float width, float height,
                   float gap) noexcept;

}  // namespace docent::interface
