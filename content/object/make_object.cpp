#include "content/object/make_object.h"

#include <utility>

#include "content/object/agree.h"
#include "content/object/crease.h"
#include "content/object/decimate.h"
#include "content/object/occlusion.h"
#include "content/object/pack.h"
#include "content/object/simplify.h"
#include "platform/image/image.h"
#include "runtime/schema/object_blob.h"

namespace docent::object {
namespace {

/// Faces that meet at more than this are an edge.
constexpr float crease_angle = 0.9F, none_at_all = 4.0F;
/// Corners are named by 16 bits, and pictures want some of an object's bytes.
constexpr std::size_t most_vertices = 40'000;

LitShape lit(Shape shape, float angle) {
  LitShape lit{.shape = std::move(shape), .normals = {}, .occlusion = {}};
  lit.normals = crease(lit.shape, angle);
  return lit;
}

/// The shape with no more triangles than its budget, and no more vertices, which creases and seams
/// of pictures double.
LitShape near_shape(const Shape& shape) {
  Shape simple = shape;
  for (const std::size_t triangles : {ObjectDetail::most_triangles, std::size_t{13'000}}) {
    decimate(simple, triangles);
    simplify(simple, triangles);
    for (const float angle : {crease_angle, none_at_all}) {
      LitShape made = lit(simple, angle);
      if (made.shape.vertices.size() <= most_vertices) return made;
    }
  }
  return {};  // 39,000 corners have no more vertices
}

LitShape distant_shape(const Shape& shape, std::size_t triangles) {
  Shape simple = without_seams(shape);
  simplify(simple, triangles);
  return lit(std::move(simple), crease_angle);
}

/// The model with pictures whose texels are as large as a distant vertex's share of them.
import::gltf::Model blurred(const import::gltf::Model& model) {
  constexpr std::uint32_t side = 24;
  import::gltf::Model far;
  far.materials = model.materials;
  for (const Pixels& picture : model.images) far.images.push_back(image::shrink(picture, side));
  return far;
}

}  // namespace

MadeObject make_object(const import::object::ObjectFile& source, const std::string& file,
                       const ObjectWish& wish, std::size_t distant_triangles) {
  MadeObject made;
  made.warnings = source.model.warnings;
  Shape shape = shape_of(source.model, file, made.notes);
  stand_up(source, wish, shape, made.notes);
  made.triangles = shape.indices.size() / 3;
  agree(shape);
  LitShape near = near_shape(shape);
  LitShape distant = distant_shape(near.shape, distant_triangles);
  // Of the shape as it was: an end that is missing on one side must not move the whole.
  const Box box = box_of(shape);
  near.occlusion = occlusion_of(near.shape, near.normals);
  distant.occlusion = occlusion_of(distant.shape, distant.normals);
  made.object.size = box.size();
  made.object.distant = pack_distant(distant, blurred(source.model), box);
  made.object.detail = schema::encode(pack_detail(near, source.model, box, file));
  return made;
}

}  // namespace docent::object
