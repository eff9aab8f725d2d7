-- A docent database: one museum, compiled. Version 20 (user_version), application_id 0x646F6374.
--
-- Rows are numbered from 0 in the order of the model's vectors, so an id here is an index there
-- (runtime/model/museum.h). Lengths are metres, angles radians, in the frames of the model's
-- headers. Blobs are arrays: the elements named beside them, field by field as listed in
-- elements.h, little-endian, without padding. rows.h ties each column to its field.

CREATE TABLE checksum (      -- BLAKE2b-256 of the whole file with these 32 bytes taken as zero
  id INTEGER PRIMARY KEY,
  blake2b BLOB NOT NULL
);

CREATE TABLE museum (        -- one row
  id INTEGER PRIMARY KEY,
  kiosk_floor INTEGER NOT NULL,
  kiosk_x REAL NOT NULL,
  kiosk_y REAL NOT NULL,
  kiosk_heading REAL NOT NULL,
  body_radius REAL NOT NULL,
  time_zone TEXT NOT NULL,           -- as POSIX's TZ, of all hours; empty: the kiosk's own
  holidays TEXT NOT NULL,            -- public ones: dates of opening_hours with commas between
  ambient_count INTEGER NOT NULL,
  ambient_entrance BLOB NOT NULL,    -- Vec2
  ambient_look_least REAL NOT NULL,  -- seconds
  ambient_look_most REAL NOT NULL
);

CREATE TABLE kiosk (         -- where several share the museum: all, the first being the one above
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,        -- what kiosk.toml calls it
  floor INTEGER NOT NULL,
  x REAL NOT NULL,
  y REAL NOT NULL,
  heading REAL NOT NULL
);

CREATE TABLE livery (        -- one row: the museum's own look; colours are sRGB, 0xRRGGBB
  id INTEGER PRIMARY KEY,
  paper INTEGER NOT NULL,
  ink INTEGER NOT NULL,
  accent INTEGER NOT NULL,   -- what invites to touch
  focus INTEGER NOT NULL,    -- what the keypad would press
  title_family TEXT NOT NULL,   -- of letters; empty: docent's own
  title_language BLOB NOT NULL, -- u32, ascending: in which it leads
  text_family TEXT NOT NULL,
  text_language BLOB NOT NULL,
  logo INTEGER NOT NULL,     -- an image, or 4294967295 for none
  logo_at_night INTEGER NOT NULL,
  logo_shows_at_night INTEGER NOT NULL  -- 1: the first is told from dark paper, too
);

CREATE TABLE font (          -- files of those families, TrueType or OpenType
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  bytes BLOB NOT NULL
);

CREATE TABLE language (      -- the first is the default
  id INTEGER PRIMARY KEY,
  tag TEXT NOT NULL,         -- BCP 47
  name TEXT NOT NULL,
  right_to_left INTEGER NOT NULL
);

CREATE TABLE text (          -- everything that is read: titles and texts by language, words by key
  subject TEXT NOT NULL,     -- museum.title museum.welcome floor.title room.title exhibit.title exhibit.text exhibit.description exhibit.more exhibit.artist exhibit.subject exhibit.period picture.caption picture.description sound.title sound.description place.title way.title tour.title language.word museum.reading
  owner INTEGER NOT NULL,    -- id in the subject's table
  key TEXT NOT NULL,         -- language tag; for language.word the word's key, for museum.reading what is read so
  text TEXT NOT NULL,
  PRIMARY KEY (subject, owner, key)
) WITHOUT ROWID;

CREATE TABLE floor (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  ordinal INTEGER NOT NULL,  -- of two floors the upper one's is greater
  height REAL NOT NULL,
  short_name TEXT NOT NULL,  -- what a lift's button says
  vertex BLOB NOT NULL,      -- Vec2
  ring BLOB NOT NULL,        -- Ring
  next BLOB NOT NULL         -- u32, one a vertex
);

CREATE TABLE connection (      -- stairs, escalators, lifts, ramps
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,          -- its id in museum.toml
  kind INTEGER NOT NULL,       -- 0 stairs, 1 escalator, 2 lift, 3 ramp
  direction INTEGER NOT NULL,  -- 0 both, 1 up, 2 down
  step_free INTEGER NOT NULL,
  closed INTEGER NOT NULL,
  hours TEXT NOT NULL,         -- as OpenStreetMap's opening_hours, here and below; empty: always
  wait_seconds REAL NOT NULL,
  seconds_per_floor REAL NOT NULL,
  metres_per_floor REAL NOT NULL,
  stop BLOB NOT NULL           -- ConnectionStop
);

CREATE TABLE door (
  floor INTEGER NOT NULL,
  id INTEGER NOT NULL,
  name TEXT NOT NULL,
  ax REAL NOT NULL,
  ay REAL NOT NULL,
  bx REAL NOT NULL,
  by REAL NOT NULL,
  closed INTEGER NOT NULL,      -- for good: the plan has a wall there
  hours TEXT NOT NULL,
  opens INTEGER NOT NULL,       -- DoorOpens
  hinge INTEGER NOT NULL,       -- DoorHinge
  PRIMARY KEY (floor, id)
) WITHOUT ROWID;

CREATE TABLE voronoi_diagram (  -- one a floor, as are roadmap and scenery
  id INTEGER PRIMARY KEY,
  site BLOB NOT NULL,           -- Site
  vertex BLOB NOT NULL,         -- Vec2
  clearance BLOB NOT NULL,      -- f64, one a vertex
  edge BLOB NOT NULL,           -- VoronoiEdge
  region_first BLOB NOT NULL,   -- u32, one a site and one more
  region_edge BLOB NOT NULL     -- u32
);

CREATE TABLE roadmap (
  id INTEGER PRIMARY KEY,
  position BLOB NOT NULL,       -- Vec2
  clearance BLOB NOT NULL,      -- f64
  voronoi_vertex BLOB NOT NULL, -- u32
  edge BLOB NOT NULL            -- RoadmapEdge
);

CREATE TABLE sight_map (
  id INTEGER PRIMARY KEY,
  corner BLOB NOT NULL,         -- u32, vertices
  pair_first BLOB NOT NULL,     -- u32, one a corner and one more
  pair_other BLOB NOT NULL,     -- u32, corners
  origin_x REAL NOT NULL,
  origin_y REAL NOT NULL,
  cell_size REAL NOT NULL,
  cell_columns INTEGER NOT NULL,
  cell_rows INTEGER NOT NULL,
  cell_first BLOB NOT NULL,     -- u32, one a cell and one more
  cell_corner BLOB NOT NULL     -- u32, corners
);

CREATE TABLE tangent_graph (    -- one a radius class, ascending
  floor INTEGER NOT NULL,
  id INTEGER NOT NULL,
  radius REAL NOT NULL,
  arc BLOB NOT NULL,            -- TangentArc
  side_first BLOB NOT NULL,     -- u32, two an arc and one more
  tangent BLOB NOT NULL,        -- Tangent
  PRIMARY KEY (floor, id)
);

CREATE TABLE hub_labels (       -- one a tangent graph
  floor INTEGER NOT NULL,
  id INTEGER NOT NULL,
  unit REAL NOT NULL,
  leaving BLOB NOT NULL,        -- LabelTable: label_blob.h
  arriving BLOB NOT NULL,       -- LabelTable
  link_part BLOB NOT NULL,      -- u32, two a shortcut
  PRIMARY KEY (floor, id)
);

CREATE TABLE scenery (
  id INTEGER PRIMARY KEY,
  vertex BLOB NOT NULL,         -- SceneryVertex
  triangle BLOB NOT NULL,       -- u32, three a triangle
  part BLOB NOT NULL,           -- SceneryPart
  lightmap_width INTEGER NOT NULL,
  lightmap_height INTEGER NOT NULL,
  lightmap_min_x REAL NOT NULL,
  lightmap_min_y REAL NOT NULL,
  lightmap_max_x REAL NOT NULL,
  lightmap_max_y REAL NOT NULL,
  lightmap BLOB NOT NULL,       -- three bytes a texel: sky, sun, height of the shade
  sun_x REAL NOT NULL,
  sun_y REAL NOT NULL,
  sun_z REAL NOT NULL
);

CREATE TABLE room (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,           -- its id in museum.toml
  floor INTEGER NOT NULL,
  label_x REAL NOT NULL,
  label_y REAL NOT NULL,
  outline BLOB NOT NULL,        -- Vec2
  closed INTEGER NOT NULL,
  hours TEXT NOT NULL
);

CREATE TABLE exhibit (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,           -- its id in exhibits/*.toml
  floor INTEGER NOT NULL,
  room INTEGER NOT NULL,
  x REAL NOT NULL,
  y REAL NOT NULL,
  heading REAL NOT NULL,
  view_x REAL NOT NULL,
  view_y REAL NOT NULL,
  view_heading REAL NOT NULL,
  place INTEGER NOT NULL,       -- ExhibitPlace: 0 on the floor, 1 on a wall, 2 in a case; to be touched: 3 free, 4 on a wall
  image INTEGER NOT NULL,
  closed INTEGER NOT NULL,
  hours TEXT NOT NULL,
  weight REAL NOT NULL,         -- how much it is worth seeing, where not all can be seen
  looking_seconds REAL NOT NULL,
  object INTEGER NOT NULL,      -- -1: it has no shape of its own
  object_x REAL NOT NULL,       -- where that stands
  object_y REAL NOT NULL,
  object_base REAL NOT NULL,    -- metres above the floor
  object_scale REAL NOT NULL,   -- of its own size
  touch BLOB NOT NULL           -- Touch: how a guide lays a hand on it, from either side; or none
);

CREATE TABLE picture (          -- of exhibits, besides their own: in the order in which one leafs
  id INTEGER PRIMARY KEY,
  exhibit INTEGER NOT NULL,
  image INTEGER NOT NULL
);

CREATE TABLE cue (              -- what is read for a part of a video: by picture, language, begin
  id INTEGER PRIMARY KEY,
  picture INTEGER NOT NULL,
  language INTEGER NOT NULL,
  begin_ms INTEGER NOT NULL,    -- of the video
  end_ms INTEGER NOT NULL,
  text TEXT NOT NULL
);

CREATE TABLE sound (            -- what one may listen to at an exhibit
  id INTEGER PRIMARY KEY,
  exhibit INTEGER NOT NULL
);

CREATE TABLE sound_cue (        -- what is read for a part of a sound: by sound, language, begin
  id INTEGER PRIMARY KEY,
  sound INTEGER NOT NULL,
  language INTEGER NOT NULL,
  begin_ms INTEGER NOT NULL,    -- of the sound
  end_ms INTEGER NOT NULL,
  text TEXT NOT NULL
);

CREATE TABLE place (            -- what visitors ask for besides exhibits
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,           -- its id in museum.toml
  kind INTEGER NOT NULL,        -- PlaceKind
  floor INTEGER NOT NULL,
  x REAL NOT NULL,
  y REAL NOT NULL,
  standing_x REAL NOT NULL,     -- where the way to it ends
  standing_y REAL NOT NULL
);

CREATE TABLE way (              -- what visitors may choose, in this order; none: everything
  id INTEGER PRIMARY KEY,
  choice INTEGER NOT NULL       -- WayChoice
);

CREATE TABLE tour (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,           -- its id in museum.toml
  exhibit BLOB NOT NULL,        -- u32, in the order in which they are visited
  fixed INTEGER NOT NULL,       -- 1: the order is staff's, else the shortest from the kiosk
  seconds REAL NOT NULL,        -- ways and looking
  arrives BLOB NOT NULL,        -- f64, one an exhibit: seconds from the kiosk
  minutes REAL NOT NULL         -- what staff promise, or 0
);

CREATE TABLE image (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  width INTEGER NOT NULL,
  height INTEGER NOT NULL,
  bytes BLOB NOT NULL,          -- a PNG or JPEG file; a WebM video where the name ends in .webm
  small BLOB NOT NULL           -- likewise, as it hangs in the model; empty: it never does, or bytes is small
);

CREATE TABLE object (           -- an exhibit's own shape
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,           -- its file
  width REAL NOT NULL,
  height REAL NOT NULL,
  depth REAL NOT NULL,
  distant_vertex BLOB NOT NULL, -- ObjectVertex: from afar
  distant_triangle BLOB NOT NULL, -- u16
  detail BLOB NOT NULL          -- from nearby, with its pictures: object_blob.h
);

CREATE TABLE speech (           -- what the kiosk says, by pieces, sorted by language and text
  id INTEGER PRIMARY KEY,
  language INTEGER NOT NULL,
  text TEXT NOT NULL,           -- or the character U+001F and the id of the sound that it is of
  made_of TEXT NOT NULL,        -- a digest of all that its sound depends on
  skip INTEGER NOT NULL,        -- samples at 48 kHz that are left out at the beginning
  samples INTEGER NOT NULL,     -- and how many follow
  packets BLOB NOT NULL         -- Opus packets of one frame, each after its length (u16)
);

CREATE TABLE joint (            -- parents before children
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  parent INTEGER NOT NULL,      -- -1 for the root
  x REAL NOT NULL,
  y REAL NOT NULL,
  z REAL NOT NULL
);

CREATE TABLE motion_clip (
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  role INTEGER NOT NULL,        -- ClipRole
  motion_class TEXT NOT NULL,
  frame_rate REAL NOT NULL,
  motion BLOB NOT NULL          -- root, rotations and foot plants of all frames: motion_blob.h
);

CREATE TABLE motion_class (     -- of the clips, in the order in which they first appear
  id INTEGER PRIMARY KEY,
  name TEXT NOT NULL,
  coefficient BLOB NOT NULL,    -- f32, one a class: how unlike its gait is to that class's
  transition BLOB NOT NULL      -- u32, ascending: those of the class's own graph
);

CREATE TABLE motion_graph (     -- one row
  id INTEGER PRIMARY KEY,
  has_rotation BLOB NOT NULL,   -- u8, one a joint
  body_part BLOB NOT NULL,      -- i32, the joint of each BodyPart, -1 for none
  transition BLOB NOT NULL      -- Transition
);

CREATE TABLE foresight (        -- one row: what walking on costs after each transition
  id INTEGER PRIMARY KEY,
  warped BLOB NOT NULL,         -- u16 for [transition][bend][turn], or none
  raw BLOB NOT NULL,            -- u16 for [transition][bend][side][turn], or none
  ending BLOB NOT NULL          -- u16 for [transition][room], or none
);

CREATE TABLE avatar (           -- one row
  id INTEGER PRIMARY KEY,
  vertex BLOB NOT NULL,         -- SkinnedVertex
  triangle BLOB NOT NULL,       -- u32
  figure_end BLOB NOT NULL,     -- u32, one a body: past its last of `triangle`
  inverse_bind BLOB NOT NULL,   -- Mat4, one a joint; with a museum's own body, one a body and joint
  colour BLOB NOT NULL,         -- sRGB, three bytes for each vertex of the museum's own body, which is the last; or none
  cloth_node BLOB NOT NULL,     -- ClothNode: what swings, body after body, chains from the top down
  cloth_collider BLOB NOT NULL  -- ClothCollider: limbs that cloth is kept out of, body after body
);
