#pragma once

#include <array>

#include "content/avatar/distance_field.h"
#include "content/avatar/figure.h"
#include "content/avatar/stance.h"

namespace docent::avatar {

/// An elliptic cross-section of the coat's trunk. Model frame, metres.
struct Girth {
  float height = 0;      ///< Along y.
  float half_width = 0;  ///< Along x.
  float half_depth = 0;  ///< Along z.
  float middle = 0;      ///< z of its centre.
};

/// How a garment is cut: metres on a person of 1.70 m.
struct Cut {
  float hem = 0.06F;        ///< Of the lower edge over the knees.
  float flare = 1;          ///< Of the lower edge's girth.
  float folds = 0;          ///< How deep the skirt's folds are.
  float sleeve = 0.94F;     ///< Share of the forearm that sleeves cover.
  float cuff = 0.040F;      ///< Radius of a sleeve's end.
  float neckline = 0.235F;  ///< How far below the shoulders it is open.
  bool lapels = true;
  bool pockets = true;
  bool buttons = true;
  bool bare_legs = false;
  float legs = 1;  ///< Share of the width of ordinary trousers.
};
Cut cut_of(Garment garment);

/// The person inside the stance: where the head is and how large, how wide the shoulders are, and
/// the solids from which clothes are cut. Model frame, metres; x = 0 is the plane of symmetry.
struct BodyShape {
  Figure figure;
  Stance stance;
  float scale = 1;   ///< Stature over the 1.70 m of the person that the body*.cpp measure.
  Vec3 skull{};      ///< Middle of the head, between chin and crown.
  Vec3 neck_base{};  ///< Where the neck leaves the shoulders.
  float hip_height = 0, shoulder_height = 0;
  float shoulder_half = 0;  ///< Half the distance between the shoulder joints.
  Cut cut{};
  float hem = 0;                  ///< Height of the coat's lower edge.
  std::array<Girth, 8> girths{};  ///< Of the coat, from hem to neck.

  const LimbPoints& limb(Side side) const { return stance.limb[static_cast<std::size_t>(side)]; }
};

BodyShape body_of(const Figure& figure, Stance stance);

// What follows are the solids as distance fields (distance_field.h): metres from `p` to the
// surface, negative inside. `p` is in the model frame.

/// The coat's trunk and skirt, without sleeves, grown by `ease` metres.
float coat_trunk(const BodyShape& body, Vec3 p, float ease);
/// One sleeve.
float coat_sleeve(const BodyShape& body, Vec3 p, Side side);
/// The whole coat as a solid, before its openings are cut.
float coat_solid(const BodyShape& body, Vec3 p);
/// One trouser leg.
float trouser_leg(const BodyShape& body, Vec3 p, Side side);
/// One hand, a little curled, thumb forward.
float hand(const BodyShape& body, Vec3 p, Side side);
float shoe(const BodyShape& body, Vec3 p, Side side);

}  // namespace docent::avatar
