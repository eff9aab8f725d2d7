#include "runtime/interface/caption.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/interface/pages.h"
#include "runtime/interface/sheet.h"

namespace docent::interface {
namespace {

constexpr float most_lines = 3;
constexpr float widest = 90;  // units

/// When a text is said, as it follows from how long its pieces sound.
class Timing {
 public:
  Timing(const Utterance& said, std::string_view text) : begins_(begins_of(said)) {
    std::size_t end = 0;  // pieces follow each other in the text
    for (const SpokenPiece& piece : said.pieces) {
      end = text.find(piece.text, end) + piece.text.size();
      ends_.push_back(end);
      lengths_.push_back(piece.text.size());
    }
  }
  /// The share that is still to be said when it comes to that byte.
  float left_at(std::size_t byte) const noexcept {
    if (byte == 0) return 1;
    float seconds = begins_.back();
    for (std::size_t i = 0; i < ends_.size(); ++i) {
      if (byte >= ends_[i]) continue;
      const std::size_t begin = ends_[i] - lengths_[i];
      const float within =
          byte <= begin ? 0 : static_cast<float>(byte - begin) / static_cast<float>(lengths_[i]);
      seconds = std::lerp(begins_[i], begins_[i + 1], within);
      break;
    }
    return 1 - seconds / begins_.back();
  }

 private:
  std::vector<float> begins_;                ///< Of the pieces, and then the end of all.
  std::vector<std::size_t> ends_, lengths_;  ///< Bytes of the text.
};

}  // namespace

PixelBox box_above(const View& view, const scene::Rect& free, float width, float height,
                   float gap) noexcept {
  const float x = (free.x + free.width / 2) * view.pixel_width - width / 2;
  float bottom = (free.y + free.height) * view.pixel_height - gap;
  const float middle = (free.y + free.height / 2) * view.pixel_height;
  for (const Control& control : view.controls) {
    const scene::Rect& r = control.rect;
    const float left = r.x * view.pixel_width, top = r.y * view.pixel_height;
    const bool is_below = top > middle && left < x + width && left + r.width * view.pixel_width > x;
    if (control.role != Role::Spot && r.width > 0 && is_below) bottom = std::min(bottom, top - gap);
  }
  return {std::round(x), std::round(bottom - height), width, height};
}

std::unique_ptr<View> make_caption(const Museum& museum, const ViewRequest& asked,
                                   PieceCache& pieces, const Closures& closed,
                                   const ShownWay* way) {
  const std::unique_ptr<View> below = make_view(museum, asked, pieces, closed, way);
  auto view = std::make_unique<View>();
  view->request = asked.id;
  view->part = asked.part;
  view->state = asked.state;
  view->pixel_width = static_cast<float>(asked.shape.width);
  view->pixel_height = static_cast<float>(asked.shape.height);
  const Utterance* said = asked.said ? said_in(below->speech, *asked.said) : nullptr;
  if (said == nullptr || said->empty()) return view;

  ViewRequest request = asked;
  request.shape.text_scale = shape_for(asked.shape, asked.state).text_scale;
  Sheet sheet(museum, request, pieces, closed, *view);
  const Measures& m = sheet.measures();
  view->unit_px = m.unit;
  const scene::Rect free =
      free_part_of(asked.shape, runs_right_to_left(museum, asked.state.language));
  const float width = std::floor(std::min(free.width * view->pixel_width - 2 * m.gap,
                                          widest * m.unit * request.shape.text_scale));
  const float pad = std::round(1.5F * m.unit), room = width - 2 * pad;
  const TextStyle style = sheet.style(Letters::Body);
  const std::string text = text_of(*said);
  const std::vector<std::string_view> pages = pages_of(sheet, style, text, room, most_lines);
  float height = 0;
  for (const std::string_view page : pages)
    height = std::max(height, sheet.extent(style, page, room).height);
  const PixelBox box = box_above(*below, free, width, height + 2 * pad, m.gap);
  sheet.lie_on(box);
  sheet.fill(box, sheet.theme().ink, m.corner);
  const Timing timing(*said, text);
  for (auto page = pages.rbegin(); page != pages.rend(); ++page) {
    const float left = timing.left_at(static_cast<std::size_t>(page->data() - text.data()));
    const TextPiece piece = sheet.set(style, *page, room);
    view->remaining.push_back(
        {left + 1e-3F,
         sheet.quad_of(piece, box.x + pad, box.y + pad, room, Align::Start, sheet.theme().paper),
         sheet.words_of(piece)});
  }
  sheet.finish();
  return view;
}

}  // namespace docent::interface
