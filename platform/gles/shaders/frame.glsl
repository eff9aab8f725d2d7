// What a whole frame shares. Linear light; world frame in metres.
layout(std140) uniform Frame {
  mat4 view_projection;
  vec4 eye;            // xyz
  vec4 sun;            // xyz: towards the sun; w: height of the floor
  vec4 focus;          // xz: floor place in x and z; z: radius; w: how much is taken away beyond it
  vec4 goal;           // as focus; w: how much is added
  vec4 paper;          // background
  vec4 lightmap;       // xy: world x and z of its corner; zw: 1 / size
  vec4 sun_colour;
  vec4 sky_colour;
  vec4 bounce_colour;  // from the floor, on what looks down
  vec4 lamp;           // on bodies alone, from above whoever looks
};
